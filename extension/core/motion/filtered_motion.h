#pragma once

#include "motion/motion.h"
#include "signal/constant_velocity_kalman.h"
#include "signal/moving_average.h"
#include "signal/one_euro.h"

namespace steadyhand {

/// The conditions that a study compares the synthesised motion with, side by side on one motion element, so
/// that switching between them takes effect at once. Between frames each holds its last output.
class FilteredMotion {
public:
	void push(double t_s, double x_m) {
		measured_m_ = x_m;
		average_.push(t_s, x_m);
		one_euro_.push(t_s, x_m);
		kalman_.push(t_s, x_m);
	}

	/// m; 0 before the first frame. Not for SYNTHESISED.
	[[nodiscard]] double value_m(MotionSource source) const {
		switch (source) {
			case MotionSource::AVERAGE:
				return average_.output();
			case MotionSource::ONE_EURO:
				return one_euro_.output();
			case MotionSource::KALMAN:
				return kalman_.output();
			case MotionSource::MEASURED:
			case MotionSource::SYNTHESISED:
				break;
		}
		return measured_m_;
	}

private:
	double measured_m_ = 0.0;
	MovingAverage average_;
	OneEuro one_euro_;
	ConstantVelocityKalman kalman_;
};

} // namespace steadyhand
