"""Reads all sessions of a study, and names every row that it leaves out."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from study.folders import SESSION_FILE, session_files, sessions_without_json
from study.logs import header_fault, read_lines
from study.session_file import Session, read_session
from study.session_rows import ANSWER_COLUMNS, TRIAL_COLUMNS, Answer, StudyTrial, parse_answer, parse_trial


@dataclass
class Sessions:
    sessions: list[Session] = field(default_factory=list)
    trials: list[StudyTrial] = field(default_factory=list)
    answers: list[Answer] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)  # each names its file, and the line if there is one
    notes: list[str] = field(default_factory=list)
    places: dict[tuple, str] = field(default_factory=dict)  # FILE:LINE of each trial and answer, by its key


def read_sessions(given: list[Path], without: list[str]) -> Sessions:
    """A row that cannot be used is a fault; the other rows count."""
    read = Sessions()
    read.faults += [f"{path}: this folder does not exist" for path in given if not path.is_dir()]
    for folder in sessions_without_json(given):
        read.faults.append(f"{folder}: {SESSION_FILE} is missing: copy the whole folder of the session")
    left_out = set()
    for path in session_files(given):
        try:
            session = read_session(path)
        except ValueError as fault:
            read.faults.append(str(fault))
            continue
        if session.participant in without:
            left_out.add(session.participant)
            continue
        read.sessions.append(session)
        read_table(read, session, "trials.csv", TRIAL_COLUMNS, parse_trial, read.trials)
        read_table(read, session, "answers.csv", ANSWER_COLUMNS, parse_answer, read.answers)
    read.faults += [f"--without {one}: no session is of this participant" for one in without if one not in left_out]
    read.notes += [f"participant {one} is left out, as --without says" for one in sorted(left_out)]
    note_missing_trials(read)
    note_similar_names(read)
    return read


def read_table(
    read: Sessions, session: Session, name: str, columns: list[str], parse: Callable, into: list[StudyTrial | Answer]
) -> None:
    path = session.folder / name
    if not path.exists():  # it is there from the start of a session, with its header line
        read.faults.append(f"{path}: this file is missing: copy the whole folder of the session")
        return
    try:
        lines = list(read_lines(path))
        is_cut = not path.read_bytes().endswith(b"\n")
    except OSError as fault:
        read.faults.append(f"{path}: {fault.strerror or fault}")
        return
    header = lines[0].cells if lines else []
    if problem := (lines[0].fault if lines else "") or header_fault(header, columns):
        read.faults.append(f"{path}:1: {problem}: see docs/study_files.md")
        return
    doubles: dict[str, list[tuple[int, str]]] = {}
    for line in lines[1:]:
        place = f"{path}:{line.number}"
        if is_cut and line is lines[-1]:
            read.faults.append(f"{place}: the line is cut (it has no line end): the row is left out")
            continue
        try:
            row = parse(session, line.row(header))
        except ValueError as fault:
            read.faults.append(f"{place}: {fault}: the row is left out")
            continue
        first = read.places.setdefault(row.key, place)
        if first == place:
            into.append(row)
        else:
            doubles.setdefault(first.rpartition(":")[0], []).append((line.number, first))
    for rows in doubles.values():
        number, first = rows[0]
        others = f", and {len(rows) - 1} more rows of these files" if len(rows) > 1 else ""
        read.faults.append(
            f"{path}:{number}: the same participant, session and trial as {first}{others}: the first counts;"
            " remove the copy, or give the session its own number"
        )


def note_missing_trials(read: Sessions) -> None:
    rows = Counter((trial.session.folder, trial.practice) for trial in read.trials)
    for session in read.sessions:
        for practice in (False, True):
            planned = sum(one.practice == practice for one in session.plan.values())
            missing = planned - rows[(session.folder, practice)]
            if missing > 0:
                kind = "practice trials" if practice else "trials"
                read.notes.append(f"{session.folder}: {missing} of {planned} planned {kind} have no row")


def note_similar_names(read: Sessions) -> None:
    names: dict[str, set[str]] = {}
    for session in read.sessions:
        names.setdefault(session.participant.lower(), set()).add(session.participant)
    for alike in names.values():
        if len(alike) > 1:
            text = " and ".join(f"'{name}'" for name in sorted(alike))
            read.notes.append(
                f"participants {text} differ only in upper and lower case: they are {len(alike)} people here"
            )
