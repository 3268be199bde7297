"""Fills generated tables into a page, between marks. The rest of the page is written by hand."""

from collections.abc import Iterable
from pathlib import Path

from whole_file import whole


def fill(path: Path, tables: dict[str, str]) -> None:
    """Replaces the text between `<!-- NAME -->` and `<!-- end of NAME -->`, in all places or in none.

    Raises SystemExit without these marks.
    """
    text = path.read_text()
    for name, table in tables.items():
        begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
        before, found, rest = text.partition(begin)
        if not found or end not in rest:
            raise SystemExit(f"{path}: the marks of table '{name}' are missing: <!-- {name} --> and {end}")
        text = before + begin + "\n" + table + "\n" + end + rest.partition(end)[2]
    with whole(path) as part:
        part.write_text(text)


def table(head: list[str], rows: Iterable[list[str]]) -> str:
    """A Markdown table. The first column is text, the others are numbers."""
    lines = [head, ["---", *["---:"] * (len(head) - 1)], *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)
