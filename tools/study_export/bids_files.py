"""Writes the TSV and JSON files of a BIDS dataset."""

import json
from collections.abc import Iterable
from pathlib import Path

from study_export.columns import COUNT, FLAG, NUMBER, Column

MISSING = "n/a"
# Readers take a key `run` of a sidecar for the run of the file name.
NAMES = {"run": "program_run"}
FORMATS = {COUNT: "integer", NUMBER: "number", FLAG: "integer"}


def cell(text: str) -> str:
    """BIDS knows no quotes: a tab or a line break becomes a space."""
    return " ".join(text.split()) if any(mark in text for mark in "\t\r\n") else text.strip() or MISSING


def write_tsv(path: Path, names: list[str], rows: Iterable[Iterable[str]]) -> None:
    """Without a header if it is empty, as motion-BIDS wants its recordings."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", encoding="utf-8", newline="") as file:
        if names:
            file.write("\t".join(names) + "\n")
        file.writelines("\t".join(map(cell, row)) + "\n" for row in rows)


def write_json(path: Path, content: dict) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent="\t", ensure_ascii=False) + "\n", encoding="utf-8")


def header(columns: Iterable[Column]) -> list[str]:
    return [NAMES.get(column.name, column.name) for column in columns]


def described(columns: Iterable[Column]) -> dict[str, dict]:
    """The columns as a BIDS sidecar describes them."""
    entries = {}
    for column in columns:
        entry: dict = {"Description": column.meaning[0].upper() + column.meaning[1:]}
        if column.unit:
            entry["Units"] = column.unit
        if column.kind in FORMATS:
            entry["Format"] = FORMATS[column.kind]
        entries[NAMES.get(column.name, column.name)] = entry
    return entries
