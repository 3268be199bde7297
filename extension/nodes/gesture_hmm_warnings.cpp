// Warnings of GestureHMM about settings with which nothing is recognised, in the log and in the editor.

#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "hand_tracker.h"
#include "node_label.h"
#include "parent_as.h"

#include "gesture/feature.h"
#include "gesture/gesture_model.h"
#include "recognition/hmm_session.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <utility>

namespace godot {

namespace {

/// m. A longer length or distance has another unit.
constexpr double LONGEST_WAY_M = 10.0;
/// Cosine of 60 degrees.
constexpr double AS_TRAINED = 0.5;

/// Whether a task has the default direction, but its gesture was trained in another one.
bool is_undirected(const GestureTask &p_task, const steadyhand::GestureModel &p_model) {
	const Vector3 right(1, 0, 0);
	const bool goes_right = to_core(p_task.get_axis()).isApprox(to_core(right), 1e-3);
	const auto is_trained = [&](const Eigen::Vector3d &axis) {
		return to_core(right).dot(axis) >= AS_TRAINED;
	};
	return goes_right && p_task.get_direction() == right && !is_trained(p_model.typical_task.axis) &&
			std::ranges::none_of(p_model.other_axes, is_trained);
}

} // namespace

/// Warns of settings that prevent recognition. Prints each warning once, even if the recogniser is rebuilt.
void GestureHMM::warn_of_settings() {
	String warning;
	if (models_.is_empty()) {
		warning = "no gesture is recognised, because \"models\" is empty. Set it to an array of *.gesture "
				  "files of res://addons/steadyhand/models";
	}
	for (int64_t i = 0; i < models_.size(); ++i) {
		const Ref<GestureModel> model = models_[i];
		if (model.is_valid() && model->core() != nullptr && !is_usable(model)) {
			warning = String("the model of '") + String(model->get_gesture()) +
					String("' needs the feature '") + model->get_feature() +
					String("', which this version does not have. Update the add-on, or remove the model");
		}
	}
	const std::size_t usable = find_usable().size();
	if (usable == 0 && warning == String()) {
		warning =
				"no gesture is recognised, because all \"models\" are empty. Load a *.gesture file into them";
	}
	int64_t tasks = 0;
	for (int64_t i = 0; i < tasks_.size() && warning == String(); ++i) {
		const GestureTask *const task = task_at(i);
		if (task == nullptr) {
			continue;
		}
		++tasks;
		if (task->get_gesture() == StringName() && usable > 1) {
			warning = node_label(*task) + String(" is not used, because it names none of the ") +
					String::num_int64(static_cast<int64_t>(usable)) + String(" models. Set its \"gesture\"");
		} else if (task->get_gesture() != StringName() && !has_model_of(task->get_gesture())) {
			warning = String("no gesture is recognised at ") + node_label(*task) +
					String(", because \"models\" has none of '") + String(task->get_gesture()) +
					String("'. Add it, or set the task's \"gesture\" to another one");
		} else if (const String fault = place_fault(*task); fault != String()) {
			warning = fault;
		}
	}
	if (warning == String() && tasks == 0 && !tasks_.is_empty()) {
		warning = "no gesture is recognised, because all of its \"tasks\" are null or were freed. Set "
				  "\"tasks\" to others, or to an empty array for gestures anywhere";
	}
	if (warning == String()) {
		warning = taskless_fault();
	}
	if (warning == String()) {
		warning = start_fault();
	}
	if (warning != String() && warning != warned_) {
		WARN_PRINT(node_label(*this) + String(": ") + warning);
	}
	warned_ = std::move(warning);
}

PackedStringArray GestureHMM::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (tracker_ == nullptr && parent_as<HandTracker>(*this) == nullptr) {
		warnings.push_back(
				"Set \"tracker\" to the HandTracker whose hand makes the gestures, or make this node "
				"its child.");
	}
	bool has_empty = false;
	for (int64_t i = 0; i < models_.size(); ++i) {
		const Ref<GestureModel> model = models_[i];
		has_empty = has_empty || model.is_null() || model->core() == nullptr;
	}
	if (models_.is_empty()) {
		warnings.push_back("Add a GestureModel to \"models\": a *.gesture file of "
						   "res://addons/steadyhand/models, or one "
						   "of your own from a GestureTrainer.");
	}
	for (int64_t i = 0; i < tasks_.size() && !models_.is_empty(); ++i) {
		const GestureTask *const task = task_at(i);
		if (task == nullptr) {
			warnings.push_back("Remove the empty entry of \"tasks\", or choose a GestureTask for it.");
		} else if (task->get_gesture() != StringName() && !has_model_of(task->get_gesture())) {
			warnings.push_back(String("Add the model of '") + String(task->get_gesture()) +
					String("' to \"models\", or set \"gesture\" of ") + node_label(*task) +
					String(" to a gesture that has a model."));
		} else if (const String fault = place_fault(*task); fault != String()) {
			warnings.push_back(fault);
		}
	}
	if (const String fault = taskless_fault(); fault != String()) {
		warnings.push_back(fault);
	}
	if (const String fault = start_fault(); fault != String()) {
		warnings.push_back(fault);
	}
	if (has_empty) {
		warnings.push_back("Remove the empty entry from \"models\", or load a *.gesture file into it.");
	}
	return warnings;
}

