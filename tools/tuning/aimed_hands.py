"""Makes a trial set of aimed minimum-jerk hands and other trackers. It shares no code with the simulation.

    python tools/tuning/aimed_hands.py --out DIR [--hands N] [--seed N] [--halting]

Hands differ in duration, in the time of the peak speed, and in their aim. One in four stops early and corrects
itself; one in four goes too far and comes back. With --halting each hand stops on its path, and then goes on or
returns. Trackers have a lag of a few ms. At the unstable position they have up to 0.12 s more, constant or growing
along the path, and also drift (a smoothed Ornstein-Uhlenbeck process), freezes, dropouts and jumps. Equal arguments
give equal files.
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
class Movement:
    t: np.ndarray  # s
    x: np.ndarray  # value in amplitudes, 0 at the start
    start_s: float  # shortly before the onset
    end_s: float  # shortly after the end

    def at(self, t: np.ndarray) -> np.ndarray:
        return np.interp(t, self.t, np.clip(self.x, 0.0, 1.0))


def aimed(duration_s: float, rng: np.random.Generator) -> Movement:
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
    return Movement(t, x * (1.0 + rng.normal(0.0, 0.02)), onset_s - rng.uniform(0.05, 0.3), end_s + 0.05)


def halting(duration_s: float, rng: np.random.Generator) -> Movement:
    onset_s, halt_s, second_s = rng.uniform(0.5, 1.2), rng.uniform(0.2, 1.0), rng.uniform(0.3, 0.8)
    end_s = onset_s + duration_s + halt_s + second_s
    t = np.arange(0.0, end_s + 1.0, 1.0 / REFERENCE_RATE_HZ)
    first, goes_on = rng.uniform(0.1, 0.9), rng.random() < 0.5
    x = first * minimum_jerk((t - onset_s) / duration_s)
    x += ((1.0 - first) if goes_on else -first) * minimum_jerk((t - end_s + second_s) / second_s)
    return Movement(t, x, onset_s - rng.uniform(0.05, 0.3), end_s + 0.05)


def ornstein_uhlenbeck(
    n: int, deviation: float, correlation_s: float, rate_hz: float, rng: np.random.Generator
) -> np.ndarray:
    """A stationary Ornstein-Uhlenbeck process (n, 3)."""
    kept = np.exp(-1.0 / rate_hz / correlation_s)
    steps = rng.normal(size=(n, 3)) * deviation * np.sqrt(1.0 - kept * kept)
    walk = rng.normal(size=(1, 3)) * deviation + np.zeros((n, 3))
    for i in range(1, n):
        walk[i] = kept * walk[i - 1] + steps[i]
    return walk


def wandering(n: int, deviation: float, correlation_s: float, rng: np.random.Generator) -> np.ndarray:
    """An Ornstein-Uhlenbeck process (n, 3) at REFERENCE_RATE_HZ, smoothed over 0.2 s."""
    walk = ornstein_uhlenbeck(n, deviation, correlation_s, REFERENCE_RATE_HZ, rng)
    window = np.hanning(51)[1:-1] / np.hanning(51).sum()
    return np.stack([np.convolve(np.pad(walk[:, k], 24, "edge"), window, "valid") for k in range(3)], axis=1)


def hand_of(
    movement: Movement, axis: np.ndarray, amplitude_m: float, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """The start and the positions (n, 3) of the hand, m, with a bow and tremor."""
    start = np.array([rng.uniform(-0.1, 0.1), rng.uniform(0.1, 0.3), rng.uniform(-0.1, 0.1)])
    aside = np.cross(axis, rng.normal(size=3))
    bow = (
        4.0
        * np.clip(movement.x, 0.0, 1.0)
        * (1.0 - np.clip(movement.x, 0.0, 1.0))
        * rng.normal(0.0, 0.04)
        * amplitude_m
    )
    line = start + amplitude_m * movement.x[:, None] * axis + bow[:, None] * aside / np.linalg.norm(aside)
    return start, line + wandering(len(movement.t), 0.0012, 0.2, rng)


def seen(
    movement: Movement, hand: np.ndarray, is_stable: bool, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """The time stamps of a tracker, s, and the measured positions, m."""
    period_s = rng.choice([1 / 50, 1 / 60, 1 / 90, 1 / 120])
    stamps = np.arange(0.0, movement.t[-1], period_s)
    stamps = np.maximum.accumulate(
        np.clip(stamps + rng.normal(0.0, rng.choice([0.0, 2e-4, 1e-3]), len(stamps)), 0.0, None)
    )
    severity = 0.0 if is_stable else rng.uniform(0.5, 1.5)
    gone = movement.at(stamps)
    lag_s = rng.uniform(0.0, 0.015) + rng.uniform(0.0, 0.08) * severity
    late = stamps - lag_s * (1.0 if rng.random() < 0.5 else gone)
    places = np.stack([np.interp(late, movement.t, hand[:, k]) for k in range(3)], axis=1)
    error = wandering(len(movement.t), 0.009 * severity, rng.uniform(0.15, 0.8), rng)
    growing = (0.3 + 0.9 * gone)[:, None] if rng.random() < 0.5 else 1.0
    places += np.stack([np.interp(stamps, movement.t, error[:, k]) for k in range(3)], axis=1) * growing
    places += rng.normal(0.0, rng.choice([1e-4, 5e-4]), places.shape)
    kept = np.ones(len(stamps), bool)
    moving = np.flatnonzero((stamps > movement.start_s - 0.2) & (stamps < movement.end_s + 0.2))
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
    parser.add_argument("--hands", type=int, default=100, help="per gesture and position")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--halting", action="store_true")
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    options.out.mkdir(parents=True, exist_ok=True)
    with (options.out / "trials.csv").open("w", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        places = [f"{what}_{k}" for what in ("start", "axis") for k in "xyz"]
        rows.writerow(["trial", "gesture", "position", "subject", "start_s", "end_s", *places, "amplitude_m"])
        for gesture, (axis, amplitude_m, duration_s) in GESTURES.items():
            for number in range(options.hands):
                for position in ("stable", "unstable"):
                    movement = (halting if options.halting else aimed)(duration_s * np.exp(rng.normal(0.0, 0.45)), rng)
                    start, hand = hand_of(movement, np.array(axis), amplitude_m, rng)
                    name = f"{gesture}_{number}_{position}"
                    write_track(options.out / f"{name}.measured.csv", *seen(movement, hand, position == "stable", rng))
                    write_track(options.out / f"{name}.reference.csv", movement.t, hand)
                    numbers = [f"{x:.4f}" for x in (movement.start_s, movement.end_s, *start, *axis, amplitude_m)]
                    rows.writerow([name, gesture, position, f"aimed_{number}", *numbers])
    print(f"{2 * options.hands * len(GESTURES)} trials in {options.out}")


if __name__ == "__main__":
    main()
