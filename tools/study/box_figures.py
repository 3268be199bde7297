"""Box plots over participants' means, as the paper's Fig. 7 and Fig. 8, with stars of significance."""

import textwrap
import unicodedata
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from conditions import TITLES
from matplotlib.axes import Axes
from plots.curves import STYLES
from plots.style import plt, save
from study.analysis import Analysis
from study.inference import Results
from study.measures import MOTIONS, Mean
from study.statistics_tables import stars
from study.tables import spoken

COLUMNS = 3  # of the panels of a questionnaire
LETTERS = 42  # in a line above a panel
STARS_NOTE = "** p < 0.001, * p < 0.05 (paired t-test, Bonferroni)"


def figure_7(path: Path, analysis: Analysis, gesture: str, means: list[Mean], results: list[Results]) -> bool:
    """R2 and T_diff of one gesture. False: there is nothing to draw."""
    panels = [("r2", "R² at the best lag", 1.0), ("t_diff", "$T_{diff}$ (ms), above 0: ends early", 1000.0)]
    own = [one for one in means if one.kind == "curve" and one.gesture == gesture]
    if not own:
        return False
    figure, axes = plt.subplots(1, len(panels), figsize=(10, 4.6), layout="constrained")
    for panel, (measure, title, factor) in zip(axes, panels, strict=True):
        shown = [one for one in own if one.measure == measure]
        draw_panel(panel, shown, post_hoc(results, "curve", measure, gesture), factor)
        panel.set_ylabel(title)
    axes[1].axhline(0, color="black", lw=0.8, zorder=1)
    finish(figure, path, analysis, f"{spoken(gesture)}: motion against the reference", own)
    return True


def figure_8(
    path: Path, analysis: Analysis, questionnaire: str, gesture: str, means: list[Mean], results: list[Results]
) -> bool:
    """The answers to each item of a questionnaire. False: there is nothing to draw."""
    asked = [one for one in analysis.answers if one.questionnaire == questionnaire]
    scales = {one.item: (one.minimum, one.maximum, one.text) for one in asked}
    measures = {item: f"{questionnaire}/{item}" for item in scales}
    own = [one for one in means if one.measure in measures.values() and one.gesture == gesture]
    items = [item for item in scales if any(one.measure == measures[item] for one in own)]
    if not items:
        return False
    columns, rows = min(COLUMNS, len(items)), -(-len(items) // COLUMNS)
    size = (max(4.3 * columns, 7.0), 4.6 * rows)
    figure, axes = plt.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False)
    for panel in axes.flat[len(items) :]:
        panel.set_visible(False)
    for panel, item in zip(axes.flat, items, strict=False):
        shown = [one for one in own if one.measure == measures[item]]
        minimum, maximum, text = scales[item]
        draw_panel(panel, shown, post_hoc(results, "answer", measures[item], gesture), 1.0, (minimum, maximum))
        panel.set_title(f"{spoken(item)}\n{wrapped(text)}", fontsize=10)
    share_top([panel for panel in axes.flat if panel.get_visible()])
    for panel in axes[:, 0]:
        panel.set_ylabel("participant's mean answer")
    finish(figure, path, analysis, f"{spoken(gesture)}: questionnaire {spoken(questionnaire)}", own)
    return True


def post_hoc(results: list[Results], kind: str, measure: str, gesture: str) -> dict[tuple[str, str], float]:
    """The corrected p of each pair of cells."""
    found = [one for one in results if (one.kind, one.measure, one.gesture) == (kind, measure, gesture)]
    return {(row["a"], row["b"]): row["p_bonferroni"] for one in found for row in one.post_hoc}


