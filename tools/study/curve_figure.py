"""The curves of one unstable trial, as the paper's Fig. 6."""

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from plots.curves import STYLES
from plots.style import plt, save
from study.analysis import Analysis
from study.session_rows import StudyTrial
from study.tables import spoken

PREFERRED = "horizontal_drag"  # as in the paper
DRAWN = ["average", "measured", "reference", "synthesised"]  # the last on top
LEGEND = ["reference", "measured", "synthesised", "average"]
BEFORE_S, AFTER_S = 0.35, 0.5
R2 = "r2_synthesised"


class NoCurves(Exception):
    """The text says why there is no figure."""


@dataclass
class Choice:
    trial: StudyTrial
    path: Path
    of: int  # trials that it was chosen from


def choose(analysis: Analysis) -> Choice:
    """The unstable trial whose R2 of the synthesised motion is the median, of those that have curves."""
    unstable = [
        trial
        for trial in analysis.trials
        if trial.position == "unstable" and trial.is_recognised and trial.figures[R2] is not None
    ]
    gestures = sorted({trial.gesture for trial in unstable}, key=lambda name: (name != PREFERRED, name))
    if not gestures:
        raise NoCurves("No recognised trial at the unstable position has a reference: there are no curves to draw.")
    own = [trial for trial in unstable if trial.gesture == gestures[0]]
    own = [(trial, path) for trial in own if (path := motion_file(trial)).is_file()]
    if not own:
        raise NoCurves(f"No unstable {spoken(gestures[0])} has a trial_NNNN.motion.csv: there are no curves to draw.")
    own.sort(key=lambda pair: (pair[0].figures[R2], pair[0].key))
    return Choice(*own[(len(own) - 1) // 2], len(own))


def motion_file(trial: StudyTrial) -> Path:
    return trial.session.folder / f"trial_{trial.trial:04}.motion.csv"


def read_motion(path: Path) -> dict[str, np.ndarray]:
    """ValueError names the file and the line."""
    try:
        text = path.read_text("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise ValueError(f"{path}: this is not UTF-8 text") from fault
    columns = ["t", *DRAWN]
    values: dict[str, list[float]] = {name: [] for name in columns}
    rows = csv.DictReader(text.splitlines())
    if missing := [name for name in columns if name not in (rows.fieldnames or [])]:
        raise ValueError(f"{path}:1: no column {', '.join(missing)}: see docs/study_files.md")
    for row in rows:
        for name in columns:
            try:
                values[name].append(float(row[name]) if row[name] else np.nan)
            except ValueError as fault:
                raise ValueError(f"{path}:{rows.line_num}: {name}: '{row[name]}' is not a number") from fault
    if not values["t"]:
        raise ValueError(f"{path}: there is no row after the header")
    return {name: np.array(column) for name, column in values.items()}


def figure_6(path: Path, analysis: Analysis) -> str:
    """Draws it and returns its caption. NoCurves or ValueError: there is no figure."""
    chosen = choose(analysis)
    trial = chosen.trial
    curves = read_motion(chosen.path)
    start_s = trial.onset_s if trial.onset_s is not None else curves["t"][0]
    figure, axes = plt.subplots(figsize=(9, 4.6), layout="constrained")
    lines = {}
    for name in DRAWN:
        style = STYLES[name]
        form = {"color": style.colour, "lw": style.width, "ls": style.dashes, "label": style.label}
        (lines[name],) = axes.plot(curves["t"] - start_s, 100 * curves[name], **form)
    last_s = (trial.end_s if trial.end_s is not None else curves["t"][-1]) - start_s + AFTER_S
    axes.set_xlim(max(-BEFORE_S, curves["t"][0] - start_s), min(last_s, curves["t"][-1] - start_s))
    axes.set_xlabel("time after the recognised start (s)")
    axes.set_ylabel("motion (cm)")
    axes.legend(handles=[lines[name] for name in LEGEND], loc="lower right", fontsize=9)
    who = f"unstable {spoken(trial.gesture)}, {trial.session.name}, trial {trial.trial}"
    axes.set_title(f"{analysis.label}: {who}", fontsize=11)
    save(figure, path)
    return (
        f"{who[0].upper()}{who[1:]}. It is the median of {chosen.of} trials by the R² of the synthesised motion,"
        f" which is {trial.figures[R2]:.3f}."
    )
