#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {

/// How far a hand at rest is shown to wander: by its own tremor, or by a tracker whose errors last longer
/// than a frame, which bends (TrackerNoise) do not tell.
class RestWander {
public:
	/// x: what the element shows of a hand at rest, in amplitudes. t_s must not decrease.
	void push(double t_s, double x) {
		const double dt_s = t_s - t_s_;
		t_s_ = t_s;
		if (dt_s > LONGEST_S) { // it may have been elsewhere
			rested_s_ = 0.0;
			mean_ = x;
			return;
		}
		if (dt_s == 0.0) {
			return;
		}
		rested_s_ = std::min(rested_s_ + dt_s, MEAN_S);
		watched_s_ = std::min(watched_s_ + dt_s, MEMORY_S);
		off_ += (std::abs(x - mean_) - off_) * dt_s / watched_s_;
		mean_ += (x - mean_) * dt_s / rested_s_;
	}

	/// Standard deviation about the latest mean, of what is Gaussian. 0 before the first frames.
	[[nodiscard]] double deviation() const { return off_ * DEVIATION_PER_OFF; }

private:
	static constexpr double MEAN_S = 0.3, MEMORY_S = 1.0;
	static constexpr double LONGEST_S = 0.3; ///< between frames of one rest
	static inline const double DEVIATION_PER_OFF = std::sqrt(0.5 * std::numbers::pi);

	double t_s_ = -INFINITY;
	double rested_s_ = 0.0, watched_s_ = 0.0; ///< what the means are of, up to their memory
	double mean_ = 0.0;
	double off_ = 0.0; ///< mean distance from mean_
};

} // namespace steadyhand
