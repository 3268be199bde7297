"""Rows that ./steadyhand study leaves out and reports: repeated trials, cut rows, bad values."""

import json
import shutil
from collections.abc import Iterator
from pathlib import Path

from suites.made_up_sessions import write_study
from suites.outcome import Outcome
from suites.study_folders import SMALL, read, report, rewrite


def doubles(folder: Path) -> Iterator[Outcome]:
    write_study(folder / "study", 3, **SMALL)
    report(folder / "study", folder / "first")
    path = folder / "study/drags/sub-p02/ses-01/trials.csv"
    lines = path.read_text().splitlines(keepends=True)
    path.write_text("".join([*lines, lines[3]]))
    status, output = report(folder / "study", folder / "second")
    message = f"{path}:{len(lines) + 1}: the same participant, session and trial as {path}:4: the first counts"
    yield Outcome.of(
        "command/study report: a repeated trial is reported, exit 1", status == 1 and message in output, output
    )
    name = "drags_synthetic_curves.csv"
    good = (folder / "first" / name).read_bytes() == (folder / "second" / name).read_bytes()
    yield Outcome.of("command/study report: a repeated trial counts once", good)
    path.write_text("".join(lines))
    copy = folder / "study/copy/sub-p02/ses-01"
    shutil.copytree(path.parent, copy)
    status, output = report(folder / "study", folder / "third")
    more = f"{len(lines) - 2} more rows of these files: the first counts"
    good = status == 1 and output.count("the same participant, session and trial") == 2 and more in output
    yield Outcome.of("command/study report: a copied session is named once a file", good, output)


def cut_rows(folder: Path) -> Iterator[Outcome]:
    write_study(folder / "study", 3, **SMALL)
    path = folder / "study/drags/sub-p03/ses-01/trials.csv"
    text = path.read_text()
    last = text.count("\n")
    # Cut after 40 letters of the row, and within its last cell.
    for length in (len(text) - 200, len(text) - 1):
        path.write_text(text[:length])
        status, output = report(folder / "study", folder / "out")
        line = path.read_text().count("\n") + 1
        message = f"{path}:{line}: the line is cut (it has no line end): the row is left out"
        good = status == 1 and message in output and line == last and "1 of 12 planned trials have no row" in output
        yield Outcome.of(f"command/study report: a row cut at {length - len(text)} is left out", good, output)
    path.write_text("".join(text.splitlines(keepends=True)[:-2]))
    status, output = report(folder / "study", folder / "out")
    good = status == 0 and f"{path.parent}: 2 of 12 planned trials have no row" in output
    yield Outcome.of("command/study report: an unfinished session is a note, exit 0", good, f"{status}\n{output}")


def bad_rows(folder: Path) -> Iterator[Outcome]:
    """Each bad row is reported with its line; the other rows count."""
    write_study(folder / "study", 3, **SMALL)
    path = folder / "study/drags/sub-p01/ses-01/trials.csv"
    answers = path.with_name("answers.csv")
    changes = [
        ("r2_measured", "nan", "r2_measured: 'nan' is no finite number"),
        ("r2_average", "1.5", "r2_average: 1.5 must be 1 or less"),
        ("participant", "p02", "participant: 'p02' must be 'p01', as in session.json"),
        ("session", "2", "session: '2' must be 1, as in session.json"),
        ("trial", "99", "trial: 99 is not in the plan of session.json"),
        ("practice", "1", "practice: 1 must be 0, as planned in session.json"),
        ("position", "odd", "position: 'odd' must be 'stable', as planned in session.json"),
        ("end_s", "0.5", "end_s: 0.5 must be after onset_s"),
        ("amplitude_m", "0", "amplitude_m: '0' must be above 0"),
        ("reference", "film", "reference: 'film' must be one of sensor, truth"),
        ("aborts", "1.5", "aborts: '1.5' must be a whole number from 0"),
    ]
    good_rows = read(path)
    for column, value, message in changes:
        rows = [dict(row) for row in good_rows]
        rows[2][column] = value
        rewrite(path, rows)
        from study.sessions import read_sessions

        found = read_sessions([folder / "study"], [])
        good = len(found.faults) == 1 and f"{path}:4: {message}" in found.faults[0] and len(found.trials) == 41
        yield Outcome.of(f"command/study report: bad row: {message}", good, f"{found.faults}")
    rewrite(path, good_rows)
    text = path.read_text()
    for change, message in ((text.replace(",", ";"), "cells are separated by ';'"), ("", "no header line")):
        path.write_text(change)
        faults = read_sessions([folder / "study"], []).faults
        good = len(faults) == 1 and faults[0].startswith(f"{path}:1: {message}")
        yield Outcome.of(f"command/study report: bad table: {message}", good, f"{faults}")
    path.write_text(text)
    rows = read(answers)
    rows[0]["value"] = "7"
    rewrite(answers, rows)
    found = read_sessions([folder / "study"], [])
    good = found.faults == [f"{answers}:2: value: 7 must be from 0 to 4: the row is left out"]
    yield Outcome.of("command/study report: an answer beyond its scale is left out", good, f"{found.faults}")


def differing_protocols(folder: Path) -> Iterator[Outcome]:
    write_study(folder / "study", 3, **SMALL)
    path = folder / "study/drags/sub-p02/ses-01/session.json"
    data = json.loads(path.read_text())
    data["protocol"] |= {"seed": 9.0, "questionnaires": [{"text": "long" * 20}]}
    path.write_text(json.dumps(data))
    report(folder / "study", folder / "out")
    page = (folder / "out/report.html").read_text()
    notes = ["Sessions differ in protocol seed: 9, none.", "Sessions differ in protocol questionnaires."]
    good = all(note in page for note in notes) and page.count("Sessions differ") == len(notes)
    yield Outcome.of("command/study report: the page names what differs between protocols", good, page[:2000])


def bad_session_files(folder: Path) -> Iterator[Outcome]:
    write_study(folder / "study", 4, **SMALL)
    path = folder / "study/drags/sub-p04/ses-01/session.json"
    data = json.loads(path.read_text())
    for text, message in (
        ("{\n", ":2: this is not JSON"),
        ("[" * 100_000, ": this JSON is nested too deeply"),
        (json.dumps(data | {"version": 2}), ': "version" must be 1, is 2'),
        (json.dumps(data | {"origin": "robot"}), ': "origin" must be one of person, mouse, synthetic, replay'),
        (json.dumps(data | {"participant": "a b"}), ': "participant" must be 1 to 32 letters and digits'),
        (json.dumps(data | {"trials": [{"trial": 1}]}), ': "trials", object 1: '),
    ):
        path.write_text(text)
        status, output = report(folder / "study", folder / "out")
        people = {row["people"] for row in read(folder / "out/drags_synthetic_curves.csv")}
        good = status == 1 and f"{path}{message}" in output and people == {"3"}
        yield Outcome.of(f"command/study report: session.json{message}", good, f"{status}\n{output}")
    path.unlink()
    status, output = report(folder / "study", folder / "out")
    good = status == 1 and f"{path.parent}: session.json is missing: copy the whole folder" in output
    yield Outcome.of("command/study report: a session without session.json is named", good, output)
    write_study(folder / "incomplete", 4, **SMALL)
    for name in ("trials.csv", "answers.csv"):
        path = folder / "incomplete/drags/sub-p04/ses-01" / name
        path.unlink()
        status, output = report(folder / "incomplete", folder / "out")
        good = status == 1 and f"{path}: this file is missing: copy the whole folder" in output
        yield Outcome.of(f"command/study report: a session without {name} is named", good, output)
