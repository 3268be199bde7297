"""The goals of `phase` mode: one figure on one set each, with raw data and the best other predictor."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from peers.comparison import TITLES, TrialFigures, groups
from results.formats import ms, percent
from results.other_hands import OtherHands
from results.study import Study

RAW, OURS = "measured", "synthesised"
PREDICTORS = [condition for condition in TITLES if condition not in (RAW, OURS)]
PAPER_RECOGNITION = {"horizontal_drag": "94.4 %", "vertical_drag": "94.6 %", "zoom": "95.1 %", "tap": "81.8 %"}
PAPER_END = {"horizontal_drag": "200 ms early", "vertical_drag": "200 ms early", "tap": "30 ms early"}
MOST_BELOW_RAW = 0.0006
MOST_END_ERROR_S = 0.01
LEAST_RECOGNISED = 0.97
MOST_ALARMS_A_MINUTE = 1.0


@dataclass
class Goal:
    what: str
    trials: str
    paper: str
    raw: str
    best_predictor: str
    ours: str
    aim: str
    is_reached: bool


def goals(studies: list[Study], compared: dict[str, list[TrialFigures]], others: list[OtherHands]) -> Iterator[Goal]:
    """compared: the trials of each study, with a task, by its name.

    The goals at stable positions are for real hands: the constant latency of a simulated sensor is not observable.
    """
    unstable, stable = (
        [
            (f"{name}, {gesture.replace('_', ' ')}: {len(group)}", gesture, group)
            for name in names
            for (gesture, own_position), group in groups(compared[name]).items()
            if own_position == position
        ]
        for position, names in (("unstable", list(compared)), ("stable", compared.keys() & {"real"}))
    )
    for trials, _, group in unstable:
        yield r2_above_predictors(trials, group)
    for trials, _, group in stable:
        yield r2_like_raw(trials, group)
    for trials, gesture, group in stable:
        yield end_error(trials, gesture, group)
    for study in studies:
        for gesture in study.gestures():
            yield recognition(study, gesture)
    if others:
        yield false_alarms(others)


def r2_above_predictors(trials: str, group: list[TrialFigures]) -> Goal:
    r2 = mean_r2(group)
    best = max(PREDICTORS, key=r2.__getitem__)
    is_reached = r2[OURS] > max(r2[best], r2[RAW])
    what, aim = "zero-lag R2, unstable", "above every predictor"
    return Goal(what, trials, "> 0.7 at the best lag", *r2_cells(r2, best), aim, is_reached)


def r2_like_raw(trials: str, group: list[TrialFigures]) -> Goal:
    r2 = mean_r2(group)
    best = max(PREDICTORS, key=r2.__getitem__)
    is_reached = r2[OURS] >= r2[RAW] - MOST_BELOW_RAW
    what, aim = "zero-lag R2, stable", f"within {MOST_BELOW_RAW:g} of raw"
    return Goal(what, trials, "like measured", *r2_cells(r2, best), aim, is_reached)


def mean_r2(group: list[TrialFigures]) -> dict[str, float]:
    return {condition: np.mean([trial.figures[condition].r2_zero for trial in group]) for condition in TITLES}


def r2_cells(r2: dict[str, float], best: str) -> list[str]:
    return [f"{r2[RAW]:.4f}", f"{r2[best]:.4f} ({TITLES[best]})", f"{r2[OURS]:.4f}"]


def end_error(trials: str, gesture: str, group: list[TrialFigures]) -> Goal:
    t_diff_s = {condition: np.median([trial.figures[condition].t_diff_s for trial in group]) for condition in TITLES}
    best = min(PREDICTORS, key=lambda condition: abs(t_diff_s[condition]))
    cells = [ms(t_diff_s[RAW]), f"{ms(t_diff_s[best])} ({TITLES[best]})", ms(t_diff_s[OURS])]
    what, aim = "median T_diff, stable", f"within {1000 * MOST_END_ERROR_S:.0f} ms"
    return Goal(what, trials, PAPER_END.get(gesture, "-"), *cells, aim, abs(t_diff_s[OURS]) <= MOST_END_ERROR_S)


def recognition(study: Study, gesture: str) -> Goal:
    row = study.open["phase"].summary["confusion"][gesture]
    right, count = row.get(gesture, 0), sum(row.values())
    trials = f"{study.name}, {gesture.replace('_', ' ')}: {count}"
    paper = PAPER_RECOGNITION.get(gesture, "-")
    aim = f">= {100 * LEAST_RECOGNISED:.0f} %"
    is_reached = right >= LEAST_RECOGNISED * count
    return Goal("recognised, without a task", trials, paper, "-", "-", percent(right / count), aim, is_reached)


def false_alarms(others: list[OtherHands]) -> Goal:
    minutes = sum(other.minutes for other in others)
    rate = sum(len(other.evaluation.summary["false_alarms"]) for other in others) / minutes
    what, trials = "false alarms a minute, without a task", f"real hands that make no gesture: {minutes:.1f} minutes"
    aim = f"< {MOST_ALARMS_A_MINUTE:g}"
    return Goal(what, trials, "-", "-", "-", f"{rate:.2f}", aim, rate < MOST_ALARMS_A_MINUTE)
