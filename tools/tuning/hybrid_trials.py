"""Makes a trial set of recorded hands with recorded tracker errors: `phase` mode was tuned on it.

    python tools/tuning/hybrid_trials.py --real ../shared/real --out DIR [--seed N] [--corrections]

The hands are those of drags_train, scaled to 20 cm. Each one is used as recorded (stable), and with tracker faults
(unstable): the errors of leap_qtm times 2 to 6, lag, freezes, dropouts and jumps, which grow along the path. With
--corrections each hand also has later submovements, and may hesitate. Equal arguments give equal files.
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from gesture_end import END_LEVEL

AXES = ("x", "y", "z")
SCENE_AMPLITUDE_M = 0.2
ERROR_RATE_HZ = 200.0
LARGEST_ERROR_M = 0.06  # with a larger error, the pair of recordings does not match


def read_track(path: Path) -> tuple[list[str], np.ndarray]:
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    rows = [[float(cell) if cell else np.nan for cell in line.split(",")] for line in lines[1:]]
    return lines[0].split(","), np.array(rows)


def joint(header: list[str], rows: np.ndarray, name: str) -> np.ndarray:
    return rows[:, [header.index(f"{name}_{axis}") for axis in AXES]]


def tracker_errors(folder: Path) -> list[np.ndarray]:
    """Leap minus motion capture, m, at ERROR_RATE_HZ, without the mean: one array (n, 3) per fingertip."""
    errors = []
    for path in sorted(folder.glob("*_leap.csv")):
        leap_header, leap = read_track(path)
        mocap_header, mocap = read_track(path.with_name(path.name.replace("_leap", "_mocap")))
        leap = leap[leap[:, leap_header.index("valid")] > 0]
        mocap = mocap[mocap[:, mocap_header.index("valid")] > 0]
        t = np.arange(max(leap[0, 0], mocap[0, 0]), min(leap[-1, 0], mocap[-1, 0]), 1.0 / ERROR_RATE_HZ)
        for tip in ("index", "middle", "thumb", "ring"):
            seen, true = joint(leap_header, leap, tip), joint(mocap_header, mocap, tip)
            error = np.stack(
                [np.interp(t, leap[:, 0], seen[:, k]) - np.interp(t, mocap[:, 0], true[:, k]) for k in range(3)], axis=1
            )
            error -= error.mean(axis=0)
            if len(t) > 6.0 * ERROR_RATE_HZ and np.abs(error).max() < LARGEST_ERROR_M:
                errors.append(error)
    return errors


def minimum_jerk(s: np.ndarray) -> np.ndarray:
    s = np.clip(s, 0.0, 1.0)
    return s**3 * (10.0 - 15.0 * s + 6.0 * s**2)


def corrected(values: np.ndarray, t: np.ndarray, end_s: float, rng: np.random.Generator) -> np.ndarray:
    """The values (in amplitudes) with submovements, perhaps a hesitation, and an error of the start."""
    onset_s = t[np.argmax(values > 0.05)]
    duration_s = max(end_s - onset_s, 0.3)
    later, total = np.zeros(len(t)), 0.0
    for _ in range(rng.integers(0, 5)):
        share = rng.normal(0.0, 0.2)
        later += share * minimum_jerk((t - onset_s - duration_s * rng.uniform(0.1, 1.0)) / rng.uniform(0.15, 0.4))
        total += share
    values = (1.0 - total) * values + later
    if rng.random() < 0.4:
        centre_s, width_s = onset_s + duration_s * rng.uniform(0.2, 0.9), rng.uniform(0.05, 0.15)
        pace = 1.0 - rng.uniform(0.5, 1.2) * np.exp(-0.5 * ((t - centre_s) / width_s) ** 2)
        own_t = t[0] + np.concatenate([[0.0], np.cumsum(0.5 * (pace[1:] + pace[:-1]) * np.diff(t))])
        values = np.interp(own_t, t, values)
    return values + rng.normal(0.0, 0.04) * (1.0 - np.clip(values, 0.0, 1.0))


def spoiled(
    t: np.ndarray,
    hand: np.ndarray,
    values: np.ndarray,
    span: tuple[float, float],
    errors: list[np.ndarray],
    rng: np.random.Generator,
) -> tuple[np.ndarray, np.ndarray]:
    """The time stamps of a bad tracker, s, and its positions of the hand (n, 3), m."""
    period_s = rng.choice([1 / 72, 1 / 90, 1 / 110])
    stamps = t[0] + period_s * np.arange(int((t[-1] - t[0]) / period_s)) + 0.0
    stamps = np.maximum.accumulate(np.maximum(stamps + rng.normal(0.0, 1e-4, len(stamps)), t[0]))
    bad = np.interp(stamps, t, np.clip(values, 0.0, 1.0) ** rng.uniform(0.7, 2.0))
    lag_s = np.convolve(np.pad(rng.uniform(0.0, 0.2) * bad, 10, "edge"), np.full(21, 1 / 21), "valid")
    seen = np.stack([np.interp(stamps - lag_s, t, hand[:, k]) for k in range(3)], axis=1)

    error = errors[rng.integers(len(errors))]
    first = rng.integers(0, max(1, len(error) - 2 * len(stamps)))
    at = first + (stamps - stamps[0]) * ERROR_RATE_HZ
    turned, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    drift = np.stack([np.interp(at, np.arange(len(error)), error[:, k]) for k in range(3)], axis=1) @ turned
    seen += drift * (rng.uniform(2.0, 6.0) * (0.15 + 0.85 * bad))[:, None]
    seen += rng.normal(0.0, 4e-5, seen.shape)

    moving = (stamps > span[0] - 0.1) & (stamps < span[1] + 0.1)
    likely = bad + 0.4 * moving
    likely /= likely.sum()
    kept = np.ones(len(stamps), bool)
    for _ in range(rng.poisson(0.8)):
        i = rng.choice(len(stamps), p=likely)
        seen[i : i + int(rng.uniform(0.05, 0.35) / period_s)] = seen[i]
    for _ in range(rng.poisson(0.8)):
        i = rng.choice(len(stamps), p=likely)
        kept[i + 1 : i + int(rng.uniform(0.05, 0.3) / period_s)] = False
    for _ in range(rng.poisson(0.8)):
        i = rng.choice(len(stamps), p=likely)
        jump = rng.normal(size=3)
        seen[i : i + rng.integers(1, 10)] += jump / np.linalg.norm(jump) * rng.uniform(0.01, 0.06)
    kept &= rng.random(len(stamps)) > 0.02
    return stamps[kept], seen[kept]


def write_track(path: Path, t: np.ndarray, places: np.ndarray, joints: tuple[str, ...] = ("index",)) -> None:
    """places: (n, 3) of one joint, or (n, joints, 3), m."""
    lines = [",".join(["t", *(f"{name}_{axis}" for name in joints for axis in AXES)])]
    lines += [",".join(f"{number:.6f}" for number in row) for row in np.column_stack([t, places.reshape(len(t), -1)])]
    path.write_text("\n".join(lines) + "\n")


def write_trials(folder: Path, trials: list[dict[str, str]]) -> None:
    with (folder / "trials.csv").open("w", newline="") as target:
        writer = csv.DictWriter(target, trials[0].keys())
        writer.writeheader()
        writer.writerows(trials)
    print(f"{len(trials)} trials in {folder}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--real", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--corrections", action="store_true")
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    errors = tracker_errors(options.real / "leap_qtm")
    options.out.mkdir(parents=True, exist_ok=True)
    with (options.real / "drags_train" / "trials.csv").open() as source:
        trials = list(csv.DictReader(source))
    written = []
    for trial in trials:
        header, reference = read_track(options.real / "drags_train" / f"{trial['trial']}.reference.csv")
        t, hand = reference[:, 0], joint(header, reference, "index")
        start = np.array([float(trial[f"start_{axis}"]) for axis in AXES])
        direction = np.array([float(trial[f"axis_{axis}"]) for axis in AXES])
        amplitude_m = float(trial["amplitude_m"])
        span = (float(trial["start_s"]), float(trial["end_s"]))
        values = (hand - start) @ direction / amplitude_m
        if options.corrections:
            other = corrected(values, t, span[1], rng)
            hand = hand + ((other - values) * amplitude_m)[:, None] * direction
            level = END_LEVEL * other[np.argmin(np.abs(t - span[1]))]
            reached_s = t[np.argmax((other >= level) & (t > span[0]))]
            values, span = other, (span[0], min(t[-1] - 0.05, max(span[1], reached_s + 0.05)))
        hand = start + (hand - start) * (SCENE_AMPLITUDE_M / amplitude_m)
        for position in ("stable", "unstable"):
            name = trial["trial"].replace("_stable", f"_{position}")
            seen = (t[::3], hand[::3]) if position == "stable" else spoiled(t, hand, values, span, errors, rng)
            write_track(options.out / f"{name}.measured.csv", *seen)
            write_track(options.out / f"{name}.reference.csv", t, hand)
            written.append(
                trial
                | {
                    "trial": name,
                    "position": position,
                    "end_s": f"{span[1]:.4f}",
                    "amplitude_m": f"{SCENE_AMPLITUDE_M:.4f}",
                }
            )
    write_trials(options.out, written)


if __name__ == "__main__":
    main()
