"""The doctest cases of the core, in a normal build and under sanitizers; threaded parts under TSan.

Sanitizers leave out the suite "figures": long cases whose code is covered by others.
"""

import os
import re
import xml.etree.ElementTree as xml
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from suites.outcome import Outcome
from suites.process import ROOT, run, scons

BUILDS = {
    "template_debug": ["tests"],
    "template_debug.address_undefined": ["tests", "sanitize=address,undefined"],
    "template_debug.thread": ["race_tests", "sanitize=thread"],
}
PROGRAMS = {"tests": "unit_tests", "race_tests": "race_tests"}
PARTS_A_CORE = 8  # some cases take a hundred times as long as others


def outcomes() -> Iterator[Outcome]:
    for variant, options in BUILDS.items():
        name = f"unit/{variant}"
        status, output = scons(*options)
        if status != 0:
            yield Outcome.of(f"{name} builds", False, output)
            continue
        without = ["--test-suite-exclude=figures"] if len(options) > 1 else []
        yield from run_cases(name, [ROOT / "build" / variant / PROGRAMS[options[0]], *without])


def run_cases(name: str, program: list) -> Iterator[Outcome]:
    """Runs parts of the cases on each core, because they take minutes under sanitizers."""
    status, output = run([*program, "--count"])
    total = re.search(r"(\d+)\s*$", output)
    if status != 0 or total is None or int(total[1]) == 0:
        yield Outcome.of(f"{name} ends", False, f"exit status {status}, no test case\n{output}")
        return
    cores = len(os.sched_getaffinity(0))
    size = -(-int(total[1]) // (PARTS_A_CORE * cores))
    with ThreadPoolExecutor(cores) as pool:
        parts = list(pool.map(partial(run_part, name, program, size), range(1, int(total[1]) + 1, size)))
    ran = [outcome for part in parts for outcome in part if not outcome.skipped]
    yield from ran
    ran_names = {outcome.name for outcome in ran}
    left_out = {outcome.name: outcome for part in parts for outcome in part if outcome.skipped}
    yield from (outcome for name, outcome in left_out.items() if name not in ran_names)


def run_part(name: str, program: list, size: int, first: int) -> list[Outcome]:
    """`size` cases, counted from 1; the others are skipped."""
    report = program[0].with_suffix(f".{first}.xml")
    report.unlink(missing_ok=True)
    part = [f"--first={first}", f"--last={first + size - 1}"]
    status, output = run([*program, *part, "--reporters=xml", f"--out={report}"], UBSAN_OPTIONS="print_stacktrace=1")
    try:
        cases = list(xml.parse(report).iter("TestCase"))
    except (OSError, xml.ParseError):
        return [Outcome.of(f"{name} ends", False, f"{' '.join(part)}: exit status {status}\n{output}")]
    found = [outcome_of(name, case) for case in cases]
    ran = sum(case.get("skipped") != "true" for case in cases)
    failures = sum(outcome.failed for outcome in found)
    if ran == 0 or (status != 0 and failures == 0):
        found.append(Outcome.of(f"{name} ends", False, f"{ran} cases, exit status {status}\n{output}"))
    return found


def outcome_of(build: str, case: xml.Element) -> Outcome:
    name = f"{build}: {case.get('name')}"
    if case.get("skipped") == "true":
        return Outcome(name, skipped=1)
    text = " ".join(text.strip() for message in case.iter("Message") for text in message.itertext())
    result = case.find("OverallResultsAsserts")
    if result.get("successes") == result.get("failures") == "0":
        without_data = text.strip().startswith("skipped: ")
        return Outcome(name, skipped=1) if without_data else Outcome.of(name, False, "not one assertion was made")
    return Outcome.of(name, result.get("test_case_success") == "true", "\n".join(complaints(case)))


def complaints(case: xml.Element) -> Iterator[str]:
    for failure in case.iter("Expression"):
        if failure.get("success") == "false":
            words = [f"{part.tag.lower()}: {part.text.strip()}" for part in failure if part.text]
            yield f"{failure.get('filename')}:{failure.get('line')}: {failure.get('type')}; " + "; ".join(words)
    for message in [*case.iter("Message"), *case.iter("Exception")]:
        yield f"{message.get('filename', '')}:{message.get('line', '')}: {''.join(message.itertext()).strip()}"
