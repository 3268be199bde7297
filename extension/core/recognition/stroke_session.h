#pragma once

#include "recognition/gesture_session.h"
#include "strokes/stroke_evidence.h"

#include <cmath>
#include <optional>
#include <vector>

namespace steadyhand {

/// A gesture without a task in `phase` mode, recognised by strokes. It starts where a stroke did, in any
/// direction of the model. When the stroke ends, the recogniser decides between the sessions that may_end().
/// The model's mean amplitude stands in for the task's.
class StrokeSession final : public GestureSession {
public:
	StrokeSession(const GestureModel &model, const Synthesis &synthesis);

	[[nodiscard]] bool may_end() const override { return end_.has_value(); }
	[[nodiscard]] bool is_end_predicted() const override { return end_ && end_->is_predicted; }
	[[nodiscard]] bool is_end_usual() const override { return end_ && end_->comes_back == usual_.is_strike; }
	[[nodiscard]] double strike_log_odds() const override { return strike_odds_; }
	[[nodiscard]] bool shares_path(const GestureSession &other) const override;
	[[nodiscard]] FeaturePlace axis() const override { return axis_; }
	[[nodiscard]] double best_log_odds() const override { return best_odds_; }
	[[nodiscard]] double log_odds_if(bool comes_back) const override;
	void count_end() override { set_log_odds(log_odds_if(usual_.is_strike)); }
	[[nodiscard]] bool is_return(const Stroke &stroke) const override;
	void end_gesture(double t_s) override;
	void ignore_before(double t_s) override { not_before_s_ = t_s; }
	void abort(double t_s) override;
	void on_dropout(double t_s, const StrokeFinder &strokes) override;

private:
	static constexpr double IMPOSSIBLE = -INFINITY; ///< log odds

	/// A stroke that has come to the gesture's end, and what the hand has done since then.
	struct End {
		bool is_predicted = false;               ///< the stroke goes on
		double t_s = 0.0;                        ///< when it came there
		double log_odds = 0.0;                   ///< without comes_back
		double length_m = 0.0, duration_s = 0.0; ///< of the stroke
		double value_m = 0.0;                    ///< motion element
		std::optional<bool> comes_back;          ///< empty: not known yet
		bool is_lost = false;                    ///< by the tracker: comes_back stays empty
	};

	UsualStroke usual_;
	double end_speed_share_;                    ///< speed at the end of the gesture / peak speed
	std::vector<FeaturePlace> directions_;      ///< of the model: unit vectors
	FeaturePlace start_ = FeaturePlace::Zero(); ///< of the motion element
	FeaturePlace from_ = FeaturePlace::Zero();  ///< the same, scaled as strokes are
	FeaturePlace way_ = FeaturePlace::Zero();   ///< unit vector: growth of the motion element
	FeaturePlace axis_ = FeaturePlace::Zero();  ///< the model's direction that the stroke follows

	std::optional<End> end_;
	double best_odds_ = 0.0, strike_odds_ = 0.0; ///< best_log_odds(), strike_log_odds()
	double likely_s_ = 0.0;                      ///< when a stroke was last likelier the gesture than none
	double moved_s_ = 0.0;                       ///< when that stroke last moved; since the end, any stroke
	double not_before_s_ = -INFINITY;            ///< earlier onsets belong to earlier gestures
	double furthest_ = 0.0;                      ///< length of the stroke while it was likely, amplitudes
	double hopeless_s_ = -INFINITY;              ///< when a stroke was last found to be no gesture
	double returned_s_ = -INFINITY;              ///< when the hand last returned after a gesture
	bool may_come_again_ = false;                ///< without a rest before it
	double ended_s_ = 0.0, stopped_s_ = 0.0;     ///< of the gesture; of the hand after it, predicted
	double gone_m_ = 0.0, furthest_m_ = 0.0;     ///< value of the motion element, now and at most

	std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) override;
	void look_for_start(double t_s, const StrokeFinder &strokes);
	void start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes);
	void look_for_end(double t_s, const StrokeFinder &strokes, bool is_missed = false);
	void watch_end(double t_s, const StrokeFinder &strokes);
	void look_for_return(double t_s, const StrokeFinder &strokes);
	[[nodiscard]] bool is_next(const Stroke &stroke, const StrokeFinder &strokes) const;
	[[nodiscard]] double most_odds(const Stroke &stroke) const;
	[[nodiscard]] bool goes_elsewhere(const StrokeFinder &strokes) const;
	void dismiss(double t_s);

	/// The motion element, m.
	[[nodiscard]] double along(const FeaturePlace &place) const { return (place - start_).dot(way_); }
	[[nodiscard]] bool comes_again(const Stroke &stroke) const;
	[[nodiscard]] double amplitudes(const Stroke &stroke) const;
	[[nodiscard]] FeaturePlace way_of(const Stroke &stroke) const;
	[[nodiscard]] StrokeEvidence evidence_of(
			const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) const;
	void aim(const FeaturePlace &to);
	[[nodiscard]] bool is_arriving(double t_s, const Stroke &stroke) const;
};

} // namespace steadyhand
