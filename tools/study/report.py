"""./steadyhand study on sessions: report.html, CSV tables, figures, and a short table on the terminal."""

import re
import sys
from pathlib import Path

from conditions import TITLES
from study import box_figures, descriptive
from study.analysis import Analysis, split
from study.curve_figure import NoCurves, figure_6
from study.inference import all_tests
from study.measures import participant_means
from study.page import Picture, Section, page
from study.sessions import Sessions, read_sessions
from study.statistics_tables import statistics_tables
from study.tables import aligned, spoken, write_csv
from whole_file import whole

INCOMPLETE = 1
BAD_INPUT = 2
LONGEST_NAME = 64  # three of them fit into a file name


def run(given: list[Path], out: Path, without: list[str]) -> int:
    """Returns the exit code: 0, 1 if a row or file is left out, 2 if nothing can be analysed or written."""
    read = read_sessions(given, without)
    analyses = [analysis for analysis in split(read) if analysis.trials]
    if not analyses:
        tell(read)
        print(f"study: no trial that counts in {', '.join(map(str, given))}", file=sys.stderr)
        return BAD_INPUT
    if out.exists() and not out.is_dir():
        print(f"study: {out}: this is a file: name a folder", file=sys.stderr)
        return BAD_INPUT
    try:
        out.mkdir(parents=True, exist_ok=True)
        taken: dict[str, set[str]] = {analysis.origin: set() for analysis in analyses}
        prefixes = [f"{file_name(one.study, taken[one.origin])}_{one.origin}" for one in analyses]
        sections = [section_of(one, out, prefix, read) for one, prefix in zip(analyses, prefixes, strict=True)]
        with whole(out / "report.html") as part:
            part.write_text(page(sections, read.faults, read.notes), "utf-8")
    except OSError as fault:
        print(f"study: cannot write to {out}: {fault.strerror or fault}", file=sys.stderr)
        return BAD_INPUT
    tell(read)
    print(short_table(sections))
    print(f"wrote {out / 'report.html'}, with its tables (*.csv) and figures (*.png) beside it")
    return INCOMPLETE if read.faults else 0


def tell(read: Sessions) -> None:
    for line in (*read.faults, *read.notes):
        print(f"study: {line}", file=sys.stderr)


def file_name(text: str, taken: set[str]) -> str:
    """Letters that every file system has, at most 64 and a number. A name is given once, also in other case."""
    first = name = re.sub(r"[^A-Za-z0-9-]+", "_", text).strip("_")[:LONGEST_NAME] or "unnamed"
    number = 1
    while name.lower() in taken:
        number += 1
        name = f"{first}_{number}"
    taken.add(name.lower())
    return name


def section_of(analysis: Analysis, out: Path, prefix: str, read: Sessions) -> Section:
    means = participant_means(analysis)
    results = all_tests(means)
    section = Section(analysis, notes=list(analysis.notes))
    section.tables = [
        descriptive.sessions_table(analysis),
        descriptive.recognition_table(analysis),
        descriptive.curves_table(analysis, means),
        *descriptive.throughput_tables(analysis),
        *([descriptive.answers_table(analysis, means)] if analysis.answers else []),
        descriptive.means_table(means),
    ]
    section.statistics = statistics_tables(results)
    for table in (*section.tables, *section.statistics):
        write_csv(out / f"{prefix}_{table.name}.csv", table, {"study": analysis.study, "origin": analysis.origin})

    taken: set[str] = set()
    names = {gesture: file_name(gesture, taken) for gesture in analysis.gestures}
    draw_curves(section, out / f"{prefix}_curves.png", read)
    for gesture in analysis.gestures:
        path = emptied(out / f"{prefix}_{names[gesture]}_boxes.png")
        if box_figures.figure_7(path, analysis, gesture, means, results):
            title = f"{analysis.label}: R² and T_diff, {spoken(gesture)} (as Fig. 7 of the paper). "
            section.pictures.append(Picture(path, title, BOXES_NOTE))
    taken = {"boxes"}
    for questionnaire in sorted({answer.questionnaire for answer in analysis.answers}):
        name = file_name(questionnaire, taken)
        for gesture in analysis.gestures:
            path = emptied(out / f"{prefix}_{names[gesture]}_{name}.png")
            if box_figures.figure_8(path, analysis, questionnaire, gesture, means, results):
                title = f"{analysis.label}: questionnaire {questionnaire}, {spoken(gesture)} (as Fig. 8 of the paper). "
                section.pictures.append(Picture(path, title, BOXES_NOTE))
    return section


def draw_curves(section: Section, path: Path, read: Sessions) -> None:
    try:
        caption = figure_6(emptied(path), section.analysis)
        section.pictures.append(Picture(path, f"{section.analysis.label}: curves (as Fig. 6 of the paper). ", caption))
    except NoCurves as reason:
        section.notes.append(str(reason))
    except ValueError as fault:
        read.faults.append(f"{fault}: the figure of curves is left out")


def emptied(path: Path) -> Path:
    """An earlier report's figure must not stay where this report has none."""
    path.unlink(missing_ok=True)
    return path


BOXES_NOTE = (
    "A point is a participant's mean. A box spans the quartiles, and whiskers reach to 1.5 times their distance."
    " Stars compare motions in one position: ** p < 0.001, * p < 0.05, Bonferroni-corrected."
)


def short_table(sections: list[Section]) -> str:
    headings = ["study", "made by", "gesture", "position", "people", "trials", "right"]
    curves = ("measured", "average", "synthesised")
    for figure in ("R2", "Tdiff, ms:"):
        headings += [f"{figure} {TITLES[curves[0]]}", *(TITLES[curve] for curve in curves[1:])]
    rows = []
    for section in sections:
        named = {table.name: table.rows for table in section.tables}
        for row in named["recognition"]:
            own = {
                one["curve"]: one
                for one in named["curves"]
                if (one["gesture"], one["position"]) == (row["gesture"], row["position"])
            }
            cells = [section.analysis.study, section.analysis.label, spoken(row["gesture"]), row["position"] or "-"]
            cells += [str(row["people"]), str(row["trials"]), f"{100 * row['rate_mean']:.0f} %"]
            for figure, form, factor in (("r2_mean", ".3f", 1.0), ("t_diff_mean", ".0f", 1000.0)):
                values = [own[curve][figure] for curve in curves]
                cells += ["-" if value is None else format(factor * value, form) for value in values]
            rows.append(cells)
    return aligned(headings, rows, left=4)
