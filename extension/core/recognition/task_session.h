#pragma once

#include "gesture/motion_element.h"
#include "recognition/gesture_session.h"
#include "recognition/rest_drift.h"
#include "recognition/task_evidence.h"

#include <cmath>

namespace steadyhand {

/// A gesture with a task. The estimator decides when it starts and ends, and the evidence decides whether
/// it was the gesture. In `paper` mode it starts by value and velocity.
class TaskSession final : public GestureSession {
public:
	TaskSession(const GestureModel &model, const Task &task, const Synthesis &synthesis);

	void set_completion(double share) override { completion_ = share; }
	void follow_hand(double t_s) override { followed_s_ = t_s; }
	void locate(const FeaturePlace &place_m) override {
		start_distance_m_ = evidence_.start_distance_m(place_m);
		path_distance_m_ = evidence_.path_distance_m(place_m);
	}
	[[nodiscard]] double start_distance_m() const override;
	void ignore_before(double t_s) override { evidence_.ignore_before(t_s); }
	void abort(double t_s) override;
	[[nodiscard]] bool is_near_end() const override;

private:
	MotionElement element_;
	double completion_ = END_LEVEL;
	TaskEvidence evidence_;
	RestDrift drift_;                    ///< of the motion element at rest
	double last_s_ = INFINITY;           ///< newest frame with a value of the feature
	double found_s_ = -INFINITY;         ///< first such frame after a dropout
	double on_path_s_ = -INFINITY;       ///< last such frame near the path
	double start_distance_m_ = INFINITY; ///< for a straight task
	double path_distance_m_ = INFINITY;
	double followed_s_ = -INFINITY; ///< last time at which the hand was near, or the motion shown
	bool is_rejected_ = false;      ///< the movement was no gesture: nothing starts before the return
	double likely_s_ = 0.0;         ///< last time of P(gesture) > START_PROBABILITY
	double at_end_since_s_ = 0.0;
	double max_value_ = 0.0;      ///< greatest estimated value of a tracked hand since the start
	double moved_s_ = 0.0;        ///< last time of P(hold) <= STOP_PROBABILITY, or without a measurement
	double beyond_s_ = -INFINITY; ///< last time of a value >= RETURNED

	std::optional<double> measure(const HandFrame &frame, const FeatureTrack &track) override;
	void update_stage(double t_s, const FeatureTrack &track) override;
	void judge();
	void update_presence(double t_s);
	[[nodiscard]] bool is_recent(double t_s) const { return t_s - last_s_ <= parameters::sessions::RECENT_S; }
	/// A dropout has just ended.
	[[nodiscard]] bool is_just_found(double t_s) const {
		return t_s - found_s_ <= parameters::sessions::RECENT_S;
	}
	/// Time for which the tracked hand has been away from the path.
	[[nodiscard]] double off_path_s() const { return last_s_ - on_path_s_; }
	[[nodiscard]] bool is_straight() const { return feature().path_distance_m == nullptr; }
	/// Distance from the positions where the gesture may start: the start, or any point of a circle.
	[[nodiscard]] double distance_m() const { return is_straight() ? start_distance_m_ : path_distance_m_; }
	[[nodiscard]] bool is_near() const;
	[[nodiscard]] bool has_left_path() const;
	[[nodiscard]] bool is_estimate_wrong(double t_s) const;
	[[nodiscard]] bool has_started(double t_s) const;
	[[nodiscard]] bool is_end_observed(double t_s, const FeatureTrack &track) const;
	[[nodiscard]] bool has_returned(double t_s) const;
	/// Must be called at each step while ACTIVE.
	[[nodiscard]] bool has_aborted(double t_s);
	void update_stop(double t_s);
	[[nodiscard]] bool has_stopped(double t_s) const;
	void try_end(double t_s);
	void go_idle(double t_s);
	void lose(double t_s);
};

} // namespace steadyhand
