#!/usr/bin/env python3
"""Draws a trained model as the paper's Fig. 3: the recordings, the reference curve, the states' motion elements."""

import argparse
import csv
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from plots.style import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION, plt, save

STATE_COLOURS = [BLUE, ORANGE, GREEN, PURPLE]
MOST_RECORDINGS_OPACITY = 0.5


@dataclass
class Recording:
    kept: bool
    r2: float
    curve: np.ndarray


def read_recordings(path: Path) -> list[Recording]:
    with path.open(newline="") as file:
        return [Recording(row[1] == "1", float(row[2]), np.array(row[3:], float)) for row in csv.reader(file)]


def draw_recordings(axes: Axes, recordings: list[Recording]) -> None:
    kept = [recording for recording in recordings if recording.kept]
    dropped = [recording for recording in recordings if not recording.kept]
    opacity = min(MOST_RECORDINGS_OPACITY, 40 / max(len(kept), 1))
    for recording in kept:
        axes.plot(np.linspace(0, 1, len(recording.curve)), recording.curve, color=GREY, lw=0.8, alpha=opacity)
    for recording in dropped:
        axes.plot(np.linspace(0, 1, len(recording.curve)), recording.curve, color=VERMILION, lw=0.9, ls=(0, (4, 2)))
    axes.plot([], [], color=GREY, lw=1.2, label=f"recordings kept: {len(kept)}")
    if dropped:
        axes.plot([], [], color=VERMILION, lw=1.2, ls=(0, (4, 2)), label=f"dropped: {len(dropped)}")


def draw_reference(axes: Axes, model: dict) -> None:
    mean, deviation = np.array(model["reference_mean"]), np.array(model["reference_deviation"])
    phase = np.linspace(0, 1, len(mean))
    axes.fill_between(
        phase, mean - deviation, mean + deviation, color=SKY, alpha=0.45, lw=0, label="mean ± 1 sd", zorder=3
    )
    for number, element in enumerate(model["elements"]):
        local = np.linspace(0, 1, 60)
        begin, end = element["phase_begin"], element["phase_end"]
        value = np.polynomial.polynomial.polyval(local, element["polynomial"])
        colour = STATE_COLOURS[number % len(STATE_COLOURS)]
        axes.plot(begin + local * (end - begin), value, color=colour, lw=3, zorder=4)
        if number > 0:
            axes.axvline(begin, color="black", lw=0.8, ls=":", zorder=2)
        duration = f"{1000 * element['duration_mean_s']:.0f}±{1000 * element['duration_deviation_s']:.0f} ms"
        axes.text(
            (begin + end) / 2, 1.12, f"state {number}\n{duration}", color=colour, ha="center", va="center", size=9
        )
    axes.plot([], [], color="black", lw=3, label="polynomial of each state")


def draw_training(axes: Axes, objective: list[float]) -> None:
    axes.plot(range(1, len(objective) + 1), objective, color=BLUE, marker="o", ms=3.5, lw=1.4)
    axes.set_title("Baum-Welch", size=11)
    axes.set_xlabel("iteration")
    axes.set_ylabel("log-likelihood + log-prior (nats)")
    axes.xaxis.get_major_locator().set_params(integer=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("model", type=Path, metavar="FILE.gesture")
    parser.add_argument("recordings", type=Path, metavar="GESTURE.recordings.csv")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.png")
    given = parser.parse_args()

    model = json.loads(given.model.read_text())
    recordings = read_recordings(given.recordings)
    figure, (curves, training) = plt.subplots(1, 2, figsize=(10, 4.6), width_ratios=[2.4, 1], layout="constrained")
    draw_recordings(curves, recordings)
    draw_reference(curves, model)
    # Outliers are cut, so that the other curves stay large.
    curves.set_xlim(0, 1)
    curves.set_ylim(max(-0.25, min(recording.curve.min() for recording in recordings) - 0.05), 1.22)
    curves.set_yticks([0, 0.25, 0.5, 0.75, 1])
    curves.set_xlabel("normalised time")
    curves.set_ylabel("normalised motion element")
    curves.legend(loc="lower right", framealpha=0.95, fontsize=9)
    provenance = model["provenance"]
    gesture = model["gesture"].replace("_", " ")
    mean_ms, deviation_ms = 1000 * model["duration_mean_s"], 1000 * model["duration_deviation_s"]
    threshold, program = provenance["r2_threshold"], provenance["trained_with"]
    figure.suptitle(
        f"{gesture}: {mean_ms:.0f} ± {deviation_ms:.0f} ms, $T_h$ = {threshold:g}, trained with {program}", size=12
    )
    draw_training(training, provenance["objective"])
    save(figure, given.out)


if __name__ == "__main__":
    main()
