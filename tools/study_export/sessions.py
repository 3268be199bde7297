"""Reads the sessions of a study: session.json, trials.csv, answers.csv and events.csv."""

import json
import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from functools import partial
from pathlib import Path

from study.folders import sessions_without_json
from study.logs import set_apart
from study.session_file import differences, part_of
from study_export.columns import ANSWERS, EVENTS, ORIGINS, TRIALS, Column, check, number, time_of
from study_export.tables import Findings, Table, read_table

FORMAT = "steadyhand-session"
VERSION = 1


@dataclass(frozen=True)
class Row:
    """A row of a study file. Cells are as they were written, so that no digit is lost."""

    line: int
    cells: dict[str, str]

    def __getitem__(self, name: str) -> str:
        return self.cells[name]

    def number(self, name: str) -> float | None:
        return number(name, self.cells[name]) if self.cells[name] else None

    def count(self, name: str) -> int | None:
        return int(self.cells[name]) if self.cells[name] else None


@dataclass
class Session:
    folder: Path
    about: dict  # session.json
    trials: list[Row] = field(default_factory=list)
    answers: list[Row] = field(default_factory=list)
    events: list[Row] = field(default_factory=list)

    @property
    def participant(self) -> str:
        return self.about["participant"]

    @property
    def number(self) -> int:
        return self.about["session"]

    @property
    def origin(self) -> str:
        return self.about["origin"]

    def setting(self, name: str) -> str:
        """A text of `settings`; empty: there is none."""
        value = (self.about.get("settings") or {}).get(name)
        return value if isinstance(value, str) else ""

    def version(self, name: str) -> str:
        return str((self.about.get("versions") or {}).get(name) or "")

    @property
    def seed(self) -> str:
        """A large seed may be written as text, because JSON numbers have 53 bits."""
        seed = self.about.get("seed", "")
        return str(int(seed)) if isinstance(seed, float) and seed.is_integer() else str(seed)

    @property
    def started(self) -> str:
        """Local date and time; empty: unknown."""
        try:
            return time_of("started", str(self.about.get("started") or "")).isoformat(timespec="seconds")
        except ValueError:
            return ""

    def local_time(self, run: int, t_s: float) -> datetime | None:
        """Local date and time of a moment on the clock of a run. None: the run's start was not recorded."""
        for event in self.events:
            if event["event"] == "run_started" and event.count("run") == run and event["value"]:
                return time_of("value", event["value"]) + timedelta(seconds=t_s - event.number("t_s"))
        return None


def read_sessions(root: Path, found: Findings) -> list[Session]:
    """Every session in and below the folder, by participant and number. Faults leave a row or a session out."""
    sessions: dict[tuple[str, int], Session] = {}
    if not root.is_dir():
        found.faults.append(f"{root}: no folder is there. Name the folder of the study")
        return []
    for path in sorted(root.rglob("session.json")):
        if apart := set_apart(path, root):
            if (note := f"{apart} is left out: it has a no_study.txt") not in found.notes:
                found.notes.append(note)
            continue
        try:
            session = Session(path.parent, read_about(path))
        except (OSError, ValueError) as fault:
            found.faults.append(f"{path}: {fault}. The session is left out: correct the file")
            continue
        key = (session.participant, session.number)
        if key in sessions:
            found.faults.append(
                f"{path}: participant '{key[0]}', session {key[1]} is also in {sessions[key].folder}."
                " This folder is left out: remove it, or give its session another number"
            )
            continue
        read_rows(session, found)
        sessions[key] = session
    for folder in sessions_without_json([root]):
        found.faults.append(
            f"{folder}: session.json is missing. The session is left out: copy the whole folder of the session"
        )
    in_order = [sessions[key] for key in sorted(sessions)]
    note_differing_protocols(in_order, found)
    return in_order


def note_differing_protocols(sessions: list[Session], found: Findings) -> None:
    protocols = defaultdict(list)
    for session in sessions:
        protocols[str(session.about.get("study")), session.origin].append(part_of(session.about, "protocol"))
    for (study, origin), parts in protocols.items():
        found.notes += [f"study '{study}' ({origin}): sessions differ in protocol {one}" for one in differences(parts)]


