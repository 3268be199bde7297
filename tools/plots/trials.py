"""Curves of single trials: one large, or many small."""

from pathlib import Path

import numpy as np
from plots.curves import STYLES, draw_curves, shown_span
from plots.style import plt, save

COLUMNS = 3
SMALL_WIDTH = 0.75  # of the lines of a large picture
SMALL = ["measured", "reference", "paper", "phase"]

Curves = dict[str, np.ndarray]


def draw_trial(path: Path, title: str, curves: Curves) -> None:
    figure, axes = plt.subplots(figsize=(9, 4.2), layout="constrained")
    draw_curves(axes, curves)
    axes.set_xlim(*shown_span(curves))
    axes.set_xlabel("time (s)")
    axes.set_title(title)
    save(figure, path)


def draw_small_multiples(path: Path, trials: dict[str, Curves]) -> None:
    """trials: curves by title."""
    rows = -(-len(trials) // COLUMNS)
    figure, axes = plt.subplots(rows, COLUMNS, figsize=(10.5, 3.1 * rows + 0.4), squeeze=False, layout="constrained")
    for place in axes.flat[len(trials) :]:
        place.set_visible(False)
    for place, (title, curves) in zip(axes.flat, trials.items(), strict=False):
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
        place.set_xlim(*shown_span({name: curves[name] for name in ("t", *SMALL)}))
        place.set_title(title, size=10)
    figure.supxlabel("time (s)", size=11)
    figure.supylabel("share of the amplitude", size=11)
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=len(SMALL))
    save(figure, path)
