"""One trial set in both modes and both contexts, as compared conditions."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from conditions import TITLES
from plots.curves import read_curves
from results.evaluation import Evaluation

MODES = ["paper", "phase"]
CONTEXTS = ["scene", "open"]

OTHERS = ["measured", "average", "one_euro", "kalman"]
# Conditions in the order of every table and picture. Each mode is the synthesised motion of its own run.
CONDITIONS = {
    **{name: TITLES[name] for name in OTHERS},
    "paper": "synthesised, `paper`",
    "phase": "synthesised, `phase`",
}


def source_of(condition: str) -> tuple[str, str]:
    """The mode whose run has the condition, and its name there."""
    return (condition, "synthesised") if condition in MODES else ("phase", condition)


@dataclass
class Study:
    name: str
    scene: dict[str, Evaluation]  # by mode; the trial's task is given
    open: dict[str, Evaluation]  # by mode; without a task

    @classmethod
    def of(cls, name: str, trials: Path, out: Path, keeps_curves: bool = True) -> "Study":
        runs = {
            context: {
                mode: Evaluation(
                    trials, mode, context, out / name / f"{mode}_{context}", keeps_curves and context == "scene"
                )
                for mode in MODES
            }
            for context in CONTEXTS
        }
        return cls(name, **runs)

    def evaluations(self) -> list[Evaluation]:
        return [*self.scene.values(), *self.open.values()]

    def gestures(self) -> list[str]:
        return self.scene["phase"].gestures()

    def groups(self) -> list[tuple[str, str]]:
        """Gesture and position of each."""
        return [(group["gesture"], group["position"]) for group in self.scene["phase"].groups()]

    def group(self, gesture: str, position: str, context: str = "scene") -> dict[str, dict] | None:
        """The figures of summary.json by condition; None where the set has no such trials."""
        runs = self.scene if context == "scene" else self.open
        figures = {}
        for condition in CONDITIONS:
            mode, name = source_of(condition)
            group = runs[mode].group(gesture, position)
            if group is None:
                return None
            figures[condition] = group["conditions"][name]
        return figures

    def values(self, gesture: str, position: str, figure: str, condition: str) -> list[float]:
        mode, name = source_of(condition)
        return self.scene[mode].values(gesture, position, figure, name)

    def curves(self, trial: str) -> dict[str, np.ndarray]:
        """Curves of TRIAL.curves.csv, with both modes in place of `synthesised`."""
        curves = read_curves(self.scene["phase"].out / f"{trial}.curves.csv")
        curves["phase"] = curves.pop("synthesised")
        curves["paper"] = read_curves(self.scene["paper"].out / f"{trial}.curves.csv")["synthesised"]
        return curves
