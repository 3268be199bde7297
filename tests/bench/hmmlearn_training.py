"""Rows for the table of bench_recognition: the time of the same training in hmmlearn.

bench_recognition | python tests/bench/hmmlearn_training.py
"""

import sys
import time

import numpy as np
from hmmlearn.hmm import CategoricalHMM

GESTURES, SEQUENCES, LENGTH = 4, 500, 75
STATES, SYMBOLS = 4, 16
ITERATIONS = 2
REFERENCE = "plain scaled forward pass"


def iteration_ns(implementation: str) -> float:
    """One Baum-Welch iteration of all gestures, on sequences made as bench_recognition's."""
    rng = np.random.default_rng(1)
    state = np.arange(LENGTH) * STATES // LENGTH
    own = state * (SYMBOLS // STATES) + rng.integers(SYMBOLS // STATES, size=(SEQUENCES, LENGTH))
    symbols = np.where(rng.random(own.shape) < 0.8, own, rng.integers(SYMBOLS, size=own.shape))
    hmm = CategoricalHMM(STATES, n_features=SYMBOLS, implementation=implementation, init_params="", params="te")
    hmm.n_iter, hmm.tol = ITERATIONS, -np.inf
    hmm.startprob_ = np.eye(STATES)[0]
    hmm.transmat_ = np.array([[0.95, 0.05, 0, 0], [0, 0.95, 0.05, 0], [0, 0, 0.95, 0.05], [0, 0, 0, 1]])
    hmm.emissionprob_ = np.full((STATES, SYMBOLS), 0.2 / (SYMBOLS - 4))
    for i in range(STATES):
        hmm.emissionprob_[i, 4 * i : 4 * i + 4] = 0.2
    begin = time.process_time()
    with np.errstate(divide="ignore"):
        hmm.fit(symbols.reshape(-1, 1), [LENGTH] * SEQUENCES)
    return GESTURES * (time.process_time() - begin) / ITERATIONS * 1e9


def main() -> None:
    row = next(line for line in sys.stdin if REFERENCE in line)
    reference_ns = float(row.split()[-2])
    for implementation in ("scaling", "log"):
        ns = min(iteration_ns(implementation) for _ in range(3))
        print(f"  {f'Baum-Welch, the same in hmmlearn, {implementation}':<46} {ns:12.1f} {ns / reference_ns:14.1f}")


if __name__ == "__main__":
    main()
