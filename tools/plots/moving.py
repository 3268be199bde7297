#!/usr/bin/env python3
"""Draws one trial as a moving picture: the hand, the tracker's motion, SteadyHand's motion, and the vibration."""

import argparse
import io
import json
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from PIL import Image
from plots.curves import STYLES, read_curves, read_wav, shown_span
from plots.style import plt
from whole_file import whole

SLOWER = 2.0  # than the hand, because a drag takes 1 s
FRAMES_PER_S = 15
LAST_FRAME_S = 1.5
MARGIN_S = 0.2  # shown before the gesture
COLOURS = 48
DPI = 80
LANES = {"reference": "the hand", "measured": "tracker", "synthesised": "SteadyHand"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("curves", type=Path, metavar="CURVES.csv")
    parser.add_argument("--wav", type=Path, required=True, help="the vibration of the same trial")
    parser.add_argument("--of", type=Path, required=True, metavar="FILE.json", help="vibration.json of the demo")
    parser.add_argument("--out", type=Path, required=True, metavar="FILE.gif")
    given = parser.parse_args()

    curves = read_curves(given.curves)
    t, samples = read_wav(given.wav)
    played = json.loads(given.of.read_text())
    shown = {name: curves[name] for name in ("t", *LANES)}
    _, end = shown_span(shown, played["cue_s"])
    span = (played["start_s"] - MARGIN_S, end)
    save(frames(shown, t + played["wav_start_s"], samples, span), given.out)


def frames(
    curves: dict[str, np.ndarray], t: np.ndarray, samples: np.ndarray, span: tuple[float, float]
) -> list[Image.Image]:
    """t, samples: of the vibration. span: first and last time shown (s)."""
    begin, end = span
    figure, axes = plt.subplots(3, 1, figsize=(8, 5.2), height_ratios=[1.2, 2.4, 1], layout="constrained", dpi=DPI)
    lanes, motion, vibration = axes
    dots, lines = {}, {}
    for height, (name, label) in enumerate(reversed(LANES.items())):
        colour = STYLES[name].colour
        (dots[name],) = lanes.plot([0.0], [height], "o", ms=15, color=colour)
        (lines[name],) = motion.plot([], [], color=colour, lw=2.4, ls=STYLES[name].dashes)
        lanes.text(-0.1, height, label, ha="right", va="center", color=colour, fontweight="bold")
    lanes.axvspan(0.95, 1.05, color="#dddddd")
    lanes.text(1.0, 2.75, "target", ha="center")
    lanes.set(xlim=(-0.1, 1.15), ylim=(-0.6, 2.6), yticks=[], xticks=[])
    lanes.spines[:].set_visible(False)
    motion.set(xlim=(begin, end), ylim=(-0.08, 1.12), ylabel="share of the amplitude", xticklabels=[])
    (wave,) = vibration.plot([], [], color=STYLES["synthesised"].colour, lw=0.5)
    vibration.set(xlim=(begin, end), ylim=(-1.05, 1.05), yticks=[], ylabel="vibration", xlabel="time (s)")
    drawn = []
    for now in np.arange(begin, end, 1.0 / (FRAMES_PER_S * SLOWER)):
        past = curves["t"] <= now
        for name in LANES:
            lines[name].set_data(curves["t"][past], curves[name][past])
            dots[name].set_xdata([curves[name][past][-1] if past.any() else 0.0])
        wave.set_data(t[t <= now], samples[t <= now])
        drawn.append(image_of(figure))
    plt.close(figure)
    return drawn


def image_of(figure: Figure) -> Image.Image:
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=DPI)
    return Image.open(buffer).convert("RGB")


def save(drawn: list[Image.Image], path: Path) -> None:
    """Uses the palette of the last frame, which has all colours."""
    palette = drawn[-1].quantize(COLOURS)
    pictures = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in drawn]
    durations_ms = [1000 // FRAMES_PER_S] * (len(pictures) - 1) + [round(1000 * LAST_FRAME_S)]
    with whole(path) as part:
        pictures[0].save(
            part, format="GIF", save_all=True, append_images=pictures[1:], duration=durations_ms, loop=0, optimize=True
        )


if __name__ == "__main__":
    main()
