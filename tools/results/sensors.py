"""Other sensors: the same people's trials with the errors of other trackers."""

import csv
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from results.evaluation import Evaluation

SEED = 1
LESS_OFTEN = 4
OUTLIERS = 0.02
OUTLIER_M = 0.02  # standard deviation per axis
ASTRAY_PER_S = 0.5
JUMP_M = 0.06
SLIDES_BACK_S = 0.06
WANDERS_M_PER_S = 0.4
WANDERS_S = 0.3

# Changes the coordinates (frames, columns) of a tracker at these times; nan: not tracked.
Change = Callable[[np.ndarray, np.ndarray, np.random.Generator], np.ndarray]


def noise(deviation_m: float) -> Change:
    return lambda _, shown, rng: shown + rng.normal(0.0, deviation_m, shown.shape)


def as_it_is(_: np.ndarray, shown: np.ndarray, __: np.random.Generator) -> np.ndarray:
    return shown


def held(_: np.ndarray, shown: np.ndarray, __: np.random.Generator) -> np.ndarray:
    return shown[np.arange(len(shown)) // LESS_OFTEN * LESS_OFTEN]


def rounded(resolution_m: float) -> Change:
    return lambda _, shown, __: np.round(shown / resolution_m) * resolution_m


def outliers(_: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Moves the whole hand in single frames."""
    where = rng.normal(0.0, OUTLIER_M, (len(shown), 3)) * (rng.random((len(shown), 1)) < OUTLIERS)
    return shown + np.tile(where, shown.shape[1] // 3)


def astray(way_m: Callable[[np.ndarray], np.ndarray]) -> Change:
    """Sometimes moves the whole hand in one direction, by way_m of the time since then."""

    def change(t: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        off = np.zeros((len(t), 3))
        begins = t[0] + rng.exponential(1.0 / ASTRAY_PER_S)
        while begins < t[-1]:
            direction = rng.normal(size=3)
            since = t - begins
            off += np.where(since > 0.0, way_m(since), 0.0)[:, None] * direction / np.linalg.norm(direction)
            begins += WANDERS_S + rng.exponential(1.0 / ASTRAY_PER_S)
        return shown + np.tile(off, shown.shape[1] // 3)

    return change


@dataclass(frozen=True)
class Sensor:
    change: Change
    every: int = 1  # keeps only every n-th frame


SENSORS = {
    "as it is": Sensor(as_it_is),
    "white noise of 0.3 mm": Sensor(noise(0.0003)),
    "white noise of 2 mm": Sensor(noise(0.002)),
    "white noise of 5 mm": Sensor(noise(0.005)),
    "rounded to 1 mm": Sensor(rounded(0.001)),
    "rounded to 3 mm": Sensor(rounded(0.003)),
    f"a frame in {1 / OUTLIERS:.0f} some 3 cm elsewhere": Sensor(outliers),
    f"jumps of {100.0 * JUMP_M:.0f} cm that slide back": Sensor(
        astray(lambda since: JUMP_M * np.exp(-since / SLIDES_BACK_S))
    ),
    f"wanders off, {100.0 * WANDERS_M_PER_S * WANDERS_S:.0f} cm in {WANDERS_S} s, and jumps back": Sensor(
        astray(lambda since: np.where(since < WANDERS_S, WANDERS_M_PER_S * since, 0.0))
    ),
    f"every {LESS_OFTEN}th frame": Sensor(as_it_is, LESS_OFTEN),
    f"the same, read {LESS_OFTEN} times": Sensor(held),
}


@dataclass
class Sensors:
    """All gestures together, in `phase` mode."""

    task_given: dict[str, Evaluation]  # by the sensor's name
    nothing_given: dict[str, Evaluation]

    @classmethod
    def of(cls, trials: Path, out: Path) -> "Sensors":
        """Makes one set for each sensor in `out`."""
        folders = {name: out / name for name in SENSORS}
        for name, sensor in SENSORS.items():
            write_trials(trials, folders[name], sensor)
        return cls(
            *(
                {
                    name: Evaluation(folder, "phase", context, out / f"{folder.name}_{context}", False)
                    for name, folder in folders.items()
                }
                for context in ("scene", "open")
            )
        )

    def evaluations(self) -> list[Evaluation]:
        return [*self.task_given.values(), *self.nothing_given.values()]

    def values(self, sensor: str, position: str, figure: str, condition: str) -> np.ndarray:
        """The figure (r2, r2_zero or t_diff) of each trial, with a task."""
        column = f"{figure}_{condition}"
        return np.array([row[column] for row in self.task_given[sensor].rows if row["position"] == position])

    def missed(self, sensor: str, position: str) -> int:
        groups = [group for group in self.task_given[sensor].groups() if group["position"] == position]
        return sum(group["conditions"]["synthesised"]["missed"] for group in groups)

    def recognised(self, sensor: str, position: str) -> float:
        """Share of the trials, all models active, without a task."""
        groups = [group for group in self.nothing_given[sensor].groups() if group["position"] == position]
        return sum(group["recognised"] for group in groups) / sum(group["trials"] for group in groups)


def write_trials(source: Path, out: Path, sensor: Sensor) -> None:
    """Writes the set with the sensor's errors."""
    out.mkdir(parents=True)
    shutil.copy(source / "trials.csv", out)
    rng = np.random.default_rng(SEED)
    for reference in sorted(source.glob("*.reference.csv")):
        shutil.copy(reference, out)
        name = reference.name.replace(".reference.", ".measured.")
        with (source / name).open(newline="") as file:
            comments = []
            while (line := file.readline()).startswith("#"):
                comments.append(line)
            header = line.strip().split(",")
            rows = list(csv.reader(file))[:: sensor.every]
        t = np.array([float(row[header.index("t")]) for row in rows])
        places = [k for k, column in enumerate(header) if column[-2:] in ("_x", "_y", "_z")]
        shown = np.array([[float(row[k] or "nan") for k in places] for row in rows])
        for row, values in zip(rows, sensor.change(t, shown, rng), strict=True):
            for k, value in zip(places, values, strict=True):
                row[k] = "" if np.isnan(value) else str(float(value))
        with (out / name).open("w", newline="") as file:
            file.writelines(comments)
            csv.writer(file, lineterminator="\n").writerows([header, *rows])
