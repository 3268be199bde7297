"""Figures of a trial against the duration of the gesture."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import NullLocator
from plots.box_plots import POSITIONS
from plots.curves import STYLES
from plots.style import plt, save

CONDITIONS = ["measured", "paper", "phase"]  # as in the table below the picture
MODES = ["paper", "phase"]
# Values beyond are written at the edge instead of drawn, so that the others stay legible.
R2_SHOWN = (0.0, 1.02)
T_DIFF_SHOWN_MS = (-320.0, 320.0)

Values = Callable[[float, str, str, str], np.ndarray]  # of duration, position, figure, condition
Share = Callable[[float, str, str], float]  # of duration, position, mode


def draw_speed(path: Path, durations: list[float], values: Values, recognised: Share) -> None:
    figure, axes = plt.subplots(3, 2, figsize=(10, 8.6), sharex=True, sharey="row", layout="constrained")
    for column, position in enumerate(POSITIONS):
        r2 = {c: [np.mean(values(d, position, "r2_zero", c)) for d in durations] for c in CONDITIONS}
        t_diff = {c: [1000 * np.median(values(d, position, "t_diff", c)) for d in durations] for c in CONDITIONS}
        for condition in CONDITIONS:
            draw_line(axes[0, column], durations, r2[condition], condition)
            draw_line(axes[1, column], durations, t_diff[condition], condition)
        mark_beyond(axes[0, column], durations, r2, R2_SHOWN, "{:.2f}")
        mark_beyond(axes[1, column], durations, t_diff, T_DIFF_SHOWN_MS, "{:+.0f}")
        for mode in MODES:
            shares = [100 * recognised(d, position, mode) for d in durations]
            draw_line(axes[2, column], durations, shares, mode)
        axes[0, column].set_title(position)
        axes[1, column].axhline(0, color="black", lw=0.8, zorder=1)
    axes[0, 0].set_ylim(*R2_SHOWN)
    axes[1, 0].set_ylim(*T_DIFF_SHOWN_MS)
    axes[0, 0].set_ylabel("mean zero-lag R²")
    axes[1, 0].set_ylabel("median $T_{diff}$ (ms), above 0: early")
    axes[2, 0].set_ylabel("recognised, without a task (%)")
    for below in axes[2]:
        below.set_xscale("log")
        below.set_xticks(durations, [f"{duration:g}" for duration in durations])
        below.xaxis.set_minor_locator(NullLocator())
        below.set_xlabel("duration of the gesture (s)")
    axes[0, 0].legend(loc="lower left", fontsize=9)
    save(figure, path)


def draw_line(axes: Axes, durations: list[float], values: list[float], condition: str) -> None:
    style = STYLES[condition]
    axes.plot(durations, values, "o-", color=style.colour, lw=style.width, ms=4, label=style.label)


def mark_beyond(
    axes: Axes, durations: list[float], lines: dict[str, list[float]], shown: tuple[float, float], number: str
) -> None:
    """Writes each value beyond the edge at the edge, in the colour of its line."""
    for place, duration in enumerate(durations):
        for edge, side, up in ((0.02, "bottom", 1), (0.98, "top", -1)):
            row = 0
            for condition, values in lines.items():
                value = values[place]
                if value < shown[0] if side == "bottom" else value > shown[1]:
                    axes.annotate(
                        number.format(value),
                        (duration, edge),
                        xycoords=axes.get_xaxis_transform(),
                        xytext=(0, 10 * up * row),
                        textcoords="offset points",
                        color=STYLES[condition].colour,
                        ha="right" if place == len(durations) - 1 else "center",
                        va=side,
                        fontsize=8.5,
                        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
                    )
                    row += 1
