"""The demo's logs, trials.csv of each session, as docs/study_logs.md has them."""

import csv
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from study.rows import COLUMNS, TASKS, Trial, parse

FILE_NAME = "trials.csv"
# A folder with a file of this name is no part of the study.
NO_STUDY = "no_study.txt"
# A column of trial sets, whose table is named trials.csv, too.
SET_COLUMNS = {"start_x", "axis_x", "subject"}

# Origins whose trials are the same in each session.
PLAYED = ["synthetic", "replay"]


@dataclass
class Line:
    number: int
    cells: list[str] = field(default_factory=list)
    fault: str = ""  # why it has no cells

    def row(self, header: list[str]) -> dict[str, str]:
        """ValueError names the fault."""
        if self.fault or len(self.cells) != len(header):
            raise ValueError(self.fault or f"{len(self.cells)} cells, the header has {len(header)}")
        return dict(zip(header, self.cells, strict=True))


@dataclass
class Logs:
    trials: list[Trial] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)  # each names its file, and the line if it is one
    notes: list[str] = field(default_factory=list)  # notes that are no faults
    # FILE:LINE of each trial. Equal rows are the same trial. Without a start time they may be of two sessions: the file
    # is part of the key.
    read: dict[tuple[Trial, Path | None], str] = field(default_factory=dict)


def read_logs(given: list[Path]) -> Logs:
    """Every trials.csv in or below the given folders, each once. An unreadable file is a fault; the others are read."""
    logs = Logs()
    files: dict[Path, tuple[Path, bool]] = {}
    for path in given:
        found = sorted(path.rglob(FILE_NAME)) if path.is_dir() else [path] if path.is_file() else []
        if not found:
            logs.faults.append(f"{path}: no {FILE_NAME} in it" if path.is_dir() else f"{path}: not there")
        for file in found:
            if not (apart := set_apart(file, path)):
                files.setdefault(file.resolve(), (file, file == path))
            elif (note := f"{apart} is left out: it has a {NO_STUDY}") not in logs.notes:
                logs.notes.append(note)
    for file, is_named in files.values():
        read_file(file, is_named, logs)
    note_custom_gestures(logs)
    return logs


def set_apart(file: Path, given: Path) -> Path | None:
    """The folder below the given one that is marked as no part of the study."""
    between = [folder for folder in file.parents if folder != given and folder.is_relative_to(given)]
    return next((folder for folder in between if (folder / NO_STUDY).exists()), None)


def read_file(path: Path, is_named: bool, logs: Logs) -> None:
    """Reads its trials in order. A bad line is a fault; the others are read."""
    try:
        lines = list(read_lines(path))
    except OSError as fault:
        logs.faults.append(f"{path}: {fault.strerror or fault}")
        return
    header, fault = (lines[0].cells, lines[0].fault) if lines else ([], "")
    fault = fault or header_fault(header, COLUMNS)
    if fault and not is_named and set(header) >= SET_COLUMNS:
        logs.notes.append(f"{path} is left out: it is a trial set's, no log")
        return
    if fault:
        logs.faults.append(f"{path}:1: {fault}")
    else:
        read_rows(path, header, lines[1:], logs)


def header_fault(header: list[str], columns: list[str]) -> str:
    """Why a table cannot be read. Empty: it has all columns."""
    if not header:
        return "no header line"
    # Spreadsheets write ';' if numbers have a decimal comma, and copy with tabs.
    for mark, name in ((";", "';'"), ("\t", "tabs")):
        if len(header) == 1 and mark in header[0]:
            return f"cells are separated by {name}: they must be by ',', and numbers have a '.'"
    missing = [name for name in columns if name not in header]
    return f"no column {', '.join(missing)}" if missing else ""


def read_rows(path: Path, header: list[str], lines: list[Line], logs: Logs) -> None:
    again: dict[
        tuple[str, bool], list[tuple[int, str]]
    ] = {}  # by the file that has the same rows, and if it is a fault
    for line in lines:
        place = f"{path}:{line.number}"
        try:
            trial = parse(line.row(header))
        except ValueError as fault:
            logs.faults.append(f"{place}: {fault}")
            continue
        first = logs.read.setdefault((trial, None if trial.start_s is not None else path), place)
        if first == place:
            logs.trials.append(trial)
        else:
            other = first.rpartition(":")[0]
            # A trial that is played in two sessions gives equal rows. A person makes none twice.
            is_played = trial.origin in PLAYED and other != str(path)
            again.setdefault((other, not is_played), []).append((line.number, first))
    for (_, is_fault), rows in again.items():
        number, first = rows[0]
        others = f", and {len(rows) - 1} more rows of these files" if len(rows) > 1 else ""
        found = logs.faults if is_fault else logs.notes
        found.append(f"{path}:{number}: the same row as {first}{others}: counted once")


def read_lines(path: Path) -> Iterator[Line]:
    """Lines that are not empty. Cells have no line breaks: an open quote affects only its own line."""
    for number, line in enumerate(path.read_bytes().splitlines(), start=1):
        try:
            text = line.decode("utf-8-sig" if number == 1 else "utf-8")
            if cells := next(csv.reader([text], strict=True), []):
                yield Line(number, cells)
        except UnicodeDecodeError:
            yield Line(number, fault="this is no UTF-8 text")
        except csv.Error:
            is_open = text.count('"') % 2 == 1
            what = "a quote is opened in this line, and not closed" if is_open else "text after a cell's closing quote"
            yield Line(number, fault=what)


def note_custom_gestures(logs: Logs) -> None:
    """Notes unknown gestures: custom ones, or misspelt ones of the demo."""
    for (trial, _), place in logs.read.items():
        note = f"'{trial.gesture}' is none of the demo's tasks, {', '.join(TASKS)}; the first is in "
        if trial.gesture not in TASKS and not any(one.startswith(note) for one in logs.notes):
            logs.notes.append(note + place)
