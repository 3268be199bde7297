#pragma once

#include "motion/motion.h"
#include "signal/constant_velocity_kalman.h"
#include "signal/moving_average.h"
#include "signal/one_euro.h"

namespace steadyhand {

/// The filters that a study compares with the synthesised motion. All run on the same motion element, so that
/// a switch between them has no delay. Between frames each holds its last output.
class FilteredMotion {
public:
	void push(double t_s, double x_m) {
		measured_m_ = x_m;
		average_.push(t_s, x_m);
		one_euro_.push(t_s, x_m);
		kalman_.push(t_s, x_m);
	}

	/// Output of a filter, m; 0 before the first frame. For SYNTHESISED it returns the measurement.
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
