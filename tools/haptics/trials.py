"""Envelope error and cue error (SPEC's metrics) of the vibration of recorded hands, by condition."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from haptics import signals
from results.evaluation import run_tool

SPRING_HZ = 180.0
MARGIN_S = 0.25  # compared on either side of the gesture
ENDS_WITH_A_CUE = ("horizontal_drag", "vertical_drag", "tap")


@dataclass
class Felt:
    gesture: str
    position: str
    condition: str
    envelope_error: float
    cue_error_s: float | None  # positive: late


def measure(trials: Path, work: Path) -> list[Felt]:
    work.mkdir(parents=True)
    run_tool("vibrate_trials", {"trials": trials, "out": work})
    report = json.loads((work / "vibrations.json").read_text())
    return [felt for row in report["trials"] for felt in read_trial(work, report, row)]


def read_trial(work: Path, report: dict, row: dict) -> list[Felt]:
    rate_hz, curve_hz = report["wav_rate"], report["curve_rate"]
    curve = np.fromfile(work / f"{row['trial']}.reference.f64", "<f8")
    times = row["first_s"] + np.arange(len(curve)) / curve_hz
    wanted = np.clip(curve, 0.0, 1.0)  # the spring's amplitude by the position
    compared = (times >= row["start_s"] - MARGIN_S) & (times <= row["end_s"] + MARGIN_S)
    rows = []
    for condition, first_s in row["conditions"].items():
        spring = signals.read_wav(work / f"{row['trial']}.{condition}.spring.wav")
        heard = signals.envelope(spring, rate_hz, SPRING_HZ)
        at = np.interp(times, first_s + np.arange(len(heard)) / rate_hz, heard)
        error = float(np.sqrt(np.mean((at - wanted)[compared] ** 2)))
        cue = signals.onset(signals.read_wav(work / f"{row['trial']}.{condition}.cue.wav"))
        cue_error_s = None
        if cue is not None:
            cue_error_s = first_s + cue / rate_hz - row["reference_end_s"]
        rows.append(Felt(row["gesture"], row["position"], condition, error, cue_error_s))
    return rows
