"""Reads CSV files whose last row may be cut off, as a crash leaves them."""

import csv
import io
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Generic, TypeVar

from study.logs import header_fault

Item = TypeVar("Item")


@dataclass
class Findings:
    faults: list[str] = field(default_factory=list)  # errors; each names its file, its line, and what to do
    notes: list[str] = field(default_factory=list)  # what the user should know, and is no error


@dataclass
class Table(Generic[Item]):
    rows: list[Item] = field(default_factory=list)
    refused: list[dict[str, str]] = field(default_factory=list)  # cells of the rows that were left out
    is_read: bool = False  # False: the whole file was left out


def read_table(
    path: Path, columns: list[str], parse: Callable[[dict[str, str], int], Item], found: Findings
) -> Table[Item]:
    """`parse` gets the cells of a row by column, and the line; ValueError refuses the row."""
    table: Table[Item] = Table()
    try:
        data = path.read_bytes()
    except OSError as fault:
        found.faults.append(f"{path}: cannot be read ({fault.strerror or fault})")
        return table
    # A byte that is no UTF-8 becomes a surrogate, and its row is refused.
    text = data.decode("utf-8-sig", errors="surrogateescape")
    is_cut = not data.endswith((b"\n", b"\r"))
    header: list[str] = []
    for line, cells, fault, is_last in records(text):
        if not header:
            if cells and cells[0].startswith("#"):
                continue  # metadata of a track
            reason = fault or header_fault(cells, columns)
            if not reason and len(set(cells)) < len(cells):
                reason = "two columns have the same name"
            if reason:
                found.faults.append(f"{path}:{line}: {reason}. The file is left out: restore its header line")
                return table
            header = cells
            table.is_read = True
            continue
        try:
            if fault or len(cells) != len(header):
                raise ValueError(fault or f"{len(cells)} cells, the header has {len(header)}")
            if is_last and is_cut:
                raise ValueError("it has no line end, so its last cell may be too short")
            table.rows.append(parse(dict(zip(header, cells, strict=True)), line))
        except ValueError as reason:
            table.refused.append(dict(zip(header, cells, strict=False)))
            if is_last and is_cut:
                found.notes.append(f"{path}:{line}: the last row is cut off, and is left out ({reason})")
            else:
                found.faults.append(f"{path}:{line}: {reason}. The row is left out: correct it")
    if not header:
        found.faults.append(f"{path}: no header line. The file is left out: restore its header line")
    return table


def records(text: str) -> Iterator[tuple[int, list[str], str, bool]]:
    """First line, cells and fault of each record that is not empty, and whether that line is the last one."""
    last = len(io.StringIO(text, newline=None).readlines())
    lines = csv.reader(io.StringIO(text, newline=""), strict=True)
    while True:
        first = lines.line_num + 1
        try:
            if cells := next(lines):
                is_text = "".join(cells).encode(errors="replace").decode() == "".join(cells)
                yield first, cells, "" if is_text else "this is no UTF-8 text", first == last
        except StopIteration:
            break
        except csv.Error as fault:
            is_open = "end of data" in str(fault)
            reason = "a quote is opened here and never closed" if is_open else f"bad quotes ({fault})"
            yield first, [], reason, first == last
