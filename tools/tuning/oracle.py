"""Compares the synthesised curve with three oracles, from the files of `./steadyhand evaluate`.

    python tools/tuning/oracle.py --trials DIR --evaluation DIR

shape:  the minimum-jerk movement with the best fit to the reference in onset, duration and length.
faults: the measured curve with a straight line over each freeze or dropout of more than 50 ms, which uses later
        frames, at the constant lag with the best fit to the reference.
late:   the reference with a random lag: normal, standard deviation LATE_MS, as the lags of trackers differ.
Mean R2 over the gesture and 0.25 s before and after it, and T_diff, with a missed end at the end of the record, as
in extension/core/metrics/curve_comparison.h.
"""

import argparse
import csv
import itertools
import sys
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from statistics import NormalDist

import numpy as np
from hybrid_trials import minimum_jerk

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from gesture_end import END_LEVEL

MARGIN_S = 0.25
HELD_MS = 50
LAGS_MS = range(-500, 501, 5)
LATE_MS = 30.0  # standard deviation of the lag of simulated trackers at the unstable position
LATENESSES_MS = [round(LATE_MS * NormalDist().inv_cdf((i + 0.5) / 9)) for i in range(9)]  # equally likely
T_DIFF_S = {"stable": (-0.05, 0.015), "unstable": (-0.1, 0.1)}  # limits of "inside": latest, earliest
CURVES = ("measured", "synthesised", "measured, best lag", "faults")


def r2(reference: np.ndarray, x: np.ndarray) -> float:
    return 1.0 - np.sum((reference - x) ** 2) / np.sum((reference - reference.mean()) ** 2)


def best_shape(t: np.ndarray, reference: np.ndarray) -> float:
    best = -np.inf
    for duration_s in np.arange(0.15, 2.5, 0.05):
        for onset_s in np.arange(t[0], t[-1], 0.02):
            curve = minimum_jerk((t - onset_s) / duration_s)
            gain = curve @ reference / max(curve @ curve, 1e-12)
            best = max(best, r2(reference, gain * curve))
    return best


def bridged(x: np.ndarray) -> np.ndarray:
    """x, at 1 kHz, with a line instead of each value that is constant for longer than HELD_MS."""
    changes = np.flatnonzero(np.diff(x)) + 1
    x = x.copy()
    for before, after in itertools.pairwise(changes):
        if after - before > HELD_MS:
            x[before : after + 1] = np.linspace(x[before], x[after], after - before + 1)
    return x


def r2_at(reference: np.ndarray, x: np.ndarray, window: np.ndarray, lag_ms: int) -> float:
    """R2 over the samples of window, of x, at 1 kHz, shifted earlier by lag_ms."""
    return r2(reference[window], x[np.clip(window + lag_ms, 0, len(x) - 1)])


def best_lag(reference: np.ndarray, x: np.ndarray, window: np.ndarray) -> tuple[float, int]:
    """The greatest R2, and its lag, ms; positive if x is late."""
    return max((r2_at(reference, x, window, ms), ms) for ms in LAGS_MS)


def end_ms(x: np.ndarray, start: int, level: float) -> int:
    """The first sample from start on at the level; the last sample of the record if there is none."""
    reached = np.flatnonzero(x[start:] >= level)
    return start + reached[0] if reached.size else len(x) - 1


def is_inside(t_diff_s: float, position: str) -> bool:
    latest_s, earliest_s = T_DIFF_S[position]
    return latest_s <= t_diff_s <= earliest_s


def window_of(t: np.ndarray, start_s: float, end_s: float) -> np.ndarray:
    """The samples for R2."""
    return np.flatnonzero((t >= start_s - MARGIN_S) & (t <= end_s + MARGIN_S))


def span_of(trial: dict[str, str]) -> tuple[float, float]:
    return float(trial["start_s"]), float(trial["end_s"])


def read_rows(trials: Path, evaluation: Path) -> list[tuple[dict[str, str], dict[str, str]]]:
    """The rows of trials.csv and of results.csv for each trial of a gesture."""
    with (trials / "trials.csv").open() as source:
        by_name = {trial["trial"]: trial for trial in csv.DictReader(source)}
    with (evaluation / "results.csv").open() as source:
        return [(by_name[row["trial"]], row) for row in csv.DictReader(source) if row["gesture"] != "none"]


@dataclass
class Trial:
    r2s: tuple[float, ...]  # of CURVES, zero-lag except "best lag" and faults; then of shape and late
    t_diffs_ms: tuple[float, ...]  # of CURVES
    lag_ms: int  # of faults

    @classmethod
    def read(cls, row: dict[str, str], curves_path: Path, start_s: float, end_s: float) -> "Trial":
        """row: of the trial in results.csv, with the values of the measured and synthesised curves."""
        curves = np.genfromtxt(curves_path, delimiter=",", names=True)
        t, reference, faults = curves["t"], curves["reference"], bridged(curves["measured"])
        window = window_of(t, start_s, end_s)
        faults_r2, lag_ms = best_lag(reference, faults, window)
        start, end = np.searchsorted(t, [start_s, end_s])
        level = END_LEVEL * reference[end]
        measured_ms, synthesised_ms, measured_lag_ms = (
            1e3 * float(row[column]) for column in ("t_diff_measured", "t_diff_synthesised", "lag_measured")
        )
        faults_ms = end_ms(reference, start, level) - end_ms(faults, start, level) + lag_ms
        late_r2 = np.mean([r2_at(reference, reference, window, -ms) for ms in LATENESSES_MS])
        known = (float(row[column]) for column in ("r2_zero_measured", "r2_zero_synthesised", "r2_measured"))
        return cls(
            (*known, faults_r2, best_shape(t[window][::5], reference[window][::5]), late_r2),
            (measured_ms, synthesised_ms, measured_ms + measured_lag_ms, faults_ms),
            lag_ms,
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=Path, required=True)
    parser.add_argument("--evaluation", type=Path, required=True)
    options = parser.parse_args()
    groups = defaultdict(list)
    for trial, row in read_rows(options.trials, options.evaluation):
        curves_path = options.evaluation / f"{row['trial']}.curves.csv"
        group = groups[row["gesture"].replace("_", " "), row["position"]]
        group.append(Trial.read(row, curves_path, *span_of(trial)))
    columns = ("trials", *CURVES, "shape", "late", "lag of faults")
    print(f"| {' | '.join(columns)} |\n| --- {'| ---: ' * (len(columns) - 1)}|")
    for (gesture, position), trials in sorted(groups.items()):
        lags_ms = [trial.lag_ms for trial in trials]
        means = " | ".join(f"{mean:.3f}" for mean in np.mean([trial.r2s for trial in trials], axis=0))
        lag = f"{np.mean(lags_ms):.0f} ± {np.std(lags_ms):.0f} ms"
        print(f"| {gesture}, {position}: {len(trials)} | {means} | {lag} |")
    print(f"\n| T_diff: median, and inside | {' | '.join(CURVES)} |\n| --- {'| ---: ' * len(CURVES)}|")
    for (gesture, position), trials in sorted(groups.items()):
        t_diffs_ms = np.array([trial.t_diffs_ms for trial in trials])
        inside = np.mean(np.vectorize(is_inside)(t_diffs_ms / 1000.0, position), axis=0)
        cells = (f"{m:+.0f} ms, {100.0 * i:.0f} %" for m, i in zip(np.median(t_diffs_ms, axis=0), inside, strict=True))
        print(f"| {gesture}, {position}: {len(trials)} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
