// What GestureHMM says of settings by which nothing would be recognised.

#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "node_label.h"

#include "gesture/feature.h"
#include "gesture/gesture_model.h"

#include <godot_cpp/core/error_macros.hpp>

#include <utility>

namespace godot {

namespace {

/// Frames with a hand in them: two seconds of a usual tracker's.
constexpr int FRAMES_WATCHED = 200;

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

/// Of what keeps it from recognising; once, however often it is made anew.
void GestureHMM::warn_of_silence() {
	String warning;
	if (models_.is_empty()) {
		warning = "nothing will be recognised, since it has no models";
	}
	for (int64_t i = 0; i < models_.size(); ++i) {
		const Ref<GestureModel> model = models_[i];
		if (model.is_valid() && model->core() != nullptr && !is_usable(model)) {
			warning = String("the model of '") + String(model->get_gesture()) +
					String("' needs the feature '") + model->get_feature() +
					String("', which this version does not have");
		}
	}
	const std::size_t usable = find_usable().size();
	if (usable == 0 && warning == String()) {
		warning = "nothing will be recognised, since none of its models holds a gesture";
	}
	int64_t tasks = 0;
	for (int64_t i = 0; i < tasks_.size() && warning == String(); ++i) {
		const GestureTask *const task = task_at(i);
		if (task == nullptr) {
			continue;
		}
		++tasks;
		if (task->get_gesture() == StringName() && usable > 1) {
			warning = String("the place of a task is not used, since it does not say which of "
							 "the ") +
					String::num_int64(static_cast<int64_t>(usable)) +
					String(" models it is for; set the GestureTask's \"gesture\"");
		} else if (task->get_gesture() != StringName() && !has_model_of(task->get_gesture())) {
			warning = String("nothing will be recognised at a task, since none of its models is of the "
							 "gesture '") +
					String(task->get_gesture()) + String("'");
		} else if (const String fault = place_fault(*task); fault != String()) {
			warning = fault;
		}
	}
	if (warning == String() && tasks == 0 && !tasks_.is_empty()) {
		warning = "nothing will be recognised, since none of its tasks is there any more; set "
				  "\"tasks\" to others, or to an empty array for gestures anywhere";
	}
	if (warning == String() && taskless_fault() != String()) {
		warning = taskless_fault();
	}
	if (warning != String() && warning != warned_) {
		WARN_PRINT(node_label(*this) + String(": ") + warning);
	}
	warned_ = std::move(warning);
}

/// Of a tracker that never shows what a task's gesture, or the only one, is measured by; once for each such
/// joint. Where several are waited for anywhere, that some cannot come may be meant.
void GestureHMM::watch_joints(uint8_t p_tracked) {
	joints_seen_ |= p_tracked;
	if (p_tracked == 0 || ++frames_with_hand_ != FRAMES_WATCHED) {
		return;
	}
	for (const Expected &one : expected_) {
		const uint8_t needed = steadyhand::find_feature(one.model->feature)->joints;
		const uint8_t missed = needed & ~joints_seen_;
		const bool is_waited_for = one.place.has_value() || expected_.size() == 1;
		if (!is_waited_for || (missed & ~joints_missed_) == 0) {
			continue;
		}
		joints_missed_ |= missed;
		WARN_PRINT(node_label(*this) + String(": nothing is recognised of '") + String(one.gesture) +
				String("', which is measured by ") + joint_list(needed) + String(": no frame has held ") +
				joint_list(missed));
	}
}

String GestureHMM::place_fault(const GestureTask &p_task) const {
	const std::vector<Expected> usable = find_usable();
	for (const Expected &one : usable) {
		// As find_expected() uses the place.
		const bool is_for_it = p_task.get_gesture() == StringName() ? usable.size() == 1
																	: p_task.get_gesture() == one.gesture;
		if (!is_for_it) {
			continue;
		}
		const steadyhand::Task place = core_task(p_task, *one.model);
		if (steadyhand::find_feature(one.model->feature)->is_radius) {
			if (place.start_m.x() <= 0.0) {
				return String("Set \"start_radius\" of the task of '") + String(one.gesture) +
						String("' to the radius at its start; it is 0.");
			}
		} else if (!place.start_m.allFinite()) {
			return String("Place ") + node_label(p_task) + String(", the task of '") + String(one.gesture) +
					String("': its global position is not finite.");
		} else if (place.axis.isZero()) {
			return String("Set \"direction\" of the task of '") + String(one.gesture) +
					String("' to the way the hand moves; it is zero.");
		}
	}
	return String();
}

String GestureHMM::taskless_fault() const {
	for (const Expected &one : find_expected()) {
		if (!one.place && steadyhand::find_feature(one.model->feature)->place == nullptr) {
			return String("Add a GestureTask of '") + String(one.gesture) +
					String("' to \"tasks\": its motion is measured about the task's start, and without one "
						   "it "
						   "is not recognised.");
		}
	}
	return String();
}

} // namespace godot
