#!/usr/bin/env python3
"""Draws the curves of one trial (TRIAL.curves.csv), as the paper's Fig. 6, and the vibration of a WAV file below."""

import argparse
import csv
import sys
import wave
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from gesture_end import END_LEVEL
from matplotlib.axes import Axes
from plots.style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, plt, save

MARGIN_S = 0.35  # shown before the reference leaves its start and after the last curve has arrived
LEFT = 0.02  # share of the amplitude


@dataclass
class Style:
    label: str
    colour: str
    width: float
    dashes: str = "-"


# In the order in which they are drawn, the last on top.
STYLES = {
    "one_euro": Style("One Euro filter", GREEN, 1.1),
    "average": Style("41-point moving average", ORANGE, 2.0),
    "measured": Style("measured", VERMILION, 1.4),
    "kalman": Style("Kalman filter", PURPLE, 1.4, (0, (2, 2))),
    "reference": Style("reference", BLACK, 2.6, (0, (4, 1.5))),
    "paper": Style("synthesised, paper", SKY, 2.0),
    "phase": Style("synthesised, phase", BLUE, 2.6),
    "synthesised": Style("synthesised", BLUE, 2.6),
}
LEGEND_ORDER = ["reference", "measured", "phase", "synthesised", "paper", "average", "one_euro", "kalman"]


def read_curves(path: Path) -> dict[str, np.ndarray]:
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        sys.exit(f"{path}: no curve in it")
    return {
        name: np.array([float(row[name]) for row in rows]) for name in rows[0] if all(row[name] != "" for row in rows)
    }


def read_wav(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Times from the first sample (s) and samples in -1..1 of the first channel of a 16-bit file."""
    with wave.open(str(path)) as file:
        if file.getsampwidth() != 2:
            sys.exit(f"{path}: {8 * file.getsampwidth()} bits a sample, not 16")
        samples = np.frombuffer(file.readframes(file.getnframes()), "<i2").reshape(-1, file.getnchannels())
        return np.arange(len(samples)) / file.getframerate(), samples[:, 0] / 32768.0


def shown_span(curves: dict[str, np.ndarray]) -> tuple[float, float]:
    """From the reference's departure to the last curve's arrival, with a margin."""
    t = curves["t"]
    reference = curves.get("reference", curves["measured"])
    leaves = t[np.argmax(reference > LEFT)]
    motions = [curve for name, curve in curves.items() if name != "t"]
    arrivals = [t[np.argmax(motion >= END_LEVEL)] for motion in motions if max(motion) >= END_LEVEL]
    return max(leaves - MARGIN_S, t[0]), min(max(arrivals, default=t[-1]) + MARGIN_S, t[-1])


def draw_curves(axes: Axes, curves: dict[str, np.ndarray]) -> None:
    lines = {}
    for name, style in STYLES.items():
        if name in curves:
            (lines[name],) = axes.plot(
                curves["t"], curves[name], color=style.colour, lw=style.width, ls=style.dashes, label=style.label
            )
    axes.set_ylabel("motion element\n(share of the amplitude)")
    axes.legend(handles=[lines[name] for name in LEGEND_ORDER if name in lines], loc="upper left", framealpha=0.95)


def draw_vibration(axes: Axes, t: np.ndarray, samples: np.ndarray) -> None:
    axes.plot(t, samples, color=STYLES["synthesised"].colour, lw=0.5)
    axes.set_ylabel("vibration\n(full scale)")
    axes.set_ylim(-1.05, 1.05)
    axes.set_yticks([-1, 0, 1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("curves", type=Path, metavar="CURVES.csv")
    parser.add_argument("--wav", type=Path, help="the vibration of the same trial, from the same instant on")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.png")
    parser.add_argument("--title", default="")
    given = parser.parse_args()

    curves = read_curves(given.curves)
    rows = 2 if given.wav else 1
    figure, axes = plt.subplots(
        rows,
        1,
        figsize=(9, 3.9 + 1.6 * (rows - 1)),
        sharex=True,
        squeeze=False,
        layout="constrained",
        height_ratios=[3, 1][:rows],
    )
    draw_curves(axes[0, 0], curves)
    if given.wav:
        t, samples = read_wav(given.wav)
        draw_vibration(axes[1, 0], curves["t"][0] + t, samples)
    axes[0, 0].set_title(given.title)
    axes[0, 0].set_xlim(*shown_span(curves))
    axes[-1, 0].set_xlabel("time (s)")
    save(figure, given.out)


if __name__ == "__main__":
    main()
