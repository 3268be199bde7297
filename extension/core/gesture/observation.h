#pragma once

#include "signal/slope_window.h"

#include <Eigen/Core>

#include <cstddef>

namespace steadyhand {

/// Position and velocity of the motion element, normalised: x / amplitude and (dx/dt) * duration / amplitude,
/// both without unit. A minimum-jerk movement of the mean duration has a peak velocity of 1.875.
using Observation = Eigen::Vector2d;

/// Position and velocity of one number, sampled at irregular intervals. The velocity is the least-squares
/// slope over the last WINDOW_S.
class ObservationWindow {
public:
	static constexpr double WINDOW_S = 0.06;

	void reset();
	/// A t_s before the last one is ignored. x_m: finite.
	void push(double t_s, double x_m);

	[[nodiscard]] double position_m() const { return position_m_; }
	/// m/s; 0 before the second sample.
	[[nodiscard]] double velocity_m_s() const { return samples_.slope(); }
	[[nodiscard]] Observation normalised(double amplitude_m, double duration_s) const {
		return { position_m_ / amplitude_m, velocity_m_s() * duration_s / amplitude_m };
	}

private:
	/// Enough for 1 kHz. Of faster sensors some older samples are dropped, never the newest.
	static constexpr std::size_t CAPACITY = 64;
	static constexpr double LEAST_INTERVAL_S = WINDOW_S / (CAPACITY - 2);

	SlopeWindow<double, CAPACITY> samples_;
	double position_m_ = 0.0;
};

} // namespace steadyhand
