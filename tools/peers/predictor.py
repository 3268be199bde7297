"""The interface of a predictor, the predictor that holds the last frame, and the run of a predictor on a trial."""

from typing import Protocol

import numpy as np
from peers.trials import Trial

# s. The default of GestureHMM.sensor_latency, which ./steadyhand evaluate uses.
SENSOR_LATENCY_S = 0.007
HORIZONS_S = np.array([0.0, 0.05, 0.1, 0.2])
# Nearer frames are skipped: their velocity would be mostly the jitter of time stamps.
LEAST_INTERVAL_S = 0.003
MARGIN_S = 0.25  # before and after the gesture, where prediction errors are taken


class Predictor(Protocol):
    def observe(self, t_s: float, value: float) -> None:
        """Takes a tracked frame, newer than all before: where the hand is along the task, in amplitudes."""

    def predict(self, times_s: np.ndarray) -> np.ndarray:
        """Where the hand is at these times, none of which is before the newest frame; 0 before the first frame."""


class Hold:
    def __init__(self) -> None:
        self.value = 0.0

    def observe(self, t_s: float, value: float) -> None:
        self.value = value

    def predict(self, times_s: np.ndarray) -> np.ndarray:
        return np.full(len(times_s), self.value)


def follow(predictor: Predictor, trial: Trial, times_s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The curve at times_s (increasing), each from the frames stamped no later; and the errors (frames, horizons).

    The errors are those of the predictions made at each frame of the gesture for HORIZONS_S ahead, in amplitudes.
    """
    curve = np.zeros(len(times_s))
    errors = []
    frames_t_s, frames = spaced(trial.t_s, trial.value)
    first = np.searchsorted(times_s, frames_t_s)
    until = np.append(first[1:], len(times_s))
    for t_s, value, begin, end in zip(frames_t_s, frames, first, until, strict=True):
        predictor.observe(t_s, value)
        if begin < end:
            curve[begin:end] = predictor.predict(times_s[begin:end])
        ahead_s = t_s + HORIZONS_S
        if trial.start_s - MARGIN_S <= t_s <= trial.end_s + MARGIN_S and ahead_s[-1] <= trial.reference_t_s[-1]:
            errors.append(predictor.predict(ahead_s) - trial.reference_at(ahead_s))
    return curve, np.array(errors).reshape(-1, len(HORIZONS_S))


def spaced(t_s: np.ndarray, value: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The frames that are at least LEAST_INTERVAL_S after the one before that is kept."""
    kept, last_s = [], -np.inf
    for i, time_s in enumerate(t_s):
        if time_s - last_s >= LEAST_INTERVAL_S:
            kept.append(i)
            last_s = time_s
    return t_s[kept], value[kept]
