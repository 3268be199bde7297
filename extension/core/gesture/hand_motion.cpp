#include "gesture/hand_motion.h"

#include "gesture/feature.h"

#include <Eigen/Geometry>

#include <cmath>
#include <optional>

namespace steadyhand {
namespace {

// asinh is linear below its unit and logarithmic above it. The units are a quarter of a usual gesture.
constexpr double DISTANCE_UNIT_M = 0.05;
constexpr double SPEED_UNIT_M_S = 0.15;
constexpr double STILL_M_S = 0.05; ///< speed that noise gives a hand at rest
constexpr double GROWTH_UNIT_M = 0.01;
constexpr double RATE_UNIT_M_S = 0.04;
/// At a smaller distance from the onset the direction is noise, and all motion counts as away.
constexpr double NO_DIRECTION_M = 0.005;

} // namespace

template <class Value> void HandMotionWindow::Samples<Value>::push(double t_s, const Value &value) {
	const std::size_t count = window.size();
	if (count > 1 && t_s - window.t_s(count - 2) < LEAST_INTERVAL_S) {
		window.drop_newest();
	}
	window.push(t_s, value, WINDOW_S);
	newest = value;
}

bool HandMotionWindow::push(const HandFrame &frame) {
	if (!frame.has(Joint::INDEX) || !frame.position(Joint::INDEX).allFinite()) {
		return false;
	}
	const Measurement measurement = monitor_.push(frame.t_s, frame.position(Joint::INDEX));
	if (!measurement.is_usable()) {
		return false;
	}
	tip_.push(frame.t_s, measurement.position_m - measurement.displacement_m);
	static const Feature *const radius = find_feature("tips_circumradius");
	const std::optional<double> radius_m = radius->measure(frame, { .start_m = Eigen::Vector3d::Zero() });
	has_radius_ = radius_m.has_value();
	if (has_radius_) {
		radius_.push(frame.t_s, *radius_m);
	}
	return true;
}

HandMotion HandMotionWindow::motion() const {
	return { tip_.newest, tip_.window.slope(), radius_.newest, has_radius_ ? radius_.window.slope() : 0.0,
		has_radius_ };
}

double MotionObserver::bow() const {
	const double square_m2 = farthest_m_.squaredNorm();
	return square_m2 > 0.0 ? farthest_m_.cross(centre_m_).norm() / square_m2 : 0.0;
}

MotionObservation MotionObserver::observe(const HandMotion &motion) {
	const Eigen::Vector3d displacement_m = motion.tip_m - onset_.tip_m;
	const Eigen::Vector3d &velocity_m_s = motion.velocity_m_s;
	const double distance_m = displacement_m.norm(), speed_m_s = velocity_m_s.norm();
	double away_m_s = speed_m_s, across_m_s = 0.0;
	if (distance_m > NO_DIRECTION_M) {
		away_m_s = velocity_m_s.dot(displacement_m) / distance_m;
		across_m_s = std::sqrt(std::max(speed_m_s * speed_m_s - away_m_s * away_m_s, 0.0));
	}
	// Without all three fingertips the hand counts as not opening.
	const bool is_seen = motion.has_radius && onset_.has_radius;
	const double growth_m = is_seen ? motion.radius_m - onset_.radius_m : 0.0;
	const double rate_m_s = is_seen ? motion.radius_rate_m_s : 0.0;
	peak_m_s_ = std::max(peak_m_s_, speed_m_s);
	growth_m_ = std::max(growth_m_, growth_m);
	const double step_m = (displacement_m - newest_m_).norm();
	path_m_ += step_m;
	path_sum_m2_ += 0.5 * step_m * (displacement_m + newest_m_);
	newest_m_ = displacement_m;
	if (distance_m > farthest_m_.norm()) {
		farthest_m_ = displacement_m;
		centre_m_ = path_sum_m2_ / path_m_;
	}
	const double usual_m_s = peak_m_s_ + STILL_M_S;
	MotionObservation point;
	point << std::asinh(distance_m / DISTANCE_UNIT_M), away_m_s / usual_m_s, across_m_s / usual_m_s,
			std::asinh(peak_m_s_ / SPEED_UNIT_M_S), std::asinh(growth_m / GROWTH_UNIT_M),
			std::asinh(rate_m_s / RATE_UNIT_M_S);
	return point;
}

} // namespace steadyhand
