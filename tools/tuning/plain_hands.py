"""Makes a trial set of plain hands and plain trackers with one kind of fault each.

    python tools/tuning/plain_hands.py --out DIR [--seed N]

Each hand rests, makes one straight minimum-jerk movement to its task's end, and rests. In a zoom the tips of thumb,
index and middle finger are on a circle that grows. Trackers have 100 frames a second, from a random time on. Those
without a fault are the stable position, the others the unstable one. Each trial has one fault (3 of 100 frames with
isolated jumps), at a random time in the gesture, which is equal for all trackers with this fault. In a zoom only the
tip of the index jumps. The column `subject` is the tracker; tools/tuning/plain_hands_table.py makes a table of them.
Equal arguments give equal files.
"""

import argparse
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from aimed_hands import GESTURES, REFERENCE_RATE_HZ
from hybrid_trials import minimum_jerk, write_track

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from results.other_hands import HEADER
from results.sensors import Change, as_it_is, noise, rounded

DURATIONS_S = (0.4, 0.8, 1.5)
REPETITIONS = 4
REST_S = 1.0  # before, and after
START_M = np.array([0.0, -0.1, -0.3])
ZOOM_START_M, ZOOM_GROWTH_M = 0.015, 0.03  # of the radius
ZOOM_TIPS_DEGREES = {"index": 80.0, "thumb": 200.0, "middle": 30.0}  # on the circle

FAULT_LENGTHS_S = (0.1, 0.2, 0.3)
FAULT_BEGINS = (-0.2, 0.8)  # in durations of the gesture
ELSEWHERE = 0.03
OFF_M = 0.1
ZOOM_OFF_M = 0.03  # a larger jump would leave the hand
JUMP_S = 0.1
LAG_S = 0.08


@dataclass(frozen=True)
class Hand:
    gesture: str
    duration_s: float
    joints: tuple[str, ...]  # the index first
    directions: np.ndarray  # (joints, 3), unit vectors
    radius_m: float  # first distance of each joint along its direction
    amplitude_m: float
    off_m: float  # length of a jump of the index

    @classmethod
    def of(cls, gesture: str, duration_s: float) -> "Hand":
        if gesture != "zoom":
            axis, amplitude_m, _ = GESTURES[gesture]
            return cls(gesture, duration_s, ("index",), np.array([axis]), 0.0, amplitude_m, OFF_M)
        angles = np.radians(list(ZOOM_TIPS_DEGREES.values()))
        vectors = np.stack([np.cos(angles), np.sin(angles), np.zeros(len(angles))], axis=1)
        return cls(gesture, duration_s, tuple(ZOOM_TIPS_DEGREES), vectors, ZOOM_START_M, ZOOM_GROWTH_M, ZOOM_OFF_M)

    def at(self, t: np.ndarray) -> np.ndarray:
        """Positions (n, joints, 3), m."""
        distance_m = self.radius_m + self.amplitude_m * minimum_jerk((t - REST_S) / self.duration_s)
        return START_M + distance_m[:, None, None] * self.directions

    def cells(self) -> list[str]:
        """The cells from start_s to the end of HEADER."""
        task = (self.radius_m, *[""] * 5) if self.gesture == "zoom" else (*START_M, *self.directions[0])
        return [str(cell) for cell in (REST_S, REST_S + self.duration_s, *task, self.amplitude_m)]


# Adds a fault to the measured positions (n, joints, 3) of a hand at these times; nan: no frame.
Fault = Callable[[Hand, np.ndarray, np.ndarray, np.random.Generator], np.ndarray]


