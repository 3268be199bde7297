"""Fits the parameters of the hand and the tracker (extension/core/base/parameters.h).

    python tools/tuning/fit_parameters.py --trials DIR... [--start NAME=VALUE...] [--minutes N] [--seed N]

DIR: sets of hybrid_trials.py, aimed_hands.py and longer_rest.py. Simulated people of the tuning population and the
checks of bench_matrix always count. The search changes one to three parameters at a time by a random factor, and
keeps what raises the score. It starts at the values of the header, or at those given, and prints each better setting.
It does not run the unit tests, which pin more than the score: a setting must pass them too.

Score: changes of zero-lag R2 in units of 1e-4. Unstable positions count in full: the lag and the faults of trackers are
what the parameters are for. A loss at the stable position counts half, and twice beyond LARGEST_LOSS: there the
output must stay like the measured motion. Checks of bench_matrix outside of their bounds cost points.
"""

import argparse
import json
import math
import random
import subprocess
import time
from collections import defaultdict
from pathlib import Path
from statistics import mean

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/template_release/bench/bench_parameters"
UNIT = 1e-4  # of R2
LARGEST_LOSS = 6.0  # units; SPEC: within 0.0006 of the measured motion
COSTS = {"outside": 0.05, "outside, short task": 0.4, "outside, asserted": 10.0}  # a check
FIRST_STEP, LEAST_STEP, LARGEST_STEP = 0.2, 0.04, 0.5  # standard deviations of the logarithm of the factor
LEAST_GAIN = 0.2


class Bench:
    def __init__(self, trials: list[Path], subjects: int):
        command = [PROGRAM, ROOT / "models", str(subjects), *trials]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.defaults: dict[str, float] = self._read()

    def measure(self, parameters: dict[str, float]) -> dict[str, float]:
        self._process.stdin.write(" ".join(f"{name} {value:.6g}" for name, value in parameters.items()) + "\n")
        self._process.stdin.flush()
        return self._read()

    def _read(self) -> dict[str, float]:
        line = self._process.stdout.readline()
        if not line:
            raise SystemExit(f"fit_parameters: {PROGRAM.name} ended")
        return json.loads(line)


def stable_points(gain: float) -> float:
    if gain > 0.0:
        return 0.1 * gain
    return 0.5 * max(gain, -LARGEST_LOSS) + 2.0 * min(gain + LARGEST_LOSS, 0.0)


def score(measures: dict[str, float], base: dict[str, float]) -> float:
    points = -sum(cost * (measures[name] - base[name]) for name, cost in COSTS.items())
    gains = defaultdict(list)  # by set and position
    for name, value in measures.items():
        if name not in COSTS:
            trial_set, position, _ = name.split("/")
            gains[trial_set, position].append((value - base[name]) / UNIT)
    for (trial_set, position), group in gains.items():
        if position == "stable":
            points += sum(stable_points(gain) for gain in group)
        else:  # the simulated set has every gesture and pace; the others have fewer
            points += (2.0 if trial_set == "simulated" else 0.3) * mean(group)
    return points


def fit(bench: Bench, start: dict[str, float], seconds: float) -> None:
    base = bench.measure(bench.defaults)
    best = bench.defaults | start
    best_score = score(bench.measure(best), base)
    steps = dict.fromkeys(best, FIRST_STEP)
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        chosen = random.sample(list(best), random.choice((1, 1, 2, 3)))
        changed = best | {name: best[name] * math.exp(random.gauss(0.0, steps[name])) for name in chosen}
        changed["LAGGING_SHARE"] = min(changed["LAGGING_SHARE"], 0.9)
        found = score(bench.measure(changed), base)
        is_better = found > best_score + LEAST_GAIN
        for name in chosen:
            steps[name] = min(1.3 * steps[name], LARGEST_STEP) if is_better else max(0.93 * steps[name], LEAST_STEP)
        if is_better:
            best, best_score = changed, found
            values = " ".join(f"{name}={best[name]:.4g}" for name in best if best[name] != bench.defaults[name])
            print(f"{best_score:+.1f}: {values}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=Path, nargs="+", required=True)
    parser.add_argument("--subjects", type=int, default=24, help="simulated people")
    parser.add_argument("--minutes", type=float, default=25.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--start", nargs="*", default=[], metavar="NAME=VALUE", help="other than in the header")
    given = parser.parse_args()
    random.seed(given.seed)
    build = ["scons", "-Q", "bench_parameters", "target=template_release"]
    subprocess.run(build, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    start = {name: float(value) for name, value in (one.split("=") for one in given.start)}
    fit(Bench(given.trials, given.subjects), start, 60.0 * given.minutes)


if __name__ == "__main__":
    main()
