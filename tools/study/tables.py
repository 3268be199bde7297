"""Tables of the report: each is a CSV file, and a table of the page."""

import csv
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from conditions import TITLES
from whole_file import whole

Value = str | int | float | None


@dataclass(frozen=True)
class Column:
    name: str  # in the CSV file
    heading: str = ""  # on the page; empty: the column is in the CSV file only
    show: Callable[[Value], str] = str


@dataclass
class Table:
    name: str
    title: str
    columns: list[Column]
    rows: list[dict[str, Value]] = field(default_factory=list)
    note: str = ""
    folded: bool = False  # on the page


def decimals(count: int, factor: float = 1.0) -> Callable[[Value], str]:
    return lambda value: f"{factor * value:.{count}f}"


def probability(value: float) -> str:
    return "< 0.0001" if value < 1e-4 else f"{value:.4f}"


def percent(value: float) -> str:
    return f"{100 * value:.1f} %"


def spoken(name: str) -> str:
    return str(name).replace("_", " ")


def with_titles(name: str) -> str:
    """A condition, or a cell of the design such as `stable average`, for people."""
    return " ".join(TITLES.get(word, word) for word in str(name).split(" "))


def shown(column: Column, row: dict[str, Value]) -> str:
    value = row.get(column.name)
    is_missing = value is None or value == "" or (isinstance(value, float) and math.isnan(value))
    return "-" if is_missing else column.show(value)


def write_csv(path: Path, table: Table, always: dict[str, Value]) -> None:
    """`always` are the first cells of every row: the study and the origin."""
    with whole(path) as part, part.open("w", encoding="utf-8", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow([*always, *(column.name for column in table.columns)])
        for row in table.rows:
            lines.writerow([*always.values(), *(plain(row.get(column.name)) for column in table.columns)])


def plain(value: Value) -> str:
    if value is None:
        return ""
    return f"{float(value):.9g}" if isinstance(value, float) else str(value)


def aligned(headings: list[str], rows: Iterable[list[str]], left: int) -> str:
    """Text for a terminal: the first `left` columns are left-aligned, the others right-aligned."""
    lines = [headings, *rows]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]

    def line(cells: list[str]) -> str:
        padded = [
            cell.ljust(width) if place < left else cell.rjust(width)
            for place, (cell, width) in enumerate(zip(cells, widths, strict=True))
        ]
        return "  ".join(padded).rstrip()

    head = line(headings)
    return "\n".join([head, "-" * len(head), *map(line, lines[1:])])