def random_directions(count: int, rng: np.random.Generator) -> np.ndarray:
    vectors = rng.normal(size=(count, 3))
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def during(hand: Hand, t: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """The frames of a fault with a random begin and one of the lengths."""
    begins_s = REST_S + hand.duration_s * rng.uniform(*FAULT_BEGINS)
    return (t >= begins_s) & (t < begins_s + rng.choice(FAULT_LENGTHS_S))


def freeze(trembling_m: float) -> Fault:
    def fault(hand: Hand, t: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        held = during(hand, t, rng)
        shown[held] = shown[np.argmax(held)] + rng.normal(0.0, trembling_m, shown[held].shape)
        return shown

    return fault


def gap(hand: Hand, t: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    shown[during(hand, t, rng)] = np.nan
    return shown


def frames_elsewhere(hand: Hand, t: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    shown[:, 0] += hand.off_m * (rng.random((len(t), 1)) < ELSEWHERE) * random_directions(len(t), rng)
    return shown


def jump(along: float, for_s: float = JUMP_S) -> Fault:
    """along: 1 forward, -1 back, 0 to a random side."""

    def fault(hand: Hand, t: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        begins_s = REST_S + hand.duration_s * rng.random()
        aside = np.cross(hand.directions[0], random_directions(1, rng)[0])
        direction = along * hand.directions[0] if along else aside / np.linalg.norm(aside)
        shown[(t >= begins_s) & (t < begins_s + for_s), 0] += hand.off_m * direction
        return shown

    return fault


def lasting_noise(deviation_m: float, correlation_s: float) -> Change:
    def change(t: np.ndarray, shown: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        error = rng.normal(0.0, deviation_m, shown.shape)
        for i, kept in enumerate(np.exp(-np.diff(t) / correlation_s), 1):
            error[i] = kept * error[i - 1] + np.sqrt(1.0 - kept**2) * error[i]
        return shown + error

    return change


@dataclass(frozen=True)
class Tracker:
    changes: tuple[Change, ...] = (as_it_is,)  # before the fault
    fault: Fault | None = None
    camera_hz: float = 100.0
    read_hz: float | None = None  # rate of reading, if above the camera's
    lag_s: float = 0.0

    def seen(self, hand: Hand, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """Time stamps, s, and positions, m."""
        fault_rng = rng.spawn(1)[0]  # the fault does not depend on the changes
        camera_s = np.arange(rng.random() / self.camera_hz, 2.0 * REST_S + hand.duration_s, 1.0 / self.camera_hz)
        t, shown_s = camera_s, camera_s
        if self.read_hz:
            t = np.arange(camera_s[0] + rng.random() / self.read_hz, camera_s[-1], 1.0 / self.read_hz)
            shown_s = camera_s[np.searchsorted(camera_s, t, "right") - 1]
        places = hand.at(shown_s - self.lag_s)
        for change in self.changes:
            places = change(t, places, rng)
        if self.fault:
            places = self.fault(hand, t, places, fault_rng)
        kept = ~np.isnan(places).any(axis=(1, 2))
        return t[kept], places[kept]


EXACT, NOISY = (as_it_is,), (noise(0.0002),)
TRACKERS = {
    "exact": Tracker(EXACT),
    "noise_of_0.2_mm": Tracker(NOISY),
    "noise_of_1_mm": Tracker((noise(0.001),)),
    "lasting_noise_of_1_mm": Tracker((lasting_noise(0.001, 0.1),)),
    "noise_of_0.2_mm_rounded_to_1_mm": Tracker((*NOISY, rounded(0.001))),
    "exact_30_frames_a_second": Tracker(EXACT, camera_hz=30.0),
    "exact_30_frames_a_second_read_at_90": Tracker(EXACT, camera_hz=30.0, read_hz=90.0),
    "exact_frames_elsewhere": Tracker(EXACT, frames_elsewhere),
    "noise_of_0.2_mm_frames_elsewhere": Tracker(NOISY, frames_elsewhere),
    "exact_freeze": Tracker(EXACT, freeze(0.0)),
    "noise_of_0.2_mm_freeze": Tracker(NOISY, freeze(0.0)),
    "noise_of_0.2_mm_freeze_that_trembles": Tracker(NOISY, freeze(0.0002)),
    "exact_gap": Tracker(EXACT, gap),
    "noise_of_0.2_mm_gap": Tracker(NOISY, gap),
    "exact_jump_back": Tracker(EXACT, jump(-1.0)),
    "noise_of_0.2_mm_jump_back": Tracker(NOISY, jump(-1.0)),
    "noise_of_0.2_mm_jump_aside_that_stays": Tracker(NOISY, jump(0.0, np.inf)),
    "noise_of_0.2_mm_jump_ahead": Tracker(NOISY, jump(1.0)),
    "noise_of_0.2_mm_lag_of_80_ms": Tracker(NOISY, lag_s=LAG_S),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    hands = [Hand.of(gesture, s) for gesture in (*GESTURES, "zoom") for s in DURATIONS_S * REPETITIONS]
    rows = [HEADER]
    for name, tracker in TRACKERS.items():
        position = "unstable" if tracker.fault or tracker.lag_s else "stable"
        for number, hand in enumerate(hands):
            trial = f"{name}_{hand.gesture}_{number}"
            seen = tracker.seen(hand, np.random.default_rng([options.seed, number]))
            reference_s = np.arange(0.0, 2.0 * REST_S + hand.duration_s, 1.0 / REFERENCE_RATE_HZ)
            write_track(options.out / f"{trial}.measured.csv", *seen, hand.joints)
            write_track(options.out / f"{trial}.reference.csv", reference_s, hand.at(reference_s), hand.joints)
            rows.append(",".join([trial, hand.gesture, position, name, *hand.cells()]))
    (options.out / "trials.csv").write_text("\n".join(rows) + "\n")
    print(f"{len(rows) - 1} trials in {options.out}")


if __name__ == "__main__":
    main()
