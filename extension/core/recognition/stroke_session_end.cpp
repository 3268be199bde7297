#include "base/parameters.h"
#include "recognition/stroke_session.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::strokes;
using namespace parameters::sessions;

/// Time from the end of a stroke until the hand stops, relative to the stroke's duration. A stroke lasts from
/// a quarter of the peak speed to a quarter: 0.146 to 0.854 of a minimum-jerk movement.
constexpr double SLOWS_DOWN = 0.146 / 0.708;

/// Upper bound of the log odds during the stroke.
double best_odds(const StrokeEvidence &evidence) {
	return LOG_PRIOR_NO_TASK + evidence.without_size() + evidence.max_remaining;
}

/// Time at which the hand will stop if the stroke ends now.
double will_stop_s(double t_s, const Stroke &stroke) {
	return t_s + SLOWS_DOWN * (t_s - stroke.onset_s);
}

} // namespace

void StrokeSession::on_dropout(double t_s, const StrokeFinder &strokes) {
	const bool is_gone = t_s >= strokes.last_measurement_s() + DROPOUTS_S.back();
	if (stage() == Stage::ACTIVE && t_s >= strokes.last_measurement_s() + DROPOUTS_S.front()) {
		look_for_end(t_s, strokes, true);
	}
	if (end_) {
		end_->is_predicted = false;
		end_->is_lost = true;
	}
	if (stage() != Stage::IDLE && is_gone) {
		abort(t_s);
	}
}

/// is_dropout: the hand is in a dropout, at one of DROPOUTS_S.
void StrokeSession::look_for_end(double t_s, const StrokeFinder &strokes, bool is_dropout) {
	end_.reset();
	double best_ended = IMPOSSIBLE, ongoing = IMPOSSIBLE; // log odds
	Stroke last;
	best_odds_ = IMPOSSIBLE;
	bool is_rejected = false;
	for (const Stroke &stroke : strokes.strokes()) {
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < SHORTEST) {
			continue;
		}
		const StrokeEvidence evidence = evidence_of(stroke, strokes, model_direction_);
		const double path = LOG_PRIOR_NO_TASK + evidence.without_size(), best = best_odds(evidence);
		update_direction(stroke.to);
		if (best > 0.0) {
			likely_s_ = t_s;
			moved_s_ = std::max(moved_s_, stroke.moved_s);
			strike_odds_ = path > ongoing ? strike_evidence(stroke, usual_) : strike_odds_;
			ongoing = std::max(ongoing, path);
			best_odds_ = std::max(best_odds_, best + return_evidence(usual_, usual_.is_strike));
			set_log_odds(ongoing);
		}
		is_rejected = is_rejected || best < REJECT_LOG_ODDS;
		const double ended =
				LOG_PRIOR_NO_TASK + evidence.sum() + (is_dropout ? strike_evidence(stroke, usual_) : 0.0);
		const bool is_end = is_dropout ? amplitudes(stroke) > NEAR_END : strokes.ended();
		if (is_end || (ended > END_LOG_ODDS && is_arriving(t_s, stroke))) {
			last = ended > best_ended ? stroke : last;
			best_ended = std::max(best_ended, ended);
		}
	}
	if (best_ended > 0.0) {
		strike_odds_ = strike_evidence(last, usual_);
		end_ = End{ .is_predicted = !is_dropout && !strokes.ended(),
			.t_s = t_s,
			.log_odds = best_ended,
			.length_m = (last.to - last.from).norm(),
			.duration_s = t_s - last.onset_s,
			.value_m = element_m_,
			.comes_back = std::nullopt,
			.is_lost = is_dropout };
		ended_s_ = t_s;
		stopped_s_ = moved_s_ = will_stop_s(t_s, strokes.strokes().front());
	} else if (t_s - moved_s_ > PAUSE_S) {
		abort(t_s); // the hand has stopped halfway; its return is no gesture either
	} else if (is_rejected && t_s - likely_s_ > REJECT_AFTER_S) {
		rejected_s_ = t_s;
		go_idle(t_s);
	}
}

