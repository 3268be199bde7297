"""The demo's logs, trials.csv of each session, as docs/study_logs.md has them."""

import csv
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from study.rows import COLUMNS, TASKS, Trial, parse

FILE_NAME = "trials.csv"
# What is in and below a folder with a file of this name is not of the study.
NO_STUDY = "no_study.txt"
# Of a trial set, which is a trials.csv too.
SET_COLUMNS = {"start_x", "axis_x", "subject"}

# Origins whose trials are the same in each session.
PLAYED = ["synthetic", "replay"]


@dataclass
class Line:
    number: int
    cells: list[str] = field(default_factory=list)
    fault: str = ""  # why it has none

    def row(self, header: list[str]) -> dict[str, str]:
        """ValueError says what is wrong."""
        if self.fault or len(self.cells) != len(header):
            raise ValueError(self.fault or f"{len(self.cells)} cells, the header has {len(header)}")
        return dict(zip(header, self.cells, strict=True))


@dataclass
class Logs:
    trials: list[Trial] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)  # each names its file, and the line if it is one
    notes: list[str] = field(default_factory=list)  # what is no fault, and worth to be told
    # Where each trial was read, FILE:LINE. One that is there twice is so to the last digit; without a start it may be
    # another session's: the file is part of its key.
    read: dict[tuple[Trial, Path | None], str] = field(default_factory=dict)


def read_logs(given: list[Path]) -> Logs:
    """Every trials.csv in or below the folders given, each once. What cannot be read is a fault; the rest goes on."""
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
    tell_own_gestures(logs)
    return logs


def set_apart(file: Path, given: Path) -> Path | None:
    """The folder below the one given that says that what is in it is not of the study."""
    between = [folder for folder in file.parents if folder != given and folder.is_relative_to(given)]
    return next((folder for folder in between if (folder / NO_STUDY).exists()), None)


def read_file(path: Path, is_named: bool, logs: Logs) -> None:
    """Its trials in their order, and what is wrong with a line: the others go on."""
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
    # As spreadsheets write it where numbers have a decimal comma, and as they copy it.
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
        told = logs.faults if is_fault else logs.notes
        told.append(f"{path}:{number}: the row of {first} again{others}: counted once")


def read_lines(path: Path) -> Iterator[Line]:
    """Those that are not empty. No cell has a line break: a quote that stays open takes no other line with it."""
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


def tell_own_gestures(logs: Logs) -> None:
    """A gesture may be one's own, and one of the demo's that is misspelt."""
    for (trial, _), place in logs.read.items():
        note = f"'{trial.gesture}' is none of the demo's tasks, {', '.join(TASKS)}; the first is in "
        if trial.gesture not in TASKS and not any(told.startswith(note) for told in logs.notes):
            logs.notes.append(note + place)
