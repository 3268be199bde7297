// Warnings of GestureHMM about frames and movements from which nothing is recognised.

#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "hand_source.h"
#include "hand_tracker.h"
#include "node_label.h"

#include "gesture/feature.h"
#include "gesture/gesture_model.h"
#include "tracking/frame.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>

namespace godot {

namespace {

/// Frames with a hand, about two seconds of a usual tracker.
constexpr int FRAMES_WATCHED = 200;
/// A device is found within this time.
constexpr double LONGEST_WITHOUT_FRAME_S = 5.0;
/// Within this time a player has raised a hand, or laid the controllers aside.
constexpr double LONGEST_WITHOUT_HAND_S = 20.0;
/// Limit of a game frame's duration that counts as waiting. A longer frame loads something.
constexpr double LONGEST_WAIT_S = 0.1;
/// m. A longer distance has another unit.
constexpr double LONGEST_DISTANCE_M = 10.0;

String joint_list(uint8_t p_joints) {
	String names;
	for (std::size_t i = 0; i < steadyhand::JOINT_COUNT; ++i) {
		if ((p_joints >> i & 1U) != 0) {
			names += (names == String() ? String() : String(", ")) + to_godot(steadyhand::JOINT_NAMES[i]);
		}
	}
	return names;
}

} // namespace

/// Warns once if a running tracker shows no hand. Checked in each frame until a hand appears.
void GestureHMM::watch_tracker(double p_passed_s) {
	if (tracker_ == nullptr || joints_seen_ != 0) {
		set_process_internal(false);
		if (tracker_ == nullptr) {
			WARN_PRINT(node_label(*this) +
					": no gesture is recognised. Set its \"tracker\", or make it a child of a HandTracker");
		}
		return;
	}
	const bool is_forgotten = !tracker_->is_inside_tree() && !has_frame_ && !tracker_->is_running();
	const bool is_processing = tracker_->is_inside_tree() && tracker_->can_process();
	const Ref<HandSource> source = tracker_->get_source();
	// Other sources report missing frames themselves, or end.
	const bool is_waited_for = source.is_null() || source->is_script() || has_frame_;
	const bool is_stopped = source.is_valid() && !tracker_->is_running();
	if (!is_forgotten && (!is_processing || is_stopped || !is_waited_for)) {
		return;
	}
	waited_s_ += std::min(p_passed_s, LONGEST_WAIT_S);
	if (waited_s_ < (has_frame_ ? LONGEST_WITHOUT_HAND_S : LONGEST_WITHOUT_FRAME_S)) {
		return;
	}
	set_process_internal(false);
	has_warned_of_no_hand_ = true;
	const String label = node_label(*tracker_);
	String fix = "Set its \"source\", for example to an XRSource";
	if (is_forgotten) {
		fix = "It is not in the scene. Add it by add_child()";
	} else if (source.is_valid()) {
		fix = source->no_frame_advice();
	}
	const String none = has_frame_ ? String("no hand for 20 s: all frames of ") + label + " are empty"
								   : String("no frame for 5 s from ") + label;
	WARN_PRINT(node_label(*this) + String(": ") + none + String(". ") + fix);
}

/// Restarts the checks for another tracker, or stops them for none.
void GestureHMM::restart_tracker_watch() {
	joints_seen_ = joints_warned_ = 0;
	has_frame_ = false;
	waited_s_ = 0.0;
	if (is_node_ready()) {
		const bool is_playing = !Engine::get_singleton()->is_editor_hint();
		set_process_internal(is_playing && tracker_ != nullptr && !has_warned_of_no_hand_);
	}
}

/// Warns once for each joint that a task's gesture or the start condition needs and the tracker never shows.
/// Without a task it warns only if no model has all its joints, because a tracker of the index tip may be
/// used with all models.
void GestureHMM::watch_joints(uint8_t p_tracked) {
	joints_seen_ |= p_tracked;
	if (p_tracked == 0 || ++frames_with_hand_ != FRAMES_WATCHED) {
		return;
	}
	const auto joints_of = [](const Expected &one) {
		return steadyhand::find_feature(one.model->feature)->joints;
	};
	const bool is_any_possible = std::ranges::any_of(
			expected_, [&](const Expected &one) { return (joints_of(one) & ~joints_seen_) == 0; });
	for (const Expected &one : expected_) {
		if (one.place.has_value() || !is_any_possible) {
			warn_of_missing_joints(
					String("'") + String(one.gesture) + String("' is not recognised. It needs "),
					joints_of(one));
		}
	}
	warn_of_missing_joints(
			"no gesture starts. \"start_condition\" needs ", steadyhand::StartCondition::joints(start_.kind));
}

void GestureHMM::warn_of_missing_joints(const String &p_what, uint8_t p_needed) {
	const uint8_t missing = p_needed & ~joints_seen_;
	if ((missing & ~joints_warned_) == 0) {
		return;
	}
	joints_warned_ |= missing;
	WARN_PRINT(node_label(*this) + String(": ") + p_what + joint_list(p_needed) + String("; no frame had ") +
			joint_list(missing) + String(". Use a source that has these joints"));
}

void GestureHMM::restart_task_watch() {
	std::vector<steadyhand::Task> places;
	watched_tasks_.clear();
	for (const Expected &one : expected_) {
		const steadyhand::Feature &feature = *steadyhand::find_feature(one.model->feature);
		if (one.place && feature.direction != nullptr && !feature.is_radius) {
			places.push_back(*one.place);
			watched_tasks_.push_back(one.task);
		}
	}
	task_watch_.expect(places);
}

/// Warns once of a task that the hand never approaches, or whose direction the hand never takes.
void GestureHMM::watch_tasks(const steadyhand::HandFrame &p_frame) {
	const std::optional<steadyhand::TaskFault> fault = task_watch_.push(p_frame);
	if (!fault) {
		return;
	}
	const auto *const task =
			Object::cast_to<GestureTask>(ObjectDB::get_instance(watched_tasks_[fault->task]));
	if (task == nullptr) {
		return;
	}
	String reason = String("no gesture starts at ") + node_label(*task);
	if (fault->kind == steadyhand::TaskFault::Kind::FAR) {
		reason += String(": the fingertip has come no nearer to its start than ") +
				String::num(fault->distance_m, 2) +
				String(fault->distance_m > LONGEST_DISTANCE_M
								? " m. Give the source's positions in metres, or move the GestureTask"
								: " m. Move the GestureTask, or set the source's space to that of the task");
	} else {
		reason += String(": the hand leaves its start towards ") +
				Variant(to_godot(fault->direction)).stringify() + String(", but its direction is ") +
				Variant(task->get_axis()).stringify() +
				String(" in the world. Turn the GestureTask, or set its \"direction\"");
	}
	WARN_PRINT(node_label(*this) + String(": ") + reason);
}

} // namespace godot
