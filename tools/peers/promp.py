"""A probabilistic movement primitive (Paraschos et al. 2013) on a grid of phases.

y(t) = mean(u) + modes(u) w + d(t) + noise, u = (t - t0) / T; w ~ N(0, 1), d an Ornstein-Uhlenbeck process. Each
hypothesis is a cell of the grid over (t0, ln T) before one kind of tracker: sound, where d is the hand's own, or
faulty, where d is large and the tracker's. Within its cell the curve is taken as linear in (t0, ln T), so that a
hypothesis is a Kalman filter over x = (w, shift of t0, shift of ln T, d). The hypotheses weigh as their marginal
likelihoods, and what is predicted is their mean.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from peers.frozen_frames import FrozenFrames
from peers.predictor import SENSOR_LATENCY_S
from peers.trials import Trial

MODES = 2
PHASES = np.linspace(0.0, 1.0, 101)
SLOW = 0.05  # of the peak speed: the hand has not begun, or has ended
MARGIN_S = 0.1  # before and after the gesture, where a training hand may begin and end

# The grid, and what is known beforehand.
ONSET_STEP_S = 0.02
ONSETS_PER_S = 1.0  # of a hand at rest
LOG_DURATION_STEP = 0.2
LOG_DURATION_STEPS = np.arange(-6, 7)
LOG_DURATION_DEVIATION = 0.6
FAULTY_SHARE = 0.2
# d by kind of tracker, sound and faulty: standard deviation (amplitudes) and time constant.
DEVIATION = np.array([0.025, 0.08])
DEVIATION_S = np.array([0.1, 0.2])
NOISE = 0.0035  # of a frame without tracker noise, amplitudes
NOISE_FRAMES = 18  # from which the tracker's white noise is measured
OUTLIERS, OUTLIER_DENSITY = 0.01, 0.4  # their share, and their density over all places (1 / amplitudes)
# What keeps the bank small and open.
MOST_HYPOTHESES = 300
LEAST_LOG_WEIGHT = -12.0
LEAST_REST = 1e-4  # a hand that came back may begin once more
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
    """From the reference curves of training hands."""
    return Primitive.of(np.array([normalised(trial) for trial in trials]))


def normalised(trial: Trial) -> np.ndarray:
    """The reference over PHASES from its onset to its end, which are where it is slow."""
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
    """Hypothesis 0 is the hand at rest before a sound tracker; its onset is never."""

    def __init__(self, primitive: Primitive, duration_s: float) -> None:
        """primitive: from train_primitive(). duration_s: the mean of the gesture's model."""
        self.primitive = primitive
        self.onset_s = np.array([np.inf])
        self.duration_s = np.array([duration_s])
        self.faulty = np.array([False])
        self.log_weight = np.zeros(1)
        self.mean = np.zeros((1, STATE))
        self.covariance = np.diag([*np.ones(MODES), *CELL_VARIANCES, DEVIATION[0] ** 2])[None]
        self.newest_s = None
        self.recent = np.zeros(0)
        self.frozen = FrozenFrames()
        log_durations = LOG_DURATION_STEP * LOG_DURATION_STEPS
        prior = np.exp(-0.5 * (log_durations / LOG_DURATION_DEVIATION) ** 2)
        # Those that are born at each onset: duration, tracker and log prior.
        self.born_duration_s = np.tile(duration_s * np.exp(log_durations), 2)
        self.born_faulty = np.repeat([False, True], len(prior))
        self.born_log_prior = np.log(np.outer([1.0 - FAULTY_SHARE, FAULTY_SHARE], prior / prior.sum()).ravel())

    def observe(self, t_s: float, value: float) -> None:
        if self.frozen.is_frozen(t_s, value):
            return
        since_s = self.newest_s
        self.drift(0.0 if since_s is None else t_s - since_s)
        self.newest_s = t_s
        if since_s is not None:
            first = int(np.floor(since_s / ONSET_STEP_S)) + 1
            for step in range(first, int(np.floor(t_s / ONSET_STEP_S)) + 1):
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
        row[..., DEVIATES] = np.where(self.faulty, 0.0, np.exp(-ahead_s[:, None] / DEVIATION_S[0]))
        by_hypothesis = mean + np.einsum("thk,hk->th", row, self.mean)
        return np.sum(
            by_hypothesis * weight, axis=1
        )  # `@` would add up in an order that depends on how many times_s are

    def linear(self, t_s: np.ndarray | float) -> tuple[np.ndarray, np.ndarray]:
        """At t_s, of each hypothesis: y = mean + row x."""
        phase = (t_s - self.onset_s) / self.duration_s
        mean, slope, modes = self.primitive.at(phase)
        to_duration = -np.clip(phase, 0.0, 1.0) * slope
        return mean, np.stack([*modes, -slope / self.duration_s, to_duration, np.ones_like(mean)], axis=-1)

    def drift(self, dt_s: float) -> None:
        """d goes back towards 0 and spreads."""
        kind = self.faulty.astype(int)
        kept = np.exp(-dt_s / DEVIATION_S[kind])
        self.mean[:, DEVIATES] *= kept
        self.covariance[:, DEVIATES, :] *= kept[:, None]
        self.covariance[:, :, DEVIATES] *= kept[:, None]
        self.covariance[:, DEVIATES, DEVIATES] += DEVIATION[kind] ** 2 * (1.0 - kept**2)

    def bear(self, onset_s: float) -> None:
        """The hand at rest sets out at onset_s, by each duration and before each kind of tracker."""
        share = ONSETS_PER_S * ONSET_STEP_S
        count = len(self.born_duration_s)
        self.onset_s = np.append(self.onset_s, np.full(count, onset_s))
        self.duration_s = np.append(self.duration_s, self.born_duration_s)
        self.faulty = np.append(self.faulty, self.born_faulty)
        self.log_weight = np.append(self.log_weight, self.log_weight[0] + np.log(share) + self.born_log_prior)
        self.log_weight[0] += np.log1p(-share)
        self.mean = np.append(self.mean, np.repeat(self.mean[:1], count, axis=0), axis=0)
        self.covariance = np.append(self.covariance, np.repeat(self.covariance[:1], count, axis=0), axis=0)

    def update(self, t_s: float, value: float, variance: float) -> None:
        """A Kalman step of each hypothesis; to one that takes the frame for an outlier it says nothing."""
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
        """Of the tracker's white noise, from what second differences are in the median; a motion has small ones."""
        if len(self.recent) < NOISE_FRAMES // 2:
            return 0.0
        return (1.4826 * np.median(np.abs(np.diff(self.recent, 2)))) ** 2 / 6.0

    def prune(self) -> None:
        self.log_weight -= np.logaddexp.reduce(self.log_weight)
        self.log_weight[0] = max(self.log_weight[0], np.log(LEAST_REST))
        order = 1 + np.argsort(-self.log_weight[1:])[: MOST_HYPOTHESES - 1]
        kept = np.append(0, order[self.log_weight[order] > self.log_weight.max() + LEAST_LOG_WEIGHT])
        for name in ("onset_s", "duration_s", "faulty", "log_weight", "mean", "covariance"):
            setattr(self, name, getattr(self, name)[kept])
        self.log_weight -= np.logaddexp.reduce(self.log_weight)
