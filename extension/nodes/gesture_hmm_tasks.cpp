// Gestures that GestureHMM expects, with their tasks: its models and the scene's tasks.

#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"
#include "node_label.h"

#include "gesture/feature.h"
#include "recognition/gesture_recogniser.h"

#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace godot {

namespace {

/// Changes without an ended gesture before the warning. Fewer are usual: a script may set properties one by
/// one, or move a task to its place in steps.
constexpr int TASK_CHANGES_WARNED = 100;
/// Smaller moves of a task are ignored, such as the jitter of a physics body. They are below a tracker's
/// resolution.
constexpr double SAME_PLACE_M = 1e-3;
constexpr double SAME_AXIS = 0.01; ///< rad

bool is_same_place(const steadyhand::Task &p_task, const steadyhand::Task &p_other) {
	return (p_task.start_m - p_other.start_m).norm() < SAME_PLACE_M &&
			(p_task.axis - p_other.axis).norm() < SAME_AXIS &&
			std::abs(p_task.amplitude_m - p_other.amplitude_m) < SAME_PLACE_M;
}

} // namespace

GestureTask *GestureHMM::task_at(int64_t p_index) const {
	return Object::cast_to<GestureTask>(tasks_[p_index].get_validated_object());
}

GestureTask *GestureHMM::task_of(int p_expected) const {
	return p_expected >= 0 ? Object::cast_to<GestureTask>(ObjectDB::get_instance(
									 expected_[static_cast<std::size_t>(p_expected)].task))
						   : nullptr;
}

GestureTask *GestureHMM::get_current_task() const {
	return task_of(shown_.gesture);
}

bool GestureHMM::is_usable(const Ref<GestureModel> &p_model) {
	return p_model.is_valid() && p_model->core() != nullptr &&
			steadyhand::find_feature(p_model->core()->feature) != nullptr;
}

steadyhand::Task GestureHMM::core_task(const GestureTask &p_task, const steadyhand::GestureModel &p_model) {
	if (steadyhand::find_feature(p_model.feature)->is_radius) {
		// A radius does not depend on the node's transform.
		return { Eigen::Vector3d(p_task.get_start_radius(), 0.0, 0.0), Eigen::Vector3d::UnitX(),
			p_task.get_amplitude() };
	}
	return { to_core(p_task.get_start()), to_core(p_task.get_axis()).normalized(), p_task.get_amplitude() };
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
	bool has_task = false; // a task selects the gestures
	for (int64_t i = 0; i < tasks_.size(); ++i) {
		const GestureTask *const task = task_at(i);
		// With several models, the gesture of this task is ambiguous.
		if (task != nullptr && task->get_gesture() == StringName() && anywhere.size() != 1) {
			continue;
		}
		has_task = true;
		if (task == nullptr) {
			continue;
		}
		for (const Expected &one : anywhere) {
			const steadyhand::Task place = core_task(*task, *one.model);
			const bool is_for_task =
					task->get_gesture() == StringName() || task->get_gesture() == one.gesture;
			if (is_for_task && steadyhand::is_place(place.start_m)) {
				at_tasks.push_back({ one.model, one.gesture, ObjectID(task->get_instance_id()), place });
			}
		}
	}
	return has_task ? at_tasks : anywhere;
}

std::vector<GestureHMM::Expected> GestureHMM::find_new_expected() const {
	std::vector<Expected> expected = find_expected();
	for (Expected &one : expected) {
		const auto place = one.place;
		for (const Expected &before : expected_) {
			const bool is_same = before.task == one.task && before.model == one.model;
			if (is_same && place && before.place && is_same_place(*before.place, *place)) {
				one.place = before.place;
			}
		}
	}
	return expected;
}

std::vector<steadyhand::ExpectedGesture> GestureHMM::core_of(const std::vector<Expected> &p_expected) {
	std::vector<steadyhand::ExpectedGesture> gestures;
	gestures.reserve(p_expected.size());
	for (const Expected &one : p_expected) {
		gestures.push_back({ one.model, one.place });
	}
	return gestures;
}

void GestureHMM::build_recogniser() {
	expected_changed_ = false;
	std::vector<Expected> expected = find_expected();
	frames_with_hand_ = expected == expected_ ? frames_with_hand_ : 0;
	expected_ = std::move(expected);
	warn_of_settings();
	restart_task_watch();
	recogniser_ = std::make_unique<steadyhand::GestureRecogniser>(core_of(expected_),
			steadyhand::Synthesis{ static_cast<steadyhand::MotionMode>(mode_),
					steadyhand::hypotheses_of(static_cast<steadyhand::Quality>(quality_)),
					sensor_latency_s_ });
	recogniser_->set_min_confidence(min_confidence_);
	recogniser_->set_completion(completion_);
	recogniser_->set_start_condition(start_);
}

