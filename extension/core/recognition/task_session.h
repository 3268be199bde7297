#pragma once

#include "gesture/motion_element.h"
#include "recognition/gesture_session.h"
#include "recognition/hand_presence.h"
#include "recognition/rest_wander.h"
#include "strokes/task_strokes.h"

#include <cmath>

namespace steadyhand {

/// A gesture with a task. The estimator decides when it starts and ends, and the strokes whether it was the
/// gesture. In `paper` mode value and velocity start it.
class TaskSession final : public GestureSession {
public:
	TaskSession(const GestureModel &model, const Task &task, const Synthesis &synthesis);

	void set_completion(double share) override { completion_ = share; }
	void follow_hand(double t_s) override { followed_s_ = t_s; }
	void locate(const FeaturePlace &place_m) override {
		start_distance_m_ = strokes_.start_distance_m(place_m);
		path_distance_m_ = strokes_.path_distance_m(place_m);
	}
	[[nodiscard]] double start_distance_m() const override;
	void ignore_before(double t_s) override { strokes_.ignore_before(t_s); }
	void abort(double t_s) override;
	[[nodiscard]] bool is_near_end() const override;

private:
	MotionElement element_;
	double completion_ = END_LEVEL;
	TaskStrokes strokes_;
	RestWander wander_; ///< of the motion element at rest
	HandPresence hand_;
	double start_distance_m_ = INFINITY; ///< of a straight task
	double path_distance_m_ = INFINITY;
	double followed_s_ = -INFINITY; ///< when the hand was last near, or the motion shown
	bool is_rejected_ = false;      ///< the movement was no gesture: nothing starts before the return
	double likely_s_ = 0.0;         ///< when P(gesture) was last above the threshold of a start
	double at_end_since_s_ = 0.0;
	double furthest_ = 0.0;       ///< greatest estimated value of a tracked hand since the start
	double moved_s_ = 0.0;        ///< when P(hold) was last small
	double beyond_s_ = -INFINITY; ///< when the value was last greater than at a return

	std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) override;
	void update_stage(double t_s, const StrokeFinder &strokes) override;
	void judge(const StrokeFinder &strokes);
	void update_nearness(double t_s);
	[[nodiscard]] bool is_straight() const { return feature().path_distance_m == nullptr; }
	/// From where the gesture may start: on a circle, anywhere.
	[[nodiscard]] double away_m() const { return is_straight() ? start_distance_m_ : path_distance_m_; }
	[[nodiscard]] bool is_near() const;
	[[nodiscard]] bool has_gone_elsewhere() const;
	[[nodiscard]] bool has_been_elsewhere(double t_s) const;
	[[nodiscard]] bool has_started(double t_s) const;
	[[nodiscard]] bool is_known(double t_s, const StrokeFinder &strokes) const;
	[[nodiscard]] bool has_returned(double t_s) const;
	/// To be called at each step while ACTIVE.
	[[nodiscard]] bool has_aborted(double t_s);
	void follow_stop(double t_s);
	[[nodiscard]] bool has_stopped(double t_s) const;
	void try_end(double t_s);
	void go_idle(double t_s);
	void lose(double t_s);
};

} // namespace steadyhand
