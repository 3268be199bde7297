#pragma once

#include "motion/filtered_motion.h"
#include "motion/output_blend.h"
#include "recognition/gesture_follower.h"
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
	std::optional<Task> task; ///< its place; nothing where the start is to be found by the hand's rest

	bool operator==(const ExpectedGesture &) const = default;
};

/// All gestures that a scene asked for, side by side on one stream of frames: says which one is under way, in
/// which state, and what motion it makes. Costs nothing for a gesture that was not asked for. Nothing is
/// allocated but by construction and expect().
class GestureRecogniser {
public:
	/// effort, latency_s: as SwitchingEstimator's; decoding: as Synthesis'.
	explicit GestureRecogniser(std::vector<ExpectedGesture> gestures, MotionMode mode = MotionMode::PHASE,
			const EstimatorEffort &effort = {}, double latency_s = 0.0, const StateDecoding &decoding = {});
	/// All at one place, or none of them.
	GestureRecogniser(const std::vector<std::shared_ptr<const GestureModel>> &models,
			const std::optional<Task> &task, MotionMode mode, const EstimatorEffort &effort = {},
			double latency_s = 0.0, const StateDecoding &decoding = {});

	/// A gesture without a task is shown, and ends, only where its confidence() has come to this: 0..1. Less
	/// shows more of what hands do otherwise, more shows gestures later.
	void set_min_confidence(double probability) { min_confidence_ = probability; }

	/// 0.5 .. 1; a gesture with a task counts as soon as it is seen to come to its end, and where the hand
	/// stops short of that from this share of the way on.
	void set_completion(double share);

	/// A gesture that begins while this is not met is not shown, and does not end. What is under way goes on.
	void set_start_condition(const StartSettings &settings) { start_condition_ = StartCondition(settings); }
	[[nodiscard]] const StartCondition &start_condition() const { return start_condition_; }

	/// From now on these: what goes on at those that were expected before goes on, be they as they were, and
	/// the others begin as with a first frame, which is where the motion steps to if the one shown goes. Of a
	/// stroke that has ended as a gesture no other is made; nor of one that makes a gesture which stays.
	/// Returns the index of each that was expected before; -1: it is no longer.
	std::vector<int> expect(std::vector<ExpectedGesture> gestures);

	/// Time stamps must not decrease; a frame that is older than the last one, the same once more, or not
	/// finite, is passed over.
	void push(const HandFrame &frame);
	/// Everything that is due by t_s, which must not be before an earlier one (it is taken as that then).
	void advance(double t_s);

	/// At the time advanced to. Depends on frames stamped at or before it, and on nothing else; where several
	/// gestures are under way, on the instants advanced to as well, by which their lead is handed over. A
	/// gesture that begins and ends between two of these is not shown.
	[[nodiscard]] Motion motion(MotionSource source) const { return motion(source, time_s_); }
	/// What it will be at t_s, not before that time, if nothing is seen until then.
	[[nodiscard]] Motion motion(MotionSource source, double t_s) const;

	/// Index of the gesture under way or just finished; -1 while there is none, or none that may be shown.
	[[nodiscard]] int gesture() const { return leader_; }
	[[nodiscard]] const GestureFollower *follower() const {
		return leader_ >= 0 ? followers_[static_cast<std::size_t>(leader_)].get() : nullptr;
	}
	/// Index of the one whose motion is shown: while none is under way, that of the task to whose start the
	/// hand is nearest; without tasks the first.
	[[nodiscard]] std::size_t shown() const { return shown_; }
	/// Probability that the gesture under way, or just finished, is what the hand does, among all models and
	/// none: 0..1; 0 while none is shown.
	[[nodiscard]] double confidence() const;
	[[nodiscard]] double time_s() const { return time_s_; }

private:
	/// 1/s: from one gesture's motion to another's within a tenth of a second.
	static constexpr double LEAD_RATE_PER_S = 50.0;

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
	std::vector<std::size_t> watched_by_; ///< per follower: index into watched_
	/// In `paper` mode, of the gestures without a task that its HMMs include; followers look at it.
	std::unique_ptr<GestureSpotter> spotter_;
	std::vector<std::unique_ptr<GestureFollower>> followers_;
	std::vector<FilteredMotion> filtered_; ///< one per follower
	double min_confidence_ = 0.0;
	double completion_ = END_LEVEL;
	StartCondition start_condition_;
	/// Of the last gesture that a follower began: which one, and whether it may be shown.
	struct Start {
		std::uint32_t begun = 0;
		bool is_allowed = true;
	};
	std::vector<Start> starts_; ///< one per follower
	int leader_ = -1;
	std::size_t shown_ = 0; ///< the leader, while there is one
	OutputBlend blend_;     ///< of what would step when another one takes the lead, m
	HandFrame last_frame_{ .t_s = -INFINITY };
	double time_s_;
	double next_absence_s_ = INFINITY;  ///< when one of GestureFollower::ABSENCES_S is over next
	double last_absence_s_ = -INFINITY; ///< when one last was
	double ended_begun_s_ = -INFINITY;  ///< when the last of those shown that have arrived began

	void expect_spotted();
	void watch_features();
	[[nodiscard]] const WatchedFeature &watched(std::size_t follower) const {
		return watched_[watched_by_[follower]];
	}
	/// With what becomes of gestures whose hand is not seen any more.
	void advance_followers(double t_s);
	void step_followers(double t_s);
	void expect_absence();
	[[nodiscard]] double posterior(std::size_t follower) const;
	/// GestureFollower::log_odds, less what speaks for another one of which this one's motion is a part.
	[[nodiscard]] double log_odds(std::size_t follower) const;
	/// Allowed to begin, and likely enough to be shown, and to end.
	[[nodiscard]] bool may_show(std::size_t follower) const;
	/// Asks the start condition once of each gesture that begins, and gives up those whose pinch opens.
	void judge_starts();
	/// Index of the one of greatest log odds among the candidates; -1 where there are none. is_candidate:
	/// f(index).
	template <class Predicate> [[nodiscard]] int likeliest(Predicate is_candidate) const;
	/// Of tasks with a straight way to a place: further from the end of `one` across its way than along it.
	[[nodiscard]] bool ends_to_the_side(std::size_t one, std::size_t other) const;
	void decide_claims();
	void let_return();
	void settle();
	void choose_leader();
	void lead(int follower);
	[[nodiscard]] std::size_t nearest() const;
	std::optional<Motion> show_nearest(double t_s);
	void go_on_from(const Motion &before, double rate_per_s);
	[[nodiscard]] Motion synthesised(double t_s) const;
};

template <class Predicate> int GestureRecogniser::likeliest(Predicate is_candidate) const {
	int best = -1;
	double best_odds = -INFINITY;
	for (std::size_t i = 0; i < followers_.size(); ++i) {
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
