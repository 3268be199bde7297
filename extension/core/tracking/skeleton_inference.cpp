#include "tracking/skeleton_inference.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace steadyhand {
namespace {

constexpr std::size_t FINGERS = 5;
/// Index of each finger's first joint in SkeletonJoint. The tip is its last joint.
constexpr std::array<std::size_t, FINGERS + 1> FIRST = { 2, 6, 11, 16, 21, 26 };
/// Fingers of an adult's hand, m (Buryanov & Kotiuk 2010): position of the knuckle ahead of the wrist and
/// towards the index finger's side, and length from the knuckle to the tip.
struct Finger {
	double ahead_m, side_m, length_m;
};
constexpr std::array<Finger, FINGERS> ADULT = { { { 0.045, 0.045, 0.070 }, { 0.093, 0.027, 0.095 },
		{ 0.095, 0.006, 0.105 }, { 0.089, -0.014, 0.098 }, { 0.080, -0.032, 0.078 } } };
constexpr double ADULT_PALM_M = 0.085; ///< from the wrist to the palm's middle
/// Position of the metacarpal joint, as a fraction of wrist to knuckle. SHARES: of the joints after the
/// knuckle, as fractions of knuckle to tip.
constexpr double METACARPAL_SHARE = 0.2;
constexpr std::array<double, 3> SHARES = { 0.45, 0.75, 1.0 };
constexpr std::array<double, 2> THUMB_SHARES = { 0.55, 1.0 };

std::size_t index_of(SkeletonJoint joint) {
	return static_cast<std::size_t>(joint);
}

void place(HandSkeleton &r_hand, std::size_t joint, const Eigen::Vector3d &position_m) {
	if (!r_hand.has(static_cast<SkeletonJoint>(joint))) {
		r_hand.set(static_cast<SkeletonJoint>(joint), position_m);
		r_hand.inferred |= 1U << joint;
	}
}

/// Rotates the joint along the bone that begins at `from`. OpenXR's +z points back along the bone.
void rotate(HandSkeleton &r_hand, std::size_t joint, const Eigen::Vector3d &from) {
	const Eigen::Vector3d back = from - r_hand.positions_m[joint];
	if ((r_hand.rotated >> joint & 1U) == 0 && back.squaredNorm() > 0.0) {
		r_hand.rotations[joint] = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), back);
		r_hand.rotated |= 1U << joint;
	}
}

/// Unit vectors of the hand, and its size relative to an adult's.
struct HandAxes {
	Eigen::Vector3d wrist_m, ahead, side, dorsal;
	double scale;
};

Eigen::Vector3d mean_tip_m(const HandSkeleton &hand) {
	Eigen::Vector3d sum = Eigen::Vector3d::Zero();
	int count = 0;
	for (std::size_t finger = 1; finger < FINGERS; ++finger) {
		const auto tip = static_cast<SkeletonJoint>(FIRST[finger + 1] - 1);
		if (hand.has(tip)) {
			sum += hand.position(tip);
			++count;
		}
	}
	return count > 0 ? Eigen::Vector3d(sum / count) : sum;
}

/// Vector between two fingertips, towards the index finger's side. Prefers fingers that are far apart and
/// similarly bent. Zero if there are no two fingertips.
Eigen::Vector3d across_m(const HandSkeleton &hand, const Eigen::Vector3d &ahead) {
	constexpr double BENT_ALIKE_M = 0.03;
	Eigen::Vector3d best = Eigen::Vector3d::Zero();
	double most = 0.0;
	for (std::size_t one = 1; one < FINGERS; ++one) {
		for (std::size_t other = one + 1; other < FINGERS; ++other) {
			const std::size_t one_tip = FIRST[one + 1] - 1, other_tip = FIRST[other + 1] - 1;
			if (!hand.has(static_cast<SkeletonJoint>(one_tip)) ||
					!hand.has(static_cast<SkeletonJoint>(other_tip))) {
				continue;
			}
			const Eigen::Vector3d way = hand.positions_m[one_tip] - hand.positions_m[other_tip];
			const double apart_m = ADULT[one].side_m - ADULT[other].side_m;
			const double quality = apart_m / (1.0 + std::abs(way.dot(ahead)) / BENT_ALIKE_M);
			if (quality > most) {
				most = quality;
				best = way;
			}
		}
	}
	return best;
}

std::optional<HandAxes> axes_of(const HandSkeleton &hand) {
	if (!hand.has(SkeletonJoint::WRIST) || !hand.has(SkeletonJoint::PALM)) {
		return std::nullopt;
	}
	HandAxes axes;
	axes.wrist_m = hand.position(SkeletonJoint::WRIST);
	const Eigen::Vector3d palm_m = hand.position(SkeletonJoint::PALM) - axes.wrist_m;
	axes.scale = palm_m.norm() / ADULT_PALM_M;
	axes.ahead = palm_m.normalized();
	const Eigen::Vector3d across = across_m(hand, axes.ahead);
	axes.side = (across - axes.ahead * axes.ahead.dot(across)).normalized();
	axes.dorsal = axes.ahead.cross(axes.side); // of a right hand
	const bool is_sound = axes.scale > 0.0 && axes.side.norm() > 0.5;
	// Fingers bend towards the palm.
	if (axes.dorsal.dot(mean_tip_m(hand) - hand.position(SkeletonJoint::PALM)) > 0.0) {
		axes.dorsal = -axes.dorsal;
	}
	return is_sound ? std::optional(axes) : std::nullopt;
}

