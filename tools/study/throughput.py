"""Fitts throughput by the effective width.

ISO/TS 9241-411:2012; Soukoreff & MacKenzie 2004, doi:10.1016/j.ijhcs.2004.09.001.
"""

import math
import statistics
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

from study.rows import Trial

# Standard deviations of a normal distribution that hold 96 % of it (of the ends): (2 pi e)^(1/2).
WIDTH_PER_DEVIATION = 4.133


@dataclass(frozen=True)
class Cell:
    """Results of one participant in one task, position and condition, at one amplitude and width.

    None: there is no such figure. A width needs two or more different ends.
    """

    origin: str
    participant: str
    gesture: str
    position: str
    condition: str
    amplitude_m: float
    width_m: float | None
    n: int  # trials that have an end
    without_end: int
    movement_time_s: float | None
    effective_amplitude_m: float | None
    effective_width_m: float | None
    effective_difficulty_bits: float | None
    throughput_bits_s: float | None


@dataclass(frozen=True)
class Group:
    """An origin, task, position and condition: means over the participants that have a throughput in it."""

    origin: str
    gesture: str
    position: str
    condition: str
    participants: int  # of persons people; of other origins mice, or simulated or replayed subjects
    n: int  # trials that have an end, of all participants
    without_end: int
    movement_time_s: float | None
    effective_amplitude_m: float | None
    effective_width_m: float | None
    effective_difficulty_bits: float | None
    throughput_bits_s: float | None
    throughput_deviation_bits_s: float | None  # over participants; None for one


def cells(trials: Iterable[Trial]) -> list[Cell]:
    parts = defaultdict(list)
    for trial in trials:
        task = (trial.gesture, trial.position, trial.condition, trial.amplitude_m, trial.width_m)
        parts[(trial.origin, trial.participant, *task)].append(trial)
    # A width may be None, which has no order.
    return [cell(*key, parts[key]) for key in sorted(parts, key=lambda key: (*key[:-1], key[-1] or 0.0))]


def cell(
    origin: str,
    participant: str,
    gesture: str,
    position: str,
    condition: str,
    amplitude_m: float,
    width_m: float | None,
    trials: list[Trial],
) -> Cell:
    done = [trial for trial in trials if trial.is_complete]
    ends_m = [trial.end_value_m for trial in done]
    time_s = statistics.fmean(trial.movement_time_s for trial in done) if done else None
    way_m = statistics.fmean(ends_m) if done else None
    spread_m = WIDTH_PER_DEVIATION * statistics.stdev(ends_m) if len(done) > 1 else None
    bits = math.log2(way_m / spread_m + 1.0) if spread_m and way_m > 0.0 else None
    rate = bits / time_s if bits is not None else None
    task = (gesture, position, condition, amplitude_m, width_m)
    return Cell(origin, participant, *task, len(done), len(trials) - len(done), time_s, way_m, spread_m, bits, rate)


def groups(of: Iterable[Cell]) -> list[Group]:
    """A participant counts once, whatever the number of amplitudes and widths: the mean of means."""
    parts = defaultdict(list)
    for one in of:
        parts[(one.origin, one.gesture, one.position, one.condition)].append(one)
    return [group(*key, parts[key]) for key in sorted(parts)]


def group(origin: str, gesture: str, position: str, condition: str, of: list[Cell]) -> Group:
    by_participant = defaultdict(list)
    for one in of:
        if one.throughput_bits_s is not None:
            by_participant[one.participant].append(one)

    def means(figure: str) -> list[float]:
        """A value a participant."""
        return [statistics.fmean(getattr(one, figure) for one in own) for own in by_participant.values()]

    figures = [
        statistics.fmean(means(figure)) if by_participant else None
        for figure in (
            "movement_time_s",
            "effective_amplitude_m",
            "effective_width_m",
            "effective_difficulty_bits",
            "throughput_bits_s",
        )
    ]
    n = sum(one.n for one in of)
    deviation = statistics.stdev(means("throughput_bits_s")) if len(by_participant) > 1 else None
    without_end = sum(one.without_end for one in of)
    return Group(origin, gesture, position, condition, len(by_participant), n, without_end, *figures, deviation)
