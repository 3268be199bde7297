#include "gesture_hmm.h"

#include "conversions.h"
#include "gesture_task.h"

#include "gesture/feature.h"
#include "motion/gesture_recogniser.h"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>
#include <optional>

namespace godot {

namespace {

/// The paper controls the vibration at 1 kHz.
constexpr double CONTROL_RATE_HZ = 1000.0;
/// After a gap this long in the stamps nothing that was recognised still holds.
constexpr double LONGEST_GAP_S = 10.0;

steadyhand::Task core_task(const GestureTask &p_task) {
	const double radius_m = p_task.get_start_radius();
	return { radius_m > 0.0 ? Eigen::Vector3d(radius_m, 0.0, 0.0) : to_core(p_task.get_start()),
		to_core(p_task.get_axis()).normalized(), p_task.get_amplitude() };
}

} // namespace

void GestureHMM::reset() {
	outdated = true;
	recognised = StringName();
	const bool was_active = shown.state >= 0;
	shown = {};
	if (was_active) {
		emit_signal(names.state_changed, -1);
	}
}

void GestureHMM::build_recogniser() {
	GestureTask *const task = get_task();
	const StringName wanted = task != nullptr ? task->get_gesture() : StringName();
	std::vector<std::shared_ptr<const steadyhand::GestureModel>> active;
	active_gestures.clear();
	for (int64_t i = 0; i < models.size(); ++i) {
		const Ref<GestureModel> model = models[i];
		if (model.is_null() || model->core() == nullptr ||
				(wanted != StringName() && wanted != model->get_gesture())) {
			continue;
		}
		if (steadyhand::find_feature(model->core()->feature) == nullptr) {
			ERR_PRINT(String("GestureHMM: the model of '") + String(model->get_gesture()) +
					String("' needs the feature '") + model->get_feature() +
					String("', which this version does not have"));
			continue;
		}
		active.push_back(model->core());
		active_gestures.push_back(model->get_gesture());
	}
	if (active.empty() && models.size() > 0) {
		WARN_PRINT(String("GestureHMM: nothing will be recognised, since none of its models is of the "
						  "gesture '") +
				String(wanted) + String("'"));
	}
	const std::optional<steadyhand::Task> known =
			task != nullptr ? std::optional(core_task(*task)) : std::nullopt;
	rest_amplitude_m = 1.0;
	if (known) {
		rest_amplitude_m = known->amplitude_m;
	} else if (!active.empty()) {
		rest_amplitude_m = active.front()->typical_task.amplitude_m;
	}
	recogniser = std::make_unique<steadyhand::GestureRecogniser>(std::move(active), known);
}

void GestureHMM::prepare(double p_time_s) {
	if (recogniser && std::abs(p_time_s - time_s) > LONGEST_GAP_S) {
		reset();
	}
	if (!outdated) {
		return;
	}
	outdated = false;
	++build;
	build_recogniser();
	next_instant = static_cast<int64_t>(std::ceil(p_time_s * CONTROL_RATE_HZ));
	time_s = p_time_s;
	listeners.call(&MotionListener::on_motion_started);
}

void GestureHMM::run_clock(double p_time_s, bool p_up_to_and_including) {
	const uint64_t this_build = build;
	// A script that is told of an instant may change settings, or push the next frame.
	while (build == this_build && !outdated) {
		const double instant_s = static_cast<double>(next_instant) / CONTROL_RATE_HZ;
		if (instant_s > p_time_s || (instant_s == p_time_s && !p_up_to_and_including)) {
			break;
		}
		++next_instant;
		recogniser->advance(instant_s);
		time_s = instant_s;
		publish();
	}
}

void GestureHMM::on_frame(const steadyhand::HandFrame &p_frame) {
	prepare(p_frame.t_s);
	// An instant before this frame must not see it.
	run_clock(p_frame.t_s, false);
	prepare(p_frame.t_s);
	recogniser->push(p_frame);
	time_s = std::max(time_s, p_frame.t_s);
}

void GestureHMM::on_time_advanced(double p_time_s) {
	prepare(p_time_s);
	run_clock(p_time_s, true);
	if (!outdated) {
		recogniser->advance(p_time_s);
		time_s = std::max(time_s, p_time_s);
	}
}

void GestureHMM::publish() {
	const steadyhand::GestureFollower *follower = recogniser->follower();
	const bool under_way =
			follower != nullptr && follower->stage() != steadyhand::GestureFollower::Stage::RESTING;
	const Shown before = shown;
	shown.model = under_way ? recogniser->gesture() : -1;
	shown.state = under_way ? follower->state() : -1;
	shown.arrived = under_way && follower->stage() == steadyhand::GestureFollower::Stage::ARRIVED;
	const bool started = under_way && shown.model != before.model;
	const bool ended = shown.arrived && (started || !before.arrived);
	const bool state_changed = started || shown.state != before.state;
	// The scripts that are told may change all of this.
	const double instant_s = time_s;
	const int state = shown.state;
	const StringName gesture = started || ended ? gesture_name(shown.model) : StringName();
	if (ended) {
		recognised = gesture;
	}
	if (!listeners.empty()) {
		listeners.call(&MotionListener::on_motion, instant_s, current(motion).value_m / amplitude_m());
	}
	if (started) {
		emit_signal(names.gesture_started, gesture);
	}
	if (state_changed) {
		emit_signal(names.state_changed, state);
	}
	if (ended) {
		emit_signal(names.gesture_ended, gesture, instant_s);
	}
	if (has_connections(names.motion_updated)) {
		emit_signal(names.motion_updated, instant_s);
	}
}

steadyhand::Motion GestureHMM::current(Motion p_motion) const {
	return recogniser && !outdated ? recogniser->motion(static_cast<steadyhand::MotionSource>(p_motion))
								   : steadyhand::Motion{};
}

double GestureHMM::amplitude_m() const {
	const steadyhand::GestureFollower *follower = recogniser->follower();
	return follower != nullptr ? follower->task().amplitude_m : rest_amplitude_m;
}

double GestureHMM::get_value() const {
	return current(motion).value_m;
}

double GestureHMM::get_velocity() const {
	return current(motion).velocity_m_s;
}

double GestureHMM::get_acceleration() const {
	return current(motion).acceleration_m_s2;
}

double GestureHMM::get_progress() const {
	return current(motion).progress;
}

double GestureHMM::get_motion_value(Motion p_motion) const {
	ERR_FAIL_INDEX_V(static_cast<int>(p_motion), MOTION_KALMAN + 1, 0.0);
	return current(p_motion).value_m;
}

} // namespace godot
