#!/usr/bin/env python3
"""Draws the accuracy of the motion over the cost of a frame, from the output of bench_quality."""

import argparse
import csv
from pathlib import Path

from matplotlib.axes import Axes
from plots.style import BLACK, BLUE, GREEN, GREY, VERMILION, plt, save

PRESET_COLOURS = {"paper": VERMILION, "fast": GREEN, "balanced": GREEN, "accurate": GREEN}
KINDS = [
    ("o", VERMILION, 8, "paper mode as it ships"),
    ("o", VERMILION, 4, "paper mode: another model, or float"),
    ("v", VERMILION, 5, "paper mode: fixed-lag Viterbi"),
    ("^", VERMILION, 5, "paper mode: filter"),
    ("o", GREEN, 8, "phase mode: a preset"),
    ("o", GREY, 4, "phase mode: another setting"),
]
COST = "x_paper"


def read_rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def front(points: list[tuple[float, float]], sign: int) -> list[tuple[float, float]]:
    """Settings that are better than all cheaper ones, from cheap to expensive. sign: -1 if less is better."""
    kept = []
    for cost, accuracy in sorted(points):
        if not kept or sign * accuracy > sign * kept[-1][1]:
            kept.append((cost, accuracy))
    return kept


def draw(axes: Axes, rows: list[dict[str, str]], column: str, title: str, sign: int = 1) -> None:
    points = [(float(row[COST]), float(row[column])) for row in rows]
    axes.step(*zip(*front(points, sign), strict=True), where="post", color=BLACK, lw=1, label="front")
    for row, (cost, accuracy) in zip(rows, points, strict=True):
        name = row["setting"]
        is_paper = row["hypotheses"] == "0"
        colour = PRESET_COLOURS["paper"] if is_paper else PRESET_COLOURS.get(name, GREY)
        marker = {"filter": "^", "viterbi": "o" if row["lag"] == "0" else "v"}[row["decoder"]]
        axes.plot(cost, accuracy, marker, color=colour, ms=8 if name else 5 if marker in "^v" else 4)
        if name:
            # On the free side, and away from the right edge.
            above, side = (24 * sign, "left") if name == "paper" else (-10 * sign, "right")
            axes.annotate(
                name,
                (cost, accuracy),
                textcoords="offset points",
                xytext=(10 if name == "paper" else 0, above),
                rotation=30 * sign,
                ha=side,
                va="top" if sign > 0 else "bottom",
                size=9,
            )
    held = [row for row in rows if float(row["outputs_per_s"]) < 1000]
    axes.plot(
        [float(row[COST]) for row in held],
        [float(row[column]) for row in held],
        "s",
        color=BLUE,
        mfc="none",
        ms=8,
        label="250 outputs a second",
    )
    for marker, colour, size, label in KINDS:
        axes.plot([], [], marker, color=colour, ms=size, label=label)
    axes.set_xscale("log")
    ticks = [0.5, 1, 2, 4, 8]
    axes.set_xticks(ticks, [str(tick) for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel("cost of a frame with its outputs, times paper mode's")
    axes.set_title(title, size=11)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rows", type=Path, metavar="QUALITY.csv")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.png")
    given = parser.parse_args()

    rows = read_rows(given.rows)
    figure, panels = plt.subplots(1, 3, figsize=(14, 5), layout="constrained")
    draw(panels[0], rows, "r2_zero_stable", "mean zero-lag R$^2$, stable tracking")
    draw(panels[1], rows, "r2_zero_unstable", "mean zero-lag R$^2$, unstable tracking")
    draw(panels[2], rows, "t_diff_s", "mean size of T_diff, s", sign=-1)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=9)
    save(figure, given.out)


if __name__ == "__main__":
    main()
