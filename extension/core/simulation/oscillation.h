#pragma once

#include "base/random.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace steadyhand {

/// Band-limited random motion as a function of time: on each axis a sum of sinusoids of random frequency and
/// phase. Used for tremor, sway, and motion of the fingers.
class Oscillation {
public:
	/// `deviation_m`: standard deviation over time, per axis.
	Oscillation(double low_hz, double high_hz, double deviation_m, Random &r_random) {
		amplitude_m_ = deviation_m * std::sqrt(2.0 / static_cast<double>(WAVES));
		for (std::size_t axis = 0; axis < 3; ++axis) {
			for (std::size_t i = 0; i < WAVES; ++i) {
				waves_[axis][i] = { 2.0 * std::numbers::pi * r_random.uniform(low_hz, high_hz),
					2.0 * std::numbers::pi * r_random.uniform() };
			}
		}
	}

	[[nodiscard]] Eigen::Vector3d at(double t_s) const {
		Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
		for (std::size_t axis = 0; axis < 3; ++axis) {
			for (const Wave &wave : waves_[axis]) {
				sum_m[static_cast<Eigen::Index>(axis)] +=
						amplitude_m_ * std::sin(wave.rate_rad_s * t_s + wave.phase_rad);
			}
		}
		return sum_m;
	}

private:
	static constexpr std::size_t WAVES = 4;
	struct Wave {
		double rate_rad_s = 0.0;
		double phase_rad = 0.0;
	};

	double amplitude_m_ = 0.0;
	std::array<std::array<Wave, WAVES>, 3> waves_{};
};

} // namespace steadyhand
