"""The report as one HTML file that needs no other file and no network."""

import base64
import html
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from study.analysis import Analysis
from study.tables import Table, shown

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 74rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
h1, h2, h3 { line-height: 1.2; } h2 { margin-top: 3rem; border-top: 2px solid #222; padding-top: 1rem; }
table { border-collapse: collapse; font-size: 13px; margin: .4rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .55rem; text-align: right; border-bottom: 1px solid #ddd; vertical-align: top; }
th { border-bottom: 1px solid #222; } .text { text-align: left; } .wide { overflow-x: auto; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
figure { margin: 1rem 0; } img { max-width: 100%; height: auto; } .note, figcaption { color: #555; font-size: 13px; }
.made-up h2, .made-up caption, .made-up summary { color: #a33c00; } .fault { color: #b00020; }
summary { cursor: pointer; font-weight: 600; } details { margin: .6rem 0; }
"""


@dataclass
class Picture:
    path: Path
    title: str
    caption: str = ""


@dataclass
class Section:
    """All of one analysis: one study and one origin."""

    analysis: Analysis
    tables: list[Table] = field(default_factory=list)
    statistics: list[Table] = field(default_factory=list)
    pictures: list[Picture] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def page(sections: list[Section], faults: list[str], notes: list[str]) -> str:
    title = "SteadyHand study: " + ", ".join(dict.fromkeys(one.analysis.study for one in sections))
    labels = ", ".join(dict.fromkeys(one.analysis.label for one in sections))
    body = [
        f"<h1>{html.escape(title)}</h1>",
        f"<p>Trials were made by: {html.escape(labels)}. Each has its own section, and no number mixes them.</p>",
        *listed("Rows and files that are left out", faults, "fault"),
        *listed("Notes", notes, "note"),
    ]
    for section in sections:
        body += section_html(section)
    head = f'<meta charset="utf-8"><title>{html.escape(f"{title} ({labels})")}</title><style>{STYLE}</style>'
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body>\n' + "\n".join(body) + "\n</body></html>\n"


def listed(title: str, lines: list[str], kind: str) -> Iterator[str]:
    if lines:
        yield f"<h3>{title}</h3>\n<ul>"
        yield from (f'<li class="{kind}">{html.escape(line)}</li>' for line in lines)
        yield "</ul>"


def section_html(section: Section) -> Iterator[str]:
    analysis = section.analysis
    people, sessions = len(analysis.participants), len(analysis.sessions)
    yield f'<section class="{"person" if analysis.origin == "person" else "made-up"}">'
    yield f"<h2>{html.escape(analysis.label)}: study {html.escape(analysis.study)}</h2>"
    who = "participants" if analysis.origin == "person" else f"participants that are {html.escape(analysis.label)}"
    yield (
        f"<p>{people} {who}, {sessions} sessions, {len(analysis.trials)} trials."
        f" {analysis.practice} practice trials are not counted.</p>"
    )
    yield from (f'<p class="note">{html.escape(note)}</p>' for note in section.notes)
    for table in section.tables:
        yield from table_html(table, analysis.label)
    yield f"<h3>{html.escape(analysis.label)}: figures</h3>"
    for picture in section.pictures:
        yield from picture_html(picture)
    yield f"<h3>{html.escape(analysis.label)}: statistics</h3>"
    for table in section.statistics:
        yield from table_html(table, analysis.label)
    yield "</section>"


def table_html(table: Table, label: str) -> Iterator[str]:
    if not table.rows:
        return
    title = html.escape(f"{table.title}: {label}")
    columns = [column for column in table.columns if column.heading]
    if table.folded:
        yield f"<details><summary>{title} ({len(table.rows)} rows)</summary>"
    caption = "" if table.folded else f"<caption>{title}</caption>"
    yield f'<div class="wide"><table>{caption}<tr>'
    is_text = [any(isinstance(row.get(column.name), str) for row in table.rows) for column in columns]
    kinds = [' class="text"' if text else "" for text in is_text]
    yield "".join(f"<th{kind}>{html.escape(column.heading)}</th>" for column, kind in zip(columns, kinds, strict=True))
    yield "</tr>"
    for row in table.rows:
        cells = zip(columns, kinds, strict=True)
        yield "<tr>" + "".join(f"<td{kind}>{html.escape(shown(one, row))}</td>" for one, kind in cells) + "</tr>"
    yield "</table></div>"
    if table.note:
        yield f'<p class="note">{html.escape(table.note)}</p>'
    if table.folded:
        yield "</details>"


def picture_html(picture: Picture) -> Iterator[str]:
    data = base64.b64encode(picture.path.read_bytes()).decode("ascii")
    title = html.escape(picture.title)
    yield f'<figure><img alt="{title}" src="data:image/png;base64,{data}">'
    yield f"<figcaption>{title}{html.escape(picture.caption)}</figcaption></figure>"
