#pragma once

#include "motion/filtered_motion.h"
#include "motion/output_blend.h"
#include "recognition/gesture_session.h"
#include "recognition/gesture_spotter.h"
#include "recognition/start_condition.h"
#include "strokes/stroke_finder.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace steadyhand {

/// A gesture that a scene asks for. A model may be expected at several places.
struct ExpectedGesture {
	std::shared_ptr<const GestureModel> model;
	std::optional<Task> task; ///< its place; nothing: anywhere

	bool operator==(const ExpectedGesture &) const = default;
};

/// All gestures that a scene asked for, on one stream of frames: which one is active, in which state, and
/// its motion. Nothing is allocated but by construction and expect().
class GestureRecogniser {
public:
	/// effort, latency_s: as SwitchingEstimator's; decoding: as Synthesis'.
	explicit GestureRecogniser(std::vector<ExpectedGesture> gestures, MotionMode mode = MotionMode::PHASE,
			const EstimatorEffort &effort = {}, double latency_s = 0.0, const StateDecoding &decoding = {});
	/// All at one place, or none of them.
	GestureRecogniser(const std::vector<std::shared_ptr<const GestureModel>> &models,
			const std::optional<Task> &task, MotionMode mode, const EstimatorEffort &effort = {},
			double latency_s = 0.0, const StateDecoding &decoding = {});

	/// A gesture without a task is shown, and ends, only from this confidence() on: 0..1. A small one gives
	/// more false alarms, a great one shows gestures later.
	void set_min_confidence(double probability) { min_confidence_ = probability; }

	/// 0.5 .. 1; a gesture with a task also ends where the hand stops from this fraction of the amplitude on.
	void set_completion(double share);

	/// A gesture that starts while this is not met is not shown, and does not end. An active one goes on.
	void set_start_condition(const StartSettings &settings) { start_condition_ = StartCondition(settings); }
	[[nodiscard]] const StartCondition &start_condition() const { return start_condition_; }

	/// From now on these. Those that were expected before go on unchanged; the others begin as with a first
	/// frame. The movement of a gesture that is active or has ended makes no other one. Returns the index of
	/// each that was expected before; -1: it is no longer.
	std::vector<int> expect(std::vector<ExpectedGesture> gestures);

	/// A frame that is older than the last one, equals it, or is not finite, is ignored.
	void push(const HandFrame &frame);
	/// Everything that is due by t_s; an earlier time than the last is ignored.
	void advance(double t_s);

	/// At the time advanced to, of the frames until then. If several gestures are active, the one that is
	/// shown changes at the instants advanced to. A gesture that starts and ends between two of these is not
	/// shown.
	[[nodiscard]] Motion motion(MotionSource source) const { return motion(source, time_s_); }
	/// Predicted for t_s, not before that time.
	[[nodiscard]] Motion motion(MotionSource source, double t_s) const;

	/// Index of the gesture that is active or has ended; -1 while there is none, or none that may be shown.
	[[nodiscard]] int gesture() const { return leader_; }
	[[nodiscard]] const GestureSession *session() const {
		return leader_ >= 0 ? sessions_[static_cast<std::size_t>(leader_)].get() : nullptr;
	}
	/// Index of the one whose motion is shown: while none is active, that of the task to whose start the hand
	/// is nearest; without tasks the first.
	[[nodiscard]] std::size_t shown() const { return shown_; }
	/// Probability of the gesture that is active or has ended, among all models and none: 0..1; 0 while none
	/// is shown.
	[[nodiscard]] double confidence() const;
	[[nodiscard]] double time_s() const { return time_s_; }

private:
	Synthesis synthesis_;
	std::vector<ExpectedGesture> gestures_;
	struct WatchedFeature {
		const Feature *feature;
		StrokeFinder strokes;
		std::optional<FeaturePlace> place; ///< in the newest frame
		FeaturePlace displacement_m;       ///< of the tracker, as of the newest place
		TrackerMonitor monitor;
		Measurement measurement; ///< the newest frame's

