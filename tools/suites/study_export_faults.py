"""Messages and output of python -m study_export for damaged sessions."""

import csv
import json
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

from suites.outcome import Outcome
from suites.study_sample import write_study

NAME = "study_export"
Export = Callable[..., tuple[int, str]]


def faults(folder: Path, export: Export) -> Iterator[Outcome]:
    yield from doubled(folder / "doubled", export)
    yield from cut_off(folder / "cut", export)
    yield from unfinished(folder / "unfinished", export)
    yield from cut_in_the_last_cell(folder / "last_cell", export)
    yield from bad_cells(folder / "cells", export)
    yield from open_quote(folder / "quote", export)
    yield from no_frames(folder / "frames", export)
    yield from differing_protocols(folder / "protocols", export)
    yield from bad_sessions(folder / "sessions", export)
    yield from refused(folder / "refused", export)


def doubled(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder)
    path = folder / "sub-ann/ses-01/trials.csv"
    path.write_text(path.read_text() + path.read_text().splitlines()[2] + "\n")
    status, output = export(folder, "--tidy", folder / "out.csv")
    named = f"{path}:6: trial 2 is already in line 3" in output
    yield Outcome.of(f"{NAME}: a repeated trial is an error", status == 1 and named, output)
    yield Outcome.of(f"{NAME}: a repeated trial counts once", len(rows(folder / "out.csv")) == 48)


def cut_off(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder)
    session = folder / "sub-ann/ses-01"
    for name in ("trials.csv", "answers.csv", "events.csv", "trial_0001.frames.csv", "trial_0001.motion.csv"):
        path = session / name
        path.write_text(path.read_text()[: -40 if name == "trials.csv" else -4].rstrip("\n"))
    answers = session / "answers.csv"
    answers.write_text(answers.read_text() + '\nann,1,person,1,2,tap,stable,measured,likert,control,"It was')
    frames = session / "trial_0001.frames.csv"
    frames.write_text(frames.read_text() + "\n1e9,0.1")
    status, output = export(folder, "--tidy", folder / "out.csv", "--bids", folder / "bids")
    messages = ["trials.csv:5: the last row is cut off", "answers.csv:6: the last row is cut off"]
    messages += ["frames.csv:"]
    missing = [text for text in messages if text not in output]
    yield Outcome.of(
        f"{NAME}: cut last rows are left out with a note", status == 0 and not missing, f"{missing}\n{output}"
    )
    yield Outcome.of(f"{NAME}: the other trials of cut tables are there", len(rows(folder / "out.csv")) == 45)


def unfinished(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder)
    session = folder / "sub-ann/ses-02"
    path = session / "trials.csv"
    path.write_text("".join(path.read_text().splitlines(keepends=True)[:-1]))
    status, output = export(folder, "--tidy", folder / "out.csv")
    messages = [f"{session}: 1 of 4 planned trials have no row yet", "trial_0004.motion.csv is left out"]
    missing = [text for text in messages if text not in output]
    yield Outcome.of(f"{NAME}: an unfinished trial is a note", status == 0 and not missing, f"{missing}\n{output}")


def cut_in_the_last_cell(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder)
    path = folder / "sub-ann/ses-01/answers.csv"
    export(folder, "--tidy", folder / "whole.csv")
    whole = rows(folder / "whole_answers.csv")
    path.write_text(path.read_text()[:-2])
    status, output = export(folder, "--tidy", folder / "out.csv")
    named = "answers.csv:5: the last row is cut off, and is left out (it has no line end" in output
    kept = rows(folder / "out_answers.csv")
    good = status == 0 and named and len(kept) == len(whole) - 1 and all(row in whole for row in kept)
    yield Outcome.of(f"{NAME}: a row cut in its last cell is left out", good, output)


def bad_cells(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder)
    path = folder / "sub-sim1/ses-01/trials.csv"
    lines = path.read_text().splitlines()
    lines[1] = lines[1].replace(",0.200000,", ",nan,")
    lines[2] = lines[2].replace("synthesised", "steady")
    lines[3] = lines[3].replace("sim1", "sim2")
    path.write_text("\n".join(lines) + "\n")
    spreadsheet = folder / "sub-ann/ses-02/trials.csv"
    spreadsheet.write_text(spreadsheet.read_text().replace(",", ";"))
    binary = folder / "sub-sim1/ses-02/trials.csv"
    binary.write_bytes(binary.read_bytes().replace(b"tap", b"t\xfcp", 1))
    status, output = export(folder, "--tidy", folder / "out.csv")
    messages = [
        f"{path}:2: amplitude_m: 'nan' is no finite number",
        f"{path}:3: condition: 'steady' is none of measured, average",
        f"{path}:4: participant: 'sim2' differs from 'sim1' in session.json",
        f"{spreadsheet}:1: cells are separated by ';'",
        f"{binary}:2: this is no UTF-8 text",
    ]
    missing = [text for text in messages if text not in output]
    yield Outcome.of(
        f"{NAME}: bad cells are named with file and line", status == 1 and not missing, f"{missing}\n{output}"
    )
    reports = [line for line in output.splitlines() if "sub-sim1/ses-01" in line or "sub-ann/ses-02" in line]
    yield Outcome.of(f"{NAME}: each trial of a refused row is reported once", len(reports) == 4, output)


def open_quote(folder: Path, export: Export) -> Iterator[Outcome]:
    """It affects all rows after it, unlike a last row that is cut off."""
    write_study(folder)
    path = folder / "sub-ann/ses-01/trials.csv"
    path.write_text(path.read_text().replace(",tap,", ',"tap,', 1).rstrip("\n"))
    status, output = export(folder, "--tidy", folder / "out.csv")
    good = status == 1 and f"{path}:2: a quote is opened here and never closed" in output
    yield Outcome.of(f"{NAME}: a quote that is never closed is an error", good, output)


