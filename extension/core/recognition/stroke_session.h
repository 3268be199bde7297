#pragma once

#include "recognition/gesture_session.h"
#include "strokes/stroke_evidence.h"

#include <cmath>
#include <vector>

namespace steadyhand {

/// Follows a gesture whose task is not known. Strokes say all: the start is where one began, either way of
/// the model's axis may be meant, and the session claims a stroke when it ends, for the recogniser to decide
/// between claims. The model's mean amplitude stands in for the task's.
class StrokeSession final : public GestureSession {
public:
	StrokeSession(const GestureModel &model, const Synthesis &synthesis);

	[[nodiscard]] bool may_end() const override { return may_end_; }
	void end_gesture(double t_s) override;
	void ignore_before(double t_s) override { not_before_s_ = t_s; }
	void abort(double t_s) override;
	void on_dropout(double t_s, const StrokeFinder &strokes) override;

private:
	static constexpr double IMPOSSIBLE = -INFINITY; ///< log odds
	/// Strokes, amplitudes: shorter ones do not say where they go, and from the other on they are well under
	/// way.
	static constexpr double SHORTEST = 0.12, WELL_UNDER_WAY = 0.3;
	/// log odds, at the best that may come, below which a stroke is none.
	static constexpr double HOPELESS = -8.0;

	double end_speed_share_; ///< of the peak speed: what a hand still has where the gesture ends
	std::vector<FeaturePlace> directions_;      ///< in which the model was trained: unit vectors
	FeaturePlace start_ = FeaturePlace::Zero(); ///< of the motion element
	FeaturePlace from_ = FeaturePlace::Zero();  ///< the same, as strokes count it
	FeaturePlace way_ = FeaturePlace::Zero();   ///< unit vector of the motion element's growth
	FeaturePlace axis_ = FeaturePlace::Zero();  ///< the model's, in the sense of the stroke

	bool may_end_ = false;
	double likely_s_ = 0.0;           ///< when a stroke last looked like the gesture
	double moved_s_ = 0.0;            ///< when such a one was last on its way
	double not_before_s_ = -INFINITY; ///< strokes that began earlier are done with
	double furthest_ = 0.0;           ///< that it came while it looked so, amplitudes
	double hopeless_s_ = -INFINITY;   ///< when one was last found to be none
	double returned_s_ = -INFINITY;   ///< when the hand was last on its way back after the gesture
	bool may_come_again_ = false;     ///< without a rest: the first one's, or none, was seen
	double slowed_odds_ = -INFINITY;  ///< log odds of the whole stroke, the best since it slowed down
	FeaturePlace slowed_at_ = FeaturePlace::Zero(); ///< where that was, as strokes count it
	double ended_s_ = 0.0, stopped_s_ = 0.0;        ///< when the gesture ended, and the hand stopped, or will
	double gone_m_ = 0.0, furthest_m_ = 0.0;        ///< along the way, since the start

	std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) override;
	void look_for_start(double t_s, const StrokeFinder &strokes);
	void start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes);
	void look_for_end(double t_s, const StrokeFinder &strokes, bool is_missed = false);
	void look_for_return(double t_s, const StrokeFinder &strokes);
	[[nodiscard]] bool is_next(const Stroke &stroke, const StrokeFinder &strokes) const;
	[[nodiscard]] double most_odds(const Stroke &stroke) const;
	[[nodiscard]] bool goes_elsewhere(const StrokeFinder &strokes) const;
	void dismiss(double t_s);

	/// How far a place is along the way, m.
	[[nodiscard]] double along(const FeaturePlace &place) const { return (place - start_).dot(way_); }
	[[nodiscard]] bool comes_again(const Stroke &stroke) const;
	[[nodiscard]] double amplitudes(const Stroke &stroke) const;
	[[nodiscard]] FeaturePlace way_of(const Stroke &stroke) const;
	[[nodiscard]] StrokeEvidence evidence_of(
			const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) const;
	void aim(const FeaturePlace &to);
	[[nodiscard]] bool is_near_end(const Stroke &stroke) const;
	[[nodiscard]] bool is_arriving(double t_s, const Stroke &stroke) const;
};

} // namespace steadyhand
