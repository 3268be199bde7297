#pragma once

#include "base/parameters.h"
#include "gesture/feature_track.h"
#include "gesture/gesture_model.h"
#include "gesture/observation.h"
#include "gesture/symbol_clock.h"
#include "gesture/task.h"
#include "hmm/state_decoder.h"
#include "motion/motion.h"
#include "motion/output_blend.h"
#include "motion/paper_synthesiser.h"
#include "motion/switching_estimator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace steadyhand {

/// Options of the synthesis. hypotheses, latency_s: of SwitchingEstimator; decoding: of the states in `paper`
/// mode.
struct Synthesis {
	MotionMode mode = MotionMode::PHASE;
	std::size_t hypotheses = DEFAULT_HYPOTHESES;
	double latency_s = 0.0;
	StateDecoding decoding = {};
};

/// One gesture on a stream of frames. IDLE: the hand rests or does something else. ACTIVE: it makes the
/// gesture. ENDED: the gesture has ended, and the motion stays at the end until the hand returns. An aborted
/// gesture is IDLE. All times are frame times. Only the constructor allocates.
///
/// This class makes the motion. Subclasses decide when a gesture starts and ends: TaskSession with a task,
/// HmmSession without one.
class GestureSession {
public:
	enum class Stage { IDLE, ACTIVE, ENDED };

	GestureSession(const GestureSession &) = delete;
	GestureSession &operator=(const GestureSession &) = delete;
	virtual ~GestureSession() = default;

	/// A new frame, not before the last one and not before the last step(). Returns false if the frame has no
	/// value of the feature. track: of the feature, with this frame.
	bool push(const HandFrame &frame, const FeatureTrack &track);
	/// Advances to the next instant of a SymbolClock. track: as of the last frame.
	void step(double t_s, const FeatureTrack &track);

	[[nodiscard]] Motion motion(double t_s) const;
	/// Value of the motion in amplitudes, at least 0. The blend at the start is left out.
	[[nodiscard]] double fraction(double t_s) const {
		return std::max(synthesised(t_s).value_m / task_.amplitude_m, 0.0);
	}
	[[nodiscard]] Stage stage() const { return stage_; }
	[[nodiscard]] double stage_began_s() const { return stage_began_s_; }
	/// Marks the end of an ENDED gesture as reported.
	void report_end() { is_end_reported_ = true; }
	[[nodiscard]] bool is_end_reported() const { return is_end_reported_; }
	/// Start of the active gesture, or of the last one; -infinity before the first.
	[[nodiscard]] double started_s() const { return started_s_; }
	/// Number of gestures so far, with the active one.
	[[nodiscard]] std::uint32_t gestures_started() const { return gestures_started_; }
	/// Sets the first number of a new session. A recogniser keeps the numbers of its sessions apart.
	void set_gestures_started(std::uint32_t number) { gestures_started_ = number; }
	[[nodiscard]] int state() const { return decoder_.state(); }
	/// log of the posterior odds of the gesture against none so far, nats. Gestures are compared by it.
	[[nodiscard]] double log_odds() const { return log_odds_; }
	/// The gesture has probably ended. The caller answers with end_gesture() or abort().
	[[nodiscard]] virtual bool may_end() const { return false; }
	virtual void end_gesture(double /*t_s*/) {}
	/// Active, and near the task's end.
	[[nodiscard]] virtual bool is_near_end() const { return false; }
	/// Position of the hand in the next frame.
	virtual void locate(const FeaturePlace & /*place_m*/) {}
	/// Distance, m, of the last located hand from the task's start. Infinite before the first locate(), and
	/// after a dropout. At least parameters::sessions::ANYWHERE_M for a gesture that may start anywhere.
	[[nodiscard]] virtual double start_distance_m() const { return INFINITY; }
	/// With a task: the gesture also ends if the hand stops beyond this fraction of the amplitude.
	virtual void set_completion(double /*share*/) {}
	/// The session follows the hand at t_s at any distance from the task, because its motion is shown.
	virtual void follow_hand(double /*t_s*/) {}
	/// A movement with an onset before t_s belongs to another gesture. For new sessions.
	virtual void ignore_before(double t_s) = 0;
	/// The present movement belongs to another gesture.
	virtual void abort(double t_s) = 0;
	/// The measured motion element, m; 0 before the first frame.
	[[nodiscard]] double measured_m() const { return window_.position_m(); }
	[[nodiscard]] const Task &task() const { return task_; }
	[[nodiscard]] const GestureModel &model() const { return *model_; }

protected:
	/// model must outlive the session; its feature must exist. follows_rest: in `phase` mode an idle session
	/// follows the hand too.
	GestureSession(
			const GestureModel &model, const Task &task, const Synthesis &synthesis, bool follows_rest);

