#pragma once

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

/// How motion is made of what is seen. effort, latency_s: as SwitchingEstimator's; decoding: of the states
/// that `paper` mode plays.
struct Synthesis {
	MotionMode mode = MotionMode::PHASE;
	EstimatorEffort effort = {};
	double latency_s = 0.0;
	StateDecoding decoding = {};
};

/// Follows one gesture through a stream of frames: waits at rest, spots the start, decodes the states, plays
/// the motion out, holds its end until the hand has come back. Strokes that do not look like the gesture are
/// let alone. Time is the frames' own; after construction nothing is allocated.
///
/// What is seen and what is put out is the same for all; when a gesture begins and ends a TaskFollower says
/// where the task is known, an OpenFollower where it is not.
class GestureFollower {
public:
	enum class Stage { RESTING, MOVING, ARRIVED };
	/// Without a task: unseen for so long a gesture has ended, if its end was near; with one, an end counts
	/// until then. In any case: unseen for so long it, or its end, is over.
	static constexpr std::array ABSENCES_S{ 0.3, 1.0 };

	GestureFollower(const GestureFollower &) = delete;
	GestureFollower &operator=(const GestureFollower &) = delete;
	virtual ~GestureFollower() = default;

	/// A new frame; t_s not before the last one's, nor before a time advanced to: all that is due before it
	/// must have been done. False where it does not hold what the feature needs. place: the feature's,
	/// finite, without the tracker's displacement; strokes: of the feature, with this frame in it;
	/// measurement: what its tracker is worth.
	bool push(const HandFrame &frame, const std::optional<FeaturePlace> &place, const StrokeFinder &strokes,
			const Measurement &measurement);
	/// All that is due by t_s; strokes and monitor: as of the last frame.
	void advance(double t_s, const StrokeFinder &strokes, const TrackerMonitor &monitor);

	[[nodiscard]] Motion motion(double t_s) const;
	[[nodiscard]] Stage stage() const { return stage_; }
	[[nodiscard]] double stage_began_s() const { return stage_began_s_; }
	/// Of one that has arrived: its end, which is news once, has been shown.
	void tell_end() { end_told_ = true; }
	[[nodiscard]] bool end_told() const { return end_told_; }
	/// When the one under way, or the last one, began; -infinity before the first.
	[[nodiscard]] double begun_s() const { return begun_s_; }
	/// How many have been under way so far, this one with them.
	[[nodiscard]] std::uint32_t gestures_begun() const { return gestures_begun_; }
	/// Of a new follower: so that no two of a recogniser's count alike.
	void count_from(std::uint32_t begun) { gestures_begun_ = begun; }
	[[nodiscard]] int state() const { return decoder_.state(); }
	/// log of the posterior odds of the gesture against none by what has been seen of it, nats; the measure
	/// by which gestures compete.
	[[nodiscard]] double log_odds() const { return log_odds_; }
	/// A stroke has ended that is likelier the gesture than none: confirm() it, or let it give_way().
	[[nodiscard]] virtual bool claims() const { return false; }
	virtual void confirm(double /*t_s*/) {}
	/// Under way, and so far on its task's way that its end is at hand.
	[[nodiscard]] virtual bool nears_end() const { return false; }
	/// No frame has been news of the hand for one of ABSENCES_S by t_s: claims what is under way, or gives it
	/// up.
	virtual void miss(double /*t_s*/, const StrokeFinder & /*strokes*/) {}
	/// Where the hand is in the frame that comes next.
	virtual void locate(const FeaturePlace & /*place_m*/) {}
	/// From where its gesture begins to where the hand was last located, m; infinite before, and since it was
	/// lost. What may begin anywhere begins a hand's breadth away.
	[[nodiscard]] virtual double off_start_m() const { return INFINITY; }
	/// Of a gesture with a task: the share of its way from which on it counts where the hand stops.
	virtual void set_completion(double /*share*/) {}
	/// It is to follow the hand, wherever that is, with frames from t_s on: what it shows at rest is put out.
	virtual void attend(double /*t_s*/) {}
	/// Of a new follower: strokes that began before t_s have been made for another gesture.
	virtual void pass_over_before(double t_s) = 0;
	/// What is under way, and what of it is still to come, was another gesture's.
	virtual void give_way(double t_s) = 0;
	/// log of the posterior odds that the stroke under way leads back after the gesture, against anything
	/// else, nats; -infinity while there is none, and where the task is known.
	[[nodiscard]] virtual double log_odds_of_return() const { return -INFINITY; }
	/// The motion element as it is seen, m; 0 before the first frame.
	[[nodiscard]] double measured_m() const { return window_.position_m(); }
	[[nodiscard]] const Task &task() const { return task_; }
	[[nodiscard]] const GestureModel &model() const { return *model_; }

protected:
	/// Expected phase from which on the gesture is at its end.
	static constexpr double ARRIVED_PHASE = 0.97;

