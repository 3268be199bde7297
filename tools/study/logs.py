"""The demo's logs, trials.csv of each session, as docs/formats.md has them."""

import csv
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

FILE_NAME = "trials.csv"
COLUMNS = [
    "participant",
    "gesture",
    "position",
    "condition",
    "amplitude_m",
    "width_m",
    "start_s",
    "gesture_end_s",
    "end_value_m",
]


@dataclass(frozen=True)
class Trial:
    participant: str  # empty: nobody was named
    gesture: str
    position: str  # stable, unstable; empty: neither
    condition: str
    amplitude_m: float
    width_m: float | None
    start_s: float | None  # None, as the next two: it never came
    gesture_end_s: float | None
    end_value_m: float | None

    @property
    def is_complete(self) -> bool:
        return None not in (self.start_s, self.gesture_end_s, self.end_value_m)

    @property
    def movement_time_s(self) -> float:
        """Of a complete one."""
        return self.gesture_end_s - self.start_s


@dataclass
class Logs:
    trials: list[Trial]
    faults: list[str]  # each names its file, and the line if it is one


def read_logs(given: list[Path]) -> Logs:
    """Every trials.csv in or below the folders given, each once. What cannot be read is a fault; the rest goes on."""
    logs = Logs([], [])
    files: dict[Path, Path] = {}
    for path in given:
        found = sorted(path.rglob(FILE_NAME)) if path.is_dir() else [path] if path.is_file() else []
        if not found:
            logs.faults.append(f"{path}: no {FILE_NAME} in it" if path.is_dir() else f"{path}: not there")
        files.update((file.resolve(), file) for file in found if file.resolve() not in files)
    for file in files.values():
        for one in read_file(file):
            (logs.faults if isinstance(one, str) else logs.trials).append(one)
    return logs


def read_file(path: Path) -> Iterator[Trial | str]:
    """Trials in their order, and what is wrong with a line."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            lines = csv.reader(file)
            header = next(lines, [])
            if len(header) == 1 and ";" in header[0]:  # as spreadsheets write it where numbers have a decimal comma
                yield f"{path}:1: cells are separated by ';': they must be by ',', and numbers have a '.'"
                return
            if missing := [name for name in COLUMNS if name not in header]:
                yield f"{path}:1: no column {', '.join(missing)} (no study log, or of an earlier version)"
                return
            for cells in lines:
                if not cells:
                    continue
                try:
                    if len(cells) != len(header):
                        raise ValueError(f"{len(cells)} cells, the header has {len(header)}")
                    yield parse(dict(zip(header, cells, strict=True)))
                except ValueError as fault:
                    yield f"{path}:{lines.line_num}: {fault}"
    except UnicodeDecodeError:
        yield f"{path}: this is no UTF-8 text"
    except (OSError, csv.Error) as fault:
        yield f"{path}: {fault}"


def parse(row: dict[str, str]) -> Trial:
    """ValueError says what is wrong."""
    numbers = {name: number(name, row[name]) for name in COLUMNS[4:]}
    if numbers["amplitude_m"] is None or numbers["amplitude_m"] <= 0.0:
        raise ValueError(f"amplitude_m: '{row['amplitude_m']}' is no length")
    trial = Trial(*(row[name] for name in COLUMNS[:4]), **numbers)
    if trial.is_complete and trial.movement_time_s <= 0.0:
        raise ValueError(f"gesture_end_s: {row['gesture_end_s']} is not after start_s {row['start_s']}")
    return trial


def number(column: str, text: str) -> float | None:
    if not text:
        return None
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ValueError(f"{column}: '{text}' is no finite number")
    return value
