"""Writes a small study as docs/study_files.md defines it. The same seed gives the same files."""

import csv
import json
import math
import random
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path

from study_export.columns import ANSWERS, CONDITIONS, CURVES, EVENTS, JOINTS, MOTION, TRIALS

PLAN = [
    ("tap", "stable", "measured"),
    ("horizontal_drag", "unstable", "synthesised"),
    ("tap", "unstable", "average"),
    ("horizontal_drag", "stable", "one_euro"),
]
TRACK = ["t", *(f"{joint}_{axis}" for joint in JOINTS for axis in "xyz"), "confidence"]
RUN_GAP_S = 30.0


@dataclass(frozen=True)
class Kind:
    origin: str
    reference: str  # sensor, truth, or empty
    source: str
    reference_name: str


PERSON = Kind("person", "sensor", "XRHandSource", "LibertySource")
SYNTHETIC = Kind("synthetic", "truth", "SyntheticSource", "")
ALONE = Kind("person", "", "XRHandSource", "")


def write_study(root: Path, seed: int = 1) -> None:
    """Two participants with two sessions each."""
    draw = random.Random(seed)
    for participant, number, kind in (
        ("ann", 1, PERSON),
        ("ann", 2, ALONE),
        ("sim1", 1, SYNTHETIC),
        ("sim1", 2, SYNTHETIC),
    ):
        write_session(root / f"sub-{participant}" / f"ses-{number:02d}", participant, number, kind, draw)


def write_session(folder: Path, participant: str, number: int, kind: Kind, draw: random.Random) -> None:
    """The first trial is for practice; the program is started again before the last trial."""
    folder.mkdir(parents=True)
    started = datetime(2026, 5, 4 + number, 9, 30)
    whose = {"participant": participant, "session": str(number), "origin": kind.origin}
    trials, answers, events = [], [], []
    clock, last_run = 100.0, 0
    for index, (gesture, position, condition) in enumerate(PLAN, start=1):
        run = 2 if index == len(PLAN) else 1
        if run == 2:  # in run 1 the program ended during this trial
            events.append([f"{clock:.6f}", "1", str(index), "target_shown", ""])
        if run != last_run:
            clock = 100.0 + 7.0 * run
            begun = started + timedelta(seconds=RUN_GAP_S * run)
            events.append([f"{clock:.6f}", str(run), "", "run_started", begun.isoformat()])
            last_run = run
        shown = clock + 2.0 + draw.random()
        onset, end = shown + 0.3 + draw.random() / 5, shown + 0.9 + draw.random() / 5
        is_missed = index == 3
        trial = {
            **whose,
            "trial": str(index),
            "block": "1" if index < 3 else "2",
            "repetition": "1",
            "run": str(run),
            "practice": str(int(index == 1)),
            "gesture": gesture,
            "position": position,
            "condition": condition,
            "amplitude_m": "0.200000",
            "width_m": "0.040000",
            "shown_s": f"{shown:.6f}",
            "onset_s": "" if is_missed else f"{onset:.6f}",
            "end_s": "" if is_missed else f"{end:.6f}",
            "recognised": "" if is_missed else gesture,
            "aborts": str(int(is_missed)),
            "losses": "1",
            "end_value_m": "" if is_missed else f"{0.2 + draw.gauss(0, 0.01):.6f}",
            "reference": kind.reference,
            "finished": (started + timedelta(seconds=clock)).isoformat(),
        }
        for curve in CURVES:
            for name in ("r2", "r2_zero", "lag", "t_diff"):
                trial[f"{name}_{curve}"] = f"{draw.random():.6f}" if kind.reference else ""
        trials.append([trial[column.name] for column in TRIALS])
        write_trial(folder / f"trial_{index:04d}", shown, end, kind, draw)
        moments = [(shown, "target_shown", ""), (onset, "abort" if is_missed else "onset", gesture)]
        moments += [(onset + 0.1, "tracking_lost", ""), (onset + 0.2, "tracking_restored", "")]
        moments += [] if is_missed else [(end, "end", gesture)]
        events += [[f"{t:.6f}", str(run), str(index), event, value] for t, event, value in moments]
        if index in (2, 4):
            events.append([f"{end + 1:.6f}", str(run), "", "questionnaire_shown", "likert"])
            text = 'It was easy, "steady" and mine'
            asked = [("control", text, str(draw.randint(1, 7)), "0"), ("comfort", "It hurt", "", "1")]
            answers += [
                [*whose.values(), str(run), str(index), gesture, position, condition, "likert", item, text, value]
                + ["1", "7", skipped, "0", f"{end + 1:.6f}", f"{end + 3:.6f}"]
                for item, text, value, skipped in asked
            ]
        clock = end + 5.0
    events.append([f"{clock:.6f}", str(last_run), "", "run_ended", (started + timedelta(seconds=200)).isoformat()])
    write_csv(folder / "trials.csv", [column.name for column in TRIALS], trials)
    write_csv(folder / "answers.csv", [column.name for column in ANSWERS], answers)
    write_csv(folder / "events.csv", [column.name for column in EVENTS], events)
    (folder / "session.json").write_text(json.dumps(about(participant, number, kind, started), indent="\t"))


