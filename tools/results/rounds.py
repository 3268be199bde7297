"""Repetition: figures of a gesture after others of its kind."""

from dataclasses import dataclass
from pathlib import Path

from results.evaluation import Evaluation

EARLIER_ROUNDS = 4


@dataclass
class Rounds:
    """By the number of rounds before, in `phase` mode: with a task, without a task."""

    task_given: dict[int, Evaluation]
    nothing_given: dict[int, Evaluation]

    @classmethod
    def of(cls, trials: dict[int, Path], out: Path) -> "Rounds":
        runs = (
            {
                rounds: Evaluation(folder, "phase", context, out / f"{rounds}_{context}", False)
                for rounds, folder in trials.items()
            }
            for context in ("scene", "open")
        )
        return cls(*runs)

    def evaluations(self) -> list[Evaluation]:
        return [*self.task_given.values(), *self.nothing_given.values()]

    def groups(self) -> list[tuple[str, str]]:
        """Gesture and position."""
        first = next(iter(self.task_given.values()))
        return [(group["gesture"], group["position"]) for group in first.groups()]

    def figures(self, rounds: int, gesture: str, position: str) -> dict[str, dict]:
        """By condition, as in summary.json, with a task."""
        return self.task_given[rounds].group(gesture, position)["conditions"]

    def recognised(self, rounds: int, gesture: str, position: str) -> float:
        """Share of the trials whose last gesture was this one, all models active, without a task."""
        group = self.nothing_given[rounds].group(gesture, position)
        return group["recognised"] / group["trials"]
