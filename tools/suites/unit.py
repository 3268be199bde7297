"""The doctest cases of the core, as built for the extension and under sanitizers; of what threads share, under TSan."""

import xml.etree.ElementTree as xml
from collections.abc import Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.process import ROOT, run, scons

BUILDS = {
    "template_debug": ["tests"],
    "template_debug.address_undefined": ["tests", "sanitize=address,undefined"],
    "template_debug.thread": ["race_tests", "sanitize=thread"],
}
PROGRAMS = {"tests": "unit_tests", "race_tests": "race_tests"}


def outcomes() -> Iterator[Outcome]:
    for variant, options in BUILDS.items():
        name = f"unit/{variant}"
        status, output = scons(*options)
        if status != 0:
            yield Outcome.of(f"{name} builds", False, output)
            continue
        yield from run_cases(name, ROOT / "build" / variant / PROGRAMS[options[0]])


def run_cases(name: str, program: Path) -> Iterator[Outcome]:
    report = program.with_suffix(".xml")
    status, output = run([program, "--reporters=xml", f"--out={report}"], UBSAN_OPTIONS="print_stacktrace=1")
    try:
        cases = list(xml.parse(report).iter("TestCase"))
    except (OSError, xml.ParseError):
        yield Outcome.of(f"{name} ends", False, f"exit status {status}\n{output}")
        return
    found = [outcome_of(name, case) for case in cases]
    yield from found
    failures = sum(outcome.failed for outcome in found)
    if not found or (status != 0 and failures == 0):
        yield Outcome.of(f"{name} ends", False, f"{len(found)} test cases, exit status {status}\n{output}")


def outcome_of(build: str, case: xml.Element) -> Outcome:
    name = f"{build}: {case.get('name')}"
    said = " ".join(text.strip() for message in case.iter("Message") for text in message.itertext())
    result = case.find("OverallResultsAsserts")
    if case.get("skipped") == "true":
        return Outcome(name, skipped=1)
    if result.get("successes") == result.get("failures") == "0":
        without_data = said.strip().startswith("skipped: ")
        return Outcome(name, skipped=1) if without_data else Outcome.of(name, False, "not one assertion was made")
    return Outcome.of(name, result.get("test_case_success") == "true", "\n".join(complaints(case)))


def complaints(case: xml.Element) -> Iterator[str]:
    for failure in case.iter("Expression"):
        if failure.get("success") == "false":
            words = [f"{part.tag.lower()}: {part.text.strip()}" for part in failure if part.text]
            yield f"{failure.get('filename')}:{failure.get('line')}: {failure.get('type')}; " + "; ".join(words)
    for message in [*case.iter("Message"), *case.iter("Exception")]:
        yield f"{message.get('filename', '')}:{message.get('line', '')}: {''.join(message.itertext()).strip()}"
