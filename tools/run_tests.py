#!/usr/bin/env python3
"""Runs the named test suites, or all except EXTRA. Prints `N passed, N failed`. The exit status is 1 after a failure.

Two lanes run in parallel: the suites of BESIDE in one, the others in the other. The suites of LAST follow in the lane
that is free first.
"""

import itertools
import sys
import time
import traceback
from collections import deque
from collections.abc import Iterator
from queue import SimpleQueue
from threading import Thread

from suites import (
    command,
    devices,
    dist,
    docs,
    engine_api,
    fuzz,
    lint,
    lsl,
    openxr,
    oracles,
    platforms,
    predictors,
    scenes,
    study_export,
    unit,
)
from suites.outcome import Outcome

SUITES = {
    "unit": unit,
    "oracles": oracles,
    "scenes": scenes,
    "devices": devices,
    "lsl": lsl,
    "fuzz": fuzz,
    "command": command,
    "study_export": study_export,
    "predictors": predictors,
    "docs": docs,
    "engine_api": engine_api,
    "dist": dist,
    "lint": lint,
    "openxr": openxr,
    "platforms": platforms,
}
EXTRA = ["openxr", "dist", "platforms"]  # downloads 265 MB; builds for release; cross-compiles for about 10 minutes
BESIDE = ["fuzz", "study_export", "lint", "command"]
LAST = ["lsl", "predictors", "docs", "engine_api"]


def main(names: list[str]) -> int:
    passed = failed = skipped = 0
    taken: dict[str, float] = {}
    for suite, outcome, taken_s in run_all(names or [name for name in SUITES if name not in EXTRA]):
        verdict = "FAIL" if outcome.failed else "pass" if outcome.passed else "skip"
        print(f"{verdict}  {outcome.name}  ({taken_s:.1f} s)", flush=True)
        if outcome.failed and outcome.output.strip():
            print("      " + outcome.output.strip().replace("\n", "\n      "), flush=True)
        passed, failed, skipped = passed + outcome.passed, failed + outcome.failed, skipped + outcome.skipped
        taken[suite] = taken.get(suite, 0.0) + taken_s
    print(", ".join(f"{suite} {seconds:.0f} s" for suite, seconds in taken.items()))
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if failed or not passed else 0


def run_all(names: list[str]) -> Iterator[tuple[str, Outcome, float]]:
    """Yields each outcome when it is there, with its suite and the time in s since the last one of its lane."""
    beside, last = ([name for name in some if name in names] for some in (BESIDE, LAST))
    lanes = [[name for name in names if name not in beside + last], beside]
    left = deque([*last, *(None for _ in lanes)])
    come: SimpleQueue[tuple[str, Outcome, float] | None] = SimpleQueue()

    def run(lane: list[str]) -> None:
        before = time.monotonic()
        for name in itertools.chain(lane, iter(left.popleft, None)):
            try:
                for outcome in SUITES[name].outcomes():
                    now = time.monotonic()
                    come.put((name, outcome, now - before))
                    before = now
            except Exception:  # an error in the suite itself; the other suites continue
                come.put((name, Outcome.of(f"{name} ends", False, traceback.format_exc()), 0.0))
        come.put(None)

    for lane in lanes:
        Thread(target=run, args=[lane], daemon=True).start()
    running = len(lanes)
    while running:
        if (one := come.get()) is None:
            running -= 1
        else:
            yield one


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