def draw_panel(
    axes: Axes,
    means: list[Mean],
    p_of: dict[tuple[str, str], float],
    factor: float,
    scale: tuple[float, float] | None = None,
) -> None:
    if not means:
        axes.text(0.5, 0.5, "no values", transform=axes.transAxes, ha="center")
        return
    positions = list(dict.fromkeys(one.position for one in means))
    motions = [one for one in MOTIONS if any(mean.motion == one for mean in means)]
    places: dict[str, float] = {}  # of a cell's name
    low, high = scale or extent([factor * one.value for one in means])
    step = 0.07 * (high - low)
    top = high
    for group, position in enumerate(positions):
        for slot, motion in enumerate(motions):
            own = [one for one in means if (one.position, one.motion) == (position, motion)]
            places[f"{position} {motion}".strip()] = place = group * (len(motions) + 0.8) + slot
            draw_box(axes, place, factor * np.array([one.value for one in own]), STYLES[motion].colour)
        names = [f"{position} {motion}".strip() for motion in motions]
        significant = [(a, b, stars(p)) for (a, b), p in p_of.items() if a in names and b in names and stars(p)]
        for level, (a, b, text) in enumerate(sorted(significant, key=lambda one: places[one[1]] - places[one[0]])):
            y = high + (0.8 + level) * step
            top = max(top, y + step)
            draw_bracket(axes, places[a], places[b], y, step, text)
        middle = group * (len(motions) + 0.8) + (len(motions) - 1) / 2
        label = {"xycoords": ("data", "axes fraction"), "textcoords": "offset points", "ha": "center", "va": "top"}
        axes.annotate(position or "no position", (middle, 0.0), (0, -56), **label)
    titles = [TITLES[motion] for _ in positions for motion in motions]
    axes.set_xticks(list(places.values()), titles, fontsize=9.5, rotation=30, ha="right", rotation_mode="anchor")
    axes.set_ylim(low - 0.5 * step, top + 0.5 * step)
    if scale and scale[1] - scale[0] <= 10:
        axes.set_yticks(np.arange(scale[0], scale[1] + 0.5))
    axes.grid(axis="x", visible=False)


def wrapped(text: str) -> str:
    """Chinese, Japanese and Korean letters are twice as wide as Latin ones."""
    wide = sum(unicodedata.east_asian_width(letter) in "WF" for letter in text)
    return textwrap.fill(text, max(LETTERS * len(text) // (len(text) + wide), 1) if text else LETTERS)


def share_top(panels: list[Axes]) -> None:
    """Panels differ in their stars: the scale looks the same in all."""
    top = max(panel.get_ylim()[1] for panel in panels)
    for panel in panels:
        panel.set_ylim(top=top)


def extent(values: Iterable[float]) -> tuple[float, float]:
    low, high = min(values), max(values)
    margin = 0.05 * (high - low) or 0.05 * abs(high) or 1.0
    return low - margin, high + margin


def draw_box(axes: Axes, place: float, values: np.ndarray, colour: str) -> None:
    boxes = axes.boxplot(
        [values],
        positions=[place],
        widths=0.62,
        showfliers=False,  # every participant is drawn as a point
        patch_artist=True,
        medianprops={"color": "black", "lw": 1.5},
    )
    boxes["boxes"][0].set(facecolor=colour, alpha=0.6)
    spread = np.linspace(-0.16, 0.16, len(values)) if len(values) > 1 else np.zeros(len(values))
    axes.plot(place + spread, values, ".", ms=5, color="#333333", alpha=0.7, zorder=3)


def draw_bracket(axes: Axes, left: float, right: float, y: float, step: float, text: str) -> None:
    axes.plot([left, left, right, right], [y - 0.2 * step, y, y, y - 0.2 * step], color="black", lw=1.0)
    axes.text((left + right) / 2, y - 0.1 * step, text, ha="center", va="bottom", fontsize=11)


def finish(figure: plt.Figure, path: Path, analysis: Analysis, what: str, means: list[Mean]) -> None:
    people = len({one.participant for one in means})
    counted = "1 participant" if people == 1 else f"{people} participants"
    figure.get_layout_engine().set(wspace=0.06)
    figure.suptitle(f"{analysis.label}: {what} ({counted}, study {analysis.study})", fontsize=12)
    figure.supxlabel(STARS_NOTE, fontsize=9)
    save(figure, path)
