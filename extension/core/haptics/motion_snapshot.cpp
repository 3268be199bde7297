#include "haptics/motion_snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

constexpr double COASTING_PER_S = 50.0;
constexpr double LONGEST_LEAD_IN_S = 0.03;
constexpr int BISECTIONS = 40;
constexpr double NEVER_S = std::numeric_limits<double>::infinity();

QuinticPiece quintic(const MotionSnapshot::Knot &from, const MotionSnapshot::Knot &to, double period_s) {
	return QuinticPiece::between({ from.position, from.velocity, from.acceleration },
			{ to.position, to.velocity, to.acceleration }, period_s);
}

/// By the motion's own acceleration: what corrects it at the first knot may have begun there.
MotionPoint before(const MotionPoint &first, double dt_s) {
	dt_s = std::max(dt_s, -LONGEST_LEAD_IN_S);
	const double acceleration = first.own_acceleration(), jerk = first.own_jerk();
	return { first.position + dt_s * (first.velocity + dt_s * (0.5 * acceleration + dt_s * jerk / 6.0)),
		first.velocity + dt_s * (acceleration + 0.5 * dt_s * jerk), acceleration + dt_s * jerk, jerk, 0.0,
		0.0 };
}

MotionPoint coasting(const MotionSnapshot::Knot &last, double dt_s) {
	const double left = std::exp(-COASTING_PER_S * dt_s);
	return { last.position + last.velocity * (1.0 - left) / COASTING_PER_S, last.velocity * left,
		last.acceleration * left, -COASTING_PER_S * last.acceleration * left, last.correction * left,
		-COASTING_PER_S * last.correction * left };
}

} // namespace

void MotionSnapshot::fit() {
	for (std::size_t i = 0; i + 1 < count; ++i) {
		const QuinticPiece piece = quintic(knots[i], knots[i + 1], period_s);
		knots[i].higher = { piece.c[3], piece.c[4], piece.c[5] };
	}
	is_fitted = true;
}

MotionPoint MotionSnapshot::at(double t_s) const {
	if (count == 0) {
		return {};
	}
	const auto on_piece = [this](std::size_t knot, double s) {
		const Knot &from = knots[knot], &to = knots[knot + 1];
		return OwnAcceleration::between(from, to, period_s).of(quintic(from, to, period_s).at(s), s);
	};
	const double x = (t_s - time_s) / period_s;
	const std::size_t last = count - 1;
	if (x < 0.0) {
		return before(last > 0 ? on_piece(0, 0.0) : coasting(knots[0], 0.0), t_s - time_s);
	}
	if (!(x < static_cast<double>(last))) {
		return coasting(knots[last], std::max(t_s - end_s(), 0.0));
	}
	const auto knot = static_cast<std::size_t>(x);
	return on_piece(knot, t_s - time_s - period_s * static_cast<double>(knot));
}

void MotionCurve::set(const MotionSnapshot &snapshot) {
	snapshot_.time_s = snapshot.time_s;
	snapshot_.period_s = snapshot.period_s;
	snapshot_.count = snapshot.count;
	snapshot_.amplitude_m = snapshot.amplitude_m;
	snapshot_.arrival = snapshot.arrival;
	snapshot_.expected = snapshot.expected;
	snapshot_.onset = snapshot.onset;
	snapshot_.is_fitted = snapshot.is_fitted;
	std::copy_n(snapshot.knots.begin(), snapshot.count, snapshot_.knots.begin());
	knots_per_s_ = 1.0 / snapshot.period_s;
	pieces_[0].length_s = pieces_[1].length_s = 0.0;
}

const MotionCurve::Piece *MotionCurve::find(double t_s) {
	const double x = (t_s - snapshot_.time_s) * knots_per_s_;
	if (!(x >= -GRAIN_S * knots_per_s_) || !(x < static_cast<double>(snapshot_.count) - 1.0)) {
		return nullptr;
	}
	const auto knot = static_cast<std::size_t>(std::max(x, 0.0));
	latest_ = 1 - latest_;
	Piece &piece = pieces_[latest_];
	const MotionSnapshot::Knot &from = snapshot_.knots[knot];
	piece.quintic = snapshot_.is_fitted
			? QuinticPiece{ { from.position, from.velocity, 0.5 * from.acceleration, from.higher[0],
					  from.higher[1], from.higher[2] } }
			: quintic(from, snapshot_.knots[knot + 1], snapshot_.period_s);
	piece.own = OwnAcceleration::between(from, snapshot_.knots[knot + 1], snapshot_.period_s);
	piece.began_s = snapshot_.time_s + snapshot_.period_s * static_cast<double>(knot);
	piece.length_s = snapshot_.period_s;
	piece.knot = knot;
	piece.is_moving = snapshot_.knots[knot].moving;
	return &piece;
}

double MotionCurve::smooth_s(double t_s) {
	const Piece *const piece = piece_at(t_s);
	if (piece == nullptr) {
		return snapshot_.count == 0 ? NEVER_S : 0.0;
	}
	return piece->length_s - (t_s - piece->began_s);
}

double MotionCurve::from_cubic(double from_s, const MotionPoint &from, double to_s, const MotionPoint &to) {
	const Piece *const first = piece_at(from_s), *const last = piece_at(to_s);
	if (first == nullptr || last == nullptr) {
		return snapshot_.count == 0 ? 0.0 : NEVER_S;
	}
	// A cubic by both ends of a piece is off by the length to the fourth power x the fourth derivative / 384.
	const double length_s = to_s - from_s, square_s2 = length_s * length_s;
	const double within =
			square_s2 * square_s2 / 384.0 * std::max(first->greatest_fourth(), last->greatest_fourth());
	if (first == last) {
		return within;
	}
	if (last->knot != first->knot + 1 || last->is_moving != first->is_moving) {
		return NEVER_S;
	}
	// What it is off by at the knot between both, in value and slope, is a cubic in each.
	const double per_s = 1.0 / length_s;
	const double share = per_s * (last->began_s - from_s), rest = 1.0 - share;
	const double way = to.position - from.position;
	const double value = from.position + share * share * (3.0 - 2.0 * share) * way +
			share * rest * length_s * (rest * from.velocity - share * to.velocity);
	const double slope = per_s * 6.0 * share * rest * way + rest * (1.0 - 3.0 * share) * from.velocity -
			share * (2.0 - 3.0 * share) * to.velocity;
	return within + std::abs(value - last->quintic.c[0]) +
			4.0 / 27.0 * length_s * std::abs(slope - last->quintic.c[1]);
}

double MotionCurve::velocity_from_cubic(double from_s, double to_s) {
	const Piece *const piece = piece_at(from_s);
	if (piece == nullptr || piece != piece_at(to_s)) {
		return snapshot_.count == 0 ? 0.0 : NEVER_S;
	}
	const double square_s2 = (to_s - from_s) * (to_s - from_s);
	return square_s2 * square_s2 / 384.0 * std::abs(120.0 * piece->quintic.c[5]);
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
