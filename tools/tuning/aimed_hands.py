"""Aimed minimum-jerk hands before trackers of another make: a trial set that shares no code with the simulation.

    python tools/tuning/aimed_hands.py --out DIR [--hands N] [--seed N] [--halting]

Hands differ in duration, in how early their speed peaks, and in their aim: one in four falls short and corrects
itself, one in four goes too far and comes back. With --halting each stops on its way and then goes on or
returns. Trackers are late by a few ms, at the unstable position by up to 0.12 s more, from the start or growing
along the way; there they also wander (an Ornstein-Uhlenbeck process, smoothed), freeze, drop frames and jump.
Equal arguments give equal files.
"""

import argparse
import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from hybrid_trials import minimum_jerk, write_track

REFERENCE_RATE_HZ = 240.0
GESTURES = {  # axis, amplitude (m), median duration (s)
    "horizontal_drag": ((1.0, 0.0, 0.0), 0.2, 0.8),
    "vertical_drag": ((0.0, 1.0, 0.0), 0.2, 0.8),
    "tap": ((0.0, 0.0, -1.0), 0.15, 0.5),
}


@dataclass
class Way:
    t: np.ndarray  # s
    x: np.ndarray  # 0 at the start, 1: the amplitude
    start_s: float  # a little before the hand sets out
    end_s: float  # and after it has come to rest

    def at(self, t: np.ndarray) -> np.ndarray:
        return np.interp(t, self.t, np.clip(self.x, 0.0, 1.0))


def aimed(duration_s: float, rng: np.random.Generator) -> Way:
    onset_s = rng.uniform(0.5, 1.2)
    t = np.arange(0.0, onset_s + duration_s + 2.2, 1.0 / REFERENCE_RATE_HZ)
    x = minimum_jerk(np.clip((t - onset_s) / duration_s, 0.0, 1.0) ** np.exp(rng.normal(-0.05, 0.15)))
    end_s = onset_s + duration_s
    aim = rng.choice(4)
    if aim > 1:
        first = rng.uniform(0.75, 0.97) if aim == 2 else rng.uniform(1.02, 1.12)
        from_s, for_s = onset_s + duration_s * rng.uniform(0.7, 1.2), rng.uniform(0.2, 0.5)
        x = first * x + (1.0 - first) * minimum_jerk((t - from_s) / for_s)
        end_s = max(end_s, from_s + for_s)
    return Way(t, x * (1.0 + rng.normal(0.0, 0.02)), onset_s - rng.uniform(0.05, 0.3), end_s + 0.05)


def halting(duration_s: float, rng: np.random.Generator) -> Way:
    onset_s, halt_s, second_s = rng.uniform(0.5, 1.2), rng.uniform(0.2, 1.0), rng.uniform(0.3, 0.8)
    end_s = onset_s + duration_s + halt_s + second_s
    t = np.arange(0.0, end_s + 1.0, 1.0 / REFERENCE_RATE_HZ)
    first, goes_on = rng.uniform(0.1, 0.9), rng.random() < 0.5
    x = first * minimum_jerk((t - onset_s) / duration_s)
    x += ((1.0 - first) if goes_on else -first) * minimum_jerk((t - end_s + second_s) / second_s)
    return Way(t, x, onset_s - rng.uniform(0.05, 0.3), end_s + 0.05)


def wandering(n: int, deviation: float, correlation_s: float, rng: np.random.Generator) -> np.ndarray:
    """An Ornstein-Uhlenbeck process (n, 3) at REFERENCE_RATE_HZ, smoothed over 0.2 s."""
    kept = np.exp(-1.0 / REFERENCE_RATE_HZ / correlation_s)
    steps = rng.normal(size=(n, 3)) * deviation * np.sqrt(1.0 - kept * kept)
    walk = rng.normal(size=(1, 3)) * deviation + np.zeros((n, 3))
    for i in range(1, n):
        walk[i] = kept * walk[i - 1] + steps[i]
    window = np.hanning(51)[1:-1] / np.hanning(51).sum()
    return np.stack([np.convolve(np.pad(walk[:, k], 24, "edge"), window, "valid") for k in range(3)], axis=1)


