"""Writes valid session folders with made-up figures (docs/study_files.md), for tests of ./steadyhand study."""

import csv
import itertools
import json
import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

POSITIONS = ["stable", "unstable"]
CURVES = ["measured", "average", "synthesised"]
ITEMS = {
    "synchronisation": "The haptic feedback was synchronized with my hand motion.",
    "smoothness": "The haptic feedback was very smooth.",
    "completion": "The haptic feedback helped me in the task completion.",
}
# Mean of a figure by position and curve. R2: the synthesised motion wins at the unstable position only.
R2 = {
    ("stable", "measured"): 0.97,
    ("stable", "average"): 0.90,
    ("stable", "synthesised"): 0.97,
    ("unstable", "measured"): 0.82,
    ("unstable", "average"): 0.80,
    ("unstable", "synthesised"): 0.95,
}
T_DIFF_S = {"measured": -0.03, "average": -0.26, "synthesised": 0.02}
ANSWER = {key: 4.0 * value**4 for key, value in R2.items()}


@dataclass
class Made:
    """One session. The same values give the same files."""

    participant: str
    session: int = 1
    origin: str = "synthetic"
    study: str = "drags"
    gestures: list[str] = field(default_factory=lambda: ["horizontal_drag"])
    repetitions: int = 4
    practice: int = 1
    r2: dict[tuple[str, str], float] = field(default_factory=lambda: dict(R2))
    noise: float = 0.05  # of R2, in a trial
    seed: int = 1
    curves: bool = True  # trial_NNNN.motion.csv of the unstable trials

    def folder(self, root: Path) -> Path:
        return root / self.study / f"sub-{self.participant}" / f"ses-{self.session:02}"


def write_session(root: Path, made: Made) -> Path:
    folder = made.folder(root)
    folder.mkdir(parents=True)
    # By the text's bytes, because Python's hash of a text differs from run to run.
    random = np.random.default_rng([made.seed, made.session, *made.participant.encode()])
    plan = planned_trials(made, random)
    write_session_file(folder, made, plan)
    person = random.normal(0.0, 0.01)  # how much better this participant's R2 is
    trials = [trial_row(made, entry, person, random) for entry in plan]
    write_rows(folder / "trials.csv", trials)
    write_rows(folder / "answers.csv", answer_rows(made, plan, random))
    write_rows(folder / "events.csv", event_rows(trials))
    for trial in trials if made.curves else []:
        if trial["position"] == "unstable":
            write_motion(folder / f"trial_{trial['trial']:04}.motion.csv", trial, random)
    return folder


def planned_trials(made: Made, random: np.random.Generator) -> list[dict]:
    plan = []
    for block, (gesture, position) in enumerate(itertools.product(made.gestures, POSITIONS), start=1):
        practice = [(True, "measured", i) for i in range(made.practice)]
        counted = [(False, condition, i) for condition in random.permutation(CURVES) for i in range(made.repetitions)]
        for is_practice, condition, repetition in [*practice, *counted]:
            plan.append(
                {
                    "trial": len(plan) + 1,
                    "block": block,
                    "practice": is_practice,
                    "gesture": gesture,
                    "position": position,
                    "condition": str(condition),
                    "repetition": repetition + 1,
                    "amplitude_m": 0.2,
                    "width_m": 0.04,
                    "rest_before_s": 0.0,
                }
            )
    return plan


def write_session_file(folder: Path, made: Made, plan: list[dict]) -> None:
    after = [entry["trial"] for entry in plan if is_last_of_condition(entry, made)]
    data = {
        "format": "steadyhand-session",
        "version": 1,
        "study": made.study,
        "participant": made.participant,
        "session": made.session,
        "origin": made.origin,
        "seed": made.seed,
        "protocol": {"repetitions": made.repetitions},
        "trials": plan,
        "questionnaires": [{"after_trial": trial, "questionnaire": "paper"} for trial in after],
        "settings": {"mode": "phase", "quality": 1.0, "sensor_latency_s": 0.007, "source": "made up", "reference": ""},
        "versions": {"steadyhand": "0.1.0", "godot": "4.4.1"},
        "machine": {"os": "Linux", "processor": "made up", "xr_runtime": "", "screen_hz": 60},
        "started": "2026-11-28T12:00:00",
    }
    (folder / "session.json").write_text(json.dumps(data, indent=2) + "\n", "utf-8")


def is_last_of_condition(entry: dict, made: Made) -> bool:
    return not entry["practice"] and entry["repetition"] == made.repetitions


