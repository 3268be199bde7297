#pragma once

#include "gesture/gesture_model.h"
#include "gesture/motion_element.h"
#include "gesture/observation.h"
#include "gesture/symbol_clock.h"
#include "gesture/task.h"
#include "hmm/state_decoder.h"
#include "motion/motion.h"
#include "motion/output_blend.h"
#include "motion/paper_synthesiser.h"
#include "motion/phase_estimator.h"
#include "motion/stroke_evidence.h"

#include <cmath>

namespace steadyhand {

/// Follows one gesture through a stream of frames: waits at rest, spots the start, decodes the states, plays
/// the motion out, holds its end until the hand has come back. Strokes that do not look like the gesture are
/// let alone. Time is the frames' own; after construction nothing is allocated.
///
/// Where the task is known, the synthesiser says when the gesture begins and arrives, and the stroke whether
/// it was the gesture. Where it is not, strokes say all: the start is where one began, either way of an axis
/// may be meant, and the follower claims a stroke when it ends, for the recogniser to decide between claims.
class GestureFollower {
public:
	enum class Stage { RESTING, MOVING, ARRIVED };

	/// model must outlive the follower; its feature must exist. Without a task the place of rest is taken for
	/// the start, and the model's mean amplitude for the task's. effort, latency_s: as PhaseEstimator's.
	/// decoding: of the states that `paper` mode plays.
	GestureFollower(const GestureModel &model, const Task &task, bool start_is_known, MotionMode mode,
			const PhaseEffort &effort = {}, double latency_s = 0.0, const StateDecoding &decoding = {});

	/// A new frame; t_s not before the last one's, nor before a time advanced to: all that is due before it
	/// must have been done. False where it does not hold what the feature needs. place: the feature's,
	/// finite; strokes: of the feature, with this frame in it.
	bool push(const HandFrame &frame, const std::optional<FeaturePlace> &place, const StrokeFinder &strokes);
	/// All that is due by t_s; strokes: as of the last frame.
	void advance(double t_s, const StrokeFinder &strokes);

	[[nodiscard]] Motion motion(double t_s) const;
	[[nodiscard]] Stage stage() const { return stage_; }
	[[nodiscard]] double stage_began_s() const { return stage_began_s_; }
	[[nodiscard]] int state() const { return decoder_.state(); }
	/// log of the posterior odds of the gesture against none by what has been seen of it, nats; the measure
	/// by which gestures compete.
	[[nodiscard]] double log_odds() const { return log_odds_; }
	/// A stroke has ended that is likelier the gesture than none: confirm() or dismiss() it.
	[[nodiscard]] bool claims() const { return claims_; }
	void confirm(double t_s);
	/// What is under way, and what of it is still to come, was another gesture's.
	void give_way(double t_s);
	/// log of the posterior odds that the stroke under way leads back after the gesture, against anything
	/// else, nats; -infinity while there is none, and where the task is known.
	[[nodiscard]] double log_odds_of_return() const { return log_odds_of_return_; }
	/// The motion element as it is seen, m; 0 before the first frame.
	[[nodiscard]] double measured_m() const { return window_.position_m(); }
	[[nodiscard]] const Task &task() const { return task_; }
	[[nodiscard]] const GestureModel &model() const { return *model_; }

private:
	const GestureModel *model_;
	MotionElement element_;
	const Feature *feature_; ///< the element's
	Task task_;
	bool start_is_known_;
	MotionMode mode_;

	ObservationWindow window_;
	SymbolClock clock_;
	bool clock_started_ = false;
	bool fresh_ = false; ///< a frame came since the last symbol
	FeaturePlace place_ = FeaturePlace::Zero();
	FeaturePlace start_ = FeaturePlace::Zero(); ///< of the motion element
	FeaturePlace way_ = FeaturePlace::Zero();   ///< unit vector of its growth
	FeaturePlace axis_ = FeaturePlace::Zero();  ///< without a task: the model's, in the sense of the stroke
	FeaturePlace from_ = FeaturePlace::Zero();  ///< without a task: start_ as strokes count it

