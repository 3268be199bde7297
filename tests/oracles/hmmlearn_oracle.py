"""Checks the core's HMM against hmmlearn: makes random models and sequences, writes what hmmlearn says of them,
and has the unit-test program compare.

    python tests/oracles/hmmlearn_oracle.py --binary build/.../unit_tests
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from hmmlearn.hmm import CategoricalHMM

ITERATIONS = 10
PSEUDO_TRANSITION = 1.0
PSEUDO_SYMBOL = 0.1
LAG = 3
ONLINE = 80  # symbols; of longer sequences not every prefix is decoded


def left_right(rng, states):
    """A of a left-right model without skips."""
    a = np.zeros((states, states))
    for i in range(states - 1):
        a[i, i] = rng.uniform(0.7, 0.98)
        a[i, i + 1] = 1.0 - a[i, i]
    a[-1, -1] = 1.0
    return a


def hmmlearn_model(pi, a, b, **options):
    hmm = CategoricalHMM(n_components=len(pi), n_features=b.shape[1], implementation="log", init_params="", **options)
    hmm.startprob_, hmm.transmat_, hmm.emissionprob_ = pi, a, b
    return hmm


def as_json(pi, a, b):
    return {"pi": pi.tolist(), "a": a.tolist(), "b": b.tolist()}


def inference_case(rng, states, symbols, length, ergodic):
    if ergodic:
        pi, a = rng.dirichlet(np.ones(states)), rng.dirichlet(np.ones(states), states)
    else:
        pi, a = np.eye(states)[0], left_right(rng, states)
    b = rng.dirichlet(np.ones(symbols), states)
    sequence = rng.integers(symbols, size=length)
    hmm = hmmlearn_model(pi, a, b)
    with np.errstate(divide="ignore"):
        score = hmm.score(sequence[:, None])
        best, path = hmm.decode(sequence[:, None])
        prefixes = [sequence[:n, None] for n in range(1, length + 1)] if length <= ONLINE else []
        lagged = [hmm.decode(prefix)[1][max(len(prefix) - 1 - LAG, 0)] for prefix in prefixes]
        filtered = [hmm.predict_proba(prefix)[-1].argmax() for prefix in prefixes]
    return {
        "model": as_json(pi, a, b),
        "symbols": sequence.tolist(),
        "log_likelihood": score,
        "viterbi": best,
        "path": path.tolist(),
        "lag": LAG,
        "lagged": np.array(lagged, int).tolist(),
        "filtered": np.array(filtered, int).tolist(),
    }


def training_case(rng, states, symbols, n_sequences):
    pi, a = np.eye(states)[0], left_right(rng, states)
    b = rng.dirichlet(np.ones(symbols), states)
    sequences = [rng.integers(symbols, size=rng.integers(10, 40)) for _ in range(n_sequences)]
    # hmmlearn's priors are Dirichlet parameters: 1 + pseudo-count.
    hmm = hmmlearn_model(
        pi,
        a,
        b,
        params="te",
        n_iter=ITERATIONS,
        tol=-np.inf,
        transmat_prior=1.0 + PSEUDO_TRANSITION * (a > 0),
        emissionprob_prior=1.0 + PSEUDO_SYMBOL,
    )
    with np.errstate(divide="ignore"):
        hmm.fit(np.concatenate(sequences)[:, None], [len(s) for s in sequences])
    return {
        "start": as_json(pi, a, b),
        "sequences": [s.tolist() for s in sequences],
        "iterations": ITERATIONS,
        "pseudo_transition": PSEUDO_TRANSITION,
        "pseudo_symbol": PSEUDO_SYMBOL,
        "result": as_json(hmm.startprob_, hmm.transmat_, hmm.emissionprob_),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--binary", required=True, help="the unit-test program")
    binary = parser.parse_args().binary
    rng = np.random.default_rng(20261121)
    oracle = {
        "inference": [
            inference_case(rng, states, symbols, length, ergodic)
            for states, symbols, length in ((2, 3, 5), (4, 16, 75), (4, 16, 1000), (8, 32, 300))
            for ergodic in (True, False)
        ],
        "training": [training_case(rng, 4, 16, 20), training_case(rng, 6, 8, 5)],
    }
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "hmmlearn.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(oracle, file)
        command = [binary, "--test-case=hmmlearn oracle*", "--no-skip"]
        return subprocess.run(command, env={**os.environ, "STEADYHAND_HMMLEARN": path}, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
