"""Writes the 1 kHz curves of a trial as a BIDS stimulus: they drove the vibration and the scene."""

import gzip
from itertools import pairwise
from pathlib import Path

from study_export.bids_files import cell, described, write_json
from study_export.columns import MOTION, check
from study_export.tables import Findings, read_table

RATE_HZ = 1000
NAMES = [column.name for column in MOTION]


def write_curves(path: Path, stem: Path, task: str, start_s: float, found: Findings) -> None:
    """`start_s`: the first frame of the trial's recording, on the run's clock."""

    def parse(cells: dict[str, str], _line: int) -> dict[str, str]:
        check(cells, MOTION)
        return cells

    rows = read_table(path, NAMES, parse, found).rows
    if not rows:
        found.notes.append(f"{path}: no row: the trial gets no curves")
        return
    times = [float(row["t"]) for row in rows]
    steps = [round((after - before) * RATE_HZ) for before, after in pairwise(times)]
    if any(step != 1 for step in steps):
        place = next(place for place, step in enumerate(steps) if step != 1)
        found.notes.append(
            f"{path}: rows are not 1 ms apart after t = {rows[place]['t']}: use the column t of its curves"
        )
    lines = (
        "\t".join([f"{t - start_s:.6f}", *(cell(row[n]) for n in NAMES[1:])]) + "\n"
        for t, row in zip(times, rows, strict=True)
    )
    # No name and no time in the header of the gzip file: the same session gives the same bytes.
    with open(f"{stem}_stim.tsv.gz", "wb") as raw, gzip.GzipFile("", "wb", mtime=0, fileobj=raw) as file:
        file.writelines(line.encode() for line in lines)
    about = described(MOTION)
    about["t"]["Description"] = "Time from the first frame of the recording of the tracker"
    write_json(
        Path(f"{stem}_stim.json"),
        {
            "TaskName": task,
            "SamplingFrequency": RATE_HZ,
            "StartTime": round(times[0] - start_s, 6),
            "Columns": NAMES,
            **about,
        },
    )