/// Half the angle x of an arc with length 1 whose ends are `chord` apart: sin(x) / x = chord.
double half_turn_of(double chord) {
	double low = 0.0, high = 3.0;
	for (int step = 0; step < 40; ++step) {
		const double x = 0.5 * (low + high);
		(std::sin(x) / std::max(x, 1e-9) > chord ? low : high) = x;
	}
	return low;
}

/// Point at fraction `share` of a circular arc of length_m from `from` to `to`, which bulges towards
/// `outward`.
Eigen::Vector3d bent(const Eigen::Vector3d &from, const Eigen::Vector3d &to, double length_m,
		const Eigen::Vector3d &outward, double share) {
	const Eigen::Vector3d way = to - from;
	const double chord = way.norm() / length_m;
	const Eigen::Vector3d along = way.normalized();
	const Eigen::Vector3d out = (outward - along * along.dot(outward)).normalized();
	if (!(chord < 0.999) || !(chord > 0.0) || !(out.norm() > 0.5)) {
		return from + share * way;
	}
	const double half = half_turn_of(chord), radius_m = 0.5 * length_m / half;
	const double angle = (2.0 * share - 1.0) * half;
	return 0.5 * (from + to) + radius_m * std::sin(angle) * along +
			radius_m * (std::cos(angle) - std::cos(half)) * out;
}

void infer_finger(HandSkeleton &r_hand, std::size_t finger, const std::optional<HandAxes> &axes,
		const Eigen::Vector3d &root_m) {
	const std::size_t tip = FIRST[finger + 1] - 1, knuckle = FIRST[finger] + 1;
	const Eigen::Vector3d tip_m = r_hand.positions_m[tip];
	const Finger &adult = ADULT[finger];
	const Eigen::Vector3d knuckle_m = axes
			? Eigen::Vector3d(
					  root_m + axes->scale * (adult.ahead_m * axes->ahead + adult.side_m * axes->side))
			: Eigen::Vector3d(root_m + 0.5 * (tip_m - root_m));
	place(r_hand, knuckle, knuckle_m);
	place(r_hand, FIRST[finger], root_m + METACARPAL_SHARE * (r_hand.positions_m[knuckle] - root_m));
	const double length_m = axes ? axes->scale * adult.length_m : 0.0;
	const Eigen::Vector3d outward = axes ? axes->dorsal : Eigen::Vector3d(Eigen::Vector3d::Zero());
	for (std::size_t joint = knuckle + 1; joint <= tip; ++joint) {
		const double share = finger == 0 ? THUMB_SHARES[joint - knuckle - 1] : SHARES[joint - knuckle - 1];
		place(r_hand, joint, bent(r_hand.positions_m[knuckle], tip_m, length_m, outward, share));
	}
	for (std::size_t joint = FIRST[finger]; joint <= tip; ++joint) {
		rotate(r_hand, joint, joint == FIRST[finger] ? root_m : r_hand.positions_m[joint - 1]);
	}
}

} // namespace

HandSkeleton infer_skeleton(const DeviceFrame &frame) {
	HandSkeleton hand = frame.skeleton;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (frame.hand.has(static_cast<Joint>(i)) && !hand.has(SKELETON_OF[i])) {
			hand.set(SKELETON_OF[i], frame.hand.positions_m[i]);
		}
	}
	const bool has_wrist = hand.has(SkeletonJoint::WRIST);
	if (!has_wrist && !hand.has(SkeletonJoint::PALM)) {
		return hand;
	}
	const Eigen::Vector3d root_m = hand.position(has_wrist ? SkeletonJoint::WRIST : SkeletonJoint::PALM);
	const std::optional<HandAxes> axes = axes_of(hand);
	bool has_finger = false;
	for (std::size_t finger = 0; finger < FINGERS; ++finger) {
		if (hand.has(static_cast<SkeletonJoint>(FIRST[finger + 1] - 1))) {
			infer_finger(hand, finger, axes, root_m);
			has_finger = true;
		}
	}
	if (has_finger) {
		const Eigen::Vector3d ahead_m = mean_tip_m(hand) - root_m;
		place(hand, index_of(SkeletonJoint::WRIST), root_m);
		place(hand, index_of(SkeletonJoint::PALM), root_m + 0.4 * ahead_m);
		rotate(hand, index_of(SkeletonJoint::WRIST), root_m - ahead_m);
		rotate(hand, index_of(SkeletonJoint::PALM), root_m);
	}
	return hand;
}

} // namespace steadyhand