def write_trial(stem: Path, shown: float, end: float, kind: Kind, draw: random.Random) -> None:
    """Frames at about 60 Hz, without a hand for 0.1 s and without a thumb for one frame; the reference at 240 Hz."""
    seconds = end + 0.5 - shown

    def reach(t: float) -> float:
        return 0.2 / (1.0 + math.exp(-(t - seconds / 2) * 9.0))

    def frames(rate: float, noise: float, jitter: float) -> Iterable[list[str]]:
        for index in range(int(seconds * rate)):
            t = (index + jitter * draw.random()) / rate
            is_lost = jitter > 0 and 0.4 < t < 0.5
            row = [f"{shown + t:.6f}"]
            for joint in JOINTS:
                is_seen = not is_lost and not (joint == "thumb" and index == 3)
                row += [f"{reach(t) + draw.gauss(0, noise):.6f}" if is_seen else "" for _ in "xyz"]
            yield [*row, "0.000" if is_lost else "0.987"]

    write_csv(stem.with_name(stem.name + ".frames.csv"), TRACK, frames(60.0, 0.004, 0.5))
    if kind.reference:
        write_csv(stem.with_name(stem.name + ".reference.csv"), TRACK, frames(240.0, 0.0002, 0.0))
    rows = []
    for index in range(int(seconds * 1000)):
        value = reach(index / 1000)
        reference = f"{value:.6f}" if kind.reference else ""
        motions = [f"{value + draw.gauss(0, 0.002):.6f}" for _ in CONDITIONS]
        rows.append([f"{shown + index / 1000:.6f}", *motions, reference, "2", f"{value / 0.2:.6f}", "0.5"])
    write_csv(stem.with_name(stem.name + ".motion.csv"), [column.name for column in MOTION], rows)


def about(participant: str, number: int, kind: Kind, started: datetime) -> dict:
    plan = [
        {
            "trial": index,
            "block": 1 if index < 3 else 2,
            "practice": index == 1,
            "gesture": gesture,
            "position": position,
            "condition": condition,
            "repetition": 1,
            "amplitude_m": 0.2,
            "width_m": 0.04,
            "rest_before_s": 0.0,
        }
        for index, (gesture, position, condition) in enumerate(PLAN, start=1)
    ]
    return {
        "format": "steadyhand-session",
        "version": 1,
        "study": "drags",
        "participant": participant,
        "session": number,
        "origin": kind.origin,
        "seed": 7,
        "protocol": {"repetitions": 1},
        "trials": plan,
        "questionnaires": [
            {"after_trial": 2, "questionnaire": "likert"},
            {"after_trial": 4, "questionnaire": "likert"},
        ],
        "settings": {
            "mode": "phase",
            "quality": 0.5,
            "sensor_latency_s": 0.007,
            "source": kind.source,
            "reference": kind.reference_name,
        },
        "versions": {"steadyhand": "0.1.0", "godot": "4.4"},
        "machine": {"os": "Linux", "processor": "x86_64", "xr_runtime": "", "screen_hz": 60.0},
        "started": started.isoformat(),
    }


def write_csv(path: Path, header: list[str], rows: Iterable[list[str]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(header)
        lines.writerows(rows)
