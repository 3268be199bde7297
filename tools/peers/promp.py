"""A probabilistic movement primitive (Paraschos et al. 2013) on a grid of phases.

y(t) = mean(u) + modes(u) w + d(t) + noise, u = (t - t0) / T; w ~ N(0, 1); d is an Ornstein-Uhlenbeck process.
A hypothesis is one cell of a grid over (t0, ln T) and one kind of tracker. With a sound tracker, d is the hand's own
deviation. With a faulty tracker, d is larger, and it is the tracker's error. In one more hypothesis the hand is free:
d alone describes a hand that makes another movement. Within a cell the curve is linearised in (t0, ln T): each
hypothesis is a Kalman filter over x = (w, shift of t0, shift of ln T, d). Its weight is its marginal likelihood. The
prediction is the weighted mean.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from peers.frozen_frames import FrozenFrames
from peers.predictor import SENSOR_LATENCY_S
from peers.trials import Trial

MODES = 2
PHASES = np.linspace(0.0, 1.0, 101)
SLOW = 0.05  # share of the peak speed: slower is before the onset or after the end
MARGIN_S = 0.1  # before and after the gesture, where a training hand may begin and end

# The grid and the priors.
ONSET_STEP_S = 0.02
ONSETS_PER_S = 1.0  # of a hand at rest
LOG_DURATION_STEP = 0.2
LOG_DURATION_STEPS = np.arange(-6, 7)
LOG_DURATION_DEVIATION = 0.6
FAULTY_SHARE = 0.2
# Kinds of hypotheses, and d of each: standard deviation (amplitudes) and time constant (s).
SOUND, FAULTY, FREE = range(3)
DEVIATION = np.array([0.025, 0.08, 1.0])
DEVIATION_S = np.array([0.1, 0.2, 1.0])
NOISE = 0.0035  # of a frame without tracker noise, amplitudes
NOISE_FRAMES = 18  # from which the tracker's white noise is measured
OUTLIERS, OUTLIER_DENSITY = 0.01, 0.4  # their share, and their density over all places (1 / amplitudes)
# Limits of the number of hypotheses.
MOST_HYPOTHESES = 300
MOST_ONSETS = 100  # in a gap: the newest 2 s of it
LEAST_LOG_WEIGHT = -12.0
REST_ROW, FREE_ROW = 0, 1
LEAST_WEIGHT = np.array([1e-4, 1e-3])  # of these two hypotheses, because a hand that returned may start again
DEVIATES = MODES + 2
STATE = MODES + 3
# Of the two shifts within a cell of the grid.
CELL_VARIANCES = np.array([(0.5 * ONSET_STEP_S) ** 2, (0.5 * LOG_DURATION_STEP) ** 2])


@dataclass(frozen=True)
class Primitive:
    """By phase, 0..1: the mean curve, its slope, and the modes that training hands deviate by, of unit variance."""

    mean: np.ndarray  # (phases)
    slope: np.ndarray
    modes: np.ndarray  # (MODES, phases)

    @classmethod
    def of(cls, curves: np.ndarray) -> "Primitive":
        """curves: (hands, PHASES), each 0 at its onset."""
        mean = curves.mean(axis=0)
        _, size, modes = np.linalg.svd(curves - mean, full_matrices=False)
        modes = modes[:MODES] * size[:MODES, None] / np.sqrt(len(curves))
        slope = np.gradient(mean, PHASES)
        slope[[0, -1]] = 0.0  # at rest
        return cls(mean, slope, modes)

    def at(self, phase: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Mean, slope and modes at phases of any shape; at rest before 0 and after 1."""
        place = np.clip(phase, 0.0, 1.0) * (len(PHASES) - 1)
        before = np.minimum(place.astype(int), len(PHASES) - 2)
        share = place - before
        table = np.vstack([self.mean, self.slope, self.modes])
        values = table[:, before] * (1.0 - share) + table[:, before + 1] * share
        return values[0], values[1], values[2:]


