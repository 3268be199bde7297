"""Figures of a trial against the duration of the gesture."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import NullLocator
from plots.box_plots import POSITIONS
from plots.curves import STYLES
from plots.style import plt, save

CONDITIONS = ["measured", "one_euro", "paper", "phase"]
MODES = ["paper", "phase"]
R2_SHOWN = (0.0, 1.02)
T_DIFF_SHOWN_MS = (-320.0, 320.0)

Values = Callable[[float, str, str, str], np.ndarray]  # of duration, position, figure, condition
Share = Callable[[float, str, str], float]  # of duration, position, mode


def draw_speed(path: Path, durations: list[float], values: Values, recognised: Share) -> None:
    figure, axes = plt.subplots(3, 2, figsize=(10, 8.6), sharex=True, sharey="row", layout="constrained")
    for column, position in enumerate(POSITIONS):
        for condition in CONDITIONS:
            r2 = [np.mean(values(d, position, "r2_zero", condition)) for d in durations]
            t_diff = [1000 * np.median(values(d, position, "t_diff", condition)) for d in durations]
            draw_line(axes[0, column], durations, r2, condition)
            draw_line(axes[1, column], durations, t_diff, condition)
        for mode in MODES:
            shares = [100 * recognised(d, position, mode) for d in durations]
            draw_line(axes[2, column], durations, shares, mode)
        axes[0, column].set_title(position)
        axes[1, column].axhline(0, color="black", lw=0.8, zorder=1)
    axes[0, 0].set_ylim(*R2_SHOWN)
    axes[1, 0].set_ylim(*T_DIFF_SHOWN_MS)
    axes[0, 0].set_ylabel("mean R² at no lag")
    axes[1, 0].set_ylabel("median $T_{diff}$ (ms), above 0: early")
    axes[2, 0].set_ylabel("recognised, nothing given (%)")
    for below in axes[2]:
        below.set_xscale("log")
        below.set_xticks(durations, [f"{duration:g}" for duration in durations])
        below.xaxis.set_minor_locator(NullLocator())
        below.set_xlabel("duration of the gesture (s)")
    axes[0, 1].legend(loc="lower right", fontsize=9)
    save(figure, path)


def draw_line(axes: Axes, durations: list[float], values: list[float], condition: str) -> None:
    style = STYLES[condition]
    axes.plot(durations, values, "o-", color=style.colour, lw=style.width, ms=4, label=style.label)