	/// Motion element in a frame, m; nullopt if the frame has none. Then last_place() is of an earlier frame.
	virtual std::optional<double> measure(const HandFrame &frame, const FeatureTrack &track) = 0;
	/// Called at each step(), after the state is decoded.
	virtual void update_stage(double t_s, const FeatureTrack &track) = 0;

	[[nodiscard]] const Feature &feature() const { return *feature_; }
	[[nodiscard]] MotionMode mode() const { return mode_; }
	/// FeatureTrack::hand() in the newest frame that has one.
	[[nodiscard]] const FeaturePlace &last_place() const { return place_; }
	/// Measured motion element, amplitudes.
	[[nodiscard]] double value() const { return window_.position_m() / task_.amplitude_m; }
	[[nodiscard]] Observation observation() const {
		return window_.normalised(task_.amplitude_m, model_->duration_mean_s);
	}
	/// Estimate of `phase` mode.
	[[nodiscard]] MotionEstimate estimate(double t_s) const { return phase_.at(t_s); }
	/// estimate(), without the blend of the last change.
	[[nodiscard]] MotionEstimate unblended(double t_s) const { return phase_.unblended(t_s); }
	/// The motion is at the gesture's end, and has almost stopped.
	[[nodiscard]] bool is_still_at_end(double t_s) const;

	void set_log_odds(double log_odds) { log_odds_ = log_odds; }
	/// Enters ACTIVE. value: motion element, amplitudes.
	void begin(double t_s, double value);
	void decode(double t_s);
	void enter_ended(double t_s) { enter(Stage::ENDED, t_s); }
	void enter_idle(double t_s);
	/// Enters IDLE, as before the first frame. The motion goes to 0, and at the next frame to the hand.
	void reset_hand(double t_s);
	[[nodiscard]] bool is_reset() const { return is_reset_; }
	/// Restarts the estimator at the hand's position, for the next gesture. shift: is added to this
	/// position, amplitudes.
	void restart_estimate(double t_s, double shift = 0.0) { phase_.restart(t_s, shift); }
	/// Blends the motion from `before` at t_s to the present one. rate: 1/s.
	void blend_from(const Motion &before, double t_s, double rate_per_s);
	/// Deletes all frames. Then replay() is called for the frames since the onset.
	void reset_frames();
	void replay(double t_s, double x_m, double noise_m);
	/// Decodes at an instant of the symbols between two replayed frames.
	void decode_replayed(double t_s);
	/// While paused, the estimator is only reset, and the motion is 0.
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
	bool has_new_frame_ = false; ///< since the last symbol
	FeaturePlace place_ = FeaturePlace::Zero();

	Stage stage_ = Stage::IDLE;
	double stage_began_s_ = -INFINITY;
	bool is_end_reported_ = false;
	double started_s_ = -INFINITY;
	std::uint32_t gestures_started_ = 0;
	double log_odds_;
	StateDecoder decoder_;
	int state_played_ = 0;
	PaperSynthesiser paper_;   ///< in `paper` mode
	SwitchingEstimator phase_; ///< in `phase` mode
	bool is_reset_ = false;    ///< by reset_hand(), until the next frame
	OutputBlend blend_;        ///< m

	void enter(Stage stage, double t_s);
	/// The estimator is in use: it gets the frames and makes the motion.
	[[nodiscard]] bool follows_phase() const {
		return mode_ == MotionMode::PHASE && (follows_rest_ || stage_ != Stage::IDLE);
	}
	[[nodiscard]] Motion synthesised(double t_s) const;
};

} // namespace steadyhand
