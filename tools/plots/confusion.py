"""Confusion tables side by side."""

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from plots.style import plt, save


def draw_confusions(path: Path, tables: dict[str, dict[str, dict[str, int]]]) -> None:
    """tables: {title: {done: {recognised: trials}}}"""
    figure, axes = plt.subplots(
        1,
        len(tables),
        figsize=(4.9 * len(tables), 4.4),
        squeeze=False,
        layout="constrained",
    )
    for place, (title, table) in zip(axes[0], tables.items(), strict=True):
        draw_confusion(place, title, table)
    save(figure, path)


def draw_confusion(axes: Axes, title: str, table: dict[str, dict[str, int]]) -> None:
    recognised = list(dict.fromkeys(name for row in table.values() for name in row))
    counts = np.array([[row.get(name, 0) for name in recognised] for row in table.values()])
    shares = counts / np.maximum(counts.sum(axis=1, keepdims=True), 1)
    axes.imshow(shares, cmap="Blues", vmin=0, vmax=1, aspect="auto")
    axes.grid(visible=False)
    for i, j in np.ndindex(counts.shape):
        if counts[i, j]:
            colour = "white" if shares[i, j] > 0.5 else "black"
            axes.text(j, i, f"{counts[i, j]}\n{shares[i, j]:.1%}", color=colour, ha="center", va="center", size=9)
    axes.set_xticks(range(len(recognised)), [name.replace("_", "\n") for name in recognised])
    axes.set_yticks(range(len(table)), [name.replace("_", "\n") for name in table])
    axes.set_xlabel("recognised")
    axes.set_ylabel("done")
    axes.set_title(title)
