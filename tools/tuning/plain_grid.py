"""Compares the synthesised curve with a plain Bayesian grid, on the files of `./steadyhand evaluate`.

    python tools/tuning/plain_grid.py --trials DIR --evaluation DIR [--lag-ms MEAN] [--lag-deviation-ms SD] [--every N]

The grid is over the onset, duration and sensor lag of one minimum-jerk curve of the task's length. Residuals have a
Student t distribution. The output is the mean of the hypotheses as of the last frame, with each trial's task. Prints
the mean zero-lag R2, and the median of T_diff, with a missed end at the end of the record, as in
tools/tuning/oracle.py. For drags and taps; with --every for one in N of each gesture and position.
"""

import argparse
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from hybrid_trials import AXES, joint, minimum_jerk, read_track
from oracle import END_LEVEL, end_ms, r2, read_rows, span_of, window_of

USUAL_DURATION_S = {"horizontal_drag": 1.0, "vertical_drag": 1.0, "tap": 0.5}
DURATION_DEVIATION = 0.6  # of its logarithm
DURATIONS_S = np.geomspace(0.15, 3.0, 22)
LAGS_S = (0.0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.13, 0.17)
ONSET_STEP_S = 0.02
EARLIEST_ONSET_S = -0.05  # from the first frame

RESIDUAL = 0.03  # scale, in shares of the amplitude
FREEDOM = 3.0  # of the Student t
CORRELATION_S = 0.05  # of the residuals: the weight of a frame is its interval / this
LONGEST_S = 0.03  # greatest interval for this weight
FIRST_S = 0.01  # interval of the first frame
OUTPUT_STEP = 4  # samples at 1 kHz, with straight lines between
NEGLIGIBLE = 1e-4  # weight of a hypothesis, relative to the likeliest one


@dataclass(frozen=True)
class Job:
    trials: Path
    evaluation: Path
    trial: dict[str, str]  # its row of trials.csv
    lag_s: tuple[float, float]  # mean and deviation


class Grid:
    def __init__(self, frames_s: np.ndarray, usual_duration_s: float, lag_s: tuple[float, float]) -> None:
        onsets_s = np.arange(frames_s[0] + EARLIEST_ONSET_S, frames_s[-1], ONSET_STEP_S)
        axes = np.meshgrid(onsets_s, DURATIONS_S, LAGS_S, indexing="ij")
        self.onset_s, self.duration_s, self.lag_s = (axis.ravel() for axis in axes)
        self.log_weight = -0.5 * (np.log(self.duration_s / usual_duration_s) / DURATION_DEVIATION) ** 2
        self.log_weight -= 0.5 * ((self.lag_s - lag_s[0]) / lag_s[1]) ** 2

    def update(self, t_s: float, value: float, interval_s: float) -> None:
        expected = minimum_jerk((t_s - self.lag_s - self.onset_s) / self.duration_s)
        surprise = np.log1p(((value - expected) / RESIDUAL) ** 2 / FREEDOM)
        self.log_weight -= interval_s / CORRELATION_S * 0.5 * (FREEDOM + 1.0) * surprise

    def values(self, t: np.ndarray) -> np.ndarray:
        """Estimated values of the hand at these times."""
        weight = np.exp(self.log_weight - self.log_weight.max())
        kept = weight > NEGLIGIBLE
        curves = minimum_jerk((t[:, None] - self.onset_s[kept]) / self.duration_s[kept])
        return curves @ weight[kept] / weight[kept].sum()


def read_frames(path: Path, trial: dict[str, str]) -> tuple[np.ndarray, np.ndarray]:
    """Times of the frames with the index tip, and its values along the task, in amplitudes."""
    start, axis = (np.array([float(trial[f"{what}_{k}"]) for k in AXES]) for what in ("start", "axis"))
    header, rows = read_track(path)
    gone = (joint(header, rows, "index") - start) @ axis / float(trial["amplitude_m"])
    seen = ~np.isnan(gone)
    return rows[seen, header.index("t")], gone[seen]


def estimate(t: np.ndarray, frames_s: np.ndarray, gone: np.ndarray, grid: Grid) -> np.ndarray:
    """Output of the grid at t, at 1 kHz; 0 before the first frame."""
    out = np.zeros(len(t))
    intervals_s = np.minimum(np.diff(frames_s, prepend=frames_s[0] - FIRST_S), LONGEST_S)
    bounds = np.append(np.searchsorted(t, frames_s), len(t))
    for i, frame in enumerate(zip(frames_s, gone, intervals_s, strict=True)):
        grid.update(*frame)
        until_next = t[bounds[i] : bounds[i + 1]]
        if until_next.size:
            some = until_next[::OUTPUT_STEP]
            out[bounds[i] : bounds[i + 1]] = np.interp(until_next, some, grid.values(some))
    return out


def run(job: Job) -> tuple[float, float]:
    """Zero-lag R2, and T_diff, ms."""
    name = job.trial["trial"]
    frames_s, gone = read_frames(job.trials / f"{name}.measured.csv", job.trial)
    curves = np.genfromtxt(job.evaluation / f"{name}.curves.csv", delimiter=",", names=True)
    t, reference = curves["t"], curves["reference"]
    values = estimate(t, frames_s, gone, Grid(frames_s, USUAL_DURATION_S[job.trial["gesture"]], job.lag_s))
    window = window_of(t, *span_of(job.trial))
    start, end = np.searchsorted(t, span_of(job.trial))
    level = END_LEVEL * reference[end]
    return r2(reference[window], values[window]), end_ms(reference, start, level) - end_ms(values, start, level)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--trials", type=Path, required=True)
    parser.add_argument("--evaluation", type=Path, required=True)
    parser.add_argument("--lag-ms", type=float, default=30.0)
    parser.add_argument("--lag-deviation-ms", type=float, default=30.0)
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    groups = defaultdict(list)
    for trial, row in read_rows(options.trials, options.evaluation):
        if trial["gesture"] in USUAL_DURATION_S:
            groups[trial["gesture"], trial["position"]].append((trial, row))
    lag_s = options.lag_ms / 1000.0, options.lag_deviation_ms / 1000.0
    columns = ("gesture, position", "trials", "measured", "synthesised", "grid", "T_diff of grid")
    print(f"| {' | '.join(columns)} |\n| --- {'| ---: ' * (len(columns) - 1)}|")
    with ProcessPoolExecutor(2) as executor:
        for (gesture, position), pairs in sorted(groups.items()):
            pairs = pairs[:: options.every]
            jobs = [Job(options.trials, options.evaluation, trial, lag_s) for trial, _ in pairs]
            r2s, t_diffs_ms = zip(*executor.map(run, jobs), strict=True)
            known = ([float(row[f"r2_zero_{curve}"]) for _, row in pairs] for curve in ("measured", "synthesised"))
            means = " | ".join(f"{np.mean(values):.3f}" for values in (*known, r2s))
            what = f"{gesture.replace('_', ' ')}, {position}"
            print(f"| {what} | {len(pairs)} | {means} | {np.median(t_diffs_ms):+.0f} ms |", flush=True)


if __name__ == "__main__":
    main()
