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

/// How freely what a hand did may be told.
struct Leeway {
	bool is_optional = false; ///< it may be said, or not
	double late_s = 1.0;      ///< how long after its end at most
};

/// A gesture that has to be started and ended once.
struct Expected {
	int gesture; ///< index into Performance::gestures()
	double from_s, to_s;
	Leeway leeway;
};

/// A hand as it is told what to do, and what it is to be understood by. A part is of the way from the start
/// of the movement that it makes to its end, 0..1.
class Performance {
public:
	/// The hand rests at the start first.
	Performance(const Models &models, Context context, std::size_t movement, std::uint64_t seed) :
			models_(models), context_(context), draws_(31 * seed + 7),
			movement_(draw_movement(movement, context, draws_)) {
		if (is_open()) {
			for (const auto &model : models_) {
				gestures_.push_back({ model, std::nullopt });
			}
		}
		begin(movement_);
	}

	/// Anew, somewhere else.
	Performance &begin(const PlannedMovement &movement) {
		const bool is_zoom = movement.grows_circle();
		const double radius_m = is_zoom ? draws_.between(0.014, 0.02) : 0.03;
		const double z_m = draws_.between(-0.4, -0.25), y_m = draws_.between(-0.2, 0.0),
					 x_m = draws_.between(-0.15, 0.15);
		const HandPose start(x_m, y_m, z_m, radius_m);
		begin_at(start, is_zoom ? HandPoint::CIRCLE_CENTRE : HandPoint::INDEX_TIP);
		return aim(movement, start).rest(draws_.between(1.0, 1.6));
	}
	/// Anew, and nothing is asked for yet.
	Performance &begin_at(const HandPose &pose, HandPoint point = HandPoint::INDEX_TIP) {
		plan_ = HandPlan(pose, point);
		expected_.clear();
		if (!is_open()) {
			gestures_.clear();
		}
		return *this;
	}
	/// What the parts are of from here on. Where tasks are given, this one is.
	Performance &aim(const PlannedMovement &movement, const HandPose &start) {
		movement_ = movement;
		start_ = start;
		gesture_ = is_open() ? static_cast<int>(movement.gesture) : ask_for_task();
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
	/// As fast as the movement is, but not much faster where it is short.
	Performance &go_to(double part) {
		const double here = (plan_.pose() - start_).dot(movement_.direction) / movement_.amplitude_m;
		return go_to(part, movement_.duration_s * (0.3 + 0.6 * std::abs(part - here)));
	}
	/// What the hand does from here until it arrives is a gesture.
	Performance &set_out() {
		set_out_s_ = now_s();
		return *this;
	}
	Performance &arrive(const Leeway &leeway = {}) {
		expected_.push_back({ gesture_, set_out_s_, now_s(), leeway });
		return *this;
	}
	Performance &make_gesture(double duration_s, const Leeway &leeway = {}) {
		return set_out().go_to(1.0, duration_s).arrive(leeway);
	}
	/// Returns before long, rests, and makes a plain gesture, which must come as any first one does.
	Performance &end_plainly(double rest_s = 0.5, bool return_may_be_one = false) {
		rest(rest_s).set_out();
		if (plan_.pose() != start_) {
			go_to(0.0, 1.2 * movement_.duration_s);
			if (return_may_be_one && is_open() && !models_[movement_.gesture]->other_axes.empty()) {
				arrive({ .is_optional = true });
			}
		}
		rest(2.2).make_gesture(movement_.duration_s).rest(0.4);
		return go_to(0.0, 1.1 * movement_.duration_s).rest(1.3);
	}

	[[nodiscard]] bool is_open() const { return context_ == Context::OPEN; }
	[[nodiscard]] double now_s() const { return plan_.end_s(); }
	[[nodiscard]] const PlannedMovement &movement() const { return movement_; }
	[[nodiscard]] const HandPose &start() const { return start_; }
	/// As long as its gesture's model takes it to be where nothing is given.
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
	/// What the recogniser is asked for.
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
	double set_out_s_ = 0.0;
	std::vector<ExpectedGesture> gestures_;
	std::vector<Expected> expected_;

	/// Once, however often it is aimed at.
	int ask_for_task() {
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
	MovementRange movements; ///< of which the seed takes one
	void (*perform)(Performance &hand, Draws &draws);
};

} // namespace steadyhand::bench
