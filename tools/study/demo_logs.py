"""Fitts throughput of the logs that the demo's task scenes write (docs/study_logs.md)."""

import csv
import sys
from collections.abc import Callable, Iterable
from dataclasses import asdict, fields
from pathlib import Path

from study.logs import read_logs
from study.rows import Trial
from study.session_file import ORIGINS
from study.throughput import Cell, Group, cells, groups
from whole_file import whole

# Exit codes, as those of the tools of the demo project.
INCOMPLETE = 1
BAD_INPUT = 2


def run(given: list[Path], out: Path) -> int:
    """Writes two tables to `out` and prints one. Returns the exit code."""
    logs = read_logs(given)
    for fault in logs.faults:
        print(f"study: {fault}", file=sys.stderr)
    for note in logs.notes:
        print(f"study: {note}", file=sys.stderr)
    if not logs.trials:
        print(f"study: no trial was read from {', '.join(map(str, given))}", file=sys.stderr)
        return BAD_INPUT
    of_participants = cells(logs.trials)
    of_all = groups(of_participants)
    if out.exists() and not out.is_dir():
        print(f"study: {out}: a file, not a folder", file=sys.stderr)
        return BAD_INPUT
    try:
        out.mkdir(parents=True, exist_ok=True)
        write(out / "throughput.csv", Cell, of_participants)
        write(out / "throughput_means.csv", Group, of_all)
    except OSError as fault:
        print(f"study: cannot write to {out}: {fault.strerror}", file=sys.stderr)
        return BAD_INPUT
    print(table(of_all))
    for note in notes(logs.trials, of_participants):
        print(f"study: {note}", file=sys.stderr)
    print(
        f"wrote {out / 'throughput.csv'} (a row for each participant, gesture, position, condition, amplitude and"
        f" width) and {out / 'throughput_means.csv'} (the table above)"
    )
    return INCOMPLETE if logs.faults else 0


def write(path: Path, kind: type, rows: Iterable[Cell] | Iterable[Group]) -> None:
    """In one step: an earlier table stays if the new one cannot be written."""
    with whole(path) as part, part.open("w", encoding="utf-8", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(field.name for field in fields(kind))
        for row in rows:
            lines.writerow(plain(value) for value in asdict(row).values())


def plain(value: str | int | float | None) -> str:
    if value is None:
        return ""
    return f"{value:.6f}" if isinstance(value, float) else str(value)


def table(rows: list[Group]) -> str:
    """Text to the left, numbers to the right. A missing value is a dash."""

    def shown(value: float | None, form: str, unit: float = 1.0) -> str:
        return "-" if value is None else format(value / unit, form)

    columns: dict[str, Callable[[Group], str]] = {
        "gesture": lambda row: row.gesture,
        "position": lambda row: row.position or "-",
        "condition": lambda row: row.condition,
        "made by": lambda row: ORIGINS[row.origin],
        "people": lambda row: str(row.participants) if row.origin == "person" else "-",
        "trials": lambda row: str(row.n),
        "no end": lambda row: str(row.without_end),
        "MT, s": lambda row: shown(row.movement_time_s, ".3f"),
        "Ae, mm": lambda row: shown(row.effective_amplitude_m, ".1f", 1e-3),
        "We, mm": lambda row: shown(row.effective_width_m, ".1f", 1e-3),
        "IDe, bits": lambda row: shown(row.effective_difficulty_bits, ".2f"),
        "TP, bits/s": lambda row: shown(row.throughput_bits_s, ".2f"),
        "SD": lambda row: shown(row.throughput_deviation_bits_s, ".2f"),
    }
    lines = [list(columns), *([of(row) for of in columns.values()] for row in rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]

    def aligned(cells: list[str]) -> str:
        padded = (
            cell.ljust(width) if place < 4 else cell.rjust(width)
            for place, (cell, width) in enumerate(zip(cells, widths, strict=True))
        )
        return "  ".join(padded).rstrip()

    text = [aligned(line) for line in lines]
    return "\n".join([text[0], "-" * len(text[0]), *text[1:]])


def notes(trials: list[Trial], of: list[Cell]) -> Iterable[str]:
    persons = [trial for trial in trials if trial.origin == "person"]
    if unnamed := sum(not trial.participant for trial in persons):
        yield f"{unnamed} of {len(persons)} trials of persons name no participant: they count as one person"
    if without := sum(one.throughput_bits_s is None for one in of):
        yield f"{without} of {len(of)} rows have no throughput: it needs two or more different ends beyond the start"
