"""Rows of a session's trials.csv and answers.csv (docs/study_files.md)."""

from dataclasses import dataclass

from study.rows import CONDITIONS, POSITIONS, number
from study.session_file import Session

CURVES = ["measured", "average", "synthesised"]
FIGURES = ["r2", "r2_zero", "lag", "t_diff"]
TRIAL_COLUMNS = [
    *("trial", "block", "repetition", "run", "participant", "session", "origin", "practice"),
    *("gesture", "position", "condition", "amplitude_m", "width_m", "shown_s", "onset_s", "end_s"),
    *("recognised", "aborts", "losses", "end_value_m", "reference"),
    *(f"{figure}_{curve}" for figure in FIGURES for curve in CURVES),
    "finished",
]
ANSWER_COLUMNS = [
    *("participant", "session", "origin", "run", "after_trial", "gesture", "position", "condition"),
    *("questionnaire", "item", "text", "value", "minimum", "maximum", "skipped", "changes", "shown_s", "answered_s"),
]
REFERENCES = ["sensor", "truth", ""]


@dataclass(frozen=True)
class StudyTrial:
    session: Session
    trial: int
    practice: bool
    gesture: str
    position: str
    condition: str
    amplitude_m: float
    width_m: float | None
    onset_s: float | None
    end_s: float | None
    recognised: str
    aborts: int
    losses: int
    end_value_m: float | None
    reference: str
    figures: dict[str, float | None]  # r2_measured and so on

    @property
    def key(self) -> tuple:
        return (self.session.study, self.session.origin, self.session.participant, self.session.number, self.trial)

    @property
    def is_recognised(self) -> bool:
        """The paper counts R2 and T_diff of these trials alone."""
        return self.recognised == self.gesture


@dataclass(frozen=True)
class Answer:
    session: Session
    after_trial: int
    gesture: str
    position: str
    condition: str
    questionnaire: str
    item: str
    text: str
    value: float | None  # None: skipped
    minimum: float
    maximum: float

    @property
    def key(self) -> tuple:
        person = (self.session.study, self.session.origin, self.session.participant, self.session.number)
        return (*person, self.after_trial, self.questionnaire, self.item)


def parse_trial(session: Session, row: dict[str, str]) -> StudyTrial:
    """ValueError names the fault."""
    check_owner(session, row)
    trial = integer(row, "trial", 1)
    practice = one_of(row, "practice", ["0", "1"]) == "1"
    check_plan(session, trial, row, practice)
    if row["gesture"] in ("", "none"):
        raise ValueError(f"gesture: '{row['gesture']}' is no gesture's name")
    amplitude_m, width_m = number("amplitude_m", row["amplitude_m"]), number("width_m", row["width_m"])
    if amplitude_m is None or amplitude_m <= 0.0:
        raise ValueError(f"amplitude_m: '{row['amplitude_m']}' must be above 0")
    if width_m is not None and width_m <= 0.0:
        raise ValueError(f"width_m: '{row['width_m']}' must be above 0, or empty")
    onset_s, end_s = number("onset_s", row["onset_s"]), number("end_s", row["end_s"])
    if onset_s is not None and end_s is not None and end_s <= onset_s:
        raise ValueError(f"end_s: {row['end_s']} must be after onset_s {row['onset_s']}")
    figures = {name: number(name, row[name]) for name in TRIAL_COLUMNS if name.split("_")[0] in ("r2", "lag", "t")}
    for name, value in figures.items():
        if name.startswith("r2") and value is not None and value > 1.0 + 1e-9:
            raise ValueError(f"{name}: {row[name]} must be 1 or less")
    return StudyTrial(
        session,
        trial,
        practice,
        row["gesture"],
        one_of(row, "position", POSITIONS),
        one_of(row, "condition", CONDITIONS),
        amplitude_m,
        width_m,
        onset_s,
        end_s,
        row["recognised"],
        integer(row, "aborts", 0),
        integer(row, "losses", 0),
        number("end_value_m", row["end_value_m"]),
        one_of(row, "reference", REFERENCES),
        figures,
    )


def parse_answer(session: Session, row: dict[str, str]) -> Answer:
    """ValueError names the fault."""
    check_owner(session, row)
    for column in ("questionnaire", "item"):
        if not row[column]:
            raise ValueError(f"{column}: must not be empty")
    value, minimum, maximum = (number(column, row[column]) for column in ("value", "minimum", "maximum"))
    if minimum is None or maximum is None or minimum >= maximum:
        raise ValueError(f"minimum '{row['minimum']}' must be below maximum '{row['maximum']}'")
    if value is not None and not minimum <= value <= maximum:
        raise ValueError(f"value: {row['value']} must be from {row['minimum']} to {row['maximum']}")
    return Answer(
        session,
        integer(row, "after_trial", 0),
        row["gesture"],
        one_of(row, "position", POSITIONS),
        one_of(row, "condition", ["", *CONDITIONS]),
        row["questionnaire"],
        row["item"],
        row["text"],
        value,
        minimum,
        maximum,
    )


def check_owner(session: Session, row: dict[str, str]) -> None:
    """A row that was copied from another session must not count here."""
    for column, wanted in (("participant", session.participant), ("origin", session.origin)):
        if row[column] != wanted:
            raise ValueError(f"{column}: '{row[column]}' must be '{wanted}', as in session.json")
    if integer(row, "session", 1) != session.number:
        raise ValueError(f"session: '{row['session']}' must be {session.number}, as in session.json")


def check_plan(session: Session, trial: int, row: dict[str, str], practice: bool) -> None:
    if trial not in session.plan:
        raise ValueError(f"trial: {trial} is not in the plan of session.json")
    planned = session.plan[trial]
    for column in ("gesture", "position", "condition"):
        wanted = getattr(planned, column)
        if row[column] != wanted:
            raise ValueError(f"{column}: '{row[column]}' must be '{wanted}', as planned in session.json")
    if practice != planned.practice:
        raise ValueError(f"practice: {row['practice']} must be {int(planned.practice)}, as planned in session.json")


def one_of(row: dict[str, str], column: str, known: list[str]) -> str:
    if row[column] not in known:
        raise ValueError(f"{column}: '{row[column]}' must be one of {', '.join(filter(None, known))}")
    return row[column]


def integer(row: dict[str, str], column: str, least: int) -> int:
    value = number(column, row[column])
    if value is None or value != int(value) or value < least:
        raise ValueError(f"{column}: '{row[column]}' must be a whole number from {least}")
    return int(value)