/// Finds the end, and then whether the hand comes back. The recogniser decides on it.
void StrokeSession::watch_end(double t_s, const StrokeFinder &strokes) {
	const bool goes_on =
			!end_ || end_->is_predicted || element_m_ > end_->value_m + SHORTEST * task().amplitude_m;
	if (goes_on) {
		look_for_end(t_s, strokes);
		return;
	}
	const double back = (max_element_m_ - element_m_) / end_->length_m;
	const double watch_s = (back < TURNED ? TURNED_WITHIN : COMES_BACK_WITHIN) * end_->duration_s;
	const bool comes_back = back > COMES_BACK;
	if (!end_->comes_back && !end_->is_lost && (comes_back || t_s - end_->t_s >= watch_s)) {
		end_->comes_back = comes_back;
	}
}

double StrokeSession::log_odds_if(bool comes_back) const {
	if (!end_) {
		return log_odds();
	}
	if (end_->is_lost) {
		return end_->log_odds;
	}
	return end_->log_odds + return_evidence(usual_, end_->comes_back.value_or(comes_back));
}

/// Predicts the end as with a task. The hand must also have slowed down, because its amplitude is unknown.
bool StrokeSession::is_arriving(double t_s, const Stroke &stroke) const {
	return mode() == MotionMode::PHASE && is_at_end(t_s) &&
			task().amplitude_m * estimate(t_s).velocity < end_speed_share_ * stroke.peak_m_s;
}

/// Enters IDLE when the hand has returned, has not moved for PAUSE_S, or makes another gesture from rest.
void StrokeSession::look_for_return(double t_s, const StrokeFinder &strokes) {
	if (!strokes.strokes().empty() && amplitudes(strokes.strokes().front()) > SHORTEST) {
		const Stroke &stroke = strokes.strokes().front();
		const bool is_gesture = stroke.onset_s < ended_s_; // it still slows down
		stopped_s_ = is_gesture ? will_stop_s(t_s, stroke) : stopped_s_;
		moved_s_ = std::max(moved_s_, is_gesture ? stopped_s_ : t_s);
		if (is_next(stroke, strokes)) {
			not_before_s_ = stroke.onset_s;
			go_idle(t_s);
			return;
		}
	}
	const bool has_returned = element_m_ < HALF_BACK * max_element_m_;
	if (has_returned) {
		returned_s_ = t_s;
	}
	if (has_returned || t_s - moved_s_ > PAUSE_S) {
		not_before_s_ = t_s; // the return is no gesture
		go_idle(t_s);
	}
}

/// The stroke is another gesture after this one. The stop of a slow hand is less certain, so that it needs a
/// longer pause.
bool StrokeSession::is_next(const Stroke &stroke, const StrokeFinder &strokes) const {
	const double hold_s = PAUSE_S + SLOWS_DOWN * (stopped_s_ - started_s());
	if (stroke.onset_s < stopped_s_ + hold_s) {
		return false;
	}
	const StrokeEvidence evidence = evidence_of(stroke, strokes, model_direction(stroke));
	return evidence.rest > 0.0 && best_odds(evidence) > 0.0;
}

bool StrokeSession::shares_path(const GestureSession &other) const {
	return !usual_.is_strike && std::ranges::any_of(directions_, [&other](const FeaturePlace &direction) {
		return direction.dot(other.axis()) > PARALLEL;
	});
}

bool StrokeSession::is_return(const Stroke &stroke) const {
	const FeaturePlace chord = stroke.to - stroke.from;
	return stage() == Stage::ENDED && stroke.onset_s > started_s() &&
			chord.dot(direction_) < -PARALLEL * chord.norm();
}

void StrokeSession::end_gesture(double t_s) {
	end_.reset();
	enter_ended(t_s);
}

} // namespace steadyhand