def no_frames(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder)
    path = folder / "sub-ann/ses-02/trial_0002.frames.csv"
    path.write_text(path.read_text().splitlines()[0] + "\n")
    status, output = export(folder, "--bids", folder / "bids")
    is_noted = f"{path}: no frame" in output and "trial 2 has no frame: BIDS gets its result only" in output
    results = folder / "bids/sub-ann/ses-02/beh/sub-ann_ses-02_task-horizontalDrag_beh.tsv"
    kept = [line.split("\t")[0] for line in results.read_text().splitlines()] == ["trial", "2", "4"]
    yield Outcome.of(f"{NAME}: a trial without frames keeps its result", status == 0 and is_noted and kept, output)


def differing_protocols(folder: Path, export: Export) -> Iterator[Outcome]:
    """Sessions of another origin are another analysis."""
    write_study(folder)
    for session, protocol in (("sim1/ses-01", {"seed": 9.0}), ("ann/ses-01", {}), ("ann/ses-02", {})):
        path = folder / f"sub-{session}/session.json"
        path.write_text(json.dumps(json.loads(path.read_text()) | {"protocol": protocol}))
    status, output = export(folder, "--tidy", folder / "out.csv")
    notes = [line for line in output.splitlines() if "sessions differ" in line]
    expected = [
        f"study: study 'drags' (synthetic): sessions differ in protocol {one}"
        for one in ("repetitions: 1, none", "seed: 9, none")
    ]
    yield Outcome.of(f"{NAME}: sessions of different protocols are a note", status == 0 and notes == expected, output)


def bad_sessions(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder / "a")
    shutil.copytree(folder / "a/sub-ann", folder / "b/sub-ann")
    about = folder / "a/sub-sim1/ses-01/session.json"
    about.write_text(about.read_text().replace('"synthetic"', '"robot"'))
    (folder / "a/sub-sim1/ses-02/session.json").write_text("[" * 100_000)
    (folder / "a/sub-ann/ses-01/trial_0002.reference.csv").unlink()
    answers = folder / "a/sub-ann/ses-02/answers.csv"
    answers.unlink()
    (folder / "b/sub-ann/ses-02/session.json").unlink()
    status, output = export(folder, "--bids", folder / "bids")
    messages = [
        f"{about}: origin: 'robot' is none of person, mouse",
        f"{folder}/a/sub-sim1/ses-02/session.json: this JSON is nested too deeply",
        f"participant 'ann', session 1 is also in {folder}/a/sub-ann/ses-01",
        "trial_0002.reference.csv: not there",
        f"{folder}/b/sub-ann/ses-02: session.json is missing. The session is left out",
        f"{answers}: this file is missing. Copy the whole folder of the session",
    ]
    missing = [text for text in messages if text not in output]
    yield Outcome.of(
        f"{NAME}: bad sessions are named and left out", status == 1 and not missing, f"{missing}\n{output}"
    )
    found = sorted(path.name for path in (folder / "bids").glob("sub-*"))
    yield Outcome.of(f"{NAME}: good sessions are exported", found == ["sub-ann"], f"{found}")


def refused(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder / "study")
    (folder / "taken").mkdir()
    (folder / "taken/mine.txt").touch()
    status, output = export(folder / "study", "--bids", folder / "taken")
    kept = [path.name for path in (folder / "taken").iterdir()] == ["mine.txt"]
    yield Outcome.of(f"{NAME}: a folder that is not empty stays as it is", status == 2 and kept, output)
    status, output = export(folder / "study", "--bids", folder / "taken/mine.txt")
    good = status == 2 and f"{folder}/taken/mine.txt: this is a file. Name a new folder" in output
    yield Outcome.of(f"{NAME}: --bids with the name of a file is an error", good, output)
    raw = folder / "study/sub-ann/ses-01/trials.csv"
    for path, message in (
        (raw, "this file is no earlier export"),
        (folder / "taken", "the name of a table ends in .csv"),
        (folder / "folder.csv", "this is a folder"),
    ):
        (folder / "folder.csv").mkdir(exist_ok=True)
        before = contents(folder)
        status, output = export(folder / "study", "--tidy", path)
        good = status == 2 and f"{path}: {message}" in output and contents(folder) == before
        yield Outcome.of(f"{NAME}: --tidy {path.name}: {message}", good, output)
    status, output = export(folder / "taken", "--tidy", folder / "none.csv")
    good = status == 2 and "no finished trial" in output and not (folder / "none.csv").exists()
    yield Outcome.of(f"{NAME}: a folder without sessions is an error", good, output)
    yield from similar_participants(folder / "similar", export)
    for path in (folder / "study").rglob("trials.csv"):
        path.write_text(path.read_text().replace(",horizontal_drag,", ",t_ap,").replace(",tap,", ",tAp,"))
    status, output = export(folder / "study", "--bids", folder / "bids")
    good = status == 2 and "BIDS label 'tAp'" in output and not list(folder.glob("bids*"))
    yield Outcome.of(f"{NAME}: two gestures with one BIDS label are an error", good, output)


def similar_participants(folder: Path, export: Export) -> Iterator[Outcome]:
    write_study(folder / "study")
    for path in (folder / "study/sub-sim1").rglob("*"):
        if path.name in ("session.json", "trials.csv", "answers.csv"):
            path.write_text(path.read_text().replace("sim1", "Ann"))
    status, output = export(folder / "study", "--bids", folder / "bids")
    good = status == 2 and "participants 'Ann' and 'ann' differ only in upper and lower case" in output
    good = good and not (folder / "bids").exists()
    yield Outcome.of(f"{NAME}: two participants that differ only in case have no BIDS dataset", good, output)


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))
