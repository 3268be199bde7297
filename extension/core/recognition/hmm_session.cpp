#include "recognition/hmm_session.h"

#include "base/parameters.h"
#include "gesture/classifier_file.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::sessions;

using Event = GestureSpotter::Event;

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
		direction_(feature().direction(task())) {}

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

std::optional<double> HmmSession::measure(
		const HandFrame &frame, bool has_place, const StrokeFinder &strokes) {
	may_end_ = false;
	const bool has_started = spotter_->event() == Event::STARTED;
	if (has_started && is_spotted()) {
		begin_at_onset(frame.t_s, strokes);
	} else if (stage() == Stage::ACTIVE) {
		look_for_end(frame.t_s);
	}
	if (!has_place) {
		return std::nullopt;
	}
	if (stage() == Stage::IDLE) {
		aim_at(spotter_->candidate_of(model().gesture), strokes.displacement_m());
	}
	if (stage() != Stage::IDLE && measurement().is_usable() &&
			along(last_place()) > farthest_m_ + START_VALUE * task().amplitude_m) {
		farthest_m_ = along(last_place());
		moved_s_ = frame.t_s;
	}
	const bool has_returned = along(last_place()) < HALF_BACK * farthest_m_;
	if (stage() == Stage::ENDED && (has_started || has_returned || frame.t_s - moved_s_ > PAUSE_S)) {
		enter_idle(frame.t_s);
	}
	return along(last_place());
}

/// Measures from the candidate's onset on, in the hand's direction; without an onset from here on.
void HmmSession::aim_at(const GestureCandidate *candidate, const FeaturePlace &displacement_m) {
	if (candidate == nullptr || candidate->log_likelihood_ratio == NEVER) {
		start_ = last_place();
		return;
	}
	start_ = feature().is_radius ? vector_of(Eigen::Vector3d::Zero(), candidate->start_radius_m)
								 : vector_of(candidate->start_m, 0.0);
	start_ -= displacement_m;
	if (!feature().is_radius && !candidate->axis.isZero(0.0)) {
		direction_ = vector_of(candidate->axis, 0.0);
	}
}

void HmmSession::update_direction() {
	const GestureCandidate &found = spotter_->candidate();
	if (!feature().is_radius) {
		direction_ = vector_of(found.axis, 0.0);
	}
	set_log_odds(log_odds_of(found.posterior));
}

void HmmSession::begin_at_onset(double t_s, const StrokeFinder &strokes) {
	const Motion before = motion(t_s);
	const GestureCandidate &found = spotter_->candidate();
	aim_at(&found, strokes.displacement_m());
	set_log_odds(log_odds_of(found.posterior));
	farthest_m_ = 0.0;
	moved_s_ = t_s;
	reset_frames();
	begin(found.onset_s, 0.0);
	double symbol_s = found.onset_s + SymbolClock::PERIOD_S;
	strokes.frames_since(found.onset_s, [&](double frame_s, const FeaturePlace &place) {
		while (symbol_s < std::min(frame_s, t_s)) {
			decode_replayed(symbol_s);
			symbol_s += SymbolClock::PERIOD_S;
		}
		if (frame_s < t_s) {
			replay(frame_s, along(place));
		}
	});
	blend_from(before, t_s, START_BLEND_PER_S);
}

void HmmSession::look_for_end(double t_s) {
	if (is_spotted()) {
		update_direction();
	} else if (spotter_->event() == Event::ENDED) {
		update_direction();
		may_end_ = true;
	} else {
		enter_idle(t_s);
	}
}

void HmmSession::end_gesture(double t_s) {
	may_end_ = false;
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

/// A lost hand gives no more evidence, so that the present one decides.
void HmmSession::on_dropout(double t_s, const StrokeFinder &strokes) {
	if (t_s >= strokes.last_measurement_s() + DROPOUTS_S.back()) {
		abort(t_s);
	} else if (is_spotted() && spotter_->candidate().end_probability > 0.5) {
		update_direction();
		spotter_->drop();
		may_end_ = true;
	}
}

} // namespace steadyhand
