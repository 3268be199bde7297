#!/usr/bin/env python3
"""Frames of a Leap service as JSON lines, for leap_stub.py: of a track CSV, or of a synthetic drag.

    make_leap_messages.py --out drag.jsonl
    make_leap_messages.py --csv track.csv --dialect bridge --side left --out track.jsonl

The hand is rigid and points along -z. It moves so that its index fingertip follows the track.
"""

import argparse
import csv
import json
import math
import random
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

DIALECTS = ("orion", "bridge")
FIRST_TIMESTAMP_US = 810321011
FIRST_FRAME_ID = 13319

Vector = tuple[float, float, float]
Sample = tuple[float, Vector | None]
"""Time in s, and the index fingertip in m; None where there is no hand."""

# A right hand of usual size, in mm from its index fingertip: carp, mcp, pip, dip, tip of thumb .. pinky. A thumb's carp
# is its mcp.
FINGERS_MM: list[list[Vector]] = [
    [(-25, -30, 130), (-25, -30, 130), (-48, -25, 90), (-58, -20, 60), (-64, -18, 36)],
    [(6, -20, 150), (4, -12, 85), (2, -6, 43), (1, -2, 20), (0, 0, 0)],
    [(18, -20, 148), (26, -12, 82), (26, -6, 36), (26, -2, 10), (26, 0, -10)],
    [(30, -20, 148), (46, -14, 86), (49, -8, 44), (51, -4, 18), (52, -2, -2)],
    [(40, -22, 150), (64, -18, 94), (70, -12, 62), (73, -8, 42), (75, -6, 24)],
]
PALM_MM: Vector = (28, -18, 105)
WRIST_MM: Vector = (22, -24, 170)
ELBOW_MM: Vector = (22, -60, 420)


def minimum_jerk(share: float) -> float:
    """How much of the way is done at a share of the duration (Flash and Hogan 1985)."""
    s = min(max(share, 0.0), 1.0)
    return s**3 * (10.0 - 15.0 * s + 6.0 * s**2)


def synthetic_drag(
    rate_hz: float = 110.0,
    rest_before_s: float = 1.0,
    duration_s: float = 0.8,
    rest_after_s: float = 1.2,
    amplitude_m: float = 0.2,
    tremor_m: float = 1e-4,
    start_m: Vector = (-0.1, 0.2, 0.0),
    seed: int = 1,
) -> Iterator[Sample]:
    """A drag along +x with tremor of that rms on each axis, at the 8 to 12 Hz of hands."""
    chosen = random.Random(seed)
    waves = [[(chosen.uniform(8.0, 12.0), chosen.uniform(0.0, math.tau)) for _ in range(4)] for _ in range(3)]
    for i in range(round((rest_before_s + duration_s + rest_after_s) * rate_hz) + 1):
        t_s = i / rate_hz
        tremor = [
            tremor_m * sum(math.sin(math.tau * hz * t_s + phase) for hz, phase in axis) / math.sqrt(len(axis) / 2.0)
            for axis in waves
        ]
        x_m = amplitude_m * minimum_jerk((t_s - rest_before_s) / duration_s)
        yield t_s, (start_m[0] + x_m + tremor[0], start_m[1] + tremor[1], start_m[2] + tremor[2])