def train_primitive(trials: Iterable[Trial]) -> Primitive:
    """Learns mean and modes from the reference curves of training hands."""
    return Primitive.of(np.array([normalised(trial) for trial in trials]))


def normalised(trial: Trial) -> np.ndarray:
    """The reference at PHASES, from 0 at its onset. Onset and end are the slow samples nearest to the peak speed."""
    t_s, value = trial.reference_t_s, trial.reference
    speed = np.gradient(value, t_s)
    inside = np.flatnonzero((t_s > trial.start_s - MARGIN_S) & (t_s < trial.end_s + MARGIN_S))
    peak = inside[np.argmax(speed[inside])]
    is_slow = speed < SLOW * speed[peak]
    before, after = np.flatnonzero(is_slow[:peak]), np.flatnonzero(is_slow[peak:])
    onset_s = t_s[before[-1]] if before.size else t_s[0]
    end_s = t_s[peak + after[0]] if after.size else t_s[-1]
    curve = trial.reference_at(onset_s + PHASES * (end_s - onset_s))
    return curve - curve[0]


class ProMP:
    """Hypothesis REST_ROW is the hand at rest with a sound tracker, FREE_ROW the free hand: their onset is infinite."""

    def __init__(self, primitive: Primitive, duration_s: float) -> None:
        """primitive: from train_primitive(). duration_s: the mean of the gesture's model."""
        self.primitive = primitive
        self.onset_s = np.array([np.inf, np.inf])
        self.duration_s = np.array([duration_s, duration_s])
        self.kind = np.array([SOUND, FREE])
        self.log_weight = np.log([1.0 - LEAST_WEIGHT[FREE_ROW], LEAST_WEIGHT[FREE_ROW]])
        self.mean = np.zeros((2, STATE))
        prior = (np.diag([*np.ones(MODES), *CELL_VARIANCES, DEVIATION[kind] ** 2]) for kind in self.kind)
        self.covariance = np.array(list(prior))
        self.newest_s = None
        self.recent = np.zeros(0)
        self.frozen = FrozenFrames()
        log_durations = LOG_DURATION_STEP * LOG_DURATION_STEPS
        prior = np.exp(-0.5 * (log_durations / LOG_DURATION_DEVIATION) ** 2)
        # New hypotheses at each onset: duration, tracker and log prior.
        self.born_duration_s = np.tile(duration_s * np.exp(log_durations), 2)
        self.born_kind = np.repeat([SOUND, FAULTY], len(prior))
        self.born_log_prior = np.log(np.outer([1.0 - FAULTY_SHARE, FAULTY_SHARE], prior / prior.sum()).ravel())

    def observe(self, t_s: float, value: float) -> None:
        if self.frozen.is_frozen(t_s, value):
            return
        since_s = self.newest_s
        self.drift(0.0 if since_s is None else t_s - since_s)
        self.newest_s = t_s
        if since_s is not None:
            first, last = (int(np.floor(at_s / ONSET_STEP_S)) + 1 for at_s in (since_s, t_s))
            for step in range(max(first, last - MOST_ONSETS), last):
                self.bear(step * ONSET_STEP_S)
        self.recent = np.append(self.recent, value)[-NOISE_FRAMES:]
        self.update(t_s, value, NOISE**2 + self.white_variance())
        self.prune()

    def predict(self, times_s: np.ndarray) -> np.ndarray:
        if self.newest_s is None:
            return np.zeros(len(times_s))
        weight = np.exp(self.log_weight)
        mean, row = self.linear(times_s[:, None] + SENSOR_LATENCY_S)
        ahead_s = times_s - self.newest_s + SENSOR_LATENCY_S
        row[..., DEVIATES] = np.where(self.kind == FAULTY, 0.0, np.exp(-ahead_s[:, None] / DEVIATION_S[self.kind]))
        by_hypothesis = mean + np.einsum("thk,hk->th", row, self.mean)
        # Not `@`: its order of summation, and so the last bit, depends on the number of times.
        return np.sum(by_hypothesis * weight, axis=1)

    def linear(self, t_s: np.ndarray | float) -> tuple[np.ndarray, np.ndarray]:
        """Mean and row of y = mean + row x at t_s, one of each hypothesis."""
        phase = (t_s - self.onset_s) / self.duration_s
        mean, slope, modes = self.primitive.at(phase)
        to_duration = -np.clip(phase, 0.0, 1.0) * slope
        return mean, np.stack([*modes, -slope / self.duration_s, to_duration, np.ones_like(mean)], axis=-1)

    def drift(self, dt_s: float) -> None:
        """Predicts d: its mean decays, its variance grows to DEVIATION^2."""
        kept = np.exp(-dt_s / DEVIATION_S[self.kind])
        self.mean[:, DEVIATES] *= kept
        self.covariance[:, DEVIATES, :] *= kept[:, None]
        self.covariance[:, :, DEVIATES] *= kept[:, None]
        self.covariance[:, DEVIATES, DEVIATES] += DEVIATION[self.kind] ** 2 * (1.0 - kept**2)

    def bear(self, onset_s: float) -> None:
        """Adds hypotheses of this onset, one for each duration and kind of tracker, with the state of the rest."""
        share = ONSETS_PER_S * ONSET_STEP_S
        count = len(self.born_duration_s)
        self.onset_s = np.append(self.onset_s, np.full(count, onset_s))
        self.duration_s = np.append(self.duration_s, self.born_duration_s)
        self.kind = np.append(self.kind, self.born_kind)
        self.log_weight = np.append(self.log_weight, self.log_weight[REST_ROW] + np.log(share) + self.born_log_prior)
        self.log_weight[REST_ROW] += np.log1p(-share)
        self.mean = np.append(self.mean, np.repeat(self.mean[:1], count, axis=0), axis=0)
        self.covariance = np.append(self.covariance, np.repeat(self.covariance[:1], count, axis=0), axis=0)

    def update(self, t_s: float, value: float, variance: float) -> None:
        """One Kalman step of each hypothesis. A hypothesis to which the frame is an outlier keeps its state."""
        mean, row = self.linear(t_s)
        off = value - mean - np.einsum("hk,hk->h", row, self.mean)
        across = np.einsum("hij,hj->hi", self.covariance, row)
        spread = np.einsum("hi,hi->h", across, row) + variance
        density = (1.0 - OUTLIERS) * np.exp(-0.5 * off**2 / spread) / np.sqrt(2.0 * np.pi * spread)
        outlier_density = OUTLIERS * OUTLIER_DENSITY
        self.log_weight += np.log(np.maximum(density, outlier_density))
        gain = np.where(density > outlier_density, 1.0 / spread, 0.0)[:, None] * across
        self.mean += gain * off[:, None]
        self.covariance -= gain[:, :, None] * across[:, None, :]

    def white_variance(self) -> float:
        """Variance of the tracker's white noise, from the median second difference: that of the motion is small."""
        if len(self.recent) < NOISE_FRAMES // 2:
            return 0.0
        return (1.4826 * np.median(np.abs(np.diff(self.recent, 2)))) ** 2 / 6.0

    def prune(self) -> None:
        self.log_weight -= np.logaddexp.reduce(self.log_weight)
        fixed = [REST_ROW, FREE_ROW]
        self.log_weight[fixed] = np.maximum(self.log_weight[fixed], np.log(LEAST_WEIGHT))
        order = 2 + np.argsort(-self.log_weight[2:])[: MOST_HYPOTHESES - 2]
        kept = np.append(fixed, order[self.log_weight[order] > self.log_weight.max() + LEAST_LOG_WEIGHT])
        for name in ("onset_s", "duration_s", "kind", "log_weight", "mean", "covariance"):
            setattr(self, name, getattr(self, name)[kept])
        self.log_weight -= np.logaddexp.reduce(self.log_weight)
