"""Trains the predictors, on other trials than those evaluated."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from peers.minimum_jerk import MinimumJerk
from peers.predictor import Hold, Predictor
from peers.promp import Primitive, ProMP, train_primitive
from peers.ridge import Ridge, train_ridge
from peers.trials import read_trials
from results.evaluation import ROOT, run_tool

REAL = ROOT.parent / "shared/real/drags_train"
SYNTHETIC = {
    "population": "train",
    "gestures": "horizontal_drag,vertical_drag,tap",
    "subjects": 8,
    "trials-per-subject": 2,
    "paces": "1,0.6",
}


@dataclass(frozen=True)
class Trained:
    """All that predictors need before a trial. It is small: worker processes get a copy."""

    coefficients: np.ndarray  # of Ridge
    primitive: Primitive
    durations_s: dict[str, float]  # means of the models by gesture
    source: str  # of the training trials, in words

    @classmethod
    def of(cls, folder: Path, work: Path) -> "Trained":
        """Trains on the trial set in the folder or, without one, on simulated people of the population `train`.

        Only trials at the stable position are used: predictors learn how hands move, not the faults of a tracker.
        """
        if (folder / "trials.csv").is_file():
            source = f"recorded hands (`{folder.name}`)"
        else:
            folder = work / "train"
            run_tool("make_trials", {"out": folder, **SYNTHETIC})
            source = "simulated people of the population `train`"
        trials = [trial for trial in read_trials(folder) if trial.position == "stable"]
        models = (json.loads(path.read_text()) for path in (ROOT / "models").glob("*.gesture"))
        durations_s = {model["gesture"]: model["duration_mean_s"] for model in models}
        return cls(train_ridge(trials), train_primitive(trials), durations_s, f"{len(trials)} trials of {source}")

    def makers(self, gesture: str) -> dict[str, Callable[[], Predictor]]:
        """By the predictor's name: makes a new one for a trial of the gesture."""
        duration_s = self.durations_s[gesture]
        return {
            "hold": Hold,
            "ridge": lambda: Ridge(self.coefficients),
            "minimum_jerk": lambda: MinimumJerk(duration_s),
            "promp": lambda: ProMP(self.primitive, duration_s),
        }
