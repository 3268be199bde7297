#pragma once

#include "signal/ring.h"

#include <type_traits>

namespace steadyhand {

/// The latest of a value seen at irregular instants, a number or an Eigen vector, and its least-squares
/// slope: a difference of two frames is all jitter at 100 Hz and more.
template <class Value, std::size_t CAPACITY> class SlopeWindow {
public:
	/// What is older than window_s goes, but for the two newest, and the oldest where there are too many.
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

	/// 1/s; 0 until two instants have been seen.
	[[nodiscard]] Value slope() const {
		if (samples_.empty()) {
			return zero();
		}
		// Sums are taken about the newest sample, so that neither an hour-long clock nor 1e9 m of offset
		// costs digits.
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
