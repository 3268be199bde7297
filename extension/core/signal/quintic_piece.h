#pragma once

#include <array>

namespace steadyhand {

/// A position and its derivatives by time, per s, s^2 and s^3.
struct MotionPoint {
	double position = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double jerk = 0.0;
	/// Part of the acceleration that corrects the position and is no motion of the hand, and its derivative.
	double correction = 0.0, correction_slope = 0.0;

	[[nodiscard]] double own_acceleration() const { return acceleration - correction; }
	[[nodiscard]] double own_jerk() const { return jerk - correction_slope; }
};

/// Position as a polynomial of the time in s since the begin of the piece.
struct QuinticPiece {
	std::array<double, 6> c{};

	/// The piece with the position, velocity and acceleration of both ends, which are duration_s apart. Its
	/// error is at most duration_s^6 times the sixth derivative of the motion / 46080.
	[[nodiscard]] static QuinticPiece between(
			const MotionPoint &from, const MotionPoint &to, double duration_s) {
		const double step = to.position - from.position;
		const double v0 = from.velocity * duration_s, v1 = to.velocity * duration_s;
		const double a0 = from.acceleration * duration_s * duration_s,
					 a1 = to.acceleration * duration_s * duration_s;
		const double rate = 1.0 / duration_s, cube = rate * rate * rate;
		return { { from.position, from.velocity, 0.5 * from.acceleration,
				cube * (10.0 * step - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1),
				cube * rate * (-15.0 * step + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1),
				cube * rate * rate * (6.0 * step - 3.0 * (v0 + v1) + 0.5 * (a1 - a0)) } };
	}

	/// The sums are split by s^2: the shorter dependency chains are faster than Horner's scheme.
	[[nodiscard]] MotionPoint at(double s) const {
		const double s2 = s * s;
		return { (c[0] + s * c[1]) + s2 * ((c[2] + s * c[3]) + s2 * (c[4] + s * c[5])),
			(c[1] + s * (2.0 * c[2])) + s2 * ((3.0 * c[3] + s * (4.0 * c[4])) + s2 * (5.0 * c[5])),
			(2.0 * c[2] + s * (6.0 * c[3])) + s2 * (12.0 * c[4] + s * (20.0 * c[5])),
			(6.0 * c[3] + s * (24.0 * c[4])) + s2 * (60.0 * c[5]) };
	}
};

} // namespace steadyhand