	/// model must outlive the follower; its feature must exist. follows_rest: `phase` mode follows the hand,
	/// and shows it, at rest too.
	GestureFollower(
			const GestureModel &model, const Task &task, const Synthesis &synthesis, bool follows_rest);

	/// The motion element in a frame, m; nothing where the frame does not hold what it needs. has_place:
	/// last_place() is the frame's.
	virtual std::optional<double> see(
			const HandFrame &frame, bool has_place, const StrokeFinder &strokes) = 0;
	/// At each instant of the symbols, after what was due of them.
	virtual void decide(double /*t_s*/, const StrokeFinder & /*strokes*/) {}

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
	/// The same, without what of it is still blended in.
	[[nodiscard]] MotionEstimate expected(double t_s) const { return phase_.expected(t_s); }
	/// What is put out is at the gesture's end.
	[[nodiscard]] bool is_at_end(double t_s) const;
	/// And all but still there.
	[[nodiscard]] bool is_still_at_end(double t_s) const;

	void set_log_odds(double log_odds) { log_odds_ = log_odds; }
	/// value: where the hand is, in amplitudes.
	void begin(double t_s, double value);
	void decode(double t_s);
	void arrive(double t_s) { enter(Stage::ARRIVED, t_s); }
	void rest(double t_s);
	/// At rest as before the first frame, and no longer shows where the hand was, nor at once where it then
	/// is.
	void forget_hand(double t_s);
	[[nodiscard]] bool is_forgotten() const { return is_forgotten_; }
	/// The estimator is to expect another gesture from where the hand is. shift: of what is measured from now
	/// on, in amplitudes.
	void restart_estimate(double t_s, double shift = 0.0) { phase_.restart(t_s, shift); }
	/// What is put out goes on from `before`, at t_s, and fades to what it is by now; rate: 1/s, of the
	/// fading.
	void blend_from(const Motion &before, double t_s, double rate_per_s);
	/// As if the frames recalled from now on had been all so far.
	void forget_frames();
	void recall(double t_s, double x_m);
	/// At the instants of the symbols between the frames recalled: decodes the states anew.
	void decode_recalled(double t_s);
	/// From this frame on the hand is where the gesture does not begin: until it is nearer again, or
	/// attend(), it is not followed, and shown at 0.
	void set_elsewhere(bool is_elsewhere) { is_elsewhere_ = is_elsewhere; }
	[[nodiscard]] bool is_elsewhere() const { return is_elsewhere_; }

private:
	const GestureModel *model_;
	const Feature *feature_;
	Task task_;
	MotionMode mode_;
	bool follows_rest_;
	bool is_elsewhere_ = false;

	ObservationWindow window_;
	SymbolClock clock_;
	bool clock_started_ = false;
	bool fresh_ = false; ///< a frame came since the last symbol
	FeaturePlace place_ = FeaturePlace::Zero();
	Measurement measurement_;

	Stage stage_ = Stage::RESTING;
	double stage_began_s_ = -INFINITY;
	bool end_told_ = false;
	double begun_s_ = -INFINITY;
	std::uint32_t gestures_begun_ = 0;
	double log_odds_;
	StateDecoder decoder_;
	int state_played_ = 0;
	PaperSynthesiser paper_; ///< used in its mode only, as the next one is
	SwitchingEstimator phase_;
	bool is_forgotten_ = false; ///< the hand is, and has not been seen again
	OutputBlend blend_;         ///< of what would step otherwise, m

	void step(double t_s, const StrokeFinder &strokes, const TrackerMonitor &monitor);
	void enter(Stage stage, double t_s);
	/// Frames go to the estimator.
	[[nodiscard]] bool follows_phase() const {
		return mode_ == MotionMode::PHASE && (follows_rest_ || stage_ != Stage::RESTING);
	}
	[[nodiscard]] Motion synthesised(double t_s) const;
};

} // namespace steadyhand
