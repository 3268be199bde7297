"""Reads trial sets: each trial as the motion along its task, in amplitudes."""

import csv
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ZOOM_TIPS = ("thumb", "index", "middle")
# Amplitudes. Three tips nearly in line have a circle of any radius: such a frame is not tracked.
LARGEST_VALUE = 20.0


@dataclass(frozen=True)
class Trial:
    name: str
    gesture: str
    position: str
    amplitude_m: float
    start_s: float
    end_s: float
    t_s: np.ndarray  # tracked frames, increasing
    value: np.ndarray
    reference_t_s: np.ndarray
    reference: np.ndarray

    def reference_at(self, times_s: np.ndarray) -> np.ndarray:
        return np.interp(times_s, self.reference_t_s, self.reference)


def read_trials(folder: Path, is_wanted: Callable[[str], bool] = lambda name: True) -> list[Trial]:
    """The trials of the wanted gestures. Ends the program with path and reason if a file cannot be read."""
    path = folder / "trials.csv"
    with open_or_exit(path) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    try:
        return [read_trial(folder, row) for row in rows if row["gesture"] != "none" and is_wanted(row["trial"])]
    except (KeyError, TypeError, ValueError) as error:
        sys.exit(f"{path}: no trial set: {error!r}")


def read_trial(folder: Path, row: dict[str, str]) -> Trial:
    name, gesture, position = row["trial"], row["gesture"], row["position"]
    amplitude_m, start_s, end_s = (float(row[column]) for column in ("amplitude_m", "start_s", "end_s"))
    measured, reference = (read_motion(folder / f"{name}.{kind}.csv", row) for kind in ("measured", "reference"))
    return Trial(name, gesture, position, amplitude_m, start_s, end_s, *measured, *reference)


def read_motion(path: Path, row: dict[str, str]) -> tuple[np.ndarray, np.ndarray]:
    """Times (s) of the tracked frames, and how far along the task the hand is in them, in amplitudes."""
    with open_or_exit(path) as file:
        lines = [line for line in file if not line.startswith("#")]
    try:
        cells = np.array([[float(cell or "nan") for cell in line.strip().split(",")] for line in lines[1:]])
        columns = dict(zip(lines[0].strip().split(","), cells.T, strict=True))
        value = task_value(columns, row)
    except (IndexError, KeyError, ValueError) as error:
        sys.exit(f"{path}: no track of a {row['gesture']}: {error!r}")
    tracked = np.isfinite(value) & (np.abs(value) < LARGEST_VALUE)
    t_s, value = columns["t"][tracked], value[tracked]
    if len(t_s) == 0:
        sys.exit(f"{path}: no tracked frame")
    is_newer = np.diff(np.maximum.accumulate(t_s), prepend=-np.inf) > 0.0
    return t_s[is_newer], value[is_newer]


def task_value(columns: dict[str, np.ndarray], row: dict[str, str]) -> np.ndarray:
    amplitude_m = float(row["amplitude_m"])
    if row["gesture"] == "zoom":
        tips = [np.stack([columns[f"{tip}_x"], columns[f"{tip}_y"]], axis=1) for tip in ZOOM_TIPS]
        return (circle_radius(*tips) - float(row["start_x"])) / amplitude_m
    along = sum((columns[f"index_{a}"] - float(row[f"start_{a}"])) * float(row[f"axis_{a}"]) for a in "xyz")
    return along / amplitude_m


def circle_radius(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """Of the circle through three points (n, 2) each; inf where they are in line."""
    sides = (np.linalg.norm(one - other, axis=1) for one, other in ((b, c), (c, a), (a, b)))
    (ab_x, ab_y), (ac_x, ac_y) = (b - a).T, (c - a).T
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.prod(list(sides), axis=0) / (2.0 * np.abs(ab_x * ac_y - ab_y * ac_x))


def open_or_exit(path: Path):
    try:
        return path.open(newline="", encoding="utf-8")
    except OSError as error:
        sys.exit(f"{path}: {error.strerror}")
