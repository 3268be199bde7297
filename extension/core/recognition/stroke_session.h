#pragma once

#include "recognition/gesture_session.h"
#include "strokes/stroke_evidence.h"

#include <cmath>
#include <optional>
#include <vector>

namespace steadyhand {

/// A gesture without a task in `phase` mode, recognised by strokes. It starts at the start of a stroke in any
/// direction of the model. When the stroke ends, the recogniser decides between the sessions that may_end().
/// The amplitude is the model's mean.
class StrokeSession final : public GestureSession {
public:
	StrokeSession(const GestureModel &model, const Synthesis &synthesis);

	[[nodiscard]] bool may_end() const override { return end_.has_value(); }
	[[nodiscard]] bool is_end_predicted() const override { return end_ && end_->is_predicted; }
	[[nodiscard]] bool is_end_usual() const override { return end_ && end_->comes_back == usual_.is_strike; }
	[[nodiscard]] double strike_log_odds() const override { return strike_odds_; }
	[[nodiscard]] bool shares_path(const GestureSession &other) const override;
	[[nodiscard]] FeaturePlace axis() const override { return model_direction_; }
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

	/// The end of the gesture's stroke, and the motion after it.
	struct End {
		bool is_predicted = false;               ///< the stroke has not ended
		double t_s = 0.0;                        ///< time of the end
		double log_odds = 0.0;                   ///< without the evidence of comes_back
		double length_m = 0.0, duration_s = 0.0; ///< of the stroke
		double value_m = 0.0;                    ///< motion element at the end
		std::optional<bool> comes_back;          ///< empty: not known yet
		bool is_lost = false;                    ///< dropout: comes_back stays empty
	};

	UsualStroke usual_;
	double end_speed_share_;                              ///< speed at the end of the gesture / peak speed
	std::vector<FeaturePlace> directions_;                ///< of the model: unit vectors
	FeaturePlace start_ = FeaturePlace::Zero();           ///< position at which the motion element is 0
	FeaturePlace from_ = FeaturePlace::Zero();            ///< start of the stroke, scaled
	FeaturePlace direction_ = FeaturePlace::Zero();       ///< unit vector in which the motion element grows
	FeaturePlace model_direction_ = FeaturePlace::Zero(); ///< direction of the model nearest to the stroke

	std::optional<End> end_;
	double best_odds_ = 0.0, strike_odds_ = 0.0; ///< best_log_odds(), strike_log_odds()
	double likely_s_ = 0.0;                      ///< last time at which a stroke could be the gesture
	double moved_s_ = 0.0;                   ///< last motion of such a stroke; after the end, of any stroke
	double not_before_s_ = -INFINITY;        ///< earlier onsets belong to earlier gestures
	double rejected_s_ = -INFINITY;          ///< last time at which a stroke was rejected
	double returned_s_ = -INFINITY;          ///< last return of the hand after a gesture
	bool may_repeat_ = false;                ///< after a return, the next gesture needs no rest before it
	double ended_s_ = 0.0, stopped_s_ = 0.0; ///< end of the gesture, and of the hand's motion, predicted
	double element_m_ = 0.0, max_element_m_ = 0.0; ///< motion element, present and greatest

	std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) override;
	void look_for_start(double t_s, const StrokeFinder &strokes);
	void start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes);
	void look_for_end(double t_s, const StrokeFinder &strokes, bool is_dropout = false);
	void watch_end(double t_s, const StrokeFinder &strokes);
	void look_for_return(double t_s, const StrokeFinder &strokes);
	[[nodiscard]] bool is_next(const Stroke &stroke, const StrokeFinder &strokes) const;
	void go_idle(double t_s);

	/// Motion element, m.
	[[nodiscard]] double along(const FeaturePlace &place) const { return (place - start_).dot(direction_); }
	[[nodiscard]] bool is_repetition(const Stroke &stroke) const;
	[[nodiscard]] double amplitudes(const Stroke &stroke) const;
	[[nodiscard]] FeaturePlace model_direction(const Stroke &stroke) const;
	[[nodiscard]] StrokeEvidence evidence_of(
			const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &direction) const;
	void update_direction(const FeaturePlace &to);
	[[nodiscard]] bool is_arriving(double t_s, const Stroke &stroke) const;
};

} // namespace steadyhand
