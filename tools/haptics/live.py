"""Measures the live vibration on an audio bus of a running Godot."""

import json
import os
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from haptics import signals
from results.evaluation import ROOT, run_tool

PROJECT = ROOT / "demo_project"
SPRING_HZ = 180.0
MARGIN_S = 0.1  # left out at a recording's ends, where a filter that runs both ways has not settled


@dataclass
class Held:
    """A hand held at half the amplitude."""

    rate_hz: float
    peak_hz: float
    amplitude: float
    step: float


@dataclass
class Change:
    what: str
    step: float  # share of the waveform's own; the greater of both buses
    recovered: float  # amplitude at the end of the recording


@dataclass
class Followed:
    """A recorded hand's vibration, live and on the motion's own clock."""

    gesture: str
    spring_delay_s: float
    spring_error: float  # RMS at that delay
    spring_error_at_no_delay: float
    cue_delay_s: float | None


@dataclass
class Live:
    held: list[Held]
    changes: dict[float, list[Change]]  # by mix rate
    followed: list[Followed]
    block_frames: int


def measure(rates_hz: list[int], trials: Path, work: Path) -> Live:
    live = Live([], {}, [], 0)
    for rate_hz in rates_hz:
        print(f"live at {rate_hz} Hz", flush=True)
        out = work / f"live_{rate_hz}"
        out.mkdir(parents=True)
        with_trials = {"trials": trials} if rate_hz == rates_hz[0] else {}
        with project_at(rate_hz) as project:
            run_tool("measure_live", {"out": out, **with_trials}, project=project)
        report = json.loads((out / "live.json").read_text())
        live.held.append(read_held(out, report))
        live.changes[report["mix_rate"]] = [read_change(out, report, *row) for row in report["changes"].items()]
        for trial in report["trials"]:
            live.followed.append(read_followed(out, report, trial))
            live.block_frames = block_of(moments_of(trial))
    return live


class project_at:
    """The demo's project with another mix rate: the same files, and an override.cfg."""

    def __init__(self, rate_hz: int) -> None:
        self.rate_hz = rate_hz

    def __enter__(self) -> Path:
        self.folder = tempfile.TemporaryDirectory(prefix="steadyhand_project")
        path = Path(self.folder.name)
        for entry in PROJECT.iterdir():
            os.symlink(entry, path / entry.name)
        (path / "override.cfg").write_text(f"[audio]\n\ndriver/mix_rate={self.rate_hz}\n")
        return path

    def __exit__(self, *_) -> None:
        self.folder.cleanup()


def read_held(out: Path, report: dict) -> Held:
    rate_hz, frequency_hz = report["mix_rate"], report["frequency"]
    samples = signals.read_floats(out / "held.f32")[:, 0]
    return Held(
        rate_hz,
        signals.peak_frequency(samples, rate_hz),
        signals.amplitude_at(samples[: int(rate_hz)], rate_hz, frequency_hz),
        signals.step_share(samples, rate_hz, frequency_hz),
    )


def read_change(out: Path, report: dict, what: str, name: str) -> Change:
    rate_hz, frequency_hz = report["mix_rate"], report["frequency"]
    steps, recovered = [], 0.0
    for file in (f"{name}.f32", f"{name}_other.f32"):
        samples = signals.read_floats(out / file)[:, 0]
        if len(samples) and np.max(np.abs(samples)) > 0.1:
            steps.append(signals.step_share(samples, rate_hz, frequency_hz))
            recovered = max(recovered, float(np.max(np.abs(samples[-round(0.1 * rate_hz) :]))))
    return Change(what, max(steps, default=0.0), recovered)


def moments_of(trial: dict) -> np.ndarray:
    """Rows: time (s), frames made until then."""
    return np.array(trial["moments"]).reshape(-1, 2)


def block_of(moments: np.ndarray) -> int:
    """Frames per mix of the engine: the most frequent number above 0 between two game frames."""
    made = np.diff(moments[:, 1]).astype(int)
    return int(np.argmax(np.bincount(made[made > 0])))


def read_followed(out: Path, report: dict, trial: dict) -> Followed:
    """A block's first sample is at the output when the block is made, and its last sample one block later."""
    rate_hz, gesture = report["mix_rate"], trial["gesture"]
    moments, clock = moments_of(trial), np.array(trial["clock"]).reshape(-1, 2)
    block = block_of(moments)
    begun = moments[:, 1] > 0
    offset_s = np.min(moments[begun, 0] - moments[begun, 1] / rate_hz) + block / rate_hz
    motion_ahead_s = np.median(clock[:, 1] - clock[:, 0])
    heard = signals.read_floats(out / f"{gesture}.f32")
    first_s = offset_s + motion_ahead_s  # on the motion's clock

    wav_hz = 48000.0
    exact_first_s = np.ceil(trial["start_s"] * 1000.0) / 1000.0
    spring = signals.envelope(signals.read_wav(Path(trial["spring"])), wav_hz, SPRING_HZ)
    live_spring = signals.envelope(heard[:, 0], rate_hz, SPRING_HZ)
    last_s = min(exact_first_s + len(spring) / wav_hz, first_s + len(heard) / rate_hz) - MARGIN_S
    times = np.arange(max(exact_first_s, first_s) + MARGIN_S, last_s, 1e-3)
    delay_s, error, error_at_none = signals.delay_and_error(
        np.interp(times, exact_first_s + np.arange(len(spring)) / wav_hz, spring),
        np.interp(times, first_s + np.arange(len(heard)) / rate_hz, live_spring),
        1000.0,
        0.08,
    )
    exact_cue = signals.onset(signals.read_wav(Path(trial["cue"])))
    live_cue = signals.onset(heard[:, 1])
    cue_delay_s = None
    if exact_cue is not None and live_cue is not None:
        cue_delay_s = first_s + live_cue / rate_hz - exact_first_s - exact_cue / wav_hz
    return Followed(gesture, delay_s, error, error_at_none, cue_delay_s)
