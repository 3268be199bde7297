#pragma once

#include "gesture/motion_element.h"
#include "recognition/gesture_session.h"
#include "recognition/hand_presence.h"
#include "recognition/rest_wander.h"
#include "strokes/task_strokes.h"

#include <cmath>

namespace steadyhand {

/// Follows a gesture whose task is known: what is put out says when it begins and arrives, and the strokes
/// whether it was the gesture.
class TaskSession final : public GestureSession {
public:
	TaskSession(const GestureModel &model, const Task &task, const Synthesis &synthesis);

	void set_completion(double share) override { completion_ = share; }
	void follow_hand(double t_s) override { followed_s_ = t_s; }
	void locate(const FeaturePlace &place_m) override {
		off_start_m_ = strokes_.off_start_m(place_m);
		off_way_m_ = strokes_.off_way_m(place_m);
	}
	[[nodiscard]] double off_start_m() const override;
	void ignore_before(double t_s) override { strokes_.ignore_before(t_s); }
	void abort(double t_s) override;
	[[nodiscard]] bool is_near_end() const override;

private:
	MotionElement element_;
	double completion_ = END_LEVEL;
	TaskStrokes strokes_;
	RestWander wander_; ///< of what is measured before the gesture
	HandPresence hand_;
	double off_start_m_ = INFINITY; ///< of a straight way
	double off_way_m_ = INFINITY;
	double followed_s_ = -INFINITY; ///< when there was last a reason to follow the hand
	bool is_rejected_ = false;      ///< what was under way was none: nothing begins before the hand is back
	double likely_s_ = 0.0;         ///< when what is under way was last likelier than none
	double at_end_since_s_ = 0.0;
	double furthest_ = 0.0;       ///< that a hand which is seen has come since it began
	double moved_s_ = 0.0;        ///< when it last did not hold still
	double beyond_s_ = -INFINITY; ///< when a gesture was last shown further than a hand that is back

	std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) override;
	void update_stage(double t_s, const StrokeFinder &strokes) override;
	void update_nearness(double t_s);
	[[nodiscard]] bool is_straight() const { return feature().off_way_m == nullptr; }
	/// From where the gesture may begin: all about a way that is not straight.
	[[nodiscard]] double away_m() const { return is_straight() ? off_start_m_ : off_way_m_; }
	/// So that the gesture may begin.
	[[nodiscard]] bool is_near() const;
	[[nodiscard]] bool has_gone_elsewhere() const;
	[[nodiscard]] bool has_been_elsewhere(double t_s) const;
	[[nodiscard]] bool has_started(double t_s) const;
	[[nodiscard]] bool is_known(double t_s, const StrokeFinder &strokes) const;
	[[nodiscard]] bool has_returned(double t_s) const;
	/// To be asked at each step of a gesture under way, as the next one.
	[[nodiscard]] bool has_aborted(double t_s);
	void follow_stop(double t_s);
	[[nodiscard]] bool has_stopped(double t_s) const;
	void try_end(double t_s);
	void go_idle(double t_s);
	void lose(double t_s);
};

} // namespace steadyhand
