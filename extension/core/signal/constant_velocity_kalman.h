#pragma once

#include "signal/constant_velocity_state.h"
#include "signal/sample_clock.h"

namespace steadyhand {

/// Kalman filter of a ConstantVelocityState, with irregular steps.
class ConstantVelocityKalman {
public:
	struct Noise {
		/// Power spectral density of the acceleration. A minimum-jerk drag of 0.2 m in 1 s has an rms of 0.8
		/// m/s^2 that keeps its sign for about half a second.
		double acceleration_psd_m2_s3 = 1.0;
		double measurement_std_m = 0.002;   ///< white part of a camera tracker's error
		double initial_speed_std_m_s = 0.5; ///< prior of a hand's speed
	};

	ConstantVelocityKalman() : ConstantVelocityKalman(Noise{}) {}
	explicit ConstantVelocityKalman(const Noise &noise) :
			acceleration_psd_(noise.acceleration_psd_m2_s3),
			measurement_variance_(noise.measurement_std_m * noise.measurement_std_m),
			initial_speed_variance_(noise.initial_speed_std_m_s * noise.initial_speed_std_m_s) {}

	/// Position, m, at t_s, from the samples up to it. A sample that SampleClock ignores does not change the
	/// output. 0 before the first sample.
	double push(double t_s, double x_m) {
		switch (clock_.judge(t_s, x_m)) {
			case SampleClock::Verdict::IGNORE:
				break;
			case SampleClock::Verdict::START:
				state_ = { .position = x_m, .p00 = measurement_variance_, .p11 = initial_speed_variance_ };
				break;
			case SampleClock::Verdict::ADVANCE:
				state_.predict(clock_.step_s(), acceleration_psd_);
				state_.correct(x_m, measurement_variance_);
				break;
		}
		return state_.position;
	}

	[[nodiscard]] double output() const { return state_.position; }
	[[nodiscard]] double velocity_m_s() const { return state_.velocity; }
	[[nodiscard]] double position_variance_m2() const { return state_.p00; }

private:
	double acceleration_psd_;
	double measurement_variance_;
	double initial_speed_variance_;
	SampleClock clock_;
	ConstantVelocityState state_; ///< m
};

} // namespace steadyhand
