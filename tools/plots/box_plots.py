"""Box plots of a gesture's trials by condition and position, as the paper's Fig. 7."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from conditions import TITLES
from matplotlib.axes import Axes
from plots.curves import STYLES
from plots.style import plt, save

POSITIONS = ["stable", "unstable"]
SHORT = {
    **{name: "\n".join(TITLES[name].rsplit(" ", 1)) for name in ("measured", "average", "one_euro", "kalman")},
    "paper": "synth.,\npaper",
    "phase": "synth.,\nphase",
}
# Values beyond are counted at the edge instead of drawn, so that the others stay legible.
R2_SHOWN = (0.5, 1.01)
T_DIFF_SHOWN_MS = (-700.0, 300.0)
# Figure, its name on the axis, factor to the axis' unit, shown range.
ROWS = [
    ("r2", "R² at the best lag", 1, R2_SHOWN),
    ("r2_zero", "zero-lag R²", 1, R2_SHOWN),
    ("t_diff", "$T_{diff}$ (ms), above 0: ends early", 1000, T_DIFF_SHOWN_MS),
]

Values = Callable[[str, str, str], list[float]]  # of position, figure, condition


def draw_box_plots(path: Path, heading: str, values: Values) -> None:
    figure, axes = plt.subplots(3, 2, figsize=(10, 8.6), sharex=True, sharey="row", layout="constrained")
    for column, position in enumerate(POSITIONS):
        for row, (name, _, factor, shown) in enumerate(ROWS):
            drawn = {condition: factor * np.array(values(position, name, condition)) for condition in SHORT}
            draw_boxes(axes[row, column], drawn, shown)
        axes[0, column].set_title(position)
        axes[-1, column].axhline(0, color="black", lw=0.8, zorder=1)
    for row, (_, title, _, _) in enumerate(ROWS):
        axes[row, 0].set_ylabel(title)
    figure.suptitle(heading)
    save(figure, path)


def draw_boxes(axes: Axes, values: dict[str, np.ndarray], shown: tuple[float, float]) -> None:
    places = range(1, len(values) + 1)
    boxes = axes.boxplot(
        list(values.values()),
        positions=places,
        whis=(5, 95),
        widths=0.6,
        patch_artist=True,
        medianprops={"color": "black", "lw": 1.5},
        flierprops={"marker": ".", "ms": 4, "markeredgecolor": "none", "markerfacecolor": "#555555", "alpha": 0.6},
    )
    for box, condition in zip(boxes["boxes"], values, strict=True):
        box.set(facecolor=STYLES[condition].colour, alpha=0.75)
    axes.set_xticks(places, [SHORT[condition] for condition in values], fontsize=9.5)
    axes.set_ylim(*shown)
    axes.grid(axis="x", visible=False)
    for place, drawn in zip(places, values.values(), strict=True):
        for beyond, edge, side in [(drawn < shown[0], 0.01, "bottom"), (drawn > shown[1], 0.99, "top")]:
            if np.any(beyond):
                text = f"{np.count_nonzero(beyond)} {'below' if side == 'bottom' else 'above'}"
                axes.text(
                    place,
                    edge,
                    text,
                    transform=axes.get_xaxis_transform(),
                    ha="center",
                    va=side,
                    fontsize=8.5,
                    bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1},
                )
