#pragma once

namespace steadyhand {

/// Mean and covariance of the position and velocity of a point with white-noise acceleration, on one axis
/// (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and Navigation", 2001, section
/// 6.2.2). In any unit of length.
struct ConstantVelocityState {
	double position = 0.0;
	double velocity = 0.0;
	double p00 = 0.0; ///< covariance of (position, velocity), which is symmetric
	double p01 = 0.0;
	double p11 = 0.0;

	/// Advances by step_s. acceleration_psd: power spectral density, length^2 / s^3.
	void predict(double step_s, double acceleration_psd) {
		const double q = acceleration_psd;
		position += velocity * step_s;
		p00 += step_s * (2.0 * p01 + step_s * (p11 + q * step_s / 3.0));
		p01 += step_s * (p11 + q * step_s / 2.0);
		p11 += q * step_s;
	}

	/// Joseph's form, (I-KH) P (I-KH)' + K R K'. It is a sum of squares, so that rounding cannot make the
	/// covariance negative. An exact position stays where it is, whatever another exact measurement says.
	void correct(double measured, double measurement_variance) {
		const double r = measurement_variance;
		if (p00 + r <= 0.0) {
			return;
		}
		const double k0 = p00 / (p00 + r);
		const double k1 = p01 / (p00 + r);
		const double residual = measured - position;
		position += k0 * residual;
		velocity += k1 * residual;
		p11 += k1 * (k1 * (p00 + r) - 2.0 * p01);
		p01 = (1.0 - k0) * (p01 - k1 * p00) + k0 * k1 * r;
		p00 = (1.0 - k0) * (1.0 - k0) * p00 + k0 * k0 * r;
	}
};

} // namespace steadyhand
