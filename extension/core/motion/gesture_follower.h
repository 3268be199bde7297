#pragma once

#include "gesture/gesture_model.h"
#include "gesture/motion_element.h"
#include "gesture/observation.h"
#include "gesture/symbol_clock.h"
#include "gesture/task.h"
#include "hmm/forward.h"
#include "hmm/viterbi.h"
#include "motion/motion.h"
#include "motion/paper_synthesiser.h"
#include "motion/phase_estimator.h"

namespace steadyhand {

/// Follows one gesture through a stream of frames: waits at rest, spots the start, decodes the states, plays
/// the motion out, holds its end until the hand has come back. Time is the frames' own; after construction
/// nothing is allocated.
class GestureFollower {
public:
	enum class Stage { RESTING, MOVING, ARRIVED };

	/// model must outlive the follower; its feature must exist. Without a task the place of rest is taken for
	/// the start, and the model's mean amplitude for the task's.
	GestureFollower(const GestureModel &model, const Task &task, bool start_is_known, MotionMode mode);

	/// A new frame; t_s not before the last one's, nor before a time advanced to. False where it does not
	/// hold what the feature needs.
	bool push(const HandFrame &frame);
	/// All that is due by t_s.
	void advance(double t_s);

	[[nodiscard]] Motion motion(double t_s) const;
	[[nodiscard]] Stage stage() const { return stage_; }
	[[nodiscard]] int state() const { return decoder_.state(); }
	/// Mean of log P(symbol) a symbol since the start, nats; the measure by which gestures compete.
	[[nodiscard]] double mean_log_likelihood() const;
	/// The motion element as it is seen, m; 0 before the first frame.
	[[nodiscard]] double measured_m() const { return window_.position_m(); }
	[[nodiscard]] const Task &task() const { return task_; }
	[[nodiscard]] const GestureModel &model() const { return *model_; }

private:
	const GestureModel *model_;
	MotionElement element_;
	Task task_;
	bool start_is_known_;
	MotionMode mode_;

	ObservationWindow window_;
	SymbolClock clock_;
	bool clock_started_ = false;
	bool fresh_ = false; ///< a frame came since the last symbol
	HandFrame last_frame_;

	Stage stage_ = Stage::RESTING;
	double stage_began_s_ = 0.0;
	double released_from_m_ = 0.0; ///< value that the last gesture left off at
	double still_since_s_ = 0.0;
	OnlineViterbi decoder_;
	ForwardFilter likelihood_;
	int symbols_seen_ = 0;
	int state_played_ = 0;
	PaperSynthesiser paper_; ///< used in its mode only, as the next one is
	PhaseEstimator phase_;

	void step(double t_s);
	void wait_at_rest(double t_s, const Observation &observation);
	void decode(double t_s, const Observation &observation);
	[[nodiscard]] bool has_begun(double t_s, const Observation &observation) const;
	[[nodiscard]] bool was_nothing(double t_s, const Observation &observation) const;
	[[nodiscard]] bool has_arrived(double t_s) const;
	[[nodiscard]] bool is_back(double t_s, const Observation &observation) const;
	void enter(Stage stage, double t_s);
	void begin(double t_s, const Observation &observation);
	void take_for_start(const HandFrame &frame);
};

} // namespace steadyhand