def track_of_csv(path: Path) -> Iterator[Sample]:
    """The index fingertip of a track CSV. Empty cells: no hand."""
    with path.open(encoding="utf-8-sig", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            cells = [row["index_x"], row["index_y"], row["index_z"]]
            yield float(row["t"]), (tuple(float(cell) for cell in cells) if all(cells) else None)


def unit(v: Vector) -> Vector:
    length = math.hypot(*v)
    return (v[0] / length, v[1] / length, v[2] / length)


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def basis(near: Vector, far: Vector, is_mirrored: bool) -> list[Vector]:
    """Rows x, y, z of the bone from `near` to `far`; z points back along it, y up."""
    if near == far:
        near, far = (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
    z = unit((near[0] - far[0], near[1] - far[1], near[2] - far[2]))
    x = unit(cross((0.0, 1.0, 0.0), z))
    y = cross(z, x)
    return [(-x[0], -x[1], -x[2]) if is_mirrored else x, y, z]


def hand_of(tip_m: Vector, time_visible_s: float, hand_id: int, is_left: bool, dialect: str) -> tuple[dict, list[dict]]:
    """The hand and its five pointables, with the fields of that dialect in its order."""

    def place(mm: Vector) -> Vector:
        return (
            tip_m[0] * 1000.0 + (-mm[0] if is_left else mm[0]),
            tip_m[1] * 1000.0 + mm[1],
            tip_m[2] * 1000.0 + mm[2],
        )

    # The original service gives left hands left-handed bases; the bridge makes them of quaternions.
    is_mirrored = is_left and dialect == "orion"
    identity = [(-1.0 if is_mirrored else 1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    hand = {
        "id": hand_id,
        "type": "left" if is_left else "right",
        "palmPosition": place(PALM_MM),
        "palmVelocity": (0.0, 0.0, 0.0),
        "palmNormal": (0.0, -1.0, 0.0),
        "direction": (0.0, 0.0, -1.0),
        "confidence": 1.0,
        "grabStrength": 0.0,
        "grabAngle": 0.4,
        "pinchStrength": 0.0,
        "pinchDistance": 58.2,
        "palmWidth": 88.9,
        "timeVisible": time_visible_s,
        "armWidth": 60.9,
        "armBasis": identity,
        "elbow": place(ELBOW_MM),
        "wrist": place(WRIST_MM),
    }
    pointables = []
    for finger, joints_mm in enumerate(FINGERS_MM):
        carp, mcp, pip, dip, tip = (place(mm) for mm in joints_mm)
        bones = [(carp, mcp), (mcp, pip), (pip, dip), (dip, tip)]
        bases = [basis(near, far, is_mirrored) for near, far in bones]
        pointable = {
            "id": hand_id * 10 + finger,
            "handId": hand_id,
            "type": finger,
            "tipPosition": tip,
            "btipPosition": tip,
            "dipPosition": dip,
            "pipPosition": pip,
            "mcpPosition": mcp,
            "carpPosition": carp,
            "direction": tuple(-part for part in bases[2][2]),
            "extended": True,
            "length": 57.6,
            "width": 18.3,
            "bases": bases,
        }
        if dialect == "orion":
            pointable["timeVisible"] = time_visible_s
        pointables.append(pointable)
    return hand, pointables


def as_text(value: object, dialect: str) -> str:
    """JSON without spaces; the bridge prints every number that is no whole one with %f."""
    if isinstance(value, float):
        return f"{value:f}" if dialect == "bridge" else json.dumps(round(value, 6))
    if isinstance(value, dict):
        return "{" + ",".join(f"{json.dumps(key)}:{as_text(part, dialect)}" for key, part in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ",".join(as_text(part, dialect) for part in value) + "]"
    return json.dumps(value)


def messages(
    samples: Iterable[Sample], dialect: str = "orion", is_left: bool = False, hand_id: int = 7
) -> Iterator[str]:
    """One frame's text for each sample. A hand that comes back has the next id, as in the services."""
    first_s = seen_since_s = None
    for i, (t_s, tip_m) in enumerate(samples):
        first_s = t_s if first_s is None else first_s
        hands: list[dict] = []
        pointables: list[dict] = []
        if tip_m is None:
            hand_id += 1 if seen_since_s is not None else 0
            seen_since_s = None
        else:
            seen_since_s = t_s if seen_since_s is None else seen_since_s
            hand, pointables = hand_of(tip_m, t_s - seen_since_s, hand_id, is_left, dialect)
            hands = [hand]
        frame = {
            "currentFrameRate": 110.7,
            "devices": [],
            "id": FIRST_FRAME_ID + i,
            "timestamp": FIRST_TIMESTAMP_US + round((t_s - first_s) * 1e6),
            "hands": hands,
            "pointables": pointables,
        }
        yield as_text(frame, dialect)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--csv", type=Path, help="a track CSV with index_x, index_y, index_z; else a synthetic drag")
    parser.add_argument("--dialect", choices=DIALECTS, default="orion")
    parser.add_argument("--side", choices=("left", "right"), default="right")
    parser.add_argument("--rest-before", type=float, default=1.0, help="of the synthetic drag, s")
    parser.add_argument("--rest-after", type=float, default=1.2, help="of the synthetic drag, s")
    parser.add_argument("--out", type=Path, help="else standard output")
    chosen = parser.parse_args()
    samples = (
        track_of_csv(chosen.csv)
        if chosen.csv
        else synthetic_drag(rest_before_s=chosen.rest_before, rest_after_s=chosen.rest_after)
    )
    text = "".join(f"{line}\n" for line in messages(samples, chosen.dialect, chosen.side == "left"))
    if chosen.out:
        chosen.out.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
