"""The core against other libraries: each Python script of tests/oracles, given the unit-test program."""

import sys
from collections.abc import Iterator

from suites.outcome import Outcome
from suites.process import ROOT, run, scons


def outcomes() -> Iterator[Outcome]:
    status, output = scons("tests")
    if status != 0:
        yield Outcome.of("oracles build", False, output)
        return
    program = ROOT / "build/template_debug/unit_tests"
    for script in sorted((ROOT / "tests/oracles").glob("*.py")):
        status, output = run([sys.executable, script, "--binary", program], kill_s=120)
        yield Outcome.of(f"oracles/{script.stem}", status == 0, output)
