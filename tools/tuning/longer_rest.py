"""Copies a trial set of hybrid_trials.py or aimed_hands.py, with a longer rest before each movement.

    python tools/tuning/longer_rest.py --trials DIR --out DIR [--rest SECONDS] [--seed N]

The trackers have no faults in this rest. In games hands rest for longer than in trials, and a tracker must be corrected
after a fault all the same. Equal arguments give equal files.
"""

import argparse
import csv
from pathlib import Path

import numpy as np
from aimed_hands import ornstein_uhlenbeck
from hybrid_trials import read_track, write_track, write_trials

FIRST_S = 0.2  # of a track: the noise and the period are measured here
SWAY_M, SWAY_S = 0.8e-3, 0.3  # of a hand at rest: standard deviation and time constant


def with_rest(t: np.ndarray, places: np.ndarray, rest_s: float, rng: np.random.Generator) -> tuple:
    """Times (s) and places (n, 3; m) with a rest before them, at the first place."""
    is_first = t < t[0] + FIRST_S
    period_s = np.median(np.diff(t[is_first]))
    noise_m = np.sqrt(np.mean(np.diff(places[is_first], n=2, axis=0) ** 2) / 6.0)
    count = int(rest_s / period_s)
    sway = ornstein_uhlenbeck(count, SWAY_M, SWAY_S, 1.0 / period_s, rng)
    rest = places[0] + (sway - sway[-1]) + rng.normal(0.0, noise_m, (count, 3))
    stamps = t[0] + rest_s - period_s * np.arange(count, 0, -1)
    return np.concatenate([stamps, t + rest_s]), np.concatenate([rest, places])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--rest", type=float, default=20.0)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    options.out.mkdir(parents=True, exist_ok=True)
    for path in sorted(options.trials.glob("*.*.csv")):
        _, rows = read_track(path)
        write_track(options.out / path.name, *with_rest(rows[:, 0], rows[:, 1:4], options.rest, rng))
    with (options.trials / "trials.csv").open() as source:
        trials = list(csv.DictReader(source))
    for trial in trials:
        for name in ("start_s", "end_s"):
            trial[name] = f"{float(trial[name]) + options.rest:.4f}"
    write_trials(options.out, trials)


if __name__ == "__main__":
    main()
