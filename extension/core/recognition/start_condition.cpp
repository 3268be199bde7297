#include "recognition/start_condition.h"

#include "base/parameters.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::start;

double distance_m(const HandFrame &frame, Joint one, Joint other) {
	return (frame.position(one) - frame.position(other)).norm();
}

} // namespace

std::uint8_t StartCondition::joints(StartKind kind) {
	switch (kind) {
		case StartKind::NONE:
			break;
		case StartKind::DWELL:
			return joint_bits({ Joint::INDEX });
		case StartKind::PINCH:
			return joint_bits({ Joint::THUMB, Joint::INDEX });
		case StartKind::POINTING_POSE:
			return joint_bits({ Joint::INDEX, Joint::MIDDLE, Joint::RING, Joint::PINKY, Joint::PALM });
	}
	return 0;
}

/// A confidence that was never high does not count: some trackers always report 0
/// (godot_openxr_for_godot_3.x #221).
bool StartCondition::is_seen_well(const HandFrame &frame) {
	has_joints_ = frame.has_all(joints(settings_.kind));
	const bool is_sure = frame.confidence >= LEAST_CONFIDENCE;
	reports_confidence_ |= has_joints_ && is_sure;
	return has_joints_ && (is_sure || !reports_confidence_);
}

void StartCondition::push(const HandFrame &frame) {
	if (settings_.kind == StartKind::NONE) {
		return;
	}
	const bool is_seen = is_seen_well(frame);
	const bool was_lost = frame.t_s - seen_s_ > SHORT_DROPOUT_S;
	if (was_lost) {
		lose();
	}
	if (!is_seen) {
		return;
	}
	seen_s_ = frame.t_s;
	found_s_ = was_lost ? frame.t_s : found_s_;
	if (is_pose() && frame.t_s - found_s_ < SETTLES_S) {
		return;
	}
	judge(frame) ? meet(frame.t_s) : fail(frame.t_s);
}

void StartCondition::lose() {
	if (is_pose() && is_met_ && seen_s_ - met_from_s_ < SETTLES_S) {
		met_to_s_ = -INFINITY;
		is_released_ = settings_.kind == StartKind::PINCH;
	}
	is_met_ = false;
	open_from_s_ = still_from_s_ = left_s_ = INFINITY;
}

bool StartCondition::judge(const HandFrame &frame) {
	switch (settings_.kind) {
		case StartKind::NONE:
			break;
		case StartKind::DWELL:
			return is_still(frame);
		case StartKind::PINCH:
			return distance_m(frame, Joint::THUMB, Joint::INDEX) <
					(is_met_ ? OPENS_AT * settings_.pinch_m : settings_.pinch_m);
		case StartKind::POINTING_POSE: {
			const double index_m = distance_m(frame, Joint::INDEX, Joint::PALM);
			const double others_m = std::max({ distance_m(frame, Joint::MIDDLE, Joint::PALM),
					distance_m(frame, Joint::RING, Joint::PALM),
					distance_m(frame, Joint::PINKY, Joint::PALM) });
			return index_m > EXTENDED_M && index_m > (is_met_ ? POINTS_TO : POINTS_FROM) * others_m;
		}
	}
	return true;
}

bool StartCondition::is_still(const HandFrame &frame) {
	const Eigen::Vector3d &tip_m = frame.position(Joint::INDEX);
	const bool is_there = (tip_m - still_at_m_).norm() < (is_met_ ? LEFT_M : STILL_M);
	left_s_ = is_there ? INFINITY : std::min(left_s_, frame.t_s);
	if (still_from_s_ == INFINITY || frame.t_s - left_s_ >= SLIP_S) {
		still_at_m_ = tip_m;
		still_from_s_ = frame.t_s;
		left_s_ = INFINITY;
		return false;
	}
	return is_there && frame.t_s - still_from_s_ >= settings_.dwell_s;
}

void StartCondition::meet(double t_s) {
	met_from_s_ = is_met_ ? met_from_s_ : t_s;
	met_to_s_ = t_s;
	open_from_s_ = INFINITY;
	is_met_ = true;
	is_released_ = false;
}

void StartCondition::fail(double t_s) {
	is_met_ = false;
	open_from_s_ = std::min(open_from_s_, t_s);
	if (settings_.kind == StartKind::PINCH && t_s - open_from_s_ >= SLIP_S) {
		met_to_s_ = -INFINITY;
		is_released_ = true;
	}
}

bool StartCondition::may_begin(double onset_s) const {
	return settings_.kind == StartKind::NONE ||
			(onset_s >= met_from_s_ && onset_s <= met_to_s_ + DETECTION_S);
}

} // namespace steadyhand