		void push(const HandFrame &frame);
		/// Without the tracker's displacement.
		[[nodiscard]] std::optional<FeaturePlace> hand() const {
			return place ? std::optional<FeaturePlace>(*place - displacement_m) : std::nullopt;
		}
	};

	std::vector<WatchedFeature> watched_; ///< each feature once, however many gestures use it
	std::vector<std::size_t> watched_by_; ///< per session: index into watched_
	/// In `paper` mode, of the gestures without a task that its HMMs include; sessions read it.
	std::unique_ptr<GestureSpotter> spotter_;
	std::vector<std::unique_ptr<GestureSession>> sessions_;
	std::vector<FilteredMotion> filtered_; ///< one per session
	double min_confidence_ = 0.0;
	double completion_ = END_LEVEL;
	StartCondition start_condition_;
	/// Of the last gesture that a session began: which one, and whether it may be shown.
	struct Start {
		std::uint32_t begun = 0;
		bool is_allowed = true;
	};
	std::vector<Start> starts_; ///< one per session
	int leader_ = -1;
	std::size_t shown_ = 0; ///< the leader, while there is one
	OutputBlend blend_;     ///< of the step when another one is shown, m
	HandFrame last_frame_{ .t_s = -INFINITY };
	double time_s_;
	double next_absence_s_ = INFINITY;   ///< when one of GestureSession::ABSENCES_S is over next
	double last_absence_s_ = -INFINITY;  ///< when one last was
	double ended_started_s_ = -INFINITY; ///< when the last gesture started whose end was shown

	void expect_spotted();
	void watch_features();
	[[nodiscard]] const WatchedFeature &watched(std::size_t session) const {
		return watched_[watched_by_[session]];
	}
	/// Including dropouts.
	void advance_sessions(double t_s);
	void step_sessions(double t_s);
	void expect_absence();
	[[nodiscard]] double posterior(std::size_t session) const;
	/// GestureSession::log_odds, as gestures are compared by it.
	[[nodiscard]] double log_odds(std::size_t session) const {
		return compared(session, sessions_[session]->log_odds());
	}
	/// Log odds of a gesture, less if its motion is a part of another gesture, or a strike too slow beside
	/// another gesture.
	[[nodiscard]] double compared(std::size_t session, double log_odds) const;
	/// Nats against a gesture whose motion is a part of another gesture.
	[[nodiscard]] double part_penalty(std::size_t session) const;
	/// Allowed to start, and likely enough to be shown, and to end.
	[[nodiscard]] bool may_show(std::size_t session) const;
	/// Asks the start condition once of each gesture that starts, and aborts those whose pinch opens.
	void judge_starts();
	/// Aborts gestures without a task whose motion is clearly a part of another gesture, or of its return.
	void abort_parts();
	/// The hand comes back from the end of another gesture of the same feature.
	[[nodiscard]] bool returns_from_other(std::size_t session) const;
	/// Index of the one of greatest log odds among the candidates; -1 where there are none. is_candidate:
	/// f(index).
	template <class Predicate> [[nodiscard]] int likeliest(Predicate is_candidate) const;
	/// Of tasks with a straight path: the end of `other` is further off the path of `one` than along it.
	[[nodiscard]] bool ends_to_the_side(std::size_t one, std::size_t other) const;
	/// The end of this session is unusual, and another gesture, whose stroke goes on, may become likelier.
	[[nodiscard]] bool may_become_other(std::size_t best) const;
	void decide_ends();
	void settle();
	void choose_leader();
	void lead(int session);
	[[nodiscard]] std::size_t nearest() const;
	std::optional<Motion> show_nearest(double t_s);
	void go_on_from(const Motion &before, double rate_per_s);
	[[nodiscard]] Motion synthesised(double t_s) const;
};

template <class Predicate> int GestureRecogniser::likeliest(Predicate is_candidate) const {
	int best = -1;
	double best_odds = -INFINITY;
	for (std::size_t i = 0; i < sessions_.size(); ++i) {
		if (!is_candidate(i)) {
			continue;
		}
		if (const double odds = log_odds(i); odds > best_odds) {
			best = static_cast<int>(i);
			best_odds = odds;
		}
	}
	return best;
}

} // namespace steadyhand
