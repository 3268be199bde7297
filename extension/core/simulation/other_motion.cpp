#include "simulation/other_motion.h"

#include "signal/minimum_jerk.h"
#include "simulation/gesture_motion.h"
#include "simulation/hand_pose.h"
#include "simulation/random_direction.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace steadyhand {

namespace {

constexpr double MARGIN_S = 0.5;
constexpr double SEVERITY_UNSTABLE = 0.5; // no way along which it could grow
constexpr double COS_30_DEG = 0.8660254037844386;

/// A hand that goes from place to place; rests between where the strokes leave gaps.
struct Stroke {
	double start_s;
	double duration_s;
	Eigen::Vector3d way_m;
};

HandWay along(std::vector<Stroke> strokes) {
	const auto shared = std::make_shared<const std::vector<Stroke>>(std::move(strokes));
	return [shared](double t_s) {
		Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
		for (const Stroke &stroke : *shared) {
			place_m += minimum_jerk((t_s - stroke.start_s) / stroke.duration_s).value * stroke.way_m;
		}
		return place_m;
	};
}

HandWay stay(double /*span_s*/, Random & /*r_random*/) {
	return [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
}

bool is_along_a_gesture(const Eigen::Vector3d &direction) {
	return std::abs(direction.x()) > COS_30_DEG || std::abs(direction.y()) > COS_30_DEG ||
			direction.z() < -COS_30_DEG;
}

HandWay reach(double span_s, Random &r_random) {
	constexpr double REACH_MAX_M = 0.25;
	std::vector<Stroke> strokes;
	Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
	for (double t_s = r_random.uniform(0.2, 0.8); t_s < span_s;) {
		const double length_m = r_random.uniform(0.03, REACH_MAX_M);
		const Eigen::Vector3d way_m = length_m * random_direction(r_random);
		if (is_along_a_gesture(way_m.normalized()) || (place_m + way_m).norm() > REACH_MAX_M) {
			continue;
		}
		// Fitts: MT = 0.25 + 0.18 log2(D / W + 1) for a target of 3 cm.
		const double duration_s =
				(0.25 + 0.18 * std::log2(way_m.norm() / 0.03 + 1.0)) * r_random.uniform(0.8, 1.4);
		strokes.push_back({ t_s, duration_s, way_m });
		place_m += way_m;
		t_s += duration_s + r_random.uniform(0.0, 0.6);
	}
	return along(std::move(strokes));
}

HandWay type(double span_s, Random &r_random) {
	std::vector<Stroke> strokes;
	for (double t_s = r_random.uniform(0.1, 0.4); t_s < span_s;) {
		// Keys 150..500 ms apart (Angelaki, Soechting 1993), 10..30 mm deep, down and up in 50..70 ms each.
		const Eigen::Vector3d depth_m(0.0, -r_random.uniform(0.010, 0.030), 0.0);
		const double half_s = r_random.uniform(0.05, 0.07);
		const double interval_s = r_random.uniform(0.15, 0.5);
		strokes.push_back({ t_s, half_s, depth_m });
		strokes.push_back({ t_s + half_s, half_s, -depth_m });
		const double left_m = r_random.uniform(-0.02, 0.02);
		strokes.push_back({ t_s + 2.0 * half_s, interval_s, { left_m, 0.0, r_random.uniform(-0.01, 0.01) } });
		t_s += 2.0 * half_s + interval_s;
	}
	return along(std::move(strokes));
}

HandWay circle(double /*span_s*/, Random &r_random) {
	const Eigen::Vector3d normal = random_direction(r_random);
	const Eigen::Vector3d right = normal.unitOrthogonal();
	const Eigen::Vector3d up = normal.cross(right);
	const double radius_m = r_random.uniform(0.03, 0.10);
	const double rate_rad_s = 2.0 * std::numbers::pi * r_random.uniform(0.4, 1.2);
	const double flatness = r_random.uniform(0.6, 1.0);
	return [=](double t_s) -> Eigen::Vector3d {
		const double angle_rad = rate_rad_s * t_s;
		return radius_m * (std::cos(angle_rad) * right + flatness * std::sin(angle_rad) * up);
	};
}

HandWay wander(double /*span_s*/, Random &r_random) {
	const double deviation_m = r_random.uniform(0.02, 0.06);
	return [way = Oscillation(0.1, 0.8, deviation_m, r_random)](double t_s) { return way.at(t_s); };
}

/// Thumb, index and middle finger, each by itself about where it happens to be in a loose hand.
class Fingers {
public:
	Fingers(double deviation_m, Random &r_random) {
		for (std::size_t i = 0; deviation_m > 0.0 && i < MOVED.size(); ++i) {
			const double x = r_random.normal(), y = r_random.normal(), z = r_random.normal();
			places_m_.push_back(LOOSE_M * Eigen::Vector3d(x, y, z));
			ways_.emplace_back(0.2, 1.2, deviation_m * r_random.uniform(0.5, 1.5), r_random);
		}
	}
	void apply(double t_s, HandFrame &r_frame) const {
		for (std::size_t i = 0; i < ways_.size(); ++i) {
			r_frame.set(MOVED[i], r_frame.position(MOVED[i]) + places_m_[i] + ways_[i].at(t_s));
		}
	}

private:
	static constexpr std::array MOVED{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
	static constexpr double LOOSE_M = 0.015;
	std::vector<Eigen::Vector3d> places_m_;
	std::vector<Oscillation> ways_;
};

constexpr std::array<OtherMotion, 6> OTHERS = { {
		{ "idle", stay },
		{ "fidgeting", stay, 0.005 },
		{ "reaching", reach },
		{ "typing", type },
		{ "circling", circle },
		{ "wandering", wander },
} };

} // namespace

std::span<const OtherMotion> other_motions() {
	return OTHERS;
}

const OtherMotion *find_other_motion(std::string_view name) {
	const auto *const found = std::find_if(
			OTHERS.begin(), OTHERS.end(), [name](const OtherMotion &kind) { return kind.name == name; });
	return found == OTHERS.end() ? nullptr : found;
}

TrueMotion make_other_motion(const OtherMotion &kind, HandPosition position, const Subject &subject,
		double span_s, Random &r_random) {
	TrueMotion motion;
	const double drawn_s = r_random.uniform(4.0, 8.0);
	motion.span_s = std::max(span_s > 0.0 ? span_s : drawn_s, 2.0 * MARGIN_S);
	motion.start_s = MARGIN_S;
	motion.end_s = motion.span_s - MARGIN_S;
	const HandWay way = kind.make(motion.span_s, r_random);
	const auto unrest = std::make_shared<const Unrest>(subject, r_random);
	const auto fingers = std::make_shared<const Fingers>(kind.fingers_m, r_random);
	motion.hand = [way, fingers, unrest, place_m = hand_place_m(position), scale = subject.hand_scale](
						  double t_s) {
		HandFrame frame = pointing_hand(scale);
		fingers->apply(t_s, frame);
		shift_hand(frame, place_m + way(t_s));
		unrest->apply(t_s, frame);
		frame.t_s = t_s;
		return frame;
	};
	motion.severity = [position](
							  double) { return position == HandPosition::STABLE ? 0.0 : SEVERITY_UNSTABLE; };
	return motion;
}

} // namespace steadyhand
