#!/usr/bin/env python3
"""Draws the cost of a frame against how near the motion comes, for what bench_quality has measured."""

import argparse
import csv
from pathlib import Path

from matplotlib.axes import Axes
from plots.style import BLACK, BLUE, GREEN, GREY, VERMILION, plt, save

PRESET_COLOURS = {"paper": VERMILION, "fast": GREEN, "balanced": GREEN, "accurate": GREEN}
COST = "x_paper"


def read_rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def front(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Those that no cheaper one equals, from cheap to dear."""
    kept = []
    for cost, accuracy in sorted(points):
        if not kept or accuracy > kept[-1][1]:
            kept.append((cost, accuracy))
    return kept


def draw(axes: Axes, rows: list[dict[str, str]], column: str, title: str) -> None:
    points = [(float(row[COST]), float(row[column])) for row in rows]
    axes.step(*zip(*front(points), strict=True), where="post", color=BLACK, lw=1, label="front")
    for row, (cost, accuracy) in zip(rows, points, strict=True):
        name = row["setting"]
        axes.plot(cost, accuracy, "o", color=PRESET_COLOURS[name] if name else GREY, ms=8 if name else 4)
        if name:
            below, side = (24, "left") if name == "paper" else (-10, "right")
            axes.annotate(
                name,
                (cost, accuracy),
                textcoords="offset points",
                xytext=(0, below),
                rotation=30,
                ha=side,
                va="top",
                size=9,
            )
    held = [row for row in rows if float(row["outputs_per_s"]) < 1000]
    axes.plot(
        [float(row[COST]) for row in held],
        [float(row[column]) for row in held],
        "s",
        color=BLUE,
        ms=5,
        label="presets, 250 outputs a second",
    )
    axes.set_xscale("log")
    axes.set_xlabel("cost of a frame with its outputs, times that of paper mode")
    axes.set_title(title, size=11)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rows", type=Path, metavar="QUALITY.csv")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.png")
    given = parser.parse_args()

    rows = read_rows(given.rows)
    figure, panels = plt.subplots(1, 2, figsize=(11, 4.4), layout="constrained")
    draw(panels[0], rows, "r2_zero_stable", "mean R$^2$ at no lag, stable tracking")
    draw(panels[1], rows, "r2_zero_unstable", "mean R$^2$ at no lag, unstable tracking")
    panels[1].legend(loc="lower right", fontsize=9)
    save(figure, given.out)


if __name__ == "__main__":
    main()
