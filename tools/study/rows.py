"""A row of the demo's trials.csv."""

import math
from dataclasses import dataclass

COLUMNS = [
    "trial",
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
NUMBERS = COLUMNS[5:]
# Gestures of the scenes; there may be custom ones.
TASKS = ["horizontal_drag", "vertical_drag", "tap", "zoom"]
POSITIONS = ["stable", "unstable", ""]
ORIGINS = ["person", "mouse", "synthetic", "replay"]
# As in demo_project/scripts/conditions.gd; the command suite compares them.
CONDITIONS = ["measured", "average", "one_euro", "kalman", "synthesised"]
# A log of an earlier version has no column origin: the trials' names give it.
NAMED_AFTER = {"live": "person", "mouse": "mouse", "synthetic": "synthetic"}
# Metres or seconds: eleven days.
LARGEST = 1e6


@dataclass(frozen=True)
class Trial:
    name: str
    participant: str  # empty: not named
    gesture: str
    position: str  # stable, unstable; empty: neither
    condition: str
    amplitude_m: float
    width_m: float | None
    start_s: float | None  # None, as the next two: it did not occur
    gesture_end_s: float | None
    end_value_m: float | None
    origin: str = "replay"  # of study.session_file.ORIGINS

    @property
    def is_complete(self) -> bool:
        return None not in (self.start_s, self.gesture_end_s, self.end_value_m)

    @property
    def movement_time_s(self) -> float:
        """Of a complete one."""
        return self.gesture_end_s - self.start_s


def parse(row: dict[str, str]) -> Trial:
    """ValueError names the fault."""
    if row["gesture"] in ("", "none"):
        raise ValueError(f"gesture: '{row['gesture']}' is no gesture's name")
    for column, known in (("position", POSITIONS), ("condition", CONDITIONS)):
        if row[column] not in known:
            raise ValueError(f"{column}: '{row[column]}' is none of {', '.join(filter(None, known))}")
    numbers = {name: number(name, row[name]) for name in NUMBERS}
    lengths = {"amplitude_m": numbers["amplitude_m"] or 0.0, "width_m": numbers["width_m"]}
    for name, length_m in lengths.items():
        if length_m is not None and length_m <= 0.0:
            raise ValueError(f"{name}: '{row[name]}' is no length")
    origin = row.get("origin") or NAMED_AFTER.get(row["trial"].rpartition("_")[0], "replay")
    if origin not in ORIGINS:
        raise ValueError(f"origin: '{origin}' is none of {', '.join(ORIGINS)}")
    trial = Trial(*(row[name] for name in COLUMNS[:5]), **numbers, origin=origin)
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
    if not math.isfinite(value) or "_" in text:
        raise ValueError(f"{column}: '{text}' is no finite number")
    if abs(value) > LARGEST:
        raise ValueError(f"{column}: '{text}' is not within +-{LARGEST:.0f}")
    return value
