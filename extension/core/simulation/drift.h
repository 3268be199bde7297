#pragma once

#include "base/random.h"

#include <cmath>

namespace steadyhand {

/// Ornstein-Uhlenbeck process with standard deviation 1. It starts in its stationary state and is exact for
/// steps of any length (Gillespie 1996, doi 10.1103/PhysRevE.54.2084). Autocorrelation: exp(-lag / tau).
class OrnsteinUhlenbeck {
public:
	OrnsteinUhlenbeck(double tau_s, Random &r_random) : tau_s_(tau_s), value_(r_random.normal()) {}

	double step(double dt_s, Random &r_random) {
		const double kept = std::exp(-dt_s / tau_s_);
		value_ = kept * value_ + std::sqrt(1.0 - kept * kept) * r_random.normal();
		return value_;
	}

private:
	double tau_s_;
	double value_;
};

/// Slow error of a tracker, standard deviation 1: an Ornstein-Uhlenbeck process with a first-order low pass.
/// The tracker's own filter leaves hardly any power above a few Hz. The process alone jitters from frame to
/// frame.
class Drift {
public:
	Drift(double tau_s, Random &r_random) :
			// A low pass of tau_l leaves tau / (tau + tau_l) of the variance.
			process_(tau_s, r_random), gain_(std::sqrt((tau_s + SMOOTHING_S) / tau_s)) {
		constexpr int SETTLING_STEPS = 97; // 6 SMOOTHING_S
		for (int i = 0; i < SETTLING_STEPS; ++i) {
			step(SMOOTHING_S / 16.0, r_random);
		}
	}

	double step(double dt_s, Random &r_random) {
		smooth_ += -std::expm1(-dt_s / SMOOTHING_S) * (process_.step(dt_s, r_random) - smooth_);
		return gain_ * smooth_;
	}

private:
	static constexpr double SMOOTHING_S = 0.1;

	OrnsteinUhlenbeck process_;
	double gain_;
	double smooth_ = 0.0;
};

} // namespace steadyhand