String GestureHMM::place_fault(const GestureTask &p_task) const {
	const std::vector<Expected> usable = find_usable();
	for (const Expected &one : usable) {
		// The same rule as in find_expected().
		const bool is_for_it = p_task.get_gesture() == StringName() ? usable.size() == 1
																	: p_task.get_gesture() == one.gesture;
		if (!is_for_it) {
			continue;
		}
		const steadyhand::Task place = core_task(p_task, *one.model);
		const steadyhand::Feature &feature = *steadyhand::find_feature(one.model->feature);
		if (place.amplitude_m > LONGEST_WAY_M) {
			return String("Set \"amplitude\" of ") + node_label(p_task) + String(" in metres, is ") +
					String::num(place.amplitude_m) + String(" m.");
		}
		if (feature.is_radius) {
			if (place.start_m.x() <= 0.0) {
				return String("Set \"start_radius\" of ") + node_label(p_task) +
						String(" to the radius of the fingertips at the start, is 0.");
			}
		} else if (!steadyhand::is_place(place.start_m)) {
			return String("Move ") + node_label(p_task) +
					String(": its global position is not finite, or beyond 1e9 m.");
		} else if (place.axis.isZero()) {
			return String("Set \"direction\" of ") + node_label(p_task) +
					String(" to the direction of the hand's motion, is zero.");
		} else if (feature.direction != nullptr && is_undirected(p_task, *one.model)) {
			return String("Set \"direction\" of ") + node_label(p_task) + String(" to that of '") +
					String(one.gesture) + String("', is (1, 0, 0), the default.");
		}
	}
	return String();
}

String GestureHMM::taskless_fault() const {
	for (const Expected &one : find_expected()) {
		if (one.place) {
			continue;
		}
		if (steadyhand::find_feature(one.model->feature)->place == nullptr) {
			return String("Add a GestureTask of '") + String(one.gesture) +
					String("' to \"tasks\": this gesture is measured from the task's start, and is not "
						   "recognised "
						   "without a task.");
		}
		if (!steadyhand::HmmSession::can_follow(one.model)) {
			return String("Train the model of '") + String(one.gesture) +
					String("' again with GestureTrainer, or add a GestureTask of it to \"tasks\": it has no "
						   "HMMs, "
						   "so it cannot be recognised without a task.");
		}
	}
	return String();
}

String GestureHMM::start_fault() const {
	for (const Expected &one : find_expected()) {
		if (start_.kind == steadyhand::StartKind::PINCH &&
				steadyhand::find_feature(one.model->feature)->is_radius) {
			return String("Set \"start_condition\" to another one than START_PINCH: '") +
					String(one.gesture) + String("' opens the fingers, which ends a pinch.");
		}
	}
	return String();
}

} // namespace godot
