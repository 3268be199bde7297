#include "recognition/gesture_session.h"

#include "base/parameters.h"

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

} // namespace

GestureSession::GestureSession(
		const GestureModel &model, const Task &task, const Synthesis &synthesis, bool follows_rest) :
		model_(&model),
		feature_(find_feature(model.feature)), task_(task), mode_(synthesis.mode),
		follows_rest_(follows_rest), log_odds_(LOG_PRIOR_NO_TASK), decoder_(model.hmm, synthesis.decoding),
		paper_(model),
		phase_(model, task.amplitude_m, synthesis.hypotheses, synthesis.latency_s,
				follows_rest ? parameters::GAIN_SPREAD
							 : feature_->no_task_gain_factor * parameters::NO_TASK_GAIN_SPREAD) {}

bool GestureSession::push(const HandFrame &frame, const FeatureTrack &track) {
	place_ = track.hand().value_or(place_);
	const std::optional<double> x_m = measure(frame, track);
	if (!x_m) {
		return false;
	}
	const Motion before = is_reset_ ? motion(frame.t_s) : Motion{};
	window_.push(frame.t_s, *x_m);
	if (follows_phase()) {
		const double x = *x_m / task_.amplitude_m;
		is_paused_ ? phase_.reset_at(frame.t_s, x) : phase_.push(track.measurement(), x);
	}
	if (is_reset_) {
		is_reset_ = false;
		blend_from(before, frame.t_s, CHANGE_BLEND_PER_S);
	}
	has_new_frame_ = true;
	return true;
}

void GestureSession::step(double t_s, const FeatureTrack &track) {
	if (!has_new_frame_ && follows_phase()) {
		phase_.wait(t_s, track.monitor().is_overdue(t_s));
	}
	if (stage_ == Stage::ACTIVE) {
		decode(t_s);
	}
	update_stage(t_s, track);
	has_new_frame_ = false;
}

void GestureSession::begin(double t_s, double value) {
	decoder_.reset();
	state_played_ = 0;
	if (mode_ == MotionMode::PAPER) {
		paper_.begin(t_s, phase_of_value(*model_, value));
	}
	gestures_started_ += stage_ != Stage::ACTIVE ? 1 : 0;
	started_s_ = t_s;
	enter(Stage::ACTIVE, t_s);
}

void GestureSession::enter_idle(double t_s) {
	const Motion before = motion(t_s);
	enter(Stage::IDLE, t_s);
	if (!follows_phase()) { // the estimator blends by itself
		blend_from(before, t_s, CHANGE_BLEND_PER_S);
	}
}

void GestureSession::reset_hand(double t_s) {
	const Motion before = motion(t_s);
	enter(Stage::IDLE, t_s);
	reset_frames();
	is_reset_ = true;
	blend_from(before, t_s, CHANGE_BLEND_PER_S);
}

void GestureSession::enter(Stage stage, double t_s) {
	stage_ = stage;
	stage_began_s_ = t_s;
	is_end_reported_ = false;
}

void GestureSession::decode(double t_s) {
	decoder_.push(has_new_frame_ ? model_->quantiser.symbol(observation()) : UNSEEN);
	if (decoder_.state() > state_played_) {
		state_played_ = decoder_.state();
		if (mode_ == MotionMode::PAPER) {
			paper_.enter_state(state_played_, t_s - decoder_.lag() * SymbolClock::PERIOD_S, t_s);
		}
	}
}

bool GestureSession::is_still_at_end(double t_s) const {
	if (mode_ == MotionMode::PAPER) {
		return paper_.phase(t_s) >= 1.0;
	}
	const MotionEstimate now = estimate(t_s);
	return now.value >= END_LEVEL && now.remaining < 1.0 - END_PHASE;
}

void GestureSession::reset_frames() {
	window_.reset();
	phase_.reset();
}

void GestureSession::replay(double t_s, double x_m, double noise_m) {
	window_.push(t_s, x_m);
	has_new_frame_ = true;
	if (mode_ == MotionMode::PHASE) {
		phase_.push({ .t_s = t_s, .noise_m = noise_m }, x_m / task_.amplitude_m);
	}
}

void GestureSession::decode_replayed(double t_s) {
	decode(t_s);
	has_new_frame_ = false;
}

void GestureSession::blend_from(const Motion &before, double t_s, double rate_per_s) {
	blend_.start(t_s, before, synthesised(t_s), rate_per_s);
}

Motion GestureSession::synthesised(double t_s) const {
	if (follows_phase()) {
		const MotionEstimate now = estimate(t_s);
		return { task_.amplitude_m * now.value, task_.amplitude_m * now.velocity,
			task_.amplitude_m * now.acceleration, stage_ == Stage::IDLE ? 0.0 : now.phase,
			task_.amplitude_m * now.correction };
	}
	return stage_ == Stage::IDLE ? Motion{} : paper_.motion(t_s, task_.amplitude_m);
}

Motion GestureSession::motion(double t_s) const {
	return blend_.completed(synthesised(t_s), t_s);
}

} // namespace steadyhand
