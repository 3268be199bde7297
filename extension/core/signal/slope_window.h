#pragma once

#include "signal/ring.h"

#include <type_traits>

namespace steadyhand {

/// The newest samples of a number or an Eigen vector at irregular times, and their least-squares slope. At
/// 100 Hz or more, a difference of two frames would be mostly jitter.
template <class Value, std::size_t CAPACITY> class SlopeWindow {
public:
	/// Drops samples older than window_s, except the two newest ones. If the window is full, the oldest one
	/// too.
	void push(double t_s, const Value &value, double window_s) {
		samples_.push({ t_s, value });
		while (samples_.size() > 2 && t_s - samples_[0].t_s > window_s) {
			samples_.drop_oldest();
		}
	}
	void drop_newest() { samples_.drop_newest(); }
	void clear() { samples_.clear(); }

	[[nodiscard]] bool empty() const { return samples_.empty(); }
	[[nodiscard]] std::size_t size() const { return samples_.size(); }
	[[nodiscard]] double t_s(std::size_t i) const { return samples_[i].t_s; }

	/// Slope per s; 0 before two different times.
	[[nodiscard]] Value slope() const {
		if (samples_.empty()) {
			return zero();
		}
		// Sums are relative to the newest sample, which keeps digits at large times and offsets.
		const Sample &newest = samples_.newest();
		double mean_t = 0.0;
		Value mean = zero();
		for (std::size_t i = 0; i < samples_.size(); ++i) {
			mean_t += samples_[i].t_s - newest.t_s;
			mean += samples_[i].value - newest.value;
		}
		const double n = static_cast<double>(samples_.size());
		mean_t /= n;
		mean /= n;
		Value covariance = zero();
		double variance = 0.0;
		for (std::size_t i = 0; i < samples_.size(); ++i) {
			const double dt = samples_[i].t_s - newest.t_s - mean_t;
			covariance += dt * (samples_[i].value - newest.value - mean);
			variance += dt * dt;
		}
		if (!(variance > 0.0)) {
			return zero();
		}
		return covariance / variance;
	}

private:
	struct Sample {
		double t_s = 0.0;
		Value value = zero();
	};
	Ring<Sample, CAPACITY> samples_;

	static Value zero() {
		if constexpr (std::is_arithmetic_v<Value>) {
			return 0.0;
		} else {
			return Value::Zero();
		}
	}
};

} // namespace steadyhand
