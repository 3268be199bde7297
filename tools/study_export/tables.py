"""Reads CSV files whose last row may be cut off, as a crash leaves them."""

import csv
import io
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

Item = TypeVar("Item")


@dataclass
class Findings:
    faults: list[str] = field(default_factory=list)  # errors; each names its file, its line, and what to do
    notes: list[str] = field(default_factory=list)  # what the user should know, and is no error


def read_table(
    path: Path, columns: list[str], parse: Callable[[dict[str, str], int], Item], found: Findings
) -> list[Item]:
    """The rows that `parse` accepts. It gets the cells by column, and the line; ValueError refuses the row."""
    try:
        text, is_cut = decode(path, found)
    except OSError as fault:
        found.faults.append(f"{path}: cannot be read ({fault.strerror or fault})")
        return []
    items: list[Item] = []
    header: list[str] = []
    for line, cells, fault, is_last in records(text):
        if not header:
            if cells and cells[0].startswith("#"):
                continue  # metadata of a track
            missing = [name for name in columns if name not in cells]
            if fault or missing or len(set(cells)) < len(cells):
                reason = fault or (f"no column {', '.join(missing)}" if missing else "two columns have the same name")
                found.faults.append(f"{path}:{line}: {reason}. The file is left out: restore its header line")
                return []
            header = cells
            continue
        try:
            if fault or len(cells) != len(header):
                raise ValueError(fault or f"{len(cells)} cells, the header has {len(header)}")
            items.append(parse(dict(zip(header, cells, strict=True)), line))
        except ValueError as reason:
            if is_last and is_cut:
                found.notes.append(f"{path}:{line}: the last row is cut off, and is left out ({reason})")
            else:
                found.faults.append(f"{path}:{line}: {reason}. The row is left out: correct it")
    if not header:
        found.faults.append(f"{path}: no header line. The file is left out: restore its header line")
    return items


def decode(path: Path, found: Findings) -> tuple[str, bool]:
    """Its text, and whether its last line has no line break."""
    data = path.read_bytes()
    is_cut = bool(data) and not data.endswith((b"\n", b"\r"))
    try:
        return data.decode("utf-8-sig"), is_cut
    except UnicodeDecodeError as fault:
        line = data.count(b"\n", 0, fault.start) + 1
        if not (is_cut and b"\n" not in data[fault.start :]):
            found.faults.append(f"{path}:{line}: this is no UTF-8 text. Save the file as UTF-8")
        return data.decode("utf-8-sig", errors="replace"), is_cut


def records(text: str) -> Iterator[tuple[int, list[str], str, bool]]:
    """Of each record that is not empty: its first line, its cells, what is wrong with it, and whether it is the last."""
    lines = csv.reader(io.StringIO(text, newline=""), strict=True)
    found: list[tuple[int, list[str], str]] = []
    while True:
        first = lines.line_num + 1
        try:
            cells = next(lines)
            if cells:
                found.append((first, cells, ""))
        except StopIteration:
            break
        except csv.Error as fault:
            is_open = "end of data" in str(fault)
            found.append((first, [], "a quote is opened here and never closed" if is_open else f"bad quotes ({fault})"))
    for place, record in enumerate(found):
        yield *record, place == len(found) - 1
