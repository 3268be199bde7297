#!/usr/bin/env python3
"""Draws the curves of one trial (TRIAL.curves.csv), as the paper's Fig. 6, and the vibration of a WAV file below."""

import argparse
import csv
import json
import sys
import wave
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from conditions import TITLES
from gesture_end import END_LEVEL
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from plots.style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, plt, save

MARGIN_S = 0.35  # shown before the reference's onset, and after the last curve's end or the end cue
LEFT = 0.02  # share of the amplitude


@dataclass
class Style:
    label: str
    colour: str
    width: float
    dashes: str = "-"


@dataclass
class Mark:
    t_s: float
    label: str
    colour: str
    dashes: str


# In the order in which they are drawn, the last on top.
STYLES = {
    "one_euro": Style(TITLES["one_euro"], GREEN, 1.1),
    "average": Style(TITLES["average"], ORANGE, 2.0),
    "measured": Style(TITLES["measured"], VERMILION, 1.4),
    "kalman": Style(TITLES["kalman"], PURPLE, 1.4, (0, (2, 2))),
    "reference": Style("reference", BLACK, 2.6, (0, (4, 1.5))),
    "paper": Style("synthesised, paper", SKY, 2.0),
    "phase": Style("synthesised, phase", BLUE, 2.6),
    "synthesised": Style(TITLES["synthesised"], BLUE, 2.6),
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


def shown_span(curves: dict[str, np.ndarray], cue_s: float | None = None) -> tuple[float, float]:
    """From the reference's onset to the last curve's end or the end cue, with a margin."""
    t = curves["t"]
    reference = curves.get("reference", curves["measured"])
    leaves = t[np.argmax(reference > LEFT)]
    motions = [curve for name, curve in curves.items() if name != "t"]
    arrivals = [t[np.argmax(motion >= END_LEVEL)] for motion in motions if max(motion) >= END_LEVEL]
    end = min(max(arrivals, default=t[-1]) + MARGIN_S, t[-1])
    return max(leaves - MARGIN_S, t[0]), max(end, cue_s + MARGIN_S) if cue_s else end


def marks(curves: dict[str, np.ndarray], played: dict) -> list[Mark]:
    """Marks of a played trial (vibration.json)."""
    found = []
    if "reference" in curves:
        t, reference = curves["t"], curves["reference"]
        level = END_LEVEL * np.interp(played["end_s"], t, reference)
        there = np.flatnonzero((t >= played["start_s"]) & (reference >= level))
        found += [Mark(t[there[0]], "the hand's end, by the reference", BLACK, ":")] if len(there) else []
    if played["cue_s"] is not None:
        found.append(Mark(played["cue_s"], "the end cue begins", BLUE, "-."))
    return found


def title_of(played: dict) -> str:
    gesture = played["gesture"].replace("_", " ")
    return f"{gesture}, {played['position']}, synthesised in {played['mode']} mode: {played['trial']}"


def draw_marks(axes: Axes, of: list[Mark]) -> list[Line2D]:
    return [axes.axvline(mark.t_s, color=mark.colour, lw=1.3, ls=mark.dashes, label=mark.label) for mark in of]


def draw_curves(axes: Axes, curves: dict[str, np.ndarray], of: Iterable[Mark] = ()) -> None:
    lines = {}
    for name, style in STYLES.items():
        if name in curves:
            (lines[name],) = axes.plot(
                curves["t"], curves[name], color=style.colour, lw=style.width, ls=style.dashes, label=style.label
            )
    axes.set_ylabel("motion element\n(share of the amplitude)")
    handles = [lines[name] for name in LEGEND_ORDER if name in lines] + draw_marks(axes, of)
    # Outside of the axes, because curves may be anywhere.
    axes.figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=9)


def draw_vibration(axes: Axes, t: np.ndarray, samples: np.ndarray) -> None:
    axes.plot(t, samples, color=STYLES["synthesised"].colour, lw=0.5)
    axes.set_ylabel("vibration\n(full scale)")
    axes.set_ylim(-1.05, 1.05)
    axes.set_yticks([-1, 0, 1])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("curves", type=Path, metavar="CURVES.csv")
    parser.add_argument("--wav", type=Path, help="the vibration of the same trial")
    parser.add_argument("--of", type=Path, metavar="FILE.json", help="the played trial: vibration.json of the demo")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.png")
    given = parser.parse_args()

    curves = read_curves(given.curves)
    played = json.loads(given.of.read_text()) if given.of else None
    marked = marks(curves, played) if played else []
    rows = 2 if given.wav else 1
    figure, axes = plt.subplots(
        rows,
        1,
        figsize=(9, 4.3 + 1.6 * (rows - 1)),
        sharex=True,
        squeeze=False,
        layout="constrained",
        height_ratios=[3, 1][:rows],
    )
    draw_curves(axes[0, 0], curves, marked)
    if given.wav:
        t, samples = read_wav(given.wav)
        draw_vibration(axes[1, 0], t + (played["wav_start_s"] if played else curves["t"][0]), samples)
        draw_marks(axes[1, 0], marked)
    axes[0, 0].set_title(title_of(played) if played else "", size=11)
    axes[0, 0].set_xlim(*shown_span(curves, played["cue_s"] if played else None))
    axes[-1, 0].set_xlabel("time (s)")
    save(figure, given.out)


if __name__ == "__main__":
    main()