def read_about(path: Path) -> dict:
    try:
        about = json.loads(path.read_text(encoding="utf-8"))
    except RecursionError as fault:
        raise ValueError("this JSON is nested too deeply") from fault
    if not isinstance(about, dict) or about.get("format") != FORMAT or about.get("version") != VERSION:
        raise ValueError(f"not of format '{FORMAT}', version {VERSION}")
    if not re.fullmatch("[A-Za-z0-9]{1,32}", str(about.get("participant", ""))):
        raise ValueError(f"participant: '{about.get('participant')}' must be 1 to 32 letters and digits")
    about["participant"] = str(about["participant"])
    session = about.get("session")
    if isinstance(session, bool) or not isinstance(session, int | float) or session != int(session) or session < 1:
        raise ValueError(f"session: '{session}' must be a whole number from 1")
    about["session"] = int(session)  # Godot writes whole numbers as 1.0
    plan = about.setdefault("trials", [])
    if not isinstance(plan, list) or not all(isinstance(trial, dict) and "trial" in trial for trial in plan):
        raise ValueError("trials: must be a list of objects with a key 'trial'")
    if about.get("origin") not in ORIGINS:
        raise ValueError(f"origin: '{about.get('origin')}' is none of {', '.join(ORIGINS)}")
    return about


def read_rows(session: Session, found: Findings) -> None:
    def read(name: str, columns: list[Column]) -> Table[Row]:
        path = session.folder / name
        if not path.exists():  # it is there from the start of a session, with its header line
            found.faults.append(f"{path}: this file is missing. Copy the whole folder of the session")
            return Table()
        return read_table(path, [column.name for column in columns], partial(parse, session, columns), found)

    trials = read("trials.csv", TRIALS)
    session.trials = once_each(session.folder / "trials.csv", trials.rows, found)
    session.answers = read("answers.csv", ANSWERS).rows
    session.events = read("events.csv", EVENTS).rows
    note_repeated_answers(session, found)
    if trials.is_read:
        note_trials_without_row(session, {row.get("trial", "") for row in trials.refused}, found)


def note_trials_without_row(session: Session, refused: set[str], found: Findings) -> None:
    """`refused`: trials whose rows were reported already."""
    done = {trial.count("trial") for trial in session.trials}
    done |= {int(trial) for trial in refused if trial.isdecimal()}
    planned = {int(trial["trial"]) for trial in session.about["trials"]}
    if missing := planned - done:
        found.notes.append(f"{session.folder}: {len(missing)} of {len(planned)} planned trials have no row yet")
    for path in sorted(session.folder.glob("trial_*.motion.csv")):
        if int(re.sub("[^0-9]", "", path.name) or 0) not in done:
            found.notes.append(f"{path} is left out: trials.csv has no row of this trial, which did not finish")


def parse(session: Session, columns: list[Column], cells: dict[str, str], line: int) -> Row:
    check(cells, columns)
    expected = {"participant": session.participant, "session": str(session.number), "origin": session.origin}
    for name, value in expected.items():
        written = cells.get(name, value)
        if (written.lstrip("0") if name == "session" else written) != value:
            raise ValueError(f"{name}: '{written}' differs from '{value}' in session.json")
    if cells.get("event") == "run_started" and cells["value"]:
        time_of("value", cells["value"])
    return Row(line, cells)


def note_repeated_answers(session: Session, found: Findings) -> None:
    first: dict[tuple[str, ...], Row] = {}
    for answer in session.answers:
        earlier = first.setdefault(tuple(answer[name] for name in ("after_trial", "questionnaire", "item")), answer)
        if earlier is not answer:
            found.notes.append(
                f"{session.folder / 'answers.csv'}:{answer.line}: the question '{answer['item']}' after trial"
                f" {answer['after_trial']} is already in line {earlier.line}: both rows are exported"
            )


def once_each(path: Path, trials: Iterable[Row], found: Findings) -> list[Row]:
    first: dict[int, Row] = {}
    for trial in trials:
        earlier = first.setdefault(trial.count("trial"), trial)
        if earlier is not trial:
            found.faults.append(
                f"{path}:{trial.line}: trial {trial['trial']} is already in line {earlier.line}."
                " This row is left out: delete one of the two"
            )
    return [first[trial] for trial in sorted(first)]
