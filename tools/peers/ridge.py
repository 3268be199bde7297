"""Ridge regression of the future displacement on velocity and acceleration.

x(t + h) = x(t) + a_h v h + b_h c h^2 / 2, two coefficients a horizon h, fitted to training hands.
"""

from collections.abc import Iterable

import numpy as np
from peers.predictor import SENSOR_LATENCY_S
from peers.trials import Trial

HORIZONS_S = np.arange(0.01, 0.301, 0.01)
VELOCITY_S, ACCELERATION_S = 0.06, 0.1  # span of the newest frames that each is fitted to
FEWEST_FRAMES = 4
PENALTY = 1e-3  # in shares of the mean square of each regressor


def derivatives(t_s: np.ndarray, value: np.ndarray) -> np.ndarray:
    """Velocity and acceleration at the newest frame, from parabolas by least squares; 0 where there are few frames."""
    result = np.zeros(2)
    ago_s = t_s - t_s[-1]
    for order, span_s in ((1, VELOCITY_S), (2, ACCELERATION_S)):
        recent = ago_s >= -span_s
        if np.count_nonzero(recent) >= FEWEST_FRAMES:
            result[order - 1] = order * np.polynomial.polynomial.polyfit(ago_s[recent], value[recent], 2)[order]
    return result


def regressors(of_hand: np.ndarray, horizon_s: float | np.ndarray) -> np.ndarray:
    return np.stack([of_hand[..., 0] * horizon_s, of_hand[..., 1] * horizon_s**2 / 2.0], axis=-1)


def train_ridge(trials: Iterable[Trial]) -> np.ndarray:
    """Coefficients (HORIZONS_S, 2) that predict later frames of the same tracker: its latency is not learned."""
    hands, displacements = [], []
    for trial in trials:
        for i in range(FEWEST_FRAMES, len(trial.t_s)):
            ahead_s = trial.t_s[i] + HORIZONS_S
            if ahead_s[-1] > trial.t_s[-1]:
                break
            recent = slice(np.searchsorted(trial.t_s, trial.t_s[i] - ACCELERATION_S), i + 1)
            hands.append(derivatives(trial.t_s[recent], trial.value[recent]))
            displacements.append(np.interp(ahead_s, trial.t_s, trial.value) - trial.value[i])
    hands, displacements = np.array(hands), np.array(displacements)
    return np.array([fit(regressors(hands, h), displacements[:, k]) for k, h in enumerate(HORIZONS_S)])


def fit(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Two coefficients. That of a column of zeros is 0."""
    squares = x.T @ x
    return np.linalg.lstsq(squares + PENALTY * np.diag(np.diag(squares)), x.T @ y, rcond=None)[0]


class Ridge:
    def __init__(self, coefficients: np.ndarray) -> None:
        """coefficients: from train_ridge()."""
        self.coefficients = coefficients
        self.t_s = np.zeros(0)
        self.value = np.zeros(0)
        self.of_hand = np.zeros(2)

    def observe(self, t_s: float, value: float) -> None:
        recent = self.t_s >= t_s - ACCELERATION_S
        self.t_s, self.value = np.append(self.t_s[recent], t_s), np.append(self.value[recent], value)
        self.of_hand = derivatives(self.t_s, self.value)

    def predict(self, times_s: np.ndarray) -> np.ndarray:
        if len(self.t_s) == 0:
            return np.zeros(len(times_s))
        ahead_s = np.minimum(times_s - self.t_s[-1] + SENSOR_LATENCY_S, HORIZONS_S[-1])
        a, b = (np.interp(ahead_s, HORIZONS_S, column) for column in self.coefficients.T)
        by_velocity, by_acceleration = regressors(self.of_hand, ahead_s).T
        return self.value[-1] + a * by_velocity + b * by_acceleration