/// Gestures at unchanged tasks and models continue.
void GestureHMM::update_expected() {
	expected_changed_ = false;
	std::vector<Expected> expected = find_new_expected();
	if (expected == expected_) {
		warn_of_settings(); // the settings may be wrong in another way than before
		return;
	}
	++build_;
	const std::size_t before = recogniser_->shown();
	const std::vector<int> now = recogniser_->expect(core_of(expected));
	const bool is_motion_continued =
			before < now.size() && now[before] == static_cast<int>(recogniser_->shown());
	frames_with_hand_ = 0;
	const StringName gesture = get_gesture();
	GestureTask *const task = get_current_task();
	expected_ = std::move(expected);
	warn_of_settings();
	restart_task_watch();
	const int shown = shown_.gesture >= 0 ? now[static_cast<std::size_t>(shown_.gesture)] : -1;
	if (shown >= 0) {
		shown_.gesture = shown;
	}
	const Watch watch(listeners_);
	if (!is_motion_continued) {
		listeners_.call(&MotionListener::on_motion_ended);
	}
	if (shown < 0 && !watch.is_destroyed()) {
		abort_shown(gesture, task);
	}
}

/// A freed node emits no signal.
bool GestureHMM::is_task_freed() const {
	return std::any_of(expected_.begin(), expected_.end(), [](const Expected &one) {
		return one.task.is_valid() && ObjectDB::get_instance(one.task) == nullptr;
	});
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
	TypedArray<GestureTask> tasks = tasks_.duplicate();
	for (int64_t i = 0; i < tasks.size(); ++i) {
		if (task_at(i) == nullptr) {
			tasks[i] = Variant(); // Node.duplicate() and PackedScene.pack() would use pointers to freed nodes
		}
	}
	tasks.make_read_only();
	return tasks;
}

void GestureHMM::set_tasks(const TypedArray<GestureTask> &p_tasks) {
	connect_tasks(false);
	tasks_ = p_tasks.duplicate();
	connect_tasks(true);
	on_expected_changed();
}

void GestureHMM::connect_tasks(bool p_connect) {
	for (int64_t i = 0; i < tasks_.size(); ++i) {
		GestureTask *const task = task_at(i);
		if (task != nullptr) {
			Array arguments;
			arguments.push_back(task->get_instance_id());
			connect_changed(
					task, callable_mp(this, &GestureHMM::on_task_changed).bindv(arguments), p_connect);
		}
	}
}

/// False may also mean unknown: expected_ does not have the task yet, or several models have its gesture.
bool GestureHMM::is_as_expected(const GestureTask &p_task) const {
	bool is_expected = false;
	for (const Expected &one : expected_) {
		if (one.task != ObjectID(p_task.get_instance_id())) {
			continue;
		}
		if (p_task.get_gesture() != one.gesture || !one.place ||
				!is_same_place(*one.place, core_task(p_task, *one.model))) {
			return false;
		}
		is_expected = true;
	}
	return is_expected;
}

/// Godot reports a moved node at the end of the frame, when the new place may already be in use. If many
/// tasks move together, the first report handles all of them.
void GestureHMM::on_task_changed(uint64_t p_task) {
	const GestureTask *const task = Object::cast_to<GestureTask>(ObjectDB::get_instance(p_task));
	if (!outdated_ && ((task != nullptr && is_as_expected(*task)) || find_new_expected() == expected_)) {
		return;
	}
	// Without a recogniser in use (in the editor, or before the first frame), nothing restarts.
	if (!outdated_ && ++task_changes_ == TASK_CHANGES_WARNED) {
		const String label = task != nullptr ? node_label(*task) : String("a GestureTask");
		WARN_PRINT(node_label(*this) + String(": ") + label +
				" keeps moving, and each move restarts its gesture. Do not make it a child of the object "
				"that the gesture moves");
	}
	on_expected_changed();
}

void GestureHMM::on_expected_changed() {
	update_configuration_warnings();
	if (emitting_ > 0) {
		expected_changed_ = true;
	} else if (!outdated_) {
		update_expected();
	}
}

} // namespace godot
