#pragma once

#include "motion/motion.h"
#include "signal/critically_damped.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Hides a step of an output and of its velocity: adds an offset that decays critically damped.
class OutputBlend {
public:
	/// Without the blend the output would step at t_s by -value, and its velocity by -velocity.
	/// rate_per_s: of the decay.
	void start(double t_s, double value, double velocity, double rate_per_s) {
		began_s_ = t_s;
		value_ = value;
		velocity_ = velocity;
		rate_per_s_ = rate_per_s;
	}

	void start(double t_s, const Motion &before, const Motion &now, double rate_per_s) {
		start(t_s, before.value_m - now.value_m, before.velocity_m_s - now.velocity_m_s, rate_per_s);
	}

	/// The offset at t_s.
	[[nodiscard]] CriticallyDamped at(double t_s) const {
		return critically_damped(value_, velocity_, rate_per_s_, std::max(t_s - began_s_, 0.0));
	}

	/// Fraction left at t_s of a step that decays exponentially: a blend that starts anew continues it.
	[[nodiscard]] double share_left(double t_s) const {
		return std::exp(-rate_per_s_ * std::max(t_s - began_s_, 0.0));
	}

	/// `motion` plus the offset at t_s, in metres.
	[[nodiscard]] Motion completed(Motion motion, double t_s) const {
		const CriticallyDamped missing = at(t_s);
		motion.value_m += missing.value;
		motion.velocity_m_s += missing.velocity;
		motion.acceleration_m_s2 += missing.acceleration;
		return motion;
	}

private:
	double began_s_ = 0.0;
	double value_ = 0.0;
	double velocity_ = 0.0;
	double rate_per_s_ = 1.0;
};

} // namespace steadyhand
