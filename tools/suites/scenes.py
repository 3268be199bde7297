"""The scene tests: each GDScript of tests/scenes in a headless Godot of its own, through the public API only.

A script whose name begins with `editor_` runs inside the editor, with the add-on's plugin.

A script ends with the line `END <n> passed, <m> failed`. A line `SKIP ...` gives the reason of a skipped test. Errors
of the engine fail the test, unless the script has a line `# expects error: TEXT`; `# expects one error: TEXT` allows it
once. `# expects warning: TEXT` and `# expects one warning: TEXT` require a warning; other warnings are ignored.
`# engine options: WORDS` are options of Godot, for example `--fixed-fps 90`.
"""

import os
import re
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from suites import reference
from suites.outcome import Outcome
from suites.process import ROOT, run, scons

PROJECT = ROOT / "demo_project"
KILL_S = 60
IN_EDITOR = "editor_"
WAITING = "leap_"  # these mostly wait for messages, and use no audio: they run in parallel
LEAKED = re.compile(r"^ERROR: .*(?:leaked at exit|still in use at exit).*$", re.MULTILINE)
END = re.compile(r"^END (\d+) passed, (\d+) failed$")
COMPLAINT = re.compile(r"^\s*(?:SCRIPT ERROR|ERROR|USER ERROR|USER SCRIPT ERROR): (.*)|.*(Parse Error.*)")
EXPECTED = re.compile(r"^\s*#+ expects (?:one )?error: (.+)$", re.MULTILINE)
ERROR_ONCE = re.compile(r"^\s*#+ expects one error: (.+)$", re.MULTILINE)
WARNING = re.compile(r"^\s*WARNING: (.*)$", re.MULTILINE)
EXPECTED_WARNING = re.compile(r"^\s*#+ expects warning: (.+)$", re.MULTILINE)
ENGINE_OPTIONS = re.compile(r"^# engine options: (.+)$", re.MULTILINE)
EXPECTED_ONCE = re.compile(r"^\s*#+ expects one warning: (.+)$", re.MULTILINE)


def outcomes() -> Iterator[Outcome]:
    godot = os.environ["GODOT"]
    status, output = build()
    if status != 0:
        yield Outcome.of("scenes: the add-on is built and imported", False, output)
        return
    yield reference.outcome(godot, PROJECT)
    scripts = sorted((ROOT / "tests/scenes").glob("*.gd"))
    if not scripts:
        yield Outcome.of("scenes: there are some", False)
    with ThreadPoolExecutor(1) as pool:
        waiting = pool.map(partial(run_script, godot), [one for one in scripts if one.stem.startswith(WAITING)])
        for script in scripts:
            if not script.stem.startswith(WAITING):
                yield run_script(godot, script)
        yield from waiting


def build() -> tuple[int, str]:
    """Builds the add-on and imports the demo."""
    status, output = scons()
    return (status, output) if status != 0 else run([ROOT / "tools/import_project.sh", os.environ["GODOT"], PROJECT])


def run_script(
    godot: str, script: Path, wrapper: Sequence = (), arguments: Sequence[str] = (), name: str = ""
) -> Outcome:
    """`wrapper`: a program that runs the engine as its child. `arguments`: the script's own."""
    name = name or f"scenes/{script.stem}"
    if script.stem.startswith(IN_EDITOR):
        return run_in_editor(godot, script, name)
    options = " ".join(ENGINE_OPTIONS.findall(script.read_text())).split()
    engine = [godot, "--headless", *options, "--path", PROJECT, "--script", script, "--", *arguments]
    status, output = run([*wrapper, *engine], kill_s=KILL_S)
    return outcome_of(name, script, status, output)


def run_in_editor(godot: str, script: Path, name: str) -> Outcome:
    """On a copy of the project: the editor rewrites project.godot."""
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder, "project")
        shutil.copytree(PROJECT, project)
        status, output = run([godot, "--headless", "--editor", "--path", project, "--script", script], kill_s=KILL_S)
    # An editor that is ended by a script reports its own resources as leaked.
    output = LEAKED.sub("", output)
    return outcome_of(name, script, status, output)


def outcome_of(name: str, script: Path, status: int, output: str) -> Outcome:
    ends = [found for line in output.splitlines() if (found := END.match(line.strip()))]
    passed, failed = (int(ends[-1][1]), int(ends[-1][2])) if ends else (0, 0)
    faults = unexpected(output, script.read_text())
    warnings = WARNING.findall(output)
    for text in EXPECTED_WARNING.findall(script.read_text()):
        if not any(text in message for message in warnings):
            faults.append(f"expected warning did not come: {text}")
    for text in EXPECTED_ONCE.findall(script.read_text()):
        if times(text, warnings) != 1:
            faults.append(f"expected warning came {times(text, warnings)} times: {text}")
    if len(ends) != 1:
        faults.append(f"{len(ends)} END lines")
    elif passed + failed == 0 and "\nSKIP " in output and not faults:
        return Outcome(name, skipped=1)
    elif passed + failed == 0:
        faults.append("no test was run")
    if status != 0 and failed == 0:
        faults.append(f"exit status {status}")
    text = "\n".join([output, *(f"-> {fault}" for fault in faults)])
    return Outcome(name, passed, failed + len(faults), output=text)


def unexpected(output: str, script: str) -> list[str]:
    """Unexpected errors, expected errors that did not occur, and repeated ones."""
    expected = EXPECTED.findall(script)
    complaints = [found[1] or found[2] for line in output.splitlines() if (found := COMPLAINT.match(line))]
    faults = [f"error: {message}" for message in complaints if not any(text in message for text in expected)]
    faults += [f"expected error did not come: {text}" for text in expected if times(text, complaints) == 0]
    again = [text for text in ERROR_ONCE.findall(script) if times(text, complaints) > 1]
    return faults + [f"expected error came {times(text, complaints)} times: {text}" for text in again]


def times(text: str, complaints: list[str]) -> int:
    return sum(text in message for message in complaints)
