#pragma once

#include "../models.h"
#include "draws.h"
#include "hand_plan.h"
#include "movements.h"
#include "recognition/gesture_recogniser.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace steadyhand::bench {

/// Tolerance for the events of a gesture.
struct Leeway {
	bool is_optional = false; ///< the gesture may be recognised or not
	double late_s = 1.0;      ///< most time from the true end to the event
};

/// A gesture that must start and end once.
struct Expected {
	int gesture; ///< index into Performance::gestures()
	double from_s, to_s;
	Leeway leeway;
};

/// Plan of a hand, and the events that are expected. `part`: position in the present movement, 0 at its start
/// and 1 at its end.
class Performance {
public:
	/// Begins with a rest at the start.
	Performance(const Models &models, Context context, std::size_t movement, std::uint64_t seed) :
			models_(models), context_(context), draws_(31 * seed + 7),
			movement_(draw_movement(movement, context, draws_)) {
		if (!has_task()) {
			for (const auto &model : models_) {
				gestures_.push_back({ model, std::nullopt });
			}
		}
		begin(movement_);
	}

	/// Starts over at a random place.
	Performance &begin(const PlannedMovement &movement) {
		const bool is_zoom = movement.grows_circle();
		const double radius_m = is_zoom ? draws_.between(0.014, 0.02) : 0.03;
		const double z_m = draws_.between(-0.4, -0.25), y_m = draws_.between(-0.2, 0.0),
					 x_m = draws_.between(-0.15, 0.15);
		const HandPose start(x_m, y_m, z_m, radius_m);
		begin_at(start, is_zoom ? HandPoint::CIRCLE_CENTRE : HandPoint::INDEX_TIP);
		return aim(movement, start).rest(draws_.between(1.0, 1.6));
	}
	/// Starts over at a pose, without expected gestures.
	Performance &begin_at(const HandPose &pose, HandPoint point = HandPoint::INDEX_TIP) {
		plan_ = HandPlan(pose, point);
		expected_.clear();
		if (has_task()) {
			gestures_.clear();
		}
		return *this;
	}
	/// Sets the present movement. With tasks, its task becomes active.
	Performance &aim(const PlannedMovement &movement, const HandPose &start) {
		movement_ = movement;
		start_ = start;
		gesture_ = has_task() ? expect_task() : static_cast<int>(movement.gesture);
		return *this;
	}

	Performance &rest(double duration_s) {
		plan_.rest(duration_s);
		return *this;
	}
	Performance &rest_until(double t_s) { return rest(std::max(0.0, t_s - now_s())); }
	Performance &go(const HandPose &pose, double duration_s) {
		plan_.go(pose, duration_s);
		return *this;
	}
	Performance &go_to(double part, double duration_s) {
		return go(start_ + part * movement_.amplitude_m * movement_.direction, duration_s);
	}
	/// Duration in proportion to the movement's own, with a constant part for short distances.
	Performance &go_to(double part) {
		const double here = (plan_.pose() - start_).dot(movement_.direction) / movement_.amplitude_m;
		return go_to(part, movement_.duration_s * (0.3 + 0.6 * std::abs(part - here)));
	}
	/// The motion from here to end_gesture() is a gesture.
	Performance &begin_gesture() {
		begin_s_ = now_s();
		return *this;
	}
	Performance &end_gesture(const Leeway &leeway = {}) {
		expected_.push_back({ gesture_, begin_s_, now_s(), leeway });
		return *this;
	}
	Performance &make_gesture(double duration_s, const Leeway &leeway = {}) {
		return begin_gesture().go_to(1.0, duration_s).end_gesture(leeway);
	}
	/// Returns to the start, rests, and makes a plain gesture, which must be recognised as usual.
	Performance &add_plain_gesture(double rest_s = 0.5, bool return_is_optional_gesture = false) {
		rest(rest_s).begin_gesture();
		if (plan_.pose() != start_) {
			go_to(0.0, 1.2 * movement_.duration_s);
			if (return_is_optional_gesture && !has_task() &&
					!models_[movement_.gesture]->other_axes.empty()) {
				end_gesture({ .is_optional = true });
			}
		}
		rest(2.2).make_gesture(movement_.duration_s).rest(0.4);
		return go_to(0.0, 1.1 * movement_.duration_s).rest(1.3);
	}

	[[nodiscard]] bool has_task() const { return context_ == Context::WITH_TASK; }
	[[nodiscard]] double now_s() const { return plan_.end_s(); }
	[[nodiscard]] const PlannedMovement &movement() const { return movement_; }
	[[nodiscard]] const HandPose &start() const { return start_; }
	/// The movement with the model's typical amplitude.
	[[nodiscard]] PlannedMovement typical(PlannedMovement movement) const {
		movement.amplitude_m = models_[movement.gesture]->typical_task.amplitude_m;
		return movement;
	}
	[[nodiscard]] PlannedMovement draw(std::size_t movement) {
		return draw_movement(movement, context_, draws_);
	}
	[[nodiscard]] Draws &draws() { return draws_; }
	[[nodiscard]] HandPlan &plan() { return plan_; }
	[[nodiscard]] const HandPlan &plan() const { return plan_; }
	/// Gestures of the recogniser.
	[[nodiscard]] const std::vector<ExpectedGesture> &gestures() const { return gestures_; }
	[[nodiscard]] const std::vector<Expected> &expected() const { return expected_; }

private:
	const Models &models_;
	Context context_;
	Draws draws_;
	PlannedMovement movement_;
	HandPose start_ = HandPose::Zero();
	HandPlan plan_{ start_ };
	int gesture_ = 0;
	double begin_s_ = 0.0;
	std::vector<ExpectedGesture> gestures_;
	std::vector<Expected> expected_;

	/// Adds the task of the present movement, unless it is there. Returns its index.
	int expect_task() {
		Task task;
		task.amplitude_m = movement_.amplitude_m;
		if (movement_.grows_circle()) {
			task.start_m = Eigen::Vector3d(start_(3), 0.0, 0.0);
		} else {
			task.start_m = start_.head<3>();
			task.axis = movement_.axis();
		}
		const auto &model = models_[movement_.gesture];
		const auto known = std::ranges::find_if(gestures_,
				[&](const ExpectedGesture &asked) { return asked.model == model && asked.task == task; });
		const auto index = static_cast<int>(known - gestures_.begin());
		if (known == gestures_.end()) {
			gestures_.push_back({ model, task });
		}
		return index;
	}
};

struct HandKind {
	const char *name;
	MovementRange movements; ///< the seed selects one
	void (*perform)(Performance &hand, Draws &draws);
};

} // namespace steadyhand::bench
