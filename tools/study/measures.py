"""What is measured: a mean for each participant, which is what all tests and box plots use."""

import statistics
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

from study.analysis import Analysis
from study.rows import CONDITIONS, POSITIONS, Trial
from study.session_rows import CURVES, StudyTrial
from study.throughput import Cell, cells

# Measure of a curve: its column in trials.csv without the curve's name.
CURVE_MEASURES = {"r2": "R² at the best lag", "r2_zero": "R² at zero lag", "t_diff": "T_diff (s)"}
THROUGHPUT = "throughput"
# In the paper's order of Fig. 7 and 8, then the others.
MOTIONS = ["measured", "synthesised", "average", "one_euro", "kalman"]
assert set(MOTIONS) == set(CONDITIONS)


@dataclass(frozen=True)
class Mean:
    """The mean of one participant in one cell of the design."""

    kind: str  # curve, throughput, answer
    measure: str
    gesture: str
    participant: str
    position: str
    motion: str  # the curve, or the condition that drove the vibration
    n: int
    value: float


def participant_means(analysis: Analysis) -> list[Mean]:
    return [*curve_means(analysis.trials), *throughput_means(analysis.trials), *answer_means(analysis)]


def curve_means(trials: Iterable[StudyTrial]) -> list[Mean]:
    """Every trial has all curves, whichever condition drove the vibration. Only recognised gestures count."""
    values = defaultdict(list)
    for trial in trials:
        for measure in CURVE_MEASURES if trial.is_recognised else ():
            for curve in CURVES:
                value = trial.figures[f"{measure}_{curve}"]
                if value is not None:
                    owner = (trial.gesture, trial.session.participant, trial.position, curve)
                    values[(measure, *owner)].append(value)
    return means_of("curve", values)


def throughput_means(trials: Iterable[StudyTrial]) -> list[Mean]:
    """The mean of a participant over amplitudes and widths, as throughput.groups has it."""
    values = defaultdict(list)
    for cell in throughput_cells(trials):
        if cell.throughput_bits_s is not None:
            owner = (cell.gesture, cell.participant, cell.position, cell.condition)
            values[(THROUGHPUT, *owner)].append((cell.throughput_bits_s, cell.n))
    return [
        Mean("throughput", *key, sum(n for _, n in pairs), statistics.fmean(value for value, _ in pairs))
        for key, pairs in sorted(values.items(), key=order_of)
    ]


def throughput_cells(trials: Iterable[StudyTrial]) -> list[Cell]:
    """A trial that ended as another gesture has no end of its own task."""
    return cells(
        Trial(
            str(trial.trial),
            trial.session.participant,
            trial.gesture,
            trial.position,
            trial.condition,
            trial.amplitude_m,
            trial.width_m,
            trial.onset_s,
            trial.end_s if trial.is_recognised else None,
            trial.end_value_m,
            trial.session.origin,
        )
        for trial in trials
    )


def answer_means(analysis: Analysis) -> list[Mean]:
    values = defaultdict(list)
    for answer in analysis.answers:
        if answer.value is not None and answer.condition:
            item = f"{answer.questionnaire}/{answer.item}"
            key = (item, answer.gesture, answer.session.participant, answer.position, answer.condition)
            values[key].append(answer.value)
    return means_of("answer", values)


def means_of(kind: str, values: dict[tuple, list[float]]) -> list[Mean]:
    return [Mean(kind, *key, len(own), statistics.fmean(own)) for key, own in sorted(values.items(), key=order_of)]


def order_of(entry: tuple) -> tuple:
    measure, gesture, participant, position, motion = entry[0]
    return (measure, gesture, POSITIONS.index(position), MOTIONS.index(motion), participant)
