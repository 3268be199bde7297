"""The columns of a study's files, as docs/study_files.md defines them."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime

CURVES = ["measured", "average", "synthesised"]  # curves that have results
CONDITIONS = ["measured", "average", "one_euro", "kalman", "synthesised"]
ORIGINS = ["person", "mouse", "synthetic", "replay"]
JOINTS = ["thumb", "index", "middle", "ring", "pinky", "palm", "wrist"]

TEXT, COUNT, NUMBER, FLAG, TIME = "text", "count", "number", "flag", "time"


@dataclass(frozen=True)
class Column:
    name: str
    unit: str  # empty: none
    kind: str
    meaning: str
    may_be_empty: bool = True
    levels: tuple[str, ...] = ()  # allowed values; empty: any

    def check(self, text: str) -> None:
        """Raises ValueError with the reason if the cell is wrong."""
        if not text:
            if not self.may_be_empty:
                raise ValueError(f"{self.name}: the cell is empty, it needs a value")
        elif self.levels and text not in self.levels:
            raise ValueError(f"{self.name}: '{text}' is none of {', '.join(self.levels)}")
        elif self.kind == COUNT:
            if not (text.isascii() and text.isdigit()):
                raise ValueError(f"{self.name}: '{text}' is no whole number from 0")
        elif self.kind == NUMBER:
            number(self.name, text)
        elif self.kind == TIME:
            time_of(self.name, text)


def number(name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or "_" in text:
        raise ValueError(f"{name}: '{text}' is no finite number")
    return value


def time_of(name: str, text: str) -> datetime:
    """Local time: a time zone in the text is ignored."""
    try:
        return datetime.fromisoformat(text).replace(tzinfo=None)
    except ValueError:
        raise ValueError(f"{name}: '{text}' is no ISO 8601 date and time, as 2026-11-28T14:03:59") from None


def check(cells: dict[str, str], columns: Iterable[Column]) -> None:
    for column in columns:
        column.check(cells[column.name])


FLAGS = ("0", "1")
ORIGIN = Column("origin", "", TEXT, "who made the trials", False, tuple(ORIGINS))
PARTICIPANT = Column("participant", "", TEXT, "id of the participant", False)
SESSION = Column("session", "", COUNT, "number of the session", False)
RUN = Column("run", "", COUNT, "how often the session was started; times of one run are on one clock", False)
TRIAL = Column("trial", "", COUNT, "number of the trial in the session's plan", False)

TRIALS = [
    TRIAL,
    Column("block", "", COUNT, "number of the block", False),
    Column("repetition", "", COUNT, "number of the repetition", False),
    RUN,
    PARTICIPANT,
    SESSION,
    ORIGIN,
    Column("practice", "", FLAG, "1: a practice trial, which no analysis counts", False, FLAGS),
    Column("gesture", "", TEXT, "the gesture that the trial asked for", False),
    Column("position", "", TEXT, "position of the hand before the tracker"),
    Column("condition", "", TEXT, "the motion that drove the vibration and the scene", False, tuple(CONDITIONS)),
    Column("amplitude_m", "m", NUMBER, "amplitude of the task"),
    Column("width_m", "m", NUMBER, "width of the target"),
    Column("shown_s", "s", NUMBER, "when the target was shown, on the run's clock"),
    Column("onset_s", "s", NUMBER, "start of the gesture as recognised, on the run's clock; empty: it never came"),
    Column("end_s", "s", NUMBER, "end of the gesture as recognised, on the run's clock; empty: it never came"),
    Column("recognised", "", TEXT, "the gesture that ended; empty: none"),
    Column("aborts", "", COUNT, "aborted gestures in the trial"),
    Column("losses", "", COUNT, "losses of tracking in the trial"),
    Column("end_value_m", "m", NUMBER, "how far the motion was at end_s"),
    Column(
        "reference",
        "",
        TEXT,
        "sensor: a reference tracker; truth: a simulated hand's own motion; empty: none",
        levels=("sensor", "truth"),
    ),
    *(
        Column(f"{name}_{curve}", unit, NUMBER, f"{meaning}, of the curve '{curve}'")
        for curve in CURVES
        for name, unit, meaning in (
            ("r2", "", "R^2 against the reference at the lag that fits best"),
            ("r2_zero", "", "zero-lag R^2 against the reference"),
            ("lag", "s", "that lag; positive: the curve is late"),
            ("t_diff", "s", "end of the reference minus end of the curve; positive: the curve ends early"),
        )
    ),
    Column("finished", "", TIME, "when the trial was finished, local date and time", False),
]

ANSWERS = [
    PARTICIPANT,
    SESSION,
    ORIGIN,
    RUN,
    Column("after_trial", "", COUNT, "the trial before the questionnaire", False),
    Column("gesture", "", TEXT, "gesture of that trial"),
    Column("position", "", TEXT, "position of that trial"),
    Column("condition", "", TEXT, "condition of that trial"),
    Column("questionnaire", "", TEXT, "name of the questionnaire", False),
    Column("item", "", TEXT, "name of the question", False),
    Column("text", "", TEXT, "the statement as it was shown"),
    Column("value", "", TEXT, "the answer; empty if it was skipped"),
    Column("minimum", "", NUMBER, "lowest value of the scale"),
    Column("maximum", "", NUMBER, "highest value of the scale"),
    Column("skipped", "", FLAG, "1: the participant left the question out", levels=FLAGS),
    Column("changes", "", COUNT, "how often the answer was changed before it was confirmed"),
    Column("shown_s", "s", NUMBER, "when the question was shown, on the run's clock"),
    Column("answered_s", "s", NUMBER, "when it was answered, on the run's clock"),
]

EVENTS = [
    Column("t_s", "s", NUMBER, "time of the event, on the run's clock", False),
    RUN,
    Column("trial", "", COUNT, "number of the trial; empty: outside of trials"),
    Column("event", "", TEXT, "kind of the event", False),
    Column("value", "", TEXT, "value of the event"),
]

MOTION = [
    Column("t", "s", NUMBER, "time on the run's clock", False),
    *(Column(name, "m", NUMBER, f"motion in the condition '{name}'") for name in CONDITIONS),
    Column("reference", "m", NUMBER, "motion by the reference; empty: none"),
    Column("state", "", NUMBER, "hidden state of the motion model; -1: none"),
    Column("progress", "", NUMBER, "progress of the gesture, 0 to 1"),
    Column("vibration", "", NUMBER, "amplitude of the vibration, 0 to 1"),
]
