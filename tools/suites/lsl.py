"""LslOutlet with a receiver of the Lab Streaming Layer."""

import os
import sys
from collections.abc import Iterator

from suites import scenes
from suites.outcome import Outcome
from suites.process import ROOT, run


def outcomes() -> Iterator[Outcome]:
    status, output = scenes.build()
    if status == 0:
        status, output = run([sys.executable, ROOT / "tests/lsl/round_trip.py", os.environ["GODOT"]], kill_s=120)
    yield Outcome.of("lsl/frames and events are received", status == 0, output)
