"""Classifies gestures by HMMs over position and velocity vectors, by their likelihoods only.

    python tools/tuning/vector_hmm.py --train DIR --trials DIR

The other reading of the paper (docs/method.md, "Recognition without a task"). One codebook for all gestures is over
the position of the index tip and the radius of the three tips' circle, relative to the hand at start_s, and over
their velocities. Each gesture has a left-right HMM of four states. They are trained on the first trial set
(build/train of `./steadyhand train`). Each gesture of the second one (build/results/trials of `./steadyhand results`)
is cut by its true start and end, and gets the name of the greatest forward likelihood.
"""

import argparse
import csv
from collections import Counter, defaultdict
from pathlib import Path

import numpy as np
from hmmlearn.hmm import CategoricalHMM
from sklearn.cluster import KMeans

SYMBOLS, STATES = 16, 4
PERIOD_S, VELOCITY_S = 0.01, 0.06  # of a symbol; window of the slope of a velocity
LENGTH_M, GROWTH_M, DURATION_S = 0.2, 0.04, 0.8  # scales of positions, radii and velocities
PSEUDO_COUNT = 0.1
TIPS = ("thumb", "index", "middle")


def circumradius(tips: np.ndarray) -> np.ndarray:
    """tips: N x 3 x 2, m."""
    a, b, c = (np.linalg.norm(tips[:, i] - tips[:, i - 1], axis=1) for i in range(3))
    first, second = tips[:, 1] - tips[:, 0], tips[:, 2] - tips[:, 0]
    twice_area = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    return a * b * c / (2.0 * np.maximum(twice_area, 1e-9))


def places(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Times, s, and scaled index tip and radius, of the frames with all three tips."""
    rows = [row for row in path.read_text().splitlines() if not row.startswith("#")]
    frames = list(csv.DictReader(rows))
    columns = [f"{tip}_{axis}" for tip in TIPS for axis in "xyz"]
    held = [frame for frame in frames if all(frame[column] for column in columns)]
    t = np.array([float(frame["t"]) for frame in held])
    tips = np.array([[float(frame[column]) for column in columns] for frame in held]).reshape(-1, 3, 3)
    return t, np.column_stack([tips[:, 1] / LENGTH_M, circumradius(tips[:, :, :2]) / GROWTH_M])


def observations(folder: Path, trial: dict[str, str]) -> np.ndarray:
    """N x 8: positions and velocities at each PERIOD_S from start to end with a new frame."""
    t, x = places(folder / f"{trial['trial']}.measured.csv")
    start_s, end_s = float(trial["start_s"]), float(trial["end_s"])
    origin = x[max(np.searchsorted(t, start_s) - 1, 0)]
    seen, last = [], -1
    for now_s in np.arange(np.ceil(start_s / PERIOD_S), end_s / PERIOD_S) * PERIOD_S:
        newest = int(np.searchsorted(t, now_s, side="right")) - 1
        if newest <= max(last, 0):
            continue
        last = newest
        first = min(int(np.searchsorted(t, t[newest] - VELOCITY_S)), newest - 1)
        time, place = t[first : newest + 1] - t[first : newest + 1].mean(), x[first : newest + 1]
        velocity = time @ place / (time @ time)
        seen.append(np.concatenate([x[newest] - origin, velocity * DURATION_S]))
    return np.array(seen)


def gestures(folder: Path) -> list[tuple[str, str, np.ndarray]]:
    with open(folder / "trials.csv", newline="", encoding="utf-8") as file:
        trials = [trial for trial in csv.DictReader(file) if trial["gesture"] != "none"]
    found = [(trial["gesture"], trial["position"], observations(folder, trial)) for trial in trials]
    return [one for one in found if len(one[2]) > 0]


def trained(sequences: list[np.ndarray]) -> CategoricalHMM:
    model = CategoricalHMM(STATES, n_features=SYMBOLS, n_iter=50, tol=1e-3, init_params="", params="te")
    model.emissionprob_prior = 1.0 + PSEUDO_COUNT
    model.startprob_ = np.eye(STATES)[0]
    stays = np.eye(STATES) + np.eye(STATES, k=1)
    model.transmat_ = stays / stays.sum(axis=1, keepdims=True)
    counts = np.full((STATES, SYMBOLS), PSEUDO_COUNT)
    for sequence in sequences:
        np.add.at(counts, (np.arange(len(sequence)) * STATES // len(sequence), sequence), 1.0)
    model.emissionprob_ = counts / counts.sum(axis=1, keepdims=True)
    return model.fit(np.concatenate(sequences)[:, None], [len(sequence) for sequence in sequences])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--train", type=Path, required=True)
    parser.add_argument("--trials", type=Path, required=True)
    options = parser.parse_args()

    learnt, tried = gestures(options.train), gestures(options.trials)
    scale = np.concatenate([seen for _, _, seen in learnt]).std(axis=0)
    codebook = KMeans(SYMBOLS, n_init=4, random_state=0)
    codebook.fit(np.concatenate([seen for _, _, seen in learnt]) / scale)
    sequences = defaultdict(list)
    for gesture, _, seen in learnt:
        sequences[gesture].append(codebook.predict(seen / scale))
    models = {gesture: trained(of_it) for gesture, of_it in sequences.items()}

    rightly, all_of = Counter(), Counter()
    for gesture, position, seen in tried:
        symbols = codebook.predict(seen / scale)[:, None]
        named = max(models, key=lambda name: models[name].score(symbols))
        rightly[gesture, position] += named == gesture
        all_of[gesture, position] += 1
    for one in sorted(all_of):
        print(f"{', '.join(one)}: {rightly[one]} of {all_of[one]}")
    print(f"all: {rightly.total()} of {all_of.total()}")


if __name__ == "__main__":
    main()
