#pragma once

#include "base/parameters.h"
#include "gesture/gesture_model.h"
#include "gesture/observation.h"
#include "gesture/symbol_clock.h"
#include "gesture/task.h"
#include "hmm/state_decoder.h"
#include "motion/motion.h"
#include "motion/output_blend.h"
#include "motion/paper_synthesiser.h"
#include "motion/switching_estimator.h"
#include "strokes/stroke_finder.h"
#include "tracking/tracker_monitor.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace steadyhand {

/// How the motion is made. effort, latency_s: as SwitchingEstimator's; decoding: of the states that `paper`
/// mode plays.
struct Synthesis {
	MotionMode mode = MotionMode::PHASE;
	EstimatorEffort effort = {};
	double latency_s = 0.0;
	StateDecoding decoding = {};
};

/// One gesture on a stream of frames. IDLE: the hand rests or does something else. ACTIVE: it makes the
/// gesture. ENDED: it has, and the end is held until the hand returns. An aborted gesture is IDLE again. Time
/// is the frames' own; after construction nothing is allocated.
///
/// The motion is made here. When a gesture starts and ends is decided by TaskSession with a task, and without
/// one by StrokeSession (`phase` mode) or HmmSession (`paper` mode).
class GestureSession {
public:
	enum class Stage { IDLE, ACTIVE, ENDED };
	/// Without a frame for so long: without a task an active gesture near its end has ended, with one it can
	/// end no more; after the second time the session is idle.
	static inline const std::array ABSENCES_S{ parameters::SHORT_DROPOUT_S, parameters::LONG_DROPOUT_S };

	GestureSession(const GestureSession &) = delete;
	GestureSession &operator=(const GestureSession &) = delete;
	virtual ~GestureSession() = default;

	/// A new frame; t_s not before the last one's, nor before a time advanced to: all that is due before it
	/// must have been done. False if it does not hold what the feature needs. place: the feature's, finite,
	/// without the tracker's displacement; strokes: of the feature, with this frame in it; measurement: of
	/// the feature's tracked point.
	bool push(const HandFrame &frame, const std::optional<FeaturePlace> &place, const StrokeFinder &strokes,
			const Measurement &measurement);
	/// All that is due by t_s; strokes and monitor: as of the last frame.
	void advance(double t_s, const StrokeFinder &strokes, const TrackerMonitor &monitor);

	[[nodiscard]] Motion motion(double t_s) const;
	[[nodiscard]] Stage stage() const { return stage_; }
	[[nodiscard]] double stage_began_s() const { return stage_began_s_; }
	/// ENDED, and the end has been reported.
	void report_end() { is_end_reported_ = true; }
	[[nodiscard]] bool is_end_reported() const { return is_end_reported_; }
	/// When the active gesture, or the last one, started; -infinity before the first.
	[[nodiscard]] double started_s() const { return started_s_; }
	/// How many have been active so far, this one included.
	[[nodiscard]] std::uint32_t gestures_started() const { return gestures_started_; }
	/// Of a new session: so that no two of a recogniser's count alike.
	void count_on_from(std::uint32_t begun) { gestures_started_ = begun; }
	[[nodiscard]] int state() const { return decoder_.state(); }
	/// log of the posterior odds of the gesture against none so far, nats; gestures compete by it. Without
	/// length and duration of the movement until count_end().
	[[nodiscard]] double log_odds() const { return log_odds_; }
	/// The gesture has come to its end, likelier than not: to be answered by end_gesture() or abort().
	[[nodiscard]] virtual bool may_end() const { return false; }
	/// may_end(), before the hand has slowed down.
	[[nodiscard]] virtual bool is_end_predicted() const { return false; }
	/// may_end(), and after its end the hand has done what is usual: it came back or stayed.
	[[nodiscard]] virtual bool is_end_usual() const { return true; }
	/// What log_odds() lacks if another gesture shares_path(): evidence that a strike is too slow, nats, <=
	/// 0.
	[[nodiscard]] virtual double strike_log_odds() const { return 0.0; }
	/// No strike, and without a task along the path of the other one.
	[[nodiscard]] virtual bool shares_path(const GestureSession & /*other*/) const { return false; }
	/// Direction of the movement without a task; 0 with one.
	[[nodiscard]] virtual FeaturePlace axis() const { return FeaturePlace::Zero(); }
	/// The most that log_odds() can become while the stroke goes on.
	[[nodiscard]] virtual double best_log_odds() const { return log_odds_; }
	/// log_odds() if the hand comes back at once after its end, or stays.
	[[nodiscard]] virtual double log_odds_if(bool /*comes_back*/) const { return log_odds_; }
	/// From now on log_odds() includes length and duration of the movement, and what the hand did after it.
	virtual void count_end() {}
	/// The gesture has ended, and the hand comes back from there by this stroke of its feature.
	[[nodiscard]] virtual bool is_return(const Stroke & /*stroke*/) const { return false; }
	virtual void end_gesture(double /*t_s*/) {}
	/// Active, and near the task's end.
	[[nodiscard]] virtual bool is_near_end() const { return false; }
	/// The hand has not been tracked for one of ABSENCES_S by t_s: the gesture may_end(), or is aborted.
	virtual void on_dropout(double /*t_s*/, const StrokeFinder & /*strokes*/) {}
	/// Where the hand is in the frame that comes next.
	virtual void locate(const FeaturePlace & /*place_m*/) {}
	/// From the start of the task to where the hand was last located, m; infinite before, and after a
	/// dropout. A gesture that may start anywhere starts a hand's breadth away.
	[[nodiscard]] virtual double start_distance_m() const { return INFINITY; }
	/// With a task: from this fraction of the amplitude on the gesture counts where the hand stops.
	virtual void set_completion(double /*share*/) {}
	/// Its motion is shown: from t_s on it follows the hand, however far that is from the task.
	virtual void follow_hand(double /*t_s*/) {}
	/// Of a new session: a movement with an onset before t_s belongs to another gesture.
	virtual void ignore_before(double t_s) = 0;
	/// The movement so far, and the rest of it, belongs to another gesture.
	virtual void abort(double t_s) = 0;
	/// The measured motion element, m; 0 before the first frame.
	[[nodiscard]] double measured_m() const { return window_.position_m(); }
	[[nodiscard]] const Task &task() const { return task_; }
	[[nodiscard]] const GestureModel &model() const { return *model_; }

protected:
	/// model must outlive the session; its feature must exist. follows_rest: in `phase` mode an idle session
	/// shows the hand too.
	GestureSession(
			const GestureModel &model, const Task &task, const Synthesis &synthesis, bool follows_rest);

