"""Curves of single trials: one large, or many small."""

from pathlib import Path

import numpy as np
from plots.curves import STYLES, draw_curves, shown_span
from plots.style import GREY, plt, save

COLUMNS = 3
SMALL_WIDTH = 0.75  # of the lines of a large picture
MARGIN_S = 0.4  # shown on either side of the gesture
SMALL = ["measured", "reference", "paper", "phase"]

Curves = dict[str, np.ndarray]


def draw_trial(path: Path, title: str, curves: Curves) -> None:
    figure, axes = plt.subplots(figsize=(9, 4.2), layout="constrained")
    draw_curves(axes, curves)
    axes.set_xlim(*shown_span(curves))
    axes.set_xlabel("time (s)")
    axes.set_title(title)
    save(figure, path)


def draw_small_multiples(path: Path, trials: dict[str, tuple[Curves, float, float]]) -> None:
    """trials: curves, and when the gesture starts and ends (s), by title."""
    rows = -(-len(trials) // COLUMNS)
    figure, axes = plt.subplots(rows, COLUMNS, figsize=(10.5, 3.1 * rows + 0.4), squeeze=False, layout="constrained")
    for place in axes.flat[len(trials) :]:
        place.set_visible(False)
    for place, (title, (curves, start_s, end_s)) in zip(axes.flat, trials.items(), strict=False):
        for name in SMALL:
            style = STYLES[name]
            place.plot(
                curves["t"],
                curves[name],
                color=style.colour,
                lw=SMALL_WIDTH * style.width,
                ls=style.dashes,
                label=style.label,
            )
        for boundary_s in (start_s, end_s):
            place.axvline(boundary_s, color=GREY, lw=1, ls=":", zorder=1)
        place.set_xlim(max(start_s - MARGIN_S, curves["t"][0]), min(end_s + MARGIN_S, curves["t"][-1]))
        place.set_title(title, size=10)
    figure.supxlabel("time (s)", size=11)
    figure.supylabel("share of the amplitude", size=11)
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=len(SMALL))
    save(figure, path)
