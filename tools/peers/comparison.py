"""Runs every predictor on every trial, and adds the curves that `./steadyhand evaluate` wrote."""

import os
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from peers.metrics import Figures, compare
from peers.predictor import follow
from peers.training import Trained
from peers.trials import Trial, read_trials
from results.progress import Progress

# In the order of the table. `measured`, `one_euro`, `kalman` and `synthesised` are from TRIAL.curves.csv.
TITLES = {
    "measured": "raw",
    "one_euro": "One Euro",
    "kalman": "Kalman",
    "ridge": "ridge",
    "minimum_jerk": "minimum jerk",
    "promp": "ProMP",
    "synthesised": "**ours**",
}


@dataclass(frozen=True)
class TrialFigures:
    trial: str
    gesture: str
    position: str
    figures: dict[str, Figures]  # by condition of TITLES
    square_errors_mm2: dict[str, np.ndarray]  # by predictor: means over the frames, by HORIZONS_S


def compare_all(trials: Path, evaluation: Path, trained: Trained) -> list[TrialFigures]:
    """trials: a trial set. evaluation: the --out of ./steadyhand evaluate --context scene on it.

    Trials without curves there, and trials of a gesture without a model, are left out.
    """
    evaluated = read_trials(trials, lambda name: curves_path(evaluation, name).is_file())
    judged = [trial for trial in evaluated if trial.gesture in trained.durations_s]
    progress = Progress(f"predicting {trials.name}")
    rows = []
    with ProcessPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for row in pool.map(partial(compare_trial, evaluation, trained), judged):
            rows.append(row)
            progress.show(len(rows) / len(judged))
    return rows


def curves_path(evaluation: Path, name: str) -> Path:
    return evaluation / f"{name}.curves.csv"


def read_curves(path: Path) -> dict[str, np.ndarray]:
    with path.open() as file:
        names = file.readline().strip().split(",")
        return dict(zip(names, np.loadtxt(file, delimiter=",", ndmin=2).T, strict=True))


def compare_trial(evaluation: Path, trained: Trained, trial: Trial) -> TrialFigures:
    curves = read_curves(curves_path(evaluation, trial.name))
    errors = {}
    for name, make in trained.makers(trial.gesture).items():
        curves[name], errors[name] = follow(make(), trial, curves["t"])
    figures = {
        name: compare(curves["t"], curves["reference"], curves[name], trial.start_s, trial.end_s) for name in TITLES
    }
    squares = {name: np.mean((1e3 * trial.amplitude_m * of) ** 2, axis=0) for name, of in errors.items() if len(of)}
    return TrialFigures(trial.name, trial.gesture, trial.position, figures, squares)


def groups(rows: Iterable[TrialFigures]) -> dict[tuple[str, str], list[TrialFigures]]:
    """By gesture and position, sorted."""
    result: dict[tuple[str, str], list[TrialFigures]] = {}
    for row in sorted(rows, key=lambda row: (row.gesture, row.position)):
        result.setdefault((row.gesture, row.position), []).append(row)
    return result
