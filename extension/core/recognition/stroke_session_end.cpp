#include "recognition/stroke_session.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// A stroke that is hopeless for so long was none after all: one that is well under way, or any where the
/// gesture has come no further than this, amplitudes. It begins again where it is well under way.
constexpr double HOPELESS_S = 0.1;
constexpr double BARELY_BEGUN = 0.2;
/// log odds from which on an end is taken before the hand has come to it.
constexpr double SURE = 1.5;
/// A hand that has slowed down to this share of its peak may be at the end, if it goes no further from there
/// than this, amplitudes: what follows is the tracker's error.
constexpr double SLOWED = 0.5;
constexpr double TAIL = 0.25;
/// At rest at the end a hand is shown to stray as far as trembling goes, and so many times as far as it did
/// before the gesture, but no further than this, amplitudes.
constexpr double STRAYS = 2.0;
constexpr double FARTHEST_STRAY = 0.2;
/// Cosine between directions that are reciprocal.
constexpr double OPPOSITE = 0.7;
/// Where tracking is lost this near to the end, that was the end.
constexpr double LOST_AT_END = 0.7;

/// log odds by the best that may come of it.
double best_odds(const StrokeEvidence &evidence) {
	return LOG_PRIOR_OPEN + evidence.so_far() + evidence.outlook;
}

} // namespace

bool StrokeSession::is_near_end(const Stroke &stroke) const {
	return amplitudes(stroke) > LOST_AT_END;
}

void StrokeSession::on_dropout(double t_s, const StrokeFinder &strokes) {
	const bool is_gone = t_s >= strokes.news_s() + ABSENCES_S.back();
	if (stage() == Stage::ACTIVE && t_s >= strokes.news_s() + ABSENCES_S.front()) {
		look_for_end(t_s, strokes, true);
	}
	if (stage() != Stage::IDLE && !may_end_ && is_gone) {
		abort(t_s);
	}
}

/// is_missed: nothing more is expected to be seen of it.
void StrokeSession::look_for_end(double t_s, const StrokeFinder &strokes, bool is_missed) {
	double size = IMPOSSIBLE, under_way = IMPOSSIBLE;
	bool is_hopeless = false;
	for (const Stroke &stroke : strokes.strokes()) {
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < SHORTEST) {
			continue;
		}
		const StrokeEvidence evidence = evidence_of(stroke, strokes, axis_);
		const double path = LOG_PRIOR_OPEN + evidence.so_far(), best = best_odds(evidence);
		aim(stroke.to);
		if (best > 0.0) {
			likely_s_ = t_s;
			furthest_ = std::max(furthest_, amplitudes(stroke));
			moved_s_ = std::max(moved_s_, stroke.moved_s);
			under_way = std::max(under_way, path);
			set_log_odds(under_way);
		} else if (best < HOPELESS && (furthest_ < BARELY_BEGUN || amplitudes(stroke) > WELL_UNDER_WAY)) {
			is_hopeless = true;
		}
		const double ended = LOG_PRIOR_OPEN + evidence.sum();
		if (ended > slowed_odds_ && strokes.speed_m_s() < SLOWED * stroke.peak_m_s) {
			slowed_odds_ = ended;
			slowed_at_ = stroke.to;
		}
		const bool has_stayed = (stroke.to - slowed_at_).norm() < TAIL * task().amplitude_m;
		const bool is_end = is_missed ? is_near_end(stroke) : strokes.ended();
		if (is_end) {
			size = std::max({ size, ended, has_stayed ? slowed_odds_ : ended });
		} else if (ended > SURE && is_arriving(t_s, stroke)) {
			size = std::max(size, ended);
		}
	}
	if (size > 0.0) {
		set_log_odds(size);
		may_end_ = true;
		end_.end(t_s, strokes.strokes().front());
	} else if (t_s - moved_s_ > EndHold::HOLD_S) {
		abort(t_s); // half-way; the way back of what is given up is over by now, and no gesture
	} else if (is_hopeless && t_s - likely_s_ > HOPELESS_S) {
		hopeless_s_ = t_s;
		dismiss(t_s);
	}
}

/// The end is predicted as with a task; but how far this hand will go is not known, so that it must have
/// slowed down too.
bool StrokeSession::is_arriving(double t_s, const Stroke &stroke) const {
	return mode() == MotionMode::PHASE && is_at_end(t_s) &&
			task().amplitude_m * estimate(t_s).velocity < end_speed_share_ * stroke.peak_m_s;
}

void StrokeSession::look_for_return(double t_s, const StrokeFinder &strokes) {
	const bool is_on_its_way = !strokes.strokes().empty() && amplitudes(strokes.strokes().front()) > SHORTEST;
	if (is_on_its_way) {
		const Stroke &stroke = strokes.strokes().front();
		end_.follow(t_s, stroke);
		return_log_odds_ = LOG_PRIOR_TASK +
				stroke_evidence(stroke, -axis_, task().amplitude_m, model().duration_mean_s).path;
	}
	if (is_on_its_way && is_next(strokes.strokes().front(), strokes)) {
		not_before_s_ = strokes.strokes().front().onset_s;
		dismiss(t_s);
	} else if (end_.has_returned()) {
		not_before_s_ = returned_s_ = t_s; // the way back is no gesture
		dismiss(t_s);
	} else if (end_.is_at_new_start(t_s, strokes, task().amplitude_m)) {
		not_before_s_ = end_.may_set_out_s();
		dismiss(t_s);
	}
}

/// A way back that began long after the hand stood at the end, at rest, is a gesture of its own, however the
/// tracker wandered meanwhile; and so is a way on after a second.
bool StrokeSession::is_next(const Stroke &stroke, const StrokeFinder &strokes) const {
	if (amplitudes(stroke) < TAIL) {
		return false;
	}
	if ((stroke.to - stroke.from).dot(axis_) > 0.0) {
		return stroke.onset_s >= end_.may_set_out_s() && best_odds(evidence_of(stroke, strokes, axis_)) > 0.0;
	}
	const double stray_m = SHORTEST * task().amplitude_m + STRAYS * begun_unrest_m_;
	const bool is_reverse_known = std::ranges::any_of(
			directions_, [this](const FeaturePlace &direction) { return direction.dot(axis_) < -OPPOSITE; });
	if (!is_reverse_known ||
			!end_.has_rested(stroke, strokes, std::min(stray_m, FARTHEST_STRAY * task().amplitude_m))) {
		return false;
	}
	const StrokeEvidence evidence = evidence_of(stroke, strokes, -axis_);
	return evidence.rest > 0.0 && best_odds(evidence) > 0.0;
}

void StrokeSession::end_gesture(double t_s) {
	may_end_ = false;
	arrive(t_s);
}

} // namespace steadyhand
