"""Writes the frames of a tracker as a motion-BIDS recording.

One trial is one BIDS run, because a study records frames in trials only. Each recording then has no break and its own
start time, and run N is trial N of the session.
"""

import statistics
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from study_export.bids_files import MISSING, write_json, write_tsv
from study_export.columns import JOINTS, number
from study_export.tables import Findings, read_table

AXES = ("x", "y", "z")
FRAME = "world"
FRAME_LEVELS = {
    "reference_frame": {
        "LongName": "Reference frame",
        "Description": "The frame that positions are given in",
        "Levels": {
            FRAME: {
                "Description": "The world of the scene: x to the right, y up, z backward (right-handed)",
                "SpatialAxes": "RUB",
                "RotationRule": "n/a",
                "RotationOrder": "n/a",
            }
        },
    }
}
CHANNELS = ["name", "component", "type", "tracked_point", "units", "placement", "reference_frame"]
OTHER_TYPES = ["ACCEL", "ANGACCEL", "GYRO", "JNTANG", "MAGN", "ORNT", "VEL"]


@dataclass
class Recording:
    stem: Path  # of its files, up to run-N
    start_s: float  # first frame, on the run's clock
    times: list[float]
    points: int
    positions: int  # position channels
    others: int

    def median_rate(self) -> list[float]:
        """Empty: it has no two frames of different times."""
        steps = [after - before for before, after in pairwise(self.times) if after > before]
        return [1.0 / statistics.median(steps)] if steps else []


def write_recording(track: Path, stem: Path, found: Findings) -> Recording | None:
    """None: the track has no frame. The sidecar needs the rate of the whole session, and is written later."""
    frames = read_frames(track, found)
    if not frames:
        found.notes.append(f"{track}: no frame: it gets no BIDS recording")
        return None
    names = [name for name in frames[0] if name != "t"]
    points = [joint for joint in JOINTS if all(f"{joint}_{axis}" in names for axis in AXES)]
    positions = [f"{joint}_{axis}" for joint in points for axis in AXES]
    others = [name for name in names if name not in positions]
    times = [number("t", frame["t"]) for frame in frames]
    start_s = times[0]
    write_tsv(
        Path(f"{stem}_motion.tsv"),
        [],
        (
            [f"{t - start_s:.6f}", *(frame[n] for n in positions + others)]
            for t, frame in zip(times, frames, strict=True)
        ),
    )
    rows = [["latency", MISSING, "LATENCY", MISSING, "s", MISSING, MISSING]]
    rows += [[n, n[-1], "POS", n[:-2], "m", f"{n[:-2]} of the hand", FRAME] for n in positions]
    rows += [[name, MISSING, "MISC", MISSING, MISSING, MISSING, MISSING] for name in others]
    write_tsv(Path(f"{stem}_channels.tsv"), CHANNELS, rows)
    write_json(Path(f"{stem}_channels.json"), FRAME_LEVELS)
    return Recording(stem, start_s, times, len(points), len(positions), len(others))


def read_frames(track: Path, found: Findings) -> list[dict[str, str]]:
    latest = -float("inf")

    def parse(cells: dict[str, str], _line: int) -> dict[str, str]:
        nonlocal latest
        t = number("t", cells["t"])
        for name, text in cells.items():
            if text and (name == "confidence" or name.rpartition("_")[0] in JOINTS):
                number(name, text)
        if t < latest:
            raise ValueError(f"t: {cells['t']} is before the frame above it")
        latest = t
        return cells

    return read_table(track, ["t"], parse, found).rows


def write_sidecars(recordings: list[Recording], task: str, system: str, about: dict, found: Findings) -> None:
    """Of the recordings of one gesture and one tracker in a session. `about`: further keys of the sidecar."""
    rates = [rate for recording in recordings for rate in recording.median_rate()]
    rate = statistics.median(rates) if rates else 0.0
    if not rates:
        found.notes.append(
            f"{recordings[0].stem}: one frame a trial: its sampling frequency is unknown, and written as 0"
        )
    for recording in recordings:
        duration_s = recording.times[-1] - recording.start_s
        effective = (
            {"SamplingFrequencyEffective": round((len(recording.times) - 1) / duration_s, 6)} if duration_s else {}
        )
        counts = {f"{kind}ChannelCount": 0 for kind in OTHER_TYPES}
        write_json(
            Path(f"{recording.stem}_motion.json"),
            {
                "TaskName": task,
                "SamplingFrequency": round(rate, 3),
                **effective,
                "RecordingDuration": round(duration_s, 6),
                "TrackingSystemName": system,
                "TrackedPointsCount": recording.points,
                "MotionChannelCount": 1 + recording.positions + recording.others,
                "POSChannelCount": recording.positions,
                "LATENCYChannelCount": 1,
                "MISCChannelCount": recording.others,
                **counts,
                "MissingValues": MISSING,
                "SubjectArtefactDescription": MISSING,
                **about,
            },
        )