	Stage stage_ = Stage::RESTING;
	double stage_began_s_ = -INFINITY;
	OutputBlend blend_; ///< of what would step otherwise: the output in amplitudes
	double log_odds_ = LOG_PRIOR_OPEN;
	double log_odds_of_return_ = -INFINITY;
	bool claims_ = false;
	bool is_rejected_ = false;        ///< what was under way was none: nothing begins before the hand is back
	double likely_s_ = 0.0;           ///< when a stroke last looked like the gesture
	bool has_moved_ = false;          ///< along the way, in the stroke under way
	double not_before_s_ = -INFINITY; ///< strokes that began earlier are done with
	double returned_s_ = -INFINITY;   ///< when the hand was last on its way back after the gesture
	double slowed_odds_ = -INFINITY;  ///< log odds of the whole stroke, the best since it slowed down
	FeaturePlace slowed_at_ = FeaturePlace::Zero(); ///< where that was, as strokes count it
	double end_speed_share_ = 0.0; ///< of the peak speed: what a hand still has where the gesture ends
	double likeliest_ = 0.0;       ///< log odds of a stroke, the best since the gesture began
	double log_odds_of_all_ = 0.0; ///< of its strokes as one, if they are several
	double at_end_since_s_ = 0.0;
	// With a task, once the gesture has begun: strokes that it is made of, however long the hand rested
	// between them.
	std::optional<Stroke> done_; ///< those before the last
	std::optional<Stroke> last_;
	double furthest_ = 0.0; ///< since it arrived, in amplitudes
	StateDecoder decoder_;
	int state_played_ = 0;
	PaperSynthesiser paper_; ///< used in its mode only, as the next one is
	PhaseEstimator phase_;

	void step(double t_s, const StrokeFinder &strokes);
	void step_in_task(double t_s, const StrokeFinder &strokes);
	void decode(double t_s);
	/// What is measured, in amplitudes.
	[[nodiscard]] double value() const { return window_.position_m() / task_.amplitude_m; }
	[[nodiscard]] Observation observation() const {
		return window_.normalised(task_.amplitude_m, model_->duration_mean_s);
	}
	void begin(double t_s, double value);
	void enter(Stage stage, double t_s);
	[[nodiscard]] Motion synthesised(double t_s) const;

	[[nodiscard]] bool has_arrived(double t_s) const;
	/// Frames go to the estimator: without a task only while something is under way.
	[[nodiscard]] bool follows_phase() const {
		return mode_ == MotionMode::PHASE && (start_is_known_ || stage_ != Stage::RESTING);
	}

	// With a task.
	[[nodiscard]] bool has_begun(double t_s) const;
	[[nodiscard]] bool was_nothing(double t_s) const;
	void arrive(double t_s);
	[[nodiscard]] bool is_back(double t_s) const;
	void judge_by_task(const StrokeFinder &strokes);
	void collect(const StrokeFinder &strokes);
	void look_for_move(const StrokeFinder &strokes);

	// Without one.
	void watch(double t_s, const StrokeFinder &strokes);
	void look_for_start(double t_s, const StrokeFinder &strokes);
	void look_for_end(double t_s, const StrokeFinder &strokes);
	void look_for_return(double t_s, const StrokeFinder &strokes);
	void dismiss(double t_s);
	void start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes);
	[[nodiscard]] bool is_arriving(double t_s, const Stroke &stroke) const;
	[[nodiscard]] FeaturePlace way_of(const Stroke &stroke) const;
	[[nodiscard]] StrokeEvidence evidence_of(const Stroke &stroke, const FeaturePlace &way) const;
	void aim(const FeaturePlace &to);
	[[nodiscard]] double amplitudes(const Stroke &stroke) const;
	[[nodiscard]] bool is_over(const Stroke &stroke, const StrokeFinder &strokes) const;
};

} // namespace steadyhand
