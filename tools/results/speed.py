"""Speed: figures of the same people's gestures with durations from 0.15 s to 4 s."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from results.evaluation import Evaluation
from results.study import Study

DURATIONS_S = [0.15, 0.25, 0.4, 0.6, 1.0, 1.6, 2.5, 4.0]


@dataclass
class Speed:
    """All gestures together."""

    studies: dict[float, Study]  # by the gestures' duration, onset to end (s)

    @classmethod
    def of(cls, trials: dict[float, Path], out: Path) -> "Speed":
        return cls({duration: Study.of(f"{duration:g} s", folder, out, False) for duration, folder in trials.items()})

    def evaluations(self) -> list[Evaluation]:
        return [evaluation for study in self.studies.values() for evaluation in study.evaluations()]

    def values(self, duration_s: float, position: str, figure: str, condition: str) -> np.ndarray:
        """The figure (r2, r2_zero, lag, t_diff or sparc) of each trial."""
        study = self.studies[duration_s]
        return np.concatenate([study.values(gesture, position, figure, condition) for gesture in study.gestures()])

    def missed(self, duration_s: float, position: str, condition: str) -> int:
        study = self.studies[duration_s]
        return sum(study.group(gesture, position)[condition]["missed"] for gesture in study.gestures())

    def recognised(self, duration_s: float, position: str, mode: str) -> float:
        """Share of the trials, all models active, without a task."""
        study = self.studies[duration_s]
        groups = [study.open[mode].group(gesture, position) for gesture in study.gestures()]
        return sum(group["recognised"] for group in groups) / sum(group["trials"] for group in groups)
