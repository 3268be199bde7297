"""Trial sets of hands that make none of the gestures: every recognised gesture is a false alarm."""

from dataclasses import dataclass
from pathlib import Path

from results.evaluation import Evaluation

HEADER = "trial,gesture,position,subject,start_s,end_s,start_x,start_y,start_z,axis_x,axis_y,axis_z,amplitude_m"


@dataclass
class OtherHands:
    """The tracks of one folder, without a task."""

    what: str
    evaluation: Evaluation  # in `phase` mode

    @classmethod
    def of(cls, tracks: Path, what: str, out: Path) -> "OtherHands":
        trials = out / tracks.name / "trials"
        make_none_trials(tracks, trials)
        return cls(what, Evaluation(trials, "phase", "open", out / tracks.name / "phase_open", False))

    @property
    def minutes(self) -> float:
        return self.evaluation.summary["none_minutes"]

    def alarms(self) -> dict[str, dict[str, int]]:
        """How often each gesture ended in each recording that has one."""
        counts: dict[str, dict[str, int]] = {}
        for alarm in self.evaluation.summary["false_alarms"]:
            recording = counts.setdefault(alarm["gesture"], {})
            recording[alarm["trial"]] = recording.get(alarm["trial"], 0) + 1
        return {gesture: counts[gesture] for gesture in sorted(counts)}


def make_none_trials(tracks: Path, folder: Path) -> None:
    """A trial set of `none`, a trial for each track; the tracks stay where they are."""
    folder.mkdir(parents=True)
    rows = [HEADER]
    for track in sorted(tracks.glob("*.csv")):
        rows.append(f"{track.stem},none,stable,{tracks.name}" + "," * 9)
        for kind in ("measured", "reference"):
            (folder / f"{track.stem}.{kind}.csv").symlink_to(track.resolve())
    (folder / "trials.csv").write_text("\n".join(rows) + "\n")
