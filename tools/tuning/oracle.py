"""What could be had at all: two oracles beside the synthesised curve, from what `./steadyhand evaluate` left.

    python tools/tuning/oracle.py --trials DIR --evaluation DIR

shape:  the minimum-jerk movement that fits the reference best, its onset, duration and length known.
faults: the measured curve with each freeze or gap of more than 50 ms bridged by a straight line from before to
        after, as if the future were known, at the constant lag that fits the reference best.
Mean R2 over the gesture's span and 0.25 s on either side, as in extension/core/metrics/curve_comparison.h.
"""

import argparse
import csv
import itertools
from collections import defaultdict
from pathlib import Path

import numpy as np

MARGIN_S = 0.25
HELD_MS = 50
LAGS_MS = range(-500, 501, 5)


def r2(reference: np.ndarray, x: np.ndarray) -> float:
    return 1.0 - np.sum((reference - x) ** 2) / np.sum((reference - reference.mean()) ** 2)


def best_shape(t: np.ndarray, reference: np.ndarray) -> float:
    best = -np.inf
    for duration_s in np.arange(0.15, 2.5, 0.05):
        for onset_s in np.arange(t[0], t[-1], 0.02):
            s = np.clip((t - onset_s) / duration_s, 0.0, 1.0)
            curve = s**3 * (10.0 - 15.0 * s + 6.0 * s**2)
            gain = curve @ reference / max(curve @ curve, 1e-12)
            best = max(best, r2(reference, gain * curve))
    return best


def bridged(x: np.ndarray) -> np.ndarray:
    """x, 1 kHz, with every value that is held for longer than HELD_MS replaced by a line to the next one."""
    changes = np.flatnonzero(np.diff(x)) + 1
    x = x.copy()
    for before, after in itertools.pairwise(changes):
        if after - before > HELD_MS:
            x[before : after + 1] = np.linspace(x[before], x[after], after - before + 1)
    return x


def best_lag(reference: np.ndarray, x: np.ndarray, window: np.ndarray) -> float:
    def shifted(ms: int) -> np.ndarray:
        return x[np.clip(np.flatnonzero(window) + ms, 0, len(x) - 1)]

    return max(r2(reference[window], shifted(ms)) for ms in LAGS_MS)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=Path, required=True)
    parser.add_argument("--evaluation", type=Path, required=True)
    given = parser.parse_args()
    groups = defaultdict(list)
    with (given.trials / "trials.csv").open() as source:
        for trial in csv.DictReader(source):
            path = given.evaluation / f"{trial['trial']}.curves.csv"
            if trial["gesture"] == "none" or not path.exists():
                continue
            curves = np.genfromtxt(path, delimiter=",", names=True)
            t, reference = curves["t"], curves["reference"]
            window = (t >= float(trial["start_s"]) - MARGIN_S) & (t <= float(trial["end_s"]) + MARGIN_S)
            groups[trial["gesture"], trial["position"]].append(
                (
                    r2(reference[window], curves["measured"][window]),
                    r2(reference[window], curves["synthesised"][window]),
                    best_lag(reference, curves["measured"], window),
                    best_lag(reference, bridged(curves["measured"]), window),
                    best_shape(t[window][::5], reference[window][::5]),
                )
            )
    columns = ("trials", "measured", "synthesised", "measured, best lag", "faults", "shape")
    print(f"| {' | '.join(columns)} |\n| --- {'| ---: ' * (len(columns) - 1)}|")
    for (gesture, position), rows in sorted(groups.items()):
        means = " | ".join(f"{mean:.3f}" for mean in np.mean(rows, axis=0))
        print(f"| {gesture.replace('_', ' ')}, {position}: {len(rows)} | {means} |")


if __name__ == "__main__":
    main()