def hand_of(way: Way, axis: np.ndarray, amplitude_m: float, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Where it starts, and its places (n, 3), m: along a bow, trembling."""
    start = np.array([rng.uniform(-0.1, 0.1), rng.uniform(0.1, 0.3), rng.uniform(-0.1, 0.1)])
    aside = np.cross(axis, rng.normal(size=3))
    bow = 4.0 * np.clip(way.x, 0.0, 1.0) * (1.0 - np.clip(way.x, 0.0, 1.0)) * rng.normal(0.0, 0.04) * amplitude_m
    line = start + amplitude_m * way.x[:, None] * axis + bow[:, None] * aside / np.linalg.norm(aside)
    return start, line + wandering(len(way.t), 0.0012, 0.2, rng)


def seen(way: Way, hand: np.ndarray, is_stable: bool, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """What a tracker makes of the hand: its own stamps, and places, m."""
    period_s = rng.choice([1 / 50, 1 / 60, 1 / 90, 1 / 120])
    stamps = np.arange(0.0, way.t[-1], period_s)
    stamps = np.maximum.accumulate(
        np.clip(stamps + rng.normal(0.0, rng.choice([0.0, 2e-4, 1e-3]), len(stamps)), 0.0, None)
    )
    severity = 0.0 if is_stable else rng.uniform(0.5, 1.5)
    gone = way.at(stamps)
    lag_s = rng.uniform(0.0, 0.015) + rng.uniform(0.0, 0.08) * severity
    late = stamps - lag_s * (1.0 if rng.random() < 0.5 else gone)
    places = np.stack([np.interp(late, way.t, hand[:, k]) for k in range(3)], axis=1)
    error = wandering(len(way.t), 0.009 * severity, rng.uniform(0.15, 0.8), rng)
    growing = (0.3 + 0.9 * gone)[:, None] if rng.random() < 0.5 else 1.0
    places += np.stack([np.interp(stamps, way.t, error[:, k]) for k in range(3)], axis=1) * growing
    places += rng.normal(0.0, rng.choice([1e-4, 5e-4]), places.shape)
    kept = np.ones(len(stamps), bool)
    moving = np.flatnonzero((stamps > way.start_s - 0.2) & (stamps < way.end_s + 0.2))
    for _ in range(rng.poisson(0.9 * severity)):
        i = rng.choice(moving)
        places[i : i + int(rng.uniform(0.04, 0.3) / period_s)] = places[i]
    for _ in range(rng.poisson(0.9 * severity)):
        i = rng.choice(moving)
        kept[i + 1 : i + int(rng.uniform(0.04, 0.3) / period_s)] = False
    for _ in range(rng.poisson(0.9 * severity)):
        i, jump = rng.choice(moving), rng.normal(size=3)
        places[i : i + rng.integers(1, 12)] += jump / np.linalg.norm(jump) * rng.uniform(0.01, 0.05)
    return stamps[kept], places[kept]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--hands", type=int, default=100, help="for each gesture, at either position")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--halting", action="store_true")
    given = parser.parse_args()
    rng = np.random.default_rng(given.seed)
    given.out.mkdir(parents=True, exist_ok=True)
    with (given.out / "trials.csv").open("w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        places = [f"{what}_{k}" for what in ("start", "axis") for k in "xyz"]
        rows.writerow(["trial", "gesture", "position", "subject", "start_s", "end_s", *places, "amplitude_m"])
        for gesture, (axis, amplitude_m, duration_s) in GESTURES.items():
            for number in range(given.hands):
                for position in ("stable", "unstable"):
                    way = (halting if given.halting else aimed)(duration_s * np.exp(rng.normal(0.0, 0.45)), rng)
                    start, hand = hand_of(way, np.array(axis), amplitude_m, rng)
                    name = f"{gesture}_{number}_{position}"
                    write_track(given.out / f"{name}.measured.csv", *seen(way, hand, position == "stable", rng))
                    write_track(given.out / f"{name}.reference.csv", way.t, hand)
                    numbers = [f"{x:.4f}" for x in (way.start_s, way.end_s, *start, *axis, amplitude_m)]
                    rows.writerow([name, gesture, position, f"aimed_{number}", *numbers])
    print(f"{2 * given.hands * len(GESTURES)} trials in {given.out}")


if __name__ == "__main__":
    main()
