#include "devices/leap_hands.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace steadyhand {
namespace {

constexpr double US_PER_S = 1e6;
/// How long a lost hand's last position is kept, s: longer than the dropout before a service mislabels a
/// hand.
constexpr double PLACE_KEPT_S = 0.5;
/// Hands in recordings move at up to 2 m/s. A step that is faster, and SAME_PLACE_M longer, is a jump.
constexpr double FASTEST_M_S = 3.0;

double seconds_between(std::int64_t from_us, std::int64_t to_us) {
	return static_cast<double>(to_us - from_us) / US_PER_S;
}

Eigen::Vector3d palm_m(const LeapHand &hand) {
	return hand.skeleton.position(SkeletonJoint::PALM);
}

Eigen::Matrix3d axes_of(LeapMounting mounting) {
	Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
	switch (mounting) {
		case LeapMounting::HMD:
			axes << -1, 0, 0, 0, 0, -1, 0, -1, 0;
			break;
		case LeapMounting::SCREENTOP:
			axes << -1, 0, 0, 0, -1, 0, 0, 0, 1;
			break;
		case LeapMounting::DESKTOP:
			break;
	}
	return axes;
}

} // namespace

HandSkeleton leap_to_godot(const HandSkeleton &skeleton, LeapMounting mounting) {
	const Eigen::Matrix3d axes = axes_of(mounting);
	const Eigen::Quaterniond turn(axes);
	HandSkeleton out = skeleton;
	for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
		out.positions_m[i] = axes * skeleton.positions_m[i];
		if ((skeleton.rotated >> i & 1U) != 0 && mounting != LeapMounting::DESKTOP) {
			out.rotations[i] = (turn * skeleton.rotations[i]).normalized();
		}
	}
	return out;
}

const LeapHandChooser::Known *LeapHandChooser::find(std::int64_t id) const {
	for (std::size_t i = 0; i < known_.size(); ++i) {
		if (known_[i].id == id) {
			return &known_[i];
		}
	}
	return nullptr;
}

bool LeapHandChooser::is_at_lost_hand(const LeapHand &hand, const LeapFrame &frame) const {
	const auto is_near = [](const Eigen::Vector3d &a, const Eigen::Vector3d &b) {
		return (a - b).norm() < SAME_PLACE_M;
	};
	for (std::size_t i = 0; i < known_.size(); ++i) {
		const Known &other = known_[i];
		if (other.id == hand.id || other.is_left == hand.is_left || !is_near(other.palm_m, palm_m(hand))) {
			continue;
		}
		const bool is_still_there =
				std::any_of(frame.hands.begin(), frame.hands.end(), [&other, &is_near](const LeapHand &seen) {
					return seen.id == other.id && seen.is_left == other.is_left &&
							is_near(other.palm_m, palm_m(seen));
				});
		if (!is_still_there) {
			return true;
		}
	}
	return false;
}

bool LeapHandChooser::is_mislabelled(const LeapHand &hand, const Known *known, const LeapFrame &frame) const {
	if (known != nullptr && known->is_left != hand.is_left) {
		return true;
	}
	if (known != nullptr && !known->mislabelled_since_us) {
		const double step_s = seconds_between(known->seen_us, frame.timestamp_us);
		if ((palm_m(hand) - known->palm_m).norm() <= SAME_PLACE_M + FASTEST_M_S * step_s) {
			return false;
		}
	}
	return is_at_lost_hand(hand, frame);
}

LeapHandChooser::Known LeapHandChooser::judge(const LeapHand &hand, const LeapFrame &frame) const {
	Known now{ hand.id, hand.is_left, palm_m(hand), frame.timestamp_us, std::nullopt };
	const Known *known = find(hand.id);
	if (!is_mislabelled(hand, known, frame)) {
		return now;
	}
	// A new mislabelled hand counts as the lost hand of the other side.
	Known before = known != nullptr ? *known : now;
	before.is_left = known != nullptr ? known->is_left : !hand.is_left;
	before.mislabelled_since_us = before.mislabelled_since_us.value_or(frame.timestamp_us);
	return seconds_between(*before.mislabelled_since_us, frame.timestamp_us) < MISLABELLED_S ? before : now;
}

const LeapHand *LeapHandChooser::choose(const LeapFrame &frame) {
	if (frame.timestamp_us < last_us_) {
		clear();
	}
	last_us_ = frame.timestamp_us;

	Ring<Known, 2 * LEAP_HANDS_MAX> next;
	for (std::size_t i = 0; i < known_.size(); ++i) {
		const Known &known = known_[i];
		const bool is_here = std::any_of(frame.hands.begin(), frame.hands.end(),
				[&known](const LeapHand &hand) { return hand.id == known.id; });
		if (!is_here && seconds_between(known.seen_us, frame.timestamp_us) < PLACE_KEPT_S) {
			next.push(known);
		}
	}
	const LeapHand *chosen = nullptr;
	for (const LeapHand &hand : frame.hands) {
		next.push(judge(hand, frame));
		if (next.newest().mislabelled_since_us || hand.is_left != (side_ == HandSide::LEFT)) {
			continue;
		}
		const bool has_last = chosen != nullptr && chosen_id_ == chosen->id;
		const bool is_longer = chosen == nullptr || hand.time_visible_s > chosen->time_visible_s;
		if (chosen_id_ == hand.id || (is_longer && !has_last)) {
			chosen = &hand;
		}
	}
	known_ = std::move(next);
	if (chosen != nullptr) {
		chosen_id_ = chosen->id;
	}
	return chosen;
}

void LeapHandChooser::clear() {
	known_.clear();
	chosen_id_.reset();
	last_us_ = 0;
}

} // namespace steadyhand