	/// The motion element in a frame, m; nothing if the frame does not hold what it needs. has_place:
	/// last_place() is the frame's.
	virtual std::optional<double> measure(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) = 0;
	/// At each instant of the symbols, after the state was decoded.
	virtual void update_stage(double /*t_s*/, const StrokeFinder & /*strokes*/) {}

	[[nodiscard]] const Feature &feature() const { return *feature_; }
	[[nodiscard]] MotionMode mode() const { return mode_; }
	/// The feature's, in the newest frame that had one.
	[[nodiscard]] const FeaturePlace &last_place() const { return place_; }
	/// Of the newest frame.
	[[nodiscard]] const Measurement &measurement() const { return measurement_; }
	/// What is measured, in amplitudes.
	[[nodiscard]] double value() const { return window_.position_m() / task_.amplitude_m; }
	[[nodiscard]] Observation observation() const {
		return window_.normalised(task_.amplitude_m, model_->duration_mean_s);
	}
	/// Of `phase` mode.
	[[nodiscard]] MotionEstimate estimate(double t_s) const { return phase_.at(t_s); }
	/// The same before it is blended.
	[[nodiscard]] MotionEstimate unblended(double t_s) const { return phase_.unblended(t_s); }
	/// The motion is at the gesture's end.
	[[nodiscard]] bool is_at_end(double t_s) const;
	/// And hardly moves.
	[[nodiscard]] bool is_still_at_end(double t_s) const;

	void set_log_odds(double log_odds) { log_odds_ = log_odds; }
	/// value: where the hand is, in amplitudes.
	void begin(double t_s, double value);
	void decode(double t_s);
	void arrive(double t_s) { enter(Stage::ENDED, t_s); }
	void rest(double t_s);
	/// Idle as before the first frame: the motion goes to 0, and from there to where the hand is next.
	void reset_hand(double t_s);
	[[nodiscard]] bool is_reset() const { return is_reset_; }
	/// The estimator expects another gesture from where the hand is. shift: of later measurements,
	/// amplitudes.
	void restart_estimate(double t_s, double shift = 0.0) { phase_.restart(t_s, shift); }
	/// The motion goes on from `before` at t_s, and fades to the present one; rate: 1/s.
	void blend_from(const Motion &before, double t_s, double rate_per_s);
	/// As if the frames that are replayed next were the first.
	void reset_frames();
	void replay(double t_s, double x_m);
	/// At the instants of the symbols between the replayed frames.
	void decode_replayed(double t_s);
	/// While the hand is where the gesture cannot start, the estimator rests, and the motion is 0.
	void set_paused(bool is_paused) { is_paused_ = is_paused; }
	[[nodiscard]] bool is_paused() const { return is_paused_; }

private:
	const GestureModel *model_;
	const Feature *feature_;
	Task task_;
	MotionMode mode_;
	bool follows_rest_;
	bool is_paused_ = false;

	ObservationWindow window_;
	SymbolClock clock_;
	bool clock_started_ = false;
	bool fresh_ = false; ///< a frame came since the last symbol
	FeaturePlace place_ = FeaturePlace::Zero();
	Measurement measurement_;

	Stage stage_ = Stage::IDLE;
	double stage_began_s_ = -INFINITY;
	bool is_end_reported_ = false;
	double started_s_ = -INFINITY;
	std::uint32_t gestures_started_ = 0;
	double log_odds_;
	StateDecoder decoder_;
	int state_played_ = 0;
	PaperSynthesiser paper_; ///< used in its mode only, as the next one is
	SwitchingEstimator phase_;
	bool is_reset_ = false; ///< by reset_hand(), and no frame came since
	OutputBlend blend_;     ///< of steps, m

	void step(double t_s, const StrokeFinder &strokes, const TrackerMonitor &monitor);
	void enter(Stage stage, double t_s);
	/// Frames go to the estimator.
	[[nodiscard]] bool follows_phase() const {
		return mode_ == MotionMode::PHASE && (follows_rest_ || stage_ != Stage::IDLE);
	}
	[[nodiscard]] Motion synthesised(double t_s) const;
};

} // namespace steadyhand