def trial_row(made: Made, entry: dict, person: float, random: np.random.Generator) -> dict:
    shown_s = 5.0 * entry["trial"]
    onset_s = shown_s + random.uniform(0.3, 0.6)
    row = {key: entry[key] for key in ("trial", "block", "repetition")}
    row |= {"run": 1, "participant": made.participant, "session": made.session, "origin": made.origin}
    row |= {"practice": int(entry["practice"])}
    row |= {key: entry[key] for key in ("gesture", "position", "condition", "amplitude_m", "width_m")}
    row |= {"shown_s": shown_s, "onset_s": onset_s, "end_s": onset_s + random.uniform(0.9, 1.3)}
    row |= {"recognised": entry["gesture"], "aborts": 0, "losses": int(entry["position"] == "unstable")}
    row |= {"end_value_m": random.normal(0.2, 0.008)}
    row |= {"reference": "truth" if made.origin == "synthetic" else "sensor"}
    found = {}
    for curve in CURVES:
        r2 = min(made.r2[(entry["position"], curve)] + person + random.normal(0.0, made.noise), 1.0)
        found["r2", curve], found["r2_zero", curve] = r2, r2 - 0.02
        found["lag", curve] = 0.005
        found["t_diff", curve] = T_DIFF_S[curve] + random.normal(0.0, 0.02)
    row |= {
        f"{figure}_{curve}": found[figure, curve] for figure in ("r2", "r2_zero", "lag", "t_diff") for curve in CURVES
    }
    return row | {"finished": "2026-11-28T12:00:05"}


def answer_rows(made: Made, plan: list[dict], random: np.random.Generator) -> list[dict]:
    rows = []
    for entry in plan:
        if not is_last_of_condition(entry, made):
            continue
        for item, text in ITEMS.items():
            value = ANSWER[(entry["position"], entry["condition"])] + random.normal(0.0, 0.5)
            row = {"participant": made.participant, "session": made.session, "origin": made.origin, "run": 1}
            row |= {"after_trial": entry["trial"]}
            row |= {key: entry[key] for key in ("gesture", "position", "condition")}
            row |= {"questionnaire": "paper", "item": item, "text": text, "value": int(np.clip(round(value), 0, 4))}
            row |= {"minimum": 0, "maximum": 4, "skipped": 0, "changes": 0, "shown_s": 1.0, "answered_s": 3.0}
            rows.append(row)
    return rows


def event_rows(trials: list[dict]) -> list[dict]:
    rows = [{"t_s": 0.0, "run": 1, "trial": "", "event": "run_started", "value": "2026-11-28T12:00:00"}]
    for trial in trials:
        for event, column in (("target_shown", "shown_s"), ("onset", "onset_s"), ("end", "end_s")):
            time = {"t_s": trial[column], "run": 1, "trial": trial["trial"]}
            rows.append(time | {"event": event, "value": trial["gesture"]})
    return rows


def write_motion(path: Path, trial: dict, random: np.random.Generator) -> None:
    """A minimum-jerk reference; the measured motion is noisy and freezes before the end."""
    start, end = trial["onset_s"], trial["end_s"]
    t = np.arange(trial["shown_s"], end + 0.5, 0.001)

    def motion(late_s: float) -> np.ndarray:
        x = np.clip((t - late_s - start) / (end - start), 0.0, 1.0)
        return trial["end_value_m"] * (10 * x**3 - 15 * x**4 + 6 * x**5)

    walk = np.repeat(np.cumsum(random.normal(0.0, 0.004, len(t) // 11 + 1)), 11)[: len(t)]
    measured = motion(0.02) + walk * np.exp(-(((t - end) / 0.4) ** 2))
    columns = {
        "t": t,
        "measured": measured,
        "average": motion(0.26),
        "one_euro": motion(0.08),
        "kalman": motion(0.06),
        "synthesised": motion(-0.01),
        "reference": motion(0.0),
        "progress": motion(0.0) / trial["end_value_m"],
    }
    with path.open("w", encoding="utf-8") as file:
        file.write("t,measured,average,one_euro,kalman,synthesised,reference,state,progress,vibration\n")
        for i in range(len(t)):
            cells = {name: f"{values[i]:.6f}" for name, values in columns.items()}
            state = math.floor(min(3.999 * columns["progress"][i], 3))
            file.write(",".join(list(cells.values())[:-1] + [str(state), cells["progress"], cells["progress"]]) + "\n")


def write_rows(path: Path, rows: list[dict]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        lines = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        lines.writeheader()
        for row in rows:
            lines.writerow({key: f"{value:.9f}" if isinstance(value, float) else value for key, value in row.items()})


def write_study(root: Path, people: int, **made: object) -> list[Path]:
    return [write_session(root, Made(f"p{number:02}", **made)) for number in range(1, people + 1)]
