#include "tracking/frame_filter.h"

#include <algorithm>
#include <bit>

namespace steadyhand {
namespace {

/// Distance of the farthest tracked joint from the origin, m.
double reach_m(const HandFrame &hand) {
	double most_m = 0.0;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (hand.has(static_cast<Joint>(i))) {
			most_m = std::max(most_m, hand.positions_m[i].norm());
		}
	}
	return most_m;
}

} // namespace

std::uint8_t FrameFilter::clean(DeviceFrame &r_frame) {
	unsigned faults = 0;
	HandFrame &hand = r_frame.hand;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (hand.has(static_cast<Joint>(i)) && !is_place(hand.positions_m[i])) {
			hand.tracked = static_cast<std::uint8_t>(hand.tracked & ~(1U << i));
			faults |= 1U << static_cast<unsigned>(FrameFault::NOT_FINITE);
		}
	}
	for (std::size_t i = 0; i < SKELETON_JOINT_COUNT; ++i) {
		if (r_frame.skeleton.has(static_cast<SkeletonJoint>(i)) &&
				!is_place(r_frame.skeleton.positions_m[i])) {
			r_frame.skeleton.positioned &= ~(1U << i);
		}
	}
	if (hand.tracked != 0) {
		const double reach = reach_m(hand);
		const bool is_one_point = std::has_single_bit(hand.tracked);
		if (reach == 0.0 && !(is_one_point && was_near_origin_)) {
			hand.tracked = 0;
			r_frame.skeleton.clear();
			faults |= 1U << static_cast<unsigned>(FrameFault::ZERO);
		} else {
			was_near_origin_ = reach < NEAR_ORIGIN_M;
		}
	}
	hand.inferred = static_cast<std::uint8_t>(hand.inferred & hand.tracked);
	return static_cast<std::uint8_t>(faults);
}

} // namespace steadyhand
