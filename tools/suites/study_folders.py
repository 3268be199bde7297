"""Runs the study report in this process, and reads and changes its files."""

import contextlib
import csv
import io
from pathlib import Path

# Few trials and no curves: fast.
SMALL = {"repetitions": 2, "curves": False}


def report(folder: Path, out: Path, *without: str) -> tuple[int, str]:
    """Runs in this process. Returns exit code and output."""
    from study.report import run as run_report

    output = io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
        status = run_report([folder], out, list(without))
    return status, output.getvalue()


def read(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def rewrite(path: Path, rows: list[dict[str, str]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        lines = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        lines.writeheader()
        lines.writerows(rows)
