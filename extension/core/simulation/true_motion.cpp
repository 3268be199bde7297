#include "simulation/true_motion.h"

#include "simulation/hand_pose.h"

#include <cstddef>

namespace steadyhand {

namespace {

constexpr double SWAY_LOW_HZ = 0.15;
constexpr double SWAY_HIGH_HZ = 1.2;
constexpr double JOINT_SHARE_OF_SWAY = 0.2; // fingers of one hand move with it

} // namespace

InvoluntaryMotion::InvoluntaryMotion(const Subject &subject, Random &r_random) :
		tremor_(subject.tremor_hz - 0.7, subject.tremor_hz + 0.7, subject.tremor_m, r_random),
		sway_(SWAY_LOW_HZ, SWAY_HIGH_HZ, subject.sway_m, r_random) {
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		joints_.emplace_back(SWAY_LOW_HZ, 2.0 * SWAY_HIGH_HZ, JOINT_SHARE_OF_SWAY * subject.sway_m, r_random);
	}
}

void InvoluntaryMotion::apply(double t_s, HandFrame &r_frame) const {
	shift_hand(r_frame, tremor_.at(t_s) + sway_.at(t_s));
	for (std::size_t joint = 0; joint < JOINT_COUNT; ++joint) {
		r_frame.positions_m[joint] += joints_[joint].at(t_s);
	}
}

} // namespace steadyhand
