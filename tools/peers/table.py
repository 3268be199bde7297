"""The tables of the comparison, in Markdown and CSV."""

import csv
from collections.abc import Iterator
from pathlib import Path
from textwrap import fill

import numpy as np
from peers.comparison import TITLES, TrialFigures, groups
from peers.predictor import HORIZONS_S

PREDICTORS = {"hold": "hold", "ridge": "ridge", "minimum_jerk": "minimum jerk", "promp": "ProMP"}

WIDTH = 120
FIGURES = (
    "Every predictor knows the task and the mean duration of the gesture's model, as ours does. Ridge and ProMP are "
    "trained on {source}. Each cell: mean zero-lag R2, median T_diff (ms), trials missed. Bold: the best R2 of a row."
)
ERRORS = "Root mean square error (mm) of the predictions {horizons} ms ahead of each frame, all gestures together:"


def as_markdown(sets: dict[str, list[TrialFigures]], source: str) -> str:
    """sets: the trials of each set by its name. source: the training trials, in words."""
    horizons = " / ".join(f"{1e3 * horizon_s:.0f}" for horizon_s in HORIZONS_S)
    texts = (FIGURES.format(source=source), ERRORS.format(horizons=horizons))
    tables = (table(figure_rows(sets)), table(error_rows(sets)))
    return "".join(f"{fill(text, WIDTH)}\n\n{rows}\n\n" for text, rows in zip(texts, tables, strict=True))[:-1]


def table(rows: Iterator[list[str]]) -> str:
    """The first row is the header; the first column is text, the others numbers."""
    lines = [f"| {' | '.join(row)} |" for row in rows]
    lines.insert(1, "| --- " + "| ---: " * (lines[0].count("|") - 2) + "|")
    return "\n".join(lines)


def figure_rows(sets: dict[str, list[TrialFigures]]) -> Iterator[list[str]]:
    yield ["trials", *TITLES.values()]
    for name, trials in sets.items():
        for (gesture, position), group in groups(trials).items():
            figures = {condition: [trial.figures[condition] for trial in group] for condition in TITLES}
            r2 = {condition: np.mean([one.r2_zero for one in of]) for condition, of in figures.items()}
            best = max(r2, key=lambda condition: r2[condition])
            cells = [f"{name}, {gesture.replace('_', ' ')}, {position}: {len(group)}"]
            for condition, of in figures.items():
                mark = "**" if condition == best else ""
                t_diff_ms = 1e3 * np.median([one.t_diff_s for one in of])
                missed = sum(one.missed for one in of)
                cells.append(f"{mark}{r2[condition]:.3f}{mark}, {t_diff_ms:+.0f}, {missed}")
            yield cells


def error_rows(sets: dict[str, list[TrialFigures]]) -> Iterator[list[str]]:
    """All trials weigh the same, whatever their number of frames."""
    yield ["trials", *PREDICTORS.values()]
    for name, trials in sets.items():
        for position in sorted({trial.position for trial in trials}):
            own = [trial for trial in trials if trial.position == position and trial.square_errors_mm2]
            if not own:
                continue
            cells = [f"{name}, {position}: {len(own)}"]
            for predictor in PREDICTORS:
                errors_mm = np.sqrt(np.mean([trial.square_errors_mm2[predictor] for trial in own], axis=0))
                cells.append(" / ".join(f"{error_mm:.1f}" for error_mm in errors_mm))
            yield cells


def write_csv(path: Path, sets: dict[str, list[TrialFigures]]) -> None:
    """One row a trial and condition."""
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["set", "trial", "gesture", "position", "condition", "r2_zero", "t_diff_s", "missed"])
        for name, trials in sets.items():
            for trial in trials:
                for condition, of in trial.figures.items():
                    row = [name, trial.trial, trial.gesture, trial.position, condition]
                    writer.writerow([*row, f"{of.r2_zero:.6f}", f"{of.t_diff_s:.6f}", int(of.missed)])
