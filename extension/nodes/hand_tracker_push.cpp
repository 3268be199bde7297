// Frames that a script pushes to a HandTracker, and errors of refused frames.

#include "hand_tracker.h"

#include "conversions.h"
#include "hand_source.h"
#include "node_label.h"

#include <godot_cpp/classes/os.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace godot {

namespace {

constexpr const char *TIME_FAULT = "the time must be finite, and below 1e12 s";

bool is_main_thread() {
	const OS *const os = OS::get_singleton();
	return os->get_thread_caller_id() == os->get_main_thread_id();
}

String type_of(const Variant &p_value) {
	return Variant::get_type_name(p_value.get_type());
}

} // namespace

Error HandTracker::push_frame(double p_time_s, const Dictionary &p_joints, double p_confidence) {
	if (!is_main_thread()) {
		return refuse_frame(Refusal::OTHER_THREAD,
				"call it from the main thread, for example by push_frame.call_deferred(...)");
	}
	if (source_.is_null() || !source_->is_script()) {
		const String has = source_.is_null()
				? String("it is empty")
				: String("its ") + source_->get_class() + String(" makes its own frames");
		return refuse_frame(Refusal::OTHER_SOURCE, String("set \"source\" to a ScriptSource first: ") + has);
	}
	if (!stream_ && start_is_due_) {
		start(); // a script has set the source and pushes at once
	}
	if (!stream_) {
		return refuse_frame(Refusal::NOT_RUNNING, "call start() first");
	}
	if (!(std::abs(p_time_s) <= steadyhand::FARTHEST_S)) {
		return refuse_frame(Refusal::NO_TIME, TIME_FAULT);
	}
	if (clock_set_ && p_time_s < time_s_) {
		return refuse_older(p_time_s);
	}
	steadyhand::DeviceFrame frame;
	if (const Error error = read_joints(p_joints, frame); error != OK) {
		return error;
	}
	frame.hand.t_s = p_time_s;
	frame.hand.confidence = limit_confidence(p_confidence);
	if (!clock_set_) {
		time_s_ = start_time_s_ = hand_seen_s_ = p_time_s;
	}
	clock_set_ = true;
	refused_from_s_.reset();
	duration_s_ = p_time_s - start_time_s_;
	const Watch watch(listeners_);
	const uint64_t this_run = run_;
	check_stream(frame.hand);
	const std::shared_ptr<HandStream> stream = stream_;
	stream->accept(frame);
	deliver_until(p_time_s);
	if (is_current(watch, this_run)) {
		report_time(p_time_s);
	}
	return OK;
}

/// Warns once per run of a confidence that is not within 0..1.
double HandTracker::limit_confidence(double p_confidence) {
	const double used = std::isfinite(p_confidence) ? std::clamp(p_confidence, 0.0, 1.0) : 0.0;
	if (used != p_confidence && !has_reported_confidence_) {
		has_reported_confidence_ = true;
		WARN_PRINT(refusal(*this, "push_frame: confidence must be 0..1", p_confidence) + String("; ") +
				String::num(used) + String(" is used (reported once per run)"));
	}
	return used;
}

/// Keys are joints of the whole skeleton. The HandFrame gets its seven joints from it.
Error HandTracker::read_joints(const Dictionary &p_joints, steadyhand::DeviceFrame &r_frame) {
	const Array keys = p_joints.keys();
	const Array values = p_joints.values();
	for (int64_t i = 0; i < keys.size(); ++i) {
		const Variant &key = keys[i];
		// All numbers of JSON are floats.
		const bool is_whole = key.get_type() == Variant::FLOAT &&
				static_cast<double>(key) == std::floor(static_cast<double>(key));
		if (key.get_type() != Variant::INT && !is_whole) {
			return refuse_frame(Refusal::NO_JOINTS,
					String("joints must map HandTracker.JOINT_* to a Vector3; the key '") + key.stringify() +
							String("' is of type ") + type_of(key));
		}
		const int64_t joint = key;
		if (joint < 0 || joint >= static_cast<int64_t>(steadyhand::SKELETON_JOINT_COUNT)) {
			return refuse_frame(Refusal::UNKNOWN_JOINT,
					String("there is no joint ") + itos(joint) +
							String(": use HandTracker.JOINT_* or XRHandTracker.HAND_JOINT_*, 0..25"));
		}
		if (values[i].get_type() != Variant::VECTOR3) {
			return refuse_frame(Refusal::NO_PLACE,
					String("joints must map HandTracker.JOINT_* to a Vector3; that of joint ") + itos(joint) +
							String(" is of type ") + type_of(values[i]));
		}
		r_frame.skeleton.set(
				static_cast<steadyhand::SkeletonJoint>(joint), to_core(static_cast<Vector3>(values[i])));
	}
	r_frame.hand = steadyhand::hand_frame_of(r_frame.skeleton, 0.0);
	return OK;
}

/// If all frames are refused as older, the hand is lost, as without frames.
Error HandTracker::refuse_older(double p_time_s) {
	const Error refused = refuse_frame(Refusal::OLDER,
			String("the time ") + String::num(p_time_s) + String(" s is before ") + String::num(time_s_) +
					String(" s, the time of the last frame. Call start() when the device's clock is reset"));
	refused_from_s_ = std::min(p_time_s, refused_from_s_.value_or(p_time_s));
	if (p_time_s - *refused_from_s_ > NO_FRAME_AFTER_S) {
		set_hand_present(false);
	}
	return refused;
}

Error HandTracker::refuse_frame(Refusal p_refusal, const String &p_reason) {
	const auto this_one = static_cast<uint8_t>(1U << static_cast<unsigned>(p_refusal));
	if ((reported_refusals_.fetch_or(this_one) & this_one) == 0) {
		// Only the main thread may get the path of a node in the tree.
		const String label = p_refusal == Refusal::OTHER_THREAD ? String("HandTracker") : node_label(*this);
		ERR_PRINT(label + String(": push_frame: ") + p_reason + String(" (reported once per run)"));
	}
	return ERR_INVALID_PARAMETER;
}

/// Warns once per run of frames in which no gesture can be recognised.
void HandTracker::check_stream(const steadyhand::HandFrame &p_frame) {
	const std::optional<steadyhand::StreamFault> fault = stream_check_.push(p_frame);
	if (!fault) {
		return;
	}
	const auto this_one = static_cast<uint8_t>(1U << static_cast<unsigned>(*fault));
	if ((reported_stream_faults_ & this_one) == 0) {
		reported_stream_faults_ |= this_one;
		WARN_PRINT(node_label(*this) + String(": push_frame: ") + to_godot(steadyhand::explain(*fault)));
	}
}

} // namespace godot
