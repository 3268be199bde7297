"""What is to be reached, beside the paper's figures: each row is judged on every set that can judge it."""

from collections.abc import Iterator
from dataclasses import dataclass

from results.asked import T_DIFF_S, is_inside
from results.other_hands import OtherHands
from results.study import OTHERS, Study

DRAGS = ("horizontal_drag", "vertical_drag")
PAPER_RECOGNITION = {"horizontal_drag": "94.4 %", "vertical_drag": "94.6 %", "zoom": "95.1 %", "tap": "81.8 %"}


@dataclass
class Verdict:
    ours: str
    reached: bool


@dataclass
class Target:
    what: str
    paper: str
    wanted: str
    verdicts: dict[str, Verdict]  # by the set's name


def targets(studies: list[Study], others: list[OtherHands]) -> Iterator[Target]:
    gestures = list(dict.fromkeys(gesture for study in studies for gesture in study.gestures()))
    for gesture in gestures:
        for what, paper, wanted, judge in rows_of(gesture):
            verdicts = {study.name: verdict for study in studies if (verdict := judge(study))}
            yield Target(f"{gesture.replace('_', ' ')}: {what}", paper, wanted, verdicts)
    verdicts = {study.name: verdict for study in studies if (verdict := false_alarms(study))}
    if others:
        verdicts["real"] = false_alarms_of_others(others)
    yield Target("false alarms a minute of other motion, without a task", "-", "< 0.2", verdicts)


def rows_of(gesture: str):
    """What, the paper's figure, the figure to reach, and who judges it: a function of a study, None where it cannot."""
    yield "mean R2, unstable", "> 0.7", ">= 0.99", at_least(gesture, "r2", "mean", 0.99)
    yield "R2 of the worst 5 %, unstable", "-", ">= 0.96", at_least(gesture, "r2", "p5", 0.96)
    yield "mean zero-lag R2, unstable", "-", ">= 0.985", at_least(gesture, "r2_zero", "mean", 0.985)
    yield "mean R2 minus that of the best filter or raw data, unstable", "-", "> 0", above_others(gesture)
    yield "loss of mean R2 against raw data, stable", "like measured", "<= 0.005", below_measured(gesture)
    if gesture in DRAGS:
        for position in ("stable", "unstable"):
            wanted = "within 20 ms"
            yield f"median T_diff, {position}", "200 ms early", wanted, median_t_diff(gesture, position, 0.02)
        for position, wanted in (("stable", "15 ms early to 50 ms late"), ("unstable", "within 100 ms")):
            yield f"T_diff of 95 % of the trials, {position}", "-", wanted, t_diff_range(gesture, position)
    if gesture == "tap":
        for position in ("stable", "unstable"):
            wanted = "within 15 ms"
            yield f"median T_diff, {position}", "30 ms early", wanted, median_t_diff(gesture, position, 0.015)
    paper = PAPER_RECOGNITION.get(gesture, "-")
    yield "recognised, all models active, without a task", paper, ">= 99 %", recognised(gesture)


def at_least(gesture: str, figure: str, statistic: str, limit: float):
    def judge(study: Study) -> Verdict | None:
        group = study.group(gesture, "unstable")
        if group is None:
            return None
        value = group["phase"][figure][statistic]
        return Verdict(f"{value:.4f}", value >= limit)

    return judge


def above_others(gesture: str):
    def judge(study: Study) -> Verdict | None:
        group = study.group(gesture, "unstable")
        if group is None:
            return None
        best = max(OTHERS, key=lambda condition: group[condition]["r2"]["mean"])
        margin = group["phase"]["r2"]["mean"] - group[best]["r2"]["mean"]
        return Verdict(f"{margin:+.4f}", margin > 0)

    return judge


def below_measured(gesture: str):
    def judge(study: Study) -> Verdict | None:
        group = study.group(gesture, "stable")
        if group is None:
            return None
        loss = group["measured"]["r2"]["mean"] - group["phase"]["r2"]["mean"]
        return Verdict(f"{loss:.4f}", loss <= 0.005)

    return judge


def median_t_diff(gesture: str, position: str, limit_s: float):
    def judge(study: Study) -> Verdict | None:
        group = study.group(gesture, position)
        if group is None:
            return None
        value_s = group["phase"]["t_diff"]["median"]
        return Verdict(f"{1000 * value_s:+.0f} ms", abs(value_s) <= limit_s)

    return judge


def t_diff_range(gesture: str, position: str):
    low_s, high_s = T_DIFF_S[position]

    def judge(study: Study) -> Verdict | None:
        group = study.group(gesture, position)
        if group is None:
            return None
        t_diff = group["phase"]["t_diff"]
        inside = [is_inside(value, position) for value in study.values(gesture, position, "t_diff", "phase")]
        share = f"{percent(sum(inside) / len(inside))} inside"
        text = f"{1000 * t_diff['p2_5']:+.0f} .. {1000 * t_diff['p97_5']:+.0f} ms, {share}"
        return Verdict(text, t_diff["p2_5"] >= low_s and t_diff["p97_5"] <= high_s)

    return judge


def recognised(gesture: str):
    def judge(study: Study) -> Verdict | None:
        row = study.open["phase"].summary["confusion"].get(gesture)
        if row is None:
            return None
        right, trials = row.get(gesture, 0), sum(row.values())
        return Verdict(f"{right} of {trials}, {percent(right / trials)}", right >= 0.99 * trials)

    return judge


def percent(share: float) -> str:
    return f"{100 * share:.1f} %"


def false_alarms(study: Study) -> Verdict | None:
    summary = study.open["phase"].summary
    if summary["none_minutes"] == 0:
        return None
    rate, alarms = summary["false_alarms_per_minute"], len(summary["false_alarms"])
    return Verdict(f"{rate:.2f} ({alarms} in {summary['none_minutes']:.0f} min)", rate < 0.2)


def false_alarms_of_others(others: list[OtherHands]) -> Verdict:
    minutes = sum(other.minutes for other in others)
    alarms = sum(len(other.evaluation.summary["false_alarms"]) for other in others)
    text = f"{alarms / minutes:.2f} ({alarms} in {minutes:.1f} min of hands at other tasks)"
    return Verdict(text, alarms < 0.2 * minutes)
