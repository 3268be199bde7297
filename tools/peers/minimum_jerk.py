"""The minimum-jerk movement of largest posterior after each frame (maximum a posteriori).

x(t) = o + A s((t - t0) / T) + noise, s(u) = 10 u^3 - 15 u^4 + 6 u^5 (Flash & Hogan 1985). Gauss-Newton on
(t0, ln T, A, o) with Huber weights. Every GRID_EVERY frames it also starts from the best node of a grid.
"""

import numpy as np
from peers.frozen_frames import FrozenFrames
from peers.predictor import SENSOR_LATENCY_S

NOISE = 0.02  # standard deviation of a frame (amplitudes): mostly hands that are no minimum jerk
HUBER = 1.5  # standard deviations beyond which the cost is linear
CORRELATION_S = 0.013  # of the noise: a shorter frame interval adds no information
# Of ln T, A and o: means (ln T: plus the model's) and standard deviations. t0: flat until LATEST_S ahead.
PRIOR_MEAN = np.array([0.0, 1.0, 0.0])
PRIOR_DEVIATION = np.array([0.6, 0.05, 0.03])
LATEST_S = 0.3
MEMORY_S = 3.0
GRID_EVERY = 4  # frames
GRID_AGO_S = np.arange(-LATEST_S, 2.3, 0.1)
GRID_LOG_DURATION = np.arange(-1.5, 1.6, 0.5)
LARGEST_STEP = np.array([0.1, 0.3, 0.1, 0.1])
RESIDUAL_S, FADE_S = 0.03, 0.1  # the mean residual of the last 30 ms is added, and decays
SURELY_BEGUN_S = 0.02  # a later onset moves nothing ahead of the newest frame


def minimum_jerk(u: np.ndarray) -> np.ndarray:
    u = np.clip(u, 0.0, 1.0)
    return u**3 * (10.0 - 15.0 * u + 6.0 * u**2)


def minimum_jerk_slope(u: np.ndarray) -> np.ndarray:
    u = np.clip(u, 0.0, 1.0)
    return 30.0 * u**2 * (1.0 - u) ** 2


class MinimumJerk:
    """Parameters p are (..., 4): t0 (s), ln T, A, o (amplitudes)."""

    def __init__(self, duration_s: float) -> None:
        """duration_s: the mean of the gesture's model."""
        self.mean = np.array([0.0, np.log(duration_s), 0.0, 0.0]) + np.append(0.0, PRIOR_MEAN)
        self.precision = np.append(0.0, PRIOR_DEVIATION**-2)
        self.t_s, self.value, self.weight = np.zeros(0), np.zeros(0), np.zeros(0)
        self.best = self.mean
        self.residual = 0.0
        self.frames = 0
        self.frozen = FrozenFrames()

    def observe(self, t_s: float, value: float) -> None:
        if self.frozen.is_frozen(t_s, value):
            return
        since_s = t_s - self.t_s[-1] if len(self.t_s) else np.inf
        weight = 1.0 if since_s == np.inf else since_s / (since_s + CORRELATION_S)
        kept = self.t_s > t_s - MEMORY_S
        self.t_s, self.value = np.append(self.t_s[kept], t_s), np.append(self.value[kept], value)
        self.weight = np.append(self.weight[kept], weight)
        candidates = [self.best] if self.frames else []
        if self.frames % GRID_EVERY == 0:
            candidates.append(self.best_of_grid(t_s))
        self.best = min((self.improved(one) for one in candidates), key=self.cost)
        self.best[0] = min(self.best[0], t_s + LATEST_S)
        self.frames += 1
        recent = self.t_s > t_s - RESIDUAL_S
        self.residual = np.mean(self.value[recent] - self.curve(self.best, self.t_s[recent]))

    def predict(self, times_s: np.ndarray) -> np.ndarray:
        if self.frames == 0:
            return np.zeros(len(times_s))
        newest_s = self.t_s[-1]
        begun = self.best[0] < newest_s - SURELY_BEGUN_S
        at_s = times_s + SENSOR_LATENCY_S if begun else np.full(len(times_s), newest_s)
        return self.curve(self.best, at_s) + self.residual * np.exp(-(times_s - newest_s) / FADE_S)

    @staticmethod
    def curve(p: np.ndarray, times_s: np.ndarray) -> np.ndarray:
        onset_s, log_duration, amplitude, offset = (p[..., k, None] for k in range(4))
        return offset + amplitude * minimum_jerk((times_s - onset_s) / np.exp(log_duration))

    def cost(self, p: np.ndarray) -> np.ndarray:
        """-ln of the posterior, but for a constant."""
        off = np.abs(self.value - self.curve(p, self.t_s)) / NOISE
        huber = np.where(off < HUBER, off**2 / 2.0, HUBER * off - HUBER**2 / 2.0)
        return huber @ self.weight + 0.5 * ((p - self.mean) ** 2 @ self.precision)

    def best_of_grid(self, t_s: float) -> np.ndarray:
        onsets_s, log_durations = np.meshgrid(t_s - GRID_AGO_S, self.mean[1] + GRID_LOG_DURATION)
        grid = np.tile(self.mean, (onsets_s.size, 1))
        grid[:, 0], grid[:, 1] = onsets_s.ravel(), log_durations.ravel()
        grid[:, 3] = self.best[3]
        return grid[np.argmin(self.cost(grid))]

    def improved(self, p: np.ndarray, steps: int = 5) -> np.ndarray:
        """Gauss-Newton steps, damped as Levenberg and Marquardt do, none of which raises the cost."""
        cost, damping = self.cost(p), 1e-2
        for _ in range(steps):
            duration_s = np.exp(p[1])
            u = (self.t_s - p[0]) / duration_s
            slope = p[2] * minimum_jerk_slope(u)
            gradient = np.stack([-slope / duration_s, -slope * u, minimum_jerk(u), np.ones_like(u)])
            off = self.value - self.curve(p, self.t_s)
            weight = self.weight / NOISE**2 * np.minimum(1.0, HUBER * NOISE / np.maximum(np.abs(off), 1e-9))
            curvature = (gradient * weight) @ gradient.T + np.diag(self.precision)
            downhill = gradient @ (weight * off) - self.precision * (p - self.mean)
            damped = curvature + np.diag(damping * np.diag(curvature) + 1e-6)
            stepped = p + np.clip(np.linalg.solve(damped, downhill), -LARGEST_STEP, LARGEST_STEP)
            stepped_cost = self.cost(stepped)
            if stepped_cost < cost:
                p, cost, damping = stepped, stepped_cost, damping * 0.3
            else:
                damping *= 10.0
        return p.copy()
