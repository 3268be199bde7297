"""The metrics of extension/core/metrics/curve_comparison.h that the table of predictors shows.

Written apart from the core: a test compares them with results.csv of `./steadyhand evaluate`.
"""

from dataclasses import dataclass

import numpy as np
from gesture_end import END_LEVEL

MARGIN_S = 0.25
SLACK_S = 1e-9  # instants this near are on the grid


@dataclass(frozen=True)
class Figures:
    r2_zero: float
    t_diff_s: float  # positive: the curve ends early; if it is missed, until the end of the record
    missed: bool  # it never reaches END_LEVEL of the reference's level at the end


def compare(t_s: np.ndarray, reference: np.ndarray, curve: np.ndarray, start_s: float, end_s: float) -> Figures:
    """Both curves at the instants t_s, in amplitudes; the gesture is from start_s to end_s."""
    window = (t_s >= start_s - MARGIN_S - SLACK_S) & (t_s <= end_s + MARGIN_S + SLACK_S)
    target = reference[window]
    r2_zero = 1.0 - np.sum((target - curve[window]) ** 2) / np.sum((target - target.mean()) ** 2)
    level = END_LEVEL * np.interp(end_s, t_s, reference)
    reference_end_s = first_reach(t_s, reference, start_s, level) if level > 0.0 else None
    curve_end_s = None if reference_end_s is None else first_reach(t_s, curve, start_s, level)
    missed = curve_end_s is None
    from_s = end_s if reference_end_s is None else reference_end_s
    return Figures(float(r2_zero), float(from_s - (t_s[-1] if missed else curve_end_s)), missed)


def first_reach(t_s: np.ndarray, curve: np.ndarray, start_s: float, level: float) -> float | None:
    """The first time from start_s on at which the curve is at the level, on straight lines between instants."""
    start_s = float(np.clip(start_s, t_s[0], t_s[-1]))
    times = np.concatenate([[start_s], t_s[t_s > start_s]])
    values = np.interp(times, t_s, curve)
    reached = np.flatnonzero(values >= level)
    if reached.size == 0:
        return None
    i = reached[0]
    if i == 0:
        return start_s
    share = (level - values[i - 1]) / (values[i] - values[i - 1])
    return times[i - 1] + share * (times[i] - times[i - 1])
