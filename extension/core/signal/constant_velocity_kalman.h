#pragma once

#include "signal/sample_clock.h"

#include <cmath>

namespace steadyhand {

/// Kalman filter of a point that keeps its velocity but for white-noise acceleration (Bar-Shalom, Li,
/// Kirubarajan, "Estimation with Applications to Tracking and Navigation", 2001, section 6.2.2), one axis,
/// irregular steps.
class ConstantVelocityKalman {
public:
	struct Noise {
		/// Power spectral density of the acceleration. A minimum-jerk drag of 0.2 m in 1 s has an rms of 0.8
		/// m/s^2 that keeps its sign for about half a second.
		double acceleration_psd_m2_s3 = 1.0;
		double measurement_std_m = 0.002;   ///< white part of a camera tracker's error
		double initial_speed_std_m_s = 0.5; ///< a hand's speed before anything is known of it
	};

	ConstantVelocityKalman() : ConstantVelocityKalman(Noise{}) {}
	explicit ConstantVelocityKalman(const Noise &noise) :
			acceleration_psd_(noise.acceleration_psd_m2_s3),
			measurement_variance_(noise.measurement_std_m * noise.measurement_std_m),
			initial_speed_variance_(noise.initial_speed_std_m_s * noise.initial_speed_std_m_s) {}

	/// Position (m) at t_s given the samples up to it. What SampleClock ignores leaves the last output; 0
	/// before any.
	double push(double t_s, double x_m) {
		switch (clock_.judge(t_s, x_m)) {
			case SampleClock::Verdict::IGNORE:
				break;
			case SampleClock::Verdict::START:
				position_m_ = x_m;
				velocity_m_s_ = 0.0;
				p00_ = measurement_variance_;
				p01_ = 0.0;
				p11_ = initial_speed_variance_;
				break;
			case SampleClock::Verdict::ADVANCE:
				predict_state(clock_.step_s());
				correct(x_m);
				break;
		}
		return position_m_;
	}

	/// Position (m) expected at t_s, on at constant velocity from the last sample; t_s not usable: at that
	/// sample.
	[[nodiscard]] double predict(double t_s) const {
		return is_usable(t_s) ? position_m_ + velocity_m_s_ * (t_s - clock_.last_s()) : position_m_;
	}

	[[nodiscard]] double output() const { return position_m_; }
	[[nodiscard]] double velocity_m_s() const { return velocity_m_s_; }
	[[nodiscard]] double position_variance_m2() const { return p00_; }

private:
	void predict_state(double step_s) {
		const double q = acceleration_psd_;
		position_m_ += velocity_m_s_ * step_s;
		p00_ += step_s * (2.0 * p01_ + step_s * (p11_ + q * step_s / 3.0));
		p01_ += step_s * (p11_ + q * step_s / 2.0);
		p11_ += q * step_s;
	}

	/// Joseph's form, (I-KH) P (I-KH)' + K R K': a sum of squares, so rounding cannot make the covariance
	/// negative.
	void correct(double x_m) {
		const double r = measurement_variance_;
		const double k0 = p00_ / (p00_ + r);
		const double k1 = p01_ / (p00_ + r);
		const double residual_m = x_m - position_m_;
		position_m_ += k0 * residual_m;
		velocity_m_s_ += k1 * residual_m;
		p11_ += k1 * (k1 * (p00_ + r) - 2.0 * p01_);
		p01_ = (1.0 - k0) * (p01_ - k1 * p00_) + k0 * k1 * r;
		p00_ = (1.0 - k0) * (1.0 - k0) * p00_ + k0 * k0 * r;
	}

	double acceleration_psd_;
	double measurement_variance_;
	double initial_speed_variance_;
	SampleClock clock_;
	double position_m_ = 0.0;
	double velocity_m_s_ = 0.0;
	double p00_ = 0.0; ///< covariance of (position, velocity), the three entries that differ
	double p01_ = 0.0;
	double p11_ = 0.0;
};

} // namespace steadyhand
