#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace steadyhand {

/// Position and velocity of the motion element, normalised: x / amplitude and (dx/dt) * duration / amplitude,
/// both without unit. A minimum-jerk movement of the mean duration has a peak velocity of 1.875.
using Observation = Eigen::Vector2d;

/// Position and velocity of one number seen at irregular instants. The velocity is the least-squares slope
/// over the last WINDOW_S, because a difference of two frames is all jitter at 100 Hz and more.
class ObservationWindow {
public:
	static constexpr double WINDOW_S = 0.06;

	void reset();
	/// t_s: not before the last one (such a frame is passed over); x in m, finite.
	void push(double t_s, double x_m);

	[[nodiscard]] double position_m() const { return position_m_; }
	/// m/s; 0 until two instants have been seen.
	[[nodiscard]] double velocity_m_s() const { return count_ > 0 ? slope() : 0.0; }
	[[nodiscard]] Observation normalised(double amplitude_m, double duration_s) const {
		return { position_m_ / amplitude_m, velocity_m_s() * duration_s / amplitude_m };
	}

private:
	/// Enough for 1 kHz sensors; of a faster one some are left out, never the newest.
	static constexpr std::size_t CAPACITY = 64;
	static constexpr double LEAST_INTERVAL_S = WINDOW_S / (CAPACITY - 2);

	struct Sample {
		double t_s, x_m;
	};
	std::array<Sample, CAPACITY> samples_{};
	std::size_t first_ = 0;
	std::size_t count_ = 0;
	double position_m_ = 0.0;

	[[nodiscard]] const Sample &sample(std::size_t i) const { return samples_[(first_ + i) % CAPACITY]; }
	[[nodiscard]] double slope() const;
};

} // namespace steadyhand
