// Which gestures GestureHMM expects, and where: its models and the scene's tasks.

#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "node_label.h"

#include "gesture/feature.h"
#include "recognition/gesture_recogniser.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <utility>

namespace godot {

namespace {

/// Without a gesture in between; a script may set some properties one by one, or slide a task into its place.
constexpr int TASK_CHANGES_TOLD = 100;
/// Frames with a hand in them: two seconds of a usual tracker's.
constexpr int FRAMES_WATCHED = 200;

bool is_usable(const Ref<GestureModel> &p_model) {
	return p_model.is_valid() && p_model->core() != nullptr &&
			steadyhand::find_feature(p_model->core()->feature) != nullptr;
}

steadyhand::Task core_task(const GestureTask &p_task, const steadyhand::GestureModel &p_model) {
	if (steadyhand::find_feature(p_model.feature)->is_radius) {
		// Wherever the node is and however it is turned.
		return { Eigen::Vector3d(p_task.get_start_radius(), 0.0, 0.0), Eigen::Vector3d::UnitX(),
			p_task.get_amplitude() };
	}
	return { to_core(p_task.get_start()), to_core(p_task.get_axis()).normalized(), p_task.get_amplitude() };
}

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

GestureTask *GestureHMM::task_at(int64_t p_index) const {
	return Object::cast_to<GestureTask>(tasks_[p_index].get_validated_object());
}

GestureTask *GestureHMM::get_current_task() const {
	return shown_.gesture >= 0 ? Object::cast_to<GestureTask>(ObjectDB::get_instance(
										 expected_[static_cast<std::size_t>(shown_.gesture)].task))
							   : nullptr;
}

std::vector<GestureHMM::Expected> GestureHMM::find_usable() const {
	std::vector<Expected> anywhere;
	for (int64_t i = 0; i < models_.size(); ++i) {
		const Ref<GestureModel> model = models_[i];
		if (is_usable(model)) {
			anywhere.push_back({ model->core(), model->get_gesture(), {}, {} });
		}
	}
	return anywhere;
}

std::vector<GestureHMM::Expected> GestureHMM::find_expected() const {
	const std::vector<Expected> anywhere = find_usable();
	std::vector<Expected> at_tasks;
	bool is_told = false; // which gestures the scene requires
	for (int64_t i = 0; i < tasks_.size(); ++i) {
		const GestureTask *const task = task_at(i);
		// With several models nobody knows whose place it is.
		if (task != nullptr && task->get_gesture() == StringName() && anywhere.size() != 1) {
			continue;
		}
		is_told = true;
		if (task == nullptr) {
			continue;
		}
		for (const Expected &one : anywhere) {
			const steadyhand::Task place = core_task(*task, *one.model);
			const bool is_its = task->get_gesture() == StringName() || task->get_gesture() == one.gesture;
			if (is_its && place.start_m.allFinite()) {
				at_tasks.push_back({ one.model, one.gesture, ObjectID(task->get_instance_id()), place });
			}
		}
	}
	return is_told ? at_tasks : anywhere;
}

void GestureHMM::build_recogniser() {
	expected_ = find_expected();
	warn_of_silence();
	frames_with_hand_ = 0;
	std::vector<steadyhand::ExpectedGesture> gestures;
	gestures.reserve(expected_.size());
	for (const Expected &one : expected_) {
		gestures.push_back({ one.model, one.place });
	}
	recogniser_ = std::make_unique<steadyhand::GestureRecogniser>(std::move(gestures),
			static_cast<steadyhand::MotionMode>(mode_),
			steadyhand::phase_effort(static_cast<steadyhand::Quality>(quality_)), sensor_latency_s_);
	recogniser_->set_min_confidence(min_confidence_);
}

/// Who is freed tells nobody.
bool GestureHMM::is_task_gone() const {
	return std::any_of(expected_.begin(), expected_.end(), [](const Expected &one) {
		return one.task.is_valid() && ObjectDB::get_instance(one.task) == nullptr;
	});
}

/// Of what keeps it from recognising; once, however often it is made anew.
void GestureHMM::warn_of_silence() {
	String warning;
	if (models_.is_empty()) {
		warning = "GestureHMM: nothing will be recognised, since it has no models";
	}
	for (int64_t i = 0; i < models_.size(); ++i) {
		const Ref<GestureModel> model = models_[i];
		if (model.is_valid() && model->core() != nullptr && !is_usable(model)) {
			warning = String("GestureHMM: the model of '") + String(model->get_gesture()) +
					String("' needs the feature '") + model->get_feature() +
					String("', which this version does not have");
		}
	}
	const std::size_t usable = find_usable().size();
	if (usable == 0 && warning == String()) {
		warning = "GestureHMM: nothing will be recognised, since none of its models holds a gesture";
	}
	int64_t tasks = 0;
	for (int64_t i = 0; i < tasks_.size() && warning == String(); ++i) {
		const GestureTask *const task = task_at(i);
		if (task == nullptr) {
			continue;
		}
		++tasks;
		if (task->get_gesture() == StringName() && usable > 1) {
			warning = String("GestureHMM: the place of a task is not used, since it does not say which of "
							 "the ") +
					String::num_int64(static_cast<int64_t>(usable)) +
					String(" models it is for; set the GestureTask's \"gesture\"");
		} else if (task->get_gesture() != StringName() && !has_model_of(task->get_gesture())) {
			warning = String("GestureHMM: nothing will be recognised at a task, since none of its models is "
							 "of the "
							 "gesture '") +
					String(task->get_gesture()) + String("'");
		} else if (const String fault = place_fault(*task); fault != String()) {
			warning = String("GestureHMM: ") + fault;
		}
	}
	if (warning == String() && tasks == 0 && !tasks_.is_empty()) {
		warning = "GestureHMM: nothing will be recognised, since none of its tasks is there any more; set "
				  "\"tasks\" to others, or to an empty array for gestures anywhere";
	}
	if (warning == String() && taskless_fault() != String()) {
		warning = String("GestureHMM: ") + taskless_fault();
	}
	if (warning != String() && warning != warned_) {
		WARN_PRINT(warning);
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
		WARN_PRINT(String("GestureHMM: nothing is recognised of '") + String(one.gesture) +
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

bool GestureHMM::has_model_of(const StringName &p_gesture) const {
	for (int64_t i = 0; i < models_.size(); ++i) {
		const Ref<GestureModel> model = models_[i];
		if (model.is_valid() && model->get_gesture() == p_gesture) {
			return true;
		}
	}
	return false;
}

void GestureHMM::set_task(GestureTask *p_task) {
	TypedArray<GestureTask> tasks;
	if (p_task != nullptr) {
		tasks.push_back(p_task);
	}
	set_tasks(tasks);
}

TypedArray<GestureTask> GestureHMM::get_tasks() const {
	return tasks_.duplicate();
}

void GestureHMM::set_tasks(const TypedArray<GestureTask> &p_tasks) {
	const Callable callable = callable_mp(this, &GestureHMM::on_task_changed);
	for (int64_t i = 0; i < tasks_.size(); ++i) {
		connect_changed(task_at(i), callable, false);
	}
	tasks_ = p_tasks.duplicate();
	for (int64_t i = 0; i < tasks_.size(); ++i) {
		connect_changed(task_at(i), callable, true);
	}
	on_settings_changed();
}

/// A node tells that it was moved once the frame is over: by then the place may be in use already.
void GestureHMM::on_task_changed() {
	if (!outdated_ && find_expected() == expected_) {
		return;
	}
	// In the editor, and where nothing has been seen since, there is nothing that could start anew.
	if (!outdated_ && ++task_changes_ == TASK_CHANGES_TOLD) {
		WARN_PRINT("GestureHMM: a GestureTask keeps moving, and the recognition starts anew each time; it "
				   "must not "
				   "be a child of what the gesture moves");
	}
	on_settings_changed();
}

} // namespace godot
