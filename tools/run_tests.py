#!/usr/bin/env python3
"""Runs the test suites named, or all, and closes with `N passed, N failed`; the exit status tells if any failed."""

import sys
import time

from suites import command, lint, oracles, scenes, unit

SUITES = {"unit": unit, "oracles": oracles, "scenes": scenes, "command": command, "lint": lint}


def main(names: list[str]) -> int:
    passed = failed = skipped = 0
    for name in names or SUITES:
        print(f"== {name}", flush=True)
        before = time.monotonic()
        for outcome in SUITES[name].outcomes():
            now = time.monotonic()
            verdict = "FAIL" if outcome.failed else "pass" if outcome.passed else "skip"
            print(f"{verdict}  {outcome.name}  ({now - before:.1f} s)", flush=True)
            if outcome.failed and outcome.output.strip():
                print("      " + outcome.output.strip().replace("\n", "\n      "), flush=True)
            passed, failed, skipped = passed + outcome.passed, failed + outcome.failed, skipped + outcome.skipped
            before = now
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
