#pragma once

#include "base/parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {

/// A measurement of the motion element, in amplitudes, and how it is weighed.
struct ElementReading {
	double t_s = 0.0;
	double x = 0.0;
	double variance = 0.0; ///< of its white noise
	double power = 1.0;    ///< of its likelihood: how far its error is its own
};

/// Likelihood of a measurement at this distance from its prediction: a normal density mixed with an
/// outlier's.
struct ReadingLikelihood {
	double density;
	double share; ///< probability that it is no outlier

	ReadingLikelihood(double error, double variance) {
		const double normal = (1.0 - parameters::OUTLIERS) * std::exp(-0.5 * error * error / variance) /
				std::sqrt(2.0 * std::numbers::pi * variance);
		density = normal + parameters::OUTLIERS * parameters::OUTLIER_DENSITY;
		share = normal / density;
	}
	/// The factor of a covariance's reduction by the gain and its transpose: that of a mixture's moments.
	[[nodiscard]] double reduction(double error, double variance) const {
		return share * (variance - (1.0 - share) * error * error);
	}
};

/// Position and velocity of a hand that follows no curve, with their covariance.
struct HandState {
	double x = 0.0, v = 0.0;
	double xx = 0.0, xv = 0.0, vv = 0.0; ///< covariance

	/// Takes in a reading; returns the reading's likelihood, to its power.
	double correct(const ElementReading &reading) {
		const double error = reading.x - x, variance = xx + reading.variance;
		const ReadingLikelihood likelihood(error, variance);
		const double gain_x = xx / variance, gain_v = xv / variance;
		const double reduction = likelihood.reduction(error, variance);
		x += likelihood.share * error * gain_x;
		v += likelihood.share * error * gain_v;
		xx -= reduction * gain_x * gain_x;
		xv -= reduction * gain_x * gain_v;
		vv -= reduction * gain_v * gain_v;
		return std::pow(likelihood.density, reading.power);
	}
};

/// A hand whose velocity is an Ornstein-Uhlenbeck process, dv = -rate v dt + noise: it comes to rest wherever
/// it is. speed: stationary standard deviation of the velocity.
struct HandProcess {
	double speed;
	double rate_per_s;

	/// How far one that goes on with a velocity of 1 gets in dt_s.
	[[nodiscard]] double reach_s(double dt_s) const { return -std::expm1(-rate_per_s * dt_s) / rate_per_s; }

	/// Exact for steps of any length.
	void predict(HandState &r_hand, double dt_s) const {
		const double fading = std::exp(-rate_per_s * dt_s), reach = reach_s(dt_s), variance = speed * speed;
		r_hand.x += reach * r_hand.v;
		r_hand.v *= fading;
		r_hand.xx += reach * (2.0 * r_hand.xv + reach * r_hand.vv) +
				variance * (2.0 * (dt_s - reach) / rate_per_s - reach * reach);
		r_hand.xv = fading * (r_hand.xv + reach * r_hand.vv) + variance * rate_per_s * reach * reach;
		r_hand.vv = fading * fading * r_hand.vv + variance * (1.0 - fading * fading);
	}
};

/// Moments of a weighted sum of hands.
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
	/// Of a sum whose weight is not 0.
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
