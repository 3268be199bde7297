"""The tidy tables: a row for each trial and curve, and a row for each answer, for R and pandas."""

import csv
from collections.abc import Iterable, Iterator
from pathlib import Path

from study_export.columns import ANSWERS, COUNT, CURVES, FLAG, FLAGS, NUMBER, TEXT, TRIALS, Column
from study_export.sessions import Row, Session
from whole_file import whole

STUDY = Column("study", "", TEXT, "name of the study")
BY_NAME = {column.name: column for column in TRIALS}
OF_TRIAL = [
    "participant",
    "session",
    "origin",
    "run",
    "trial",
    "block",
    "repetition",
    "practice",
    "gesture",
    "position",
]
OF_TASK = ["condition", "amplitude_m", "width_m", "shown_s", "onset_s", "end_s"]
OF_RESULT = ["aborts", "losses", "end_value_m", "reference"]

TIDY = [
    STUDY,
    *(BY_NAME[name] for name in OF_TRIAL + OF_TASK),
    Column("reaction_time_s", "s", NUMBER, "onset_s - shown_s"),
    Column("movement_time_s", "s", NUMBER, "end_s - onset_s"),
    Column("recognised", "", FLAG, "1: the gesture that ended is the one that the trial asked for; 0: another or none"),
    Column("recognised_gesture", "", TEXT, "the gesture that ended; empty: none"),
    *(BY_NAME[name] for name in OF_RESULT),
    Column("curve", "", TEXT, "the motion that the next columns are about: " + ", ".join(CURVES)),
    Column("drives", "", FLAG, "1: this curve drove the vibration and the scene (curve equals condition)"),
    Column("r2", "", NUMBER, "R^2 of the curve against the reference at the lag that fits best"),
    Column("r2_zero", "", NUMBER, "zero-lag R^2 of the curve against the reference"),
    Column("lag_s", "s", NUMBER, "that lag; positive: the curve is late"),
    Column("t_diff_s", "s", NUMBER, "end of the reference minus end of the curve; positive: the curve ends early"),
    BY_NAME["finished"],
]
TIDY_ANSWERS = [
    STUDY,
    *ANSWERS[:4],
    Column("practice", "", FLAG, "1: the trial before was a practice trial; empty: it has no row"),
    *ANSWERS[4:],
]
CODEBOOK = ["file", "column", "unit", "type", "values", "meaning"]
TYPES = {COUNT: "whole number", NUMBER: "number", FLAG: "0 or 1"}


def beside(out: Path, ending: str) -> Path:
    """study.csv: study_answers.csv."""
    return out.with_name(f"{out.stem}_{ending}.csv")


def write_tidy(sessions: list[Session], out: Path) -> list[Path]:
    """The files that it wrote. ValueError: it would replace a file of another kind. OSError: one cannot be written."""
    if out.suffix != ".csv":
        raise ValueError(f"--tidy {out}: the name of a table ends in .csv")
    answers = beside(out, "answers")
    columns = {out: TIDY, answers: TIDY_ANSWERS}
    files = {
        out: (names(TIDY), trial_rows(sessions)),
        answers: (names(TIDY_ANSWERS), answer_rows(sessions)),
        beside(out, "codebook"): (CODEBOOK, codebook_rows(columns)),
    }
    for path, (header, _) in files.items():
        refuse_foreign(path, header)
    out.parent.mkdir(parents=True, exist_ok=True)
    for path, (header, rows) in files.items():
        write(path, header, rows)
    return list(files)


def names(columns: list[Column]) -> list[str]:
    return [column.name for column in columns]


def refuse_foreign(path: Path, header: list[str]) -> None:
    """A wrong name must not replace the raw data of a participant: only an earlier table may be replaced."""
    if path.is_dir():
        raise ValueError(f"{path}: this is a folder. Name a file in it")
    if not path.exists():
        return
    with path.open("rb") as file:
        first = file.readline().strip()
    if first != ",".join(header).encode():
        raise ValueError(f"{path}: this file is no earlier export. Name another file")


def codebook_rows(columns: dict[Path, list[Column]]) -> Iterator[list[str]]:
    for path, of in columns.items():
        for column in of:
            kind = TYPES.get(column.kind, column.kind)
            yield [path.name, column.name, column.unit, kind, values(column), column.meaning]


def values(column: Column) -> str:
    """The allowed values; empty: any."""
    return " ".join(FLAGS if column.kind == FLAG else column.levels)


def write(path: Path, header: list[str], rows: Iterable[list[str]]) -> None:
    with whole(path) as part, part.open("w", encoding="utf-8", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(header)
        lines.writerows(rows)


def trial_rows(sessions: list[Session]) -> Iterator[list[str]]:
    for session in sessions:
        for trial in session.trials:
            shared = trial_cells(session, trial)
            for curve in CURVES:
                cells = {
                    **shared,
                    "curve": curve,
                    "drives": str(int(curve == trial["condition"])),
                    "r2": trial[f"r2_{curve}"],
                    "r2_zero": trial[f"r2_zero_{curve}"],
                    "lag_s": trial[f"lag_{curve}"],
                    "t_diff_s": trial[f"t_diff_{curve}"],
                }
                yield [cells[column.name] for column in TIDY]


def trial_cells(session: Session, trial: Row) -> dict[str, str]:
    return {
        **trial.cells,
        "study": str(session.about.get("study") or ""),
        "reaction_time_s": difference(trial, "shown_s", "onset_s"),
        "movement_time_s": difference(trial, "onset_s", "end_s"),
        "recognised": str(int(trial["recognised"] == trial["gesture"])),
        "recognised_gesture": trial["recognised"],
    }


def difference(trial: Row, begin: str, end: str) -> str:
    """Empty: one of the two never came."""
    values = trial.number(begin), trial.number(end)
    return "" if None in values else f"{values[1] - values[0]:.6f}"


def answer_rows(sessions: list[Session]) -> Iterator[list[str]]:
    for session in sessions:
        practice = {trial.count("trial"): trial["practice"] for trial in session.trials}
        for answer in session.answers:
            cells = {
                **answer.cells,
                "study": str(session.about.get("study") or ""),
                "practice": practice.get(answer.count("after_trial"), ""),
            }
            yield [cells[column.name] for column in TIDY_ANSWERS]
