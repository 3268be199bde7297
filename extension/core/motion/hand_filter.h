#pragma once

#include "base/parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {

/// A measurement of the motion element, in amplitudes.
struct ElementReading {
	double t_s = 0.0;
	double x = 0.0;
	double variance = 0.0; ///< of white measurement noise
	double power = 1.0;    ///< exponent of the likelihood; below 1 if the error correlates with the last one
};

/// Likelihood of a measurement: a normal density of its innovation, mixed with a constant density of
/// outliers. error: measurement minus prediction; variance: of the innovation.
struct ReadingLikelihood {
	double density;
	double inlier_probability;

	ReadingLikelihood(double error, double variance) {
		const double normal = (1.0 - parameters::OUTLIERS) * std::exp(-0.5 * error * error / variance) /
				std::sqrt(2.0 * std::numbers::pi * variance);
		density = normal + parameters::OUTLIERS * parameters::OUTLIER_DENSITY;
		inlier_probability = normal / density;
	}
	/// Factor c of the covariance update P - c K K^T, which has the moments of the mixture. K: Kalman gain.
	[[nodiscard]] double reduction(double error, double variance) const {
		return inlier_probability * (variance - (1.0 - inlier_probability) * error * error);
	}
};

/// Position and velocity of a hand in HOLD or FREE, with their covariance.
struct HandState {
	double x = 0.0, v = 0.0;
	double xx = 0.0, xv = 0.0, vv = 0.0; ///< covariance

	/// Kalman update. Returns the likelihood of the reading to the power reading.power.
	double correct(const ElementReading &reading) {
		const double error = reading.x - x, variance = xx + reading.variance;
		const ReadingLikelihood likelihood(error, variance);
		const double gain_x = xx / variance, gain_v = xv / variance;
		const double reduction = likelihood.reduction(error, variance);
		x += likelihood.inlier_probability * error * gain_x;
		v += likelihood.inlier_probability * error * gain_v;
		xx -= reduction * gain_x * gain_x;
		xv -= reduction * gain_x * gain_v;
		vv -= reduction * gain_v * gain_v;
		return std::pow(likelihood.density, reading.power);
	}
};

/// Motion of a hand whose velocity is an Ornstein-Uhlenbeck process, dv = -rate v dt + noise. speed:
/// stationary standard deviation of the velocity.
struct HandProcess {
	double speed;
	double rate_per_s;

	/// Mean displacement in dt_s, divided by the velocity at its begin.
	[[nodiscard]] double displacement_per_velocity_s(double dt_s) const {
		return -std::expm1(-rate_per_s * dt_s) / rate_per_s;
	}

	/// Exact for any dt_s.
	void predict(HandState &r_hand, double dt_s) const {
		const double fading = std::exp(-rate_per_s * dt_s), factor_s = displacement_per_velocity_s(dt_s),
					 variance = speed * speed;
		r_hand.x += factor_s * r_hand.v;
		r_hand.v *= fading;
		r_hand.xx += factor_s * (2.0 * r_hand.xv + factor_s * r_hand.vv) +
				variance * (2.0 * (dt_s - factor_s) / rate_per_s - factor_s * factor_s);
		r_hand.xv = fading * (r_hand.xv + factor_s * r_hand.vv) + variance * rate_per_s * factor_s * factor_s;
		r_hand.vv = fading * fading * r_hand.vv + variance * (1.0 - fading * fading);
	}
};

/// Mean and covariance of a weighted mixture of hand states.
class HandMixture {
public:
	void add(double weight, const HandState &hand) {
		weight_ += weight;
		sum_.x += weight * hand.x;
		sum_.v += weight * hand.v;
		sum_.xx += weight * (hand.xx + hand.x * hand.x);
		sum_.xv += weight * (hand.xv + hand.x * hand.v);
		sum_.vv += weight * (hand.vv + hand.v * hand.v);
	}
	[[nodiscard]] double weight() const { return weight_; }
	/// weight() must not be 0.
	[[nodiscard]] HandState state() const {
		const double x = sum_.x / weight_, v = sum_.v / weight_;
		return { x, v, std::max(sum_.xx / weight_ - x * x, 0.0), sum_.xv / weight_ - x * v,
			std::max(sum_.vv / weight_ - v * v, 0.0) };
	}

private:
	double weight_ = 0.0;
	HandState sum_;
};

} // namespace steadyhand
