"""The tables of docs/haptics_measured.md."""

import re
import statistics
from collections.abc import Iterable

from conditions import TITLES
from haptics.live import Live
from haptics.trials import ENDS_WITH_A_CUE, Felt
from page_tables import table

CONDITIONS = {
    "reference": "the reference itself",
    **{name: TITLES[name] for name in ("measured", "average", "one_euro", "kalman")},
    "paper": "synthesised, `paper`",
    "synthesised": "synthesised, `phase`",
}
ENGINE_SAYS = re.compile(r"Godot Engine|^\s*$")


def milliseconds(seconds: float | None) -> str:
    return "" if seconds is None else f"{1000.0 * seconds:+.1f}"


def live_tables(measured: Live) -> str:
    held = table(
        ["mix rate, Hz", "spectrum's peak, Hz", "amplitude", "largest step"],
        (
            [f"{held.rate_hz:.0f}", f"{held.peak_hz:.4f}", f"{held.amplitude:.5f}", f"{held.step:.3f}"]
            for held in measured.held
        ),
    )
    rates = list(measured.changes)
    changes = table(
        ["change", *(f"{rate:.0f} Hz" for rate in rates), "amplitude after"],
        (
            [
                first.what,
                *(f"{next(c.step for c in measured.changes[rate] if c.what == first.what):.3f}" for rate in rates),
                f"{first.recovered:.2f}",
            ]
            for first in measured.changes[rates[0]]
        ),
    )
    followed = table(
        ["gesture", "delay of the envelope, ms", "error at that delay", "error without delay", "delay of the cue, ms"],
        (
            [
                row.gesture.replace("_", " "),
                milliseconds(row.spring_delay_s),
                f"{row.spring_error:.4f}",
                f"{row.spring_error_at_no_delay:.4f}",
                milliseconds(row.cue_delay_s),
            ]
            for row in measured.followed
        ),
    )
    return (
        f"A hand held at half the amplitude, 180 Hz:\n\n{held}\n"
        "Changes while a hand is held at full amplitude. Each cell: the largest step between two samples, divided by "
        f"the largest\nstep of a sine of the same amplitude.\n\n{changes}\n"
        "A recorded hand in real time, compared with the same motion rendered afterwards. The engine mixes "
        f"{measured.block_frames} samples at a time\nhere.\n\n{followed}"
    )


def trials_table(sets: dict[str, list[Felt]]) -> str:
    rows = []
    for set_name, felt in sets.items():
        groups = sorted({(row.gesture, row.position) for row in felt})
        for gesture, position in groups:
            own = [row for row in felt if (row.gesture, row.position) == (gesture, position)]
            cells = [cell([row for row in own if row.condition == c], gesture) for c in CONDITIONS]
            rows.append([f"{set_name}, {gesture.replace('_', ' ')}, {position}", *cells])
    return table(["trials", *CONDITIONS.values()], rows)


def cell(rows: list[Felt], gesture: str) -> str:
    error = statistics.fmean(row.envelope_error for row in rows)
    if gesture not in ENDS_WITH_A_CUE:
        return f"{error:.3f}"
    cues = [row.cue_error_s for row in rows if row.cue_error_s is not None]
    late = f"{1000.0 * statistics.median(cues):+.0f} ms" if cues else "none"
    return f"{error:.3f}, {late}, {len(rows) - len(cues)}"


def as_text(outputs: Iterable[str]) -> str:
    lines = [line.rstrip() for part in outputs for line in part.splitlines() if not ENGINE_SAYS.search(line)]
    return "```\n" + "\n".join(lines) + "\n```\n"
