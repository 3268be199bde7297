#include "haptics/motion_snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

constexpr double COASTING_PER_S = 50.0;
constexpr double LONGEST_LEAD_IN_S = 0.03;
constexpr int BISECTIONS = 40;

QuinticPiece quintic(const MotionSnapshot::Knot &from, const MotionSnapshot::Knot &to, double period_s) {
	return QuinticPiece::between({ from.position, from.velocity, from.acceleration },
			{ to.position, to.velocity, to.acceleration }, period_s);
}

MotionPoint before(const MotionPoint &first, double dt_s) {
	dt_s = std::max(dt_s, -LONGEST_LEAD_IN_S);
	const double acceleration = first.acceleration + dt_s * first.jerk;
	const double velocity = first.velocity + dt_s * (first.acceleration + 0.5 * dt_s * first.jerk);
	return { first.position +
				dt_s * (first.velocity + dt_s * (0.5 * first.acceleration + dt_s * first.jerk / 6.0)),
		velocity, acceleration, first.jerk };
}

MotionPoint coasting(const MotionSnapshot::Knot &last, double dt_s) {
	const double left = std::exp(-COASTING_PER_S * dt_s);
	return { last.position + last.velocity * (1.0 - left) / COASTING_PER_S, last.velocity * left,
		last.acceleration * left, -COASTING_PER_S * last.acceleration * left };
}

} // namespace

MotionPoint MotionSnapshot::at(double t_s) const {
	if (count == 0) {
		return {};
	}
	const double x = (t_s - time_s) / period_s;
	const std::size_t last = count - 1;
	if (x < 0.0 && last > 0) {
		return before(quintic(knots[0], knots[1], period_s).at(0.0), t_s - time_s);
	}
	if (!(x < static_cast<double>(last))) {
		return coasting(knots[last], std::max(t_s - end_s(), 0.0));
	}
	const auto knot = static_cast<std::size_t>(x);
	return quintic(knots[knot], knots[knot + 1], period_s)
			.at(t_s - time_s - period_s * static_cast<double>(knot));
}

bool MotionCurve::find(double t_s) {
	const double x = (t_s - snapshot_.time_s) / snapshot_.period_s;
	if (!(x >= 0.0) || !(x < static_cast<double>(snapshot_.count) - 1.0)) {
		return false;
	}
	const auto knot = static_cast<std::size_t>(x);
	piece_ = quintic(snapshot_.knots[knot], snapshot_.knots[knot + 1], snapshot_.period_s);
	began_s_ = snapshot_.time_s + snapshot_.period_s * static_cast<double>(knot);
	length_s_ = snapshot_.period_s;
	is_moving_ = snapshot_.knots[knot].moving;
	return true;
}

bool MotionSnapshot::is_moving(double t_s) const {
	if (count == 0) {
		return false;
	}
	const double x = (t_s - time_s) / period_s;
	const double held = std::clamp(x, 0.0, static_cast<double>(count - 1));
	return std::isfinite(held) && knots[static_cast<std::size_t>(held)].moving;
}

double MotionSnapshot::reaches_s(double level, double from_s) const {
	double from = from_s;
	for (std::size_t i = 0; i < count; ++i) {
		double to = time_s + period_s * static_cast<double>(i);
		if (to < from_s || !(knots[i].position >= level)) {
			from = std::max(from, to);
			continue;
		}
		for (int k = 0; k < BISECTIONS && from < to; ++k) {
			const double middle = 0.5 * (from + to);
			(at(middle).position >= level ? to : from) = middle;
		}
		return to;
	}
	return std::numeric_limits<double>::quiet_NaN();
}

} // namespace steadyhand
