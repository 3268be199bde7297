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
constexpr double SEVERITY_UNSTABLE = 0.5; // constant: there is no path along which it could grow
constexpr double COS_30_DEG = 0.8660254037844386;

/// A straight minimum-jerk movement. The hand rests between strokes.
struct Stroke {
	double start_s;
	double duration_s;
	Eigen::Vector3d displacement_m;
};

HandDisplacement along(std::vector<Stroke> strokes) {
	const auto shared = std::make_shared<const std::vector<Stroke>>(std::move(strokes));
	return [shared](double t_s) {
		Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
		for (const Stroke &stroke : *shared) {
			place_m += minimum_jerk((t_s - stroke.start_s) / stroke.duration_s).value * stroke.displacement_m;
		}
		return place_m;
	};
}

HandDisplacement stay(double /*span_s*/, Random & /*r_random*/) {
	return [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
}

bool is_along_a_gesture(const Eigen::Vector3d &direction) {
	return std::abs(direction.x()) > COS_30_DEG || std::abs(direction.y()) > COS_30_DEG ||
			direction.z() < -COS_30_DEG;
}

HandDisplacement reach(double span_s, Random &r_random) {
	constexpr double REACH_MAX_M = 0.25;
	std::vector<Stroke> strokes;
	Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
	for (double t_s = r_random.uniform(0.2, 0.8); t_s < span_s;) {
		const double length_m = r_random.uniform(0.03, REACH_MAX_M);
		const Eigen::Vector3d displacement_m = length_m * random_direction(r_random);
		if (is_along_a_gesture(displacement_m.normalized()) ||
				(place_m + displacement_m).norm() > REACH_MAX_M) {
			continue;
		}
		// Fitts: MT = 0.25 + 0.18 log2(D / W + 1) for a target of 3 cm.
		const double duration_s =
				(0.25 + 0.18 * std::log2(displacement_m.norm() / 0.03 + 1.0)) * r_random.uniform(0.8, 1.4);
		strokes.push_back({ t_s, duration_s, displacement_m });
		place_m += displacement_m;
		t_s += duration_s + r_random.uniform(0.0, 0.6);
	}
	return along(std::move(strokes));
}

HandDisplacement type(double span_s, Random &r_random) {
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

HandDisplacement circle(double /*span_s*/, Random &r_random) {
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

HandDisplacement wander(double /*span_s*/, Random &r_random) {
	const double deviation_m = r_random.uniform(0.02, 0.06);
	return [motion = Oscillation(0.1, 0.8, deviation_m, r_random)](double t_s) { return motion.at(t_s); };
}

/// Independent motion of thumb, index and middle finger around random positions.
class Fingers {
public:
	Fingers(double deviation_m, Random &r_random) {
		for (std::size_t i = 0; deviation_m > 0.0 && i < MOVED.size(); ++i) {
			const double x = r_random.normal(), y = r_random.normal(), z = r_random.normal();
			places_m_.push_back(LOOSE_M * Eigen::Vector3d(x, y, z));
			motions_.emplace_back(0.2, 1.2, deviation_m * r_random.uniform(0.5, 1.5), r_random);
		}
	}
	void apply(double t_s, HandFrame &r_frame) const {
		for (std::size_t i = 0; i < motions_.size(); ++i) {
			r_frame.set(MOVED[i], r_frame.position(MOVED[i]) + places_m_[i] + motions_[i].at(t_s));
		}
	}

private:
	static constexpr std::array MOVED{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
	static constexpr double LOOSE_M = 0.015;
	std::vector<Eigen::Vector3d> places_m_;
	std::vector<Oscillation> motions_;
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
	const HandDisplacement displacement = kind.make(motion.span_s, r_random);
	const auto involuntary = std::make_shared<const InvoluntaryMotion>(subject, r_random);
	const auto fingers = std::make_shared<const Fingers>(kind.fingers_m, r_random);
	motion.hand = [displacement, fingers, involuntary, place_m = hand_place_m(position),
						  scale = subject.hand_scale](double t_s) {
		HandFrame frame = pointing_hand(scale);
		fingers->apply(t_s, frame);
		shift_hand(frame, place_m + displacement(t_s));
		involuntary->apply(t_s, frame);
		frame.t_s = t_s;
		return frame;
	};
	motion.severity = [position](
							  double) { return position == HandPosition::STABLE ? 0.0 : SEVERITY_UNSTABLE; };
	return motion;
}

} // namespace steadyhand
