#pragma once

#include "gesture/feature_track.h"
#include "motion/filtered_motion.h"
#include "motion/output_blend.h"
#include "recognition/gesture_session.h"
#include "recognition/gesture_spotter.h"
#include "recognition/start_condition.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace steadyhand {

/// A gesture to recognise. Several ones may have the same model and different tasks.
struct ExpectedGesture {
	std::shared_ptr<const GestureModel> model;
	std::optional<Task> task; ///< nullopt: without a task

	bool operator==(const ExpectedGesture &) const = default;
};

/// Recognises several gestures in one stream of frames: which one is active, in which state, and its motion.
/// Only the constructor and expect() allocate.
class GestureRecogniser {
public:
	explicit GestureRecogniser(std::vector<ExpectedGesture> gestures, const Synthesis &synthesis = {});

	/// Least confidence() at which a gesture without a task is shown, and may end: 0..1. A low one gives more
	/// false alarms, a high one later starts.
	void set_min_confidence(double probability) { min_confidence_ = probability; }

	/// A gesture with a task also ends if the hand stops beyond this fraction of the amplitude, 0.5..1.
	void set_completion(double share);

	/// A gesture that starts while the condition is not met is not shown and does not end. An active gesture
	/// goes on.
	void set_start_condition(const StartSettings &settings) { start_condition_ = StartCondition(settings); }
	[[nodiscard]] const StartCondition &start_condition() const { return start_condition_; }

	/// Replaces the gestures. Those that were expected before keep their state. New ones begin as before a
	/// first frame; the present movement of an active or ended gesture does not start them. Returns the new
	/// index of each former gesture; -1 if it is removed.
	std::vector<int> expect(std::vector<ExpectedGesture> gestures);

	/// A frame with an earlier or non-finite time, or equal to the last one, is ignored.
	void push(const HandFrame &frame);
	/// Advances to t_s; ignored if it is not later than time_s(). The shown gesture changes only in push(),
	/// advance() and expect(). A gesture that is shown and aborted within one call is not noticed.
	void advance(double t_s);

	/// Motion at time_s().
	[[nodiscard]] Motion motion(MotionSource source) const { return motion(source, time_s_); }
	/// Motion predicted for t_s, not before time_s().
	[[nodiscard]] Motion motion(MotionSource source, double t_s) const;

	/// Index of the shown gesture, active or ended; -1 if there is none.
	[[nodiscard]] int gesture() const { return leader_; }
	[[nodiscard]] const GestureSession *session() const {
		return leader_ >= 0 ? sessions_[static_cast<std::size_t>(leader_)].get() : nullptr;
	}
	/// Index of the gesture whose motion is shown. While gesture() is -1, the one with the nearest start; the
	/// first one without tasks.
	[[nodiscard]] std::size_t shown() const { return shown_; }
	/// Probability, 0..1, of the shown gesture among all gestures and none; 0 if gesture() is -1.
	[[nodiscard]] double confidence() const;
	/// Time of the last push() or advance().
	[[nodiscard]] double time_s() const { return time_s_; }

private:
	Synthesis synthesis_;
	std::vector<ExpectedGesture> gestures_;
	std::vector<FeatureTrack> tracks_;  ///< one for each feature
	std::vector<std::size_t> track_of_; ///< per session: index into tracks_
	/// Spots the gestures without a task, for their sessions; nullptr if there are none.
	std::unique_ptr<GestureSpotter> spotter_;
	std::vector<std::unique_ptr<GestureSession>> sessions_;
	std::vector<FilteredMotion> filtered_; ///< one per session
	double min_confidence_ = 0.0;
	double completion_ = END_LEVEL;
	StartCondition start_condition_;
	/// The last start of a session: its onset, and whether the start condition was met.
	struct Start {
		double onset_s = -INFINITY;
		bool is_allowed = true;
	};
	std::vector<Start> starts_; ///< one per session
	int leader_ = -1;
	std::size_t shown_ = 0; ///< the leader, if there is one
	OutputBlend blend_;     ///< of the step to another shown gesture, m
	HandFrame last_frame_{ .t_s = -INFINITY };
	SymbolClock clock_; ///< of the sessions
	double time_s_ = -INFINITY;
	double ended_s_ = -INFINITY; ///< time of the last reported end

	void expect_spotted();
	void track_features();
	[[nodiscard]] const FeatureTrack &track(std::size_t session) const { return tracks_[track_of_[session]]; }
	/// Steps all sessions through the instants of the symbols, up to t_s.
	void step_sessions(double t_s);
	void update_gestures();
	[[nodiscard]] double posterior(std::size_t session) const;
	[[nodiscard]] double log_odds(std::size_t session) const { return sessions_[session]->log_odds(); }
	/// The start condition was met, and the confidence is high enough, so that the gesture may be shown and
	/// end.
	[[nodiscard]] bool may_show(std::size_t session) const;
	/// Checks the start condition at each onset, and aborts gestures whose pinch opens.
	void judge_starts();
	/// Index of the candidate with the greatest log odds; -1 if there is none. is_candidate: f(index).
	template <class Predicate> [[nodiscard]] int likeliest(Predicate is_candidate) const;
	/// Both have tasks with a straight path, and the end of `other` is beside the path of `one`: its distance
	/// from the end of `one` is greater across that path than along it.
	[[nodiscard]] bool ends_off_path(std::size_t one, std::size_t other) const;
	void decide_ends();
	void report_end();
	void choose_leader();
	void set_leader(int session);
	[[nodiscard]] std::size_t nearest() const;
	std::optional<Motion> show_nearest(double t_s);
	void blend_from(const Motion &before, double rate_per_s);
	[[nodiscard]] Motion synthesised(double t_s) const;
};

template <class Predicate> int GestureRecogniser::likeliest(Predicate is_candidate) const {
	int best = -1;
	double best_odds = -INFINITY;
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (is_candidate(i) && log_odds(i) > best_odds) {
			best = static_cast<int>(i);
			best_odds = log_odds(i);
		}
	}
	return best;
}

} // namespace steadyhand
