#include "recognition/hmm_session.h"

#include "base/parameters.h"
#include "gesture/classifier_file.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

using Event = GestureSpotter::Event;

/// Onsets closer together belong to one rest.
constexpr double LATER_ONSET_S = 0.1;
constexpr double LEAST_COMPLEMENT = 1e-12; ///< keeps log odds finite

FeaturePlace vector_of(const Eigen::Vector3d &tip, double radius) {
	return { tip.x(), tip.y(), tip.z(), radius };
}

double log_odds_of(double posterior) {
	return std::log(posterior / std::max(1.0 - posterior, LEAST_COMPLEMENT));
}

} // namespace

HmmSession::HmmSession(const GestureModel &model, const Synthesis &synthesis, GestureSpotter &r_spotter) :
		GestureSession(model, model.typical_task, synthesis, false), spotter_(&r_spotter),
		direction_(feature().direction != nullptr ? feature().direction(task()) : FeaturePlace::Zero()) {}

GestureHmms HmmSession::hmms_of(const std::shared_ptr<const GestureModel> &model) {
	GestureHmms own{ model->gesture, { model, &model->recorded_hmms } };
	if (own.hmms->empty()) {
		const std::shared_ptr<const ClassifierModel> classifier = own_classifier();
		own.hmms = { classifier, &classifier->gestures };
	}
	return own;
}

bool HmmSession::can_follow(const std::shared_ptr<const GestureModel> &model) {
	return std::ranges::any_of(*hmms_of(model).hmms, [&](const DirectedHmm &one) {
		return one.gesture == model->gesture &&
				model->feature == (one.is_radius ? "tips_circumradius" : "index_along_axis");
	});
}

std::optional<double> HmmSession::measure(const HandFrame &frame, const FeatureTrack &track) {
	may_end_ = false;
	const bool has_started = spotter_->event() == Event::STARTED;
	if (has_started && is_spotted()) {
		begin_at_onset(frame.t_s, track);
	} else if (stage() == Stage::ACTIVE) {
		look_for_end(frame.t_s, track);
	}
	if (!track.hand()) {
		return std::nullopt;
	}
	if (stage() == Stage::IDLE) {
		aim_at(spotter_->candidate_of(model().gesture), track);
	}
	const bool is_usable = track.measurement().is_usable();
	if (stage() != Stage::IDLE && is_usable) {
		follow_hand_path(frame.t_s, track.measurement().noise_m);
	}
	const double now_m = along(last_place());
	const bool has_returned = is_usable && now_m < HALF_BACK * farthest_m_;
	const bool has_stopped = frame.t_s - moved_s_ > PAUSE_S;
	if (stage() == Stage::ACTIVE && has_stopped && !may_end_) {
		decide(frame.t_s, SWITCH_MARGIN);
	} else if (stage() == Stage::ENDED && (has_started || has_returned)) {
		enter_idle(frame.t_s);
	}
	return now_m;
}

/// The direction of an active gesture leads to where the hand was farthest from the start.
void HmmSession::follow_hand_path(double t_s, double noise_m) {
	const FeaturePlace off_m = last_place() - start_;
	const FeaturePlace step_m = last_place() - moved_to_;
	const double least_m = START_VALUE * task().amplitude_m;
	if ((feature().is_radius ? std::abs(step_m.dot(direction_)) : step_m.norm()) >
			std::max(least_m, START_DRIFTS * noise_m)) {
		moved_to_ = last_place();
		moved_s_ = t_s;
	}
	const bool may_turn = stage() == Stage::ACTIVE && !feature().is_radius;
	const double distance_m = may_turn ? off_m.norm() : along(last_place());
	if (distance_m > farthest_m_ + least_m) {
		farthest_m_ = distance_m;
		direction_ = may_turn ? FeaturePlace(off_m / distance_m) : direction_;
	}
}

/// Measures from the candidate's onset on, in the hand's direction; without an onset from here on.
void HmmSession::aim_at(const GestureCandidate *candidate, const FeatureTrack &track) {
	if (candidate == nullptr || candidate->log_likelihood_ratio == NEVER) {
		start_ = last_place();
		return;
	}
	if (feature().is_radius) {
		start_ = vector_of(Eigen::Vector3d::Zero(), candidate->start_radius_m) - track.displacement_m();
		return;
	}
	start_ = vector_of(candidate->start_m, 0.0);
	if (!candidate->axis.isZero(0.0)) {
		direction_ = vector_of(candidate->axis, 0.0);
	}
}

void HmmSession::begin_at_onset(double t_s, const FeatureTrack &track) {
	const Motion before = motion(t_s);
	const GestureCandidate &found = spotter_->candidate();
	aim_at(&found, track);
	set_log_odds(log_odds_of(found.posterior));
	farthest_m_ = 0.0;
	moved_s_ = t_s;
	reset_frames();
	begin(found.onset_s, 0.0);
	double symbol_s = found.onset_s + SymbolClock::PERIOD_S;
	track.frames_since(found.onset_s, [&](double frame_s, const FeaturePlace &hand) {
		while (symbol_s < std::min(frame_s, t_s)) {
			decode_replayed(symbol_s);
			symbol_s += SymbolClock::PERIOD_S;
		}
		if (frame_s < t_s) {
			replay(frame_s, along(hand), track.measurement().noise_m);
		}
	});
	blend_from(before, t_s, START_BLEND_PER_S);
}

void HmmSession::look_for_end(double t_s, const FeatureTrack &track) {
	if (is_spotted()) {
		const GestureCandidate &now = spotter_->candidate();
		if (now.onset_s > started_s() + LATER_ONSET_S && now.reach > SHORTEST) {
			begin_at_onset(t_s, track);
		}
		set_log_odds(log_odds_of(now.posterior));
	} else if (spotter_->event() == Event::ENDED) {
		set_log_odds(log_odds_of(spotter_->candidate().posterior));
		may_end_ = true;
	} else {
		enter_idle(t_s);
	}
}

void HmmSession::end_gesture(double t_s) {
	may_end_ = false;
	spotter_->set_arrival(moved_s_);
	enter_ended(t_s);
}

void HmmSession::abort(double t_s) {
	may_end_ = false;
	if (is_spotted()) {
		spotter_->drop();
	}
	if (stage() != Stage::IDLE) {
		enter_idle(t_s);
	}
}

/// After a short dropout a gesture near its end is decided, after a long one the session is idle.
void HmmSession::update_stage(double t_s, const FeatureTrack &track) {
	const double unseen_s = t_s - track.last_measurement_s();
	if (unseen_s >= LONG_DROPOUT_S) {
		abort(t_s);
	} else if (unseen_s >= SHORT_DROPOUT_S && is_spotted() && spotter_->candidate().reach > NEAR_END) {
		decide(t_s, 0.0);
	}
}

/// No more evidence is to come: the hand is lost or has stopped. Near the end it has probably arrived.
/// least: log odds for an end.
void HmmSession::decide(double t_s, double least) {
	set_log_odds(log_odds_of(spotter_->candidate().posterior));
	if (!is_spotted() || spotter_->candidate().reach < NEAR_END || log_odds() < least) {
		abort(t_s);
		return;
	}
	spotter_->end();
	may_end_ = true;
}

} // namespace steadyhand
