#include "recognition/open_follower.h"

#include "recognition/stroke_start.h"

#include <algorithm>
#include <limits>

namespace steadyhand {
namespace {

/// A start that was shown so far elsewhere, in amplitudes, is corrected for so long.
constexpr double CORRECTED_BY = 0.1;
constexpr double CORRECTED_FOR_S = 0.3;
constexpr double IMPOSSIBLE = -std::numeric_limits<double>::infinity(); ///< log odds
/// Shorter strokes (in amplitudes) do not say where they go.
constexpr double SHORTEST = 0.12;
/// Nor do those that are shorter than so many times the tracker's noise, but for such as are well under way.
constexpr double TREMBLES = 10.0;
/// log odds, at the best that may come, below which for so long a stroke was none after all: one that is well
/// under way, amplitudes, or any where the gesture has come no further than the other. It begins again where
/// it is well under way.
constexpr double HOPELESS = -8.0;
constexpr double HOPELESS_S = 0.1;
constexpr double WELL_UNDER_WAY = 0.3;
constexpr double BARELY_BEGUN = 0.2;
/// log odds from which on an end is taken before the hand has come to it.
constexpr double SURE = 1.5;
/// A hand that has slowed down to this share of its peak may be at the end, if it goes no further from there
/// than this, amplitudes: what follows is the tracker's error.
constexpr double SLOWED = 0.5;
constexpr double TAIL = 0.25;
/// A gesture that comes again this soon after its own way back needs no rest before it; and competes with
/// others as if it had been seen, nats: a small gesture's hand has not settled while a large one's has.
constexpr double AGAIN_S = 1.0;
constexpr double AGAIN = 2.0;
/// At rest at the end a hand is shown to stray as far as trembling goes, and so many times as far as it did
/// before the gesture, but no further than this, amplitudes.
constexpr double STRAYS = 2.0;
constexpr double FARTHEST_STRAY = 0.2;
/// Where tracking is lost this near to the end, that was the end.
constexpr double LOST_AT_END = 0.7;
constexpr double STARTING_RATE_PER_S = 100.0;

/// The model's speed at this phase, its end, in shares of its peak, and what people slow down less.
double end_speed_share(const GestureModel &model, double end_phase) {
	constexpr double SLOWED_LESS = 0.25;
	constexpr int POINTS = 50;
	double peak = 0.0;
	for (int i = 0; i <= POINTS; ++i) {
		peak = std::max(peak, evaluate(model, static_cast<double>(i) / POINTS).slope);
	}
	return peak > 0.0 ? SLOWED_LESS + std::max(evaluate(model, end_phase).slope, 0.0) / peak : SLOWED_LESS;
}

/// log odds by the best that may come of it.
double best_odds(const StrokeEvidence &evidence) {
	return LOG_PRIOR_OPEN + evidence.so_far() + evidence.outlook;
}

} // namespace

OpenFollower::OpenFollower(const GestureModel &model, const Synthesis &synthesis) :
		GestureFollower(model, model.typical_task, synthesis, false),
		end_speed_share_(end_speed_share(model, ARRIVED_PHASE)) {}

std::optional<double> OpenFollower::see(const HandFrame &frame, bool has_place, const StrokeFinder &strokes) {
	claims_ = false;
	log_odds_of_return_ = IMPOSSIBLE;
	if (!has_place) {
		return std::nullopt;
	}
	end_.see(strokes, gone_m(strokes), along(last_place()), task().amplitude_m);
	switch (stage()) {
		case Stage::RESTING:
			look_for_start(frame.t_s, strokes);
			break;
		case Stage::MOVING:
			correct_start(frame.t_s, strokes);
			look_for_end(frame.t_s, strokes);
			break;
		case Stage::ARRIVED:
			look_for_return(frame.t_s, strokes);
			break;
	}
	return along(last_place());
}

FeaturePlace OpenFollower::way_of(const Stroke &stroke) const {
	const FeaturePlace direction = feature().direction(task());
	const bool is_reverse = model().both_ways && (stroke.to - stroke.from).dot(direction) < 0.0;
	return is_reverse ? FeaturePlace(-direction) : direction;
}

/// stroke: one of the finder's; way: in its sense.
StrokeEvidence OpenFollower::evidence_of(
		const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) const {
	Stroke watched = stroke;
	watched.unrest_m = strokes.unrest_m(stroke);
	StrokeEvidence evidence = stroke_evidence(watched, way, task().amplitude_m, model().duration_mean_s);
	if (comes_again(stroke)) {
		evidence.rest = std::max(evidence.rest, 0.0);
	}
	return evidence;
}

/// The motion is the way along the hand's own direction, once that can be told.
void OpenFollower::aim(const FeaturePlace &to) {
	const FeaturePlace chord = to - from_;
	if (!feature().is_radius && chord.norm() > SHORTEST * task().amplitude_m) {
		way_ = chord.normalized();
	}
}

bool OpenFollower::comes_again(const Stroke &stroke) const {
	return may_come_again_ && stroke.onset_s - returned_s_ < AGAIN_S;
}

double OpenFollower::amplitudes(const Stroke &stroke) const {
	return (stroke.to - stroke.from).norm() / task().amplitude_m;
}

/// How far the hand is, without the steps that no hand makes.
double OpenFollower::gone_m(const StrokeFinder &strokes) const {
	return (strokes.place_m() - from_).dot(way_);
}

bool OpenFollower::is_near_end(const Stroke &stroke) const {
	return amplitudes(stroke) > LOST_AT_END;
}

/// stroke: one of the finder's. What was lost near the end was over too.
bool OpenFollower::is_over(const Stroke &stroke, const StrokeFinder &strokes) const {
	return stroke.is_lost ? is_near_end(stroke) : strokes.ended();
}

void OpenFollower::look_for_start(double t_s, const StrokeFinder &strokes) {
	const bool has_stroke = !strokes.strokes().empty();
	start_ = has_stroke ? strokes.strokes().front().seen_from : last_place();
	way_ = feature().direction(task());
	const double trembling = TREMBLES * strokes.noise_m() / task().amplitude_m;
	const double shortest = std::clamp(trembling, SHORTEST, WELL_UNDER_WAY);
	for (const Stroke &stroke : strokes.strokes()) {
		const double least = stroke.onset_s < hopeless_s_ ? WELL_UNDER_WAY : shortest;
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < least) {
			continue;
		}
		const FeaturePlace way = way_of(stroke);
		if (LOG_PRIOR_OPEN + most_evidence(stroke, way, task().amplitude_m) < 0.0) {
			continue;
		}
		const StrokeEvidence evidence = evidence_of(stroke, strokes, way);
		const double yet = evidence.outlook + shortfall(stroke, strokes.speed_m_s(), task().amplitude_m);
		const double rest = is_over(stroke, strokes) ? std::max(evidence.size, yet) : yet;
		if (LOG_PRIOR_OPEN + evidence.so_far() + rest > 0.0) {
			set_log_odds(LOG_PRIOR_OPEN + evidence.so_far());
			from_ = stroke.from;
			way_ = axis_ = way;
			aim(stroke.to);
			// A hand that came into view waving is not excused a second time.
			may_come_again_ = evidence.rest >= 0.0 || stroke.watched_s >= Stroke::REST_S;
			begun_ = stroke;
			begun_step_m_ = strokes.step_m();
			start_ = start_of(stroke, strokes, way_);
			start_from(t_s, stroke, strokes);
			look_for_end(t_s, strokes); // it may be over already
			return;
		}
	}
}

void OpenFollower::start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes) {
	const Motion before = motion(t_s);
	forget_frames();
	strokes.frames_since(stroke.onset_s - BEFORE_ONSET_S,
			[&](double frame_s, const FeaturePlace &place, const FeaturePlace & /*step*/) {
				if (frame_s < t_s) {
					recall(frame_s, along(place), place);
				}
			});
	catch_up();
	begin(t_s, along(last_place()) / task().amplitude_m);
	likely_s_ = moved_s_ = t_s;
	furthest_ = 0.0;
	end_.begin(begun_.onset_s, along(last_place()));
	slowed_odds_ = IMPOSSIBLE;
	blend_from(before, t_s, STARTING_RATE_PER_S);
}

/// Where the tracker had jumped when the hand set out, and is back: the motion counts from there, too.
void OpenFollower::correct_start(double t_s, const StrokeFinder &strokes) {
	const double least_m = CORRECTED_BY * task().amplitude_m;
	const bool has_stepped = (strokes.step_m() - begun_step_m_).norm() > least_m;
	if (!has_stepped || t_s - stage_began_s() > CORRECTED_FOR_S) {
		return;
	}
	const FeaturePlace start = start_of(begun_, strokes, way_);
	if ((start - start_).norm() > least_m) {
		start_ = start;
		begun_step_m_ = strokes.step_m();
		start_from(t_s, begun_, strokes);
	}
}

void OpenFollower::miss(double t_s, const StrokeFinder &strokes) {
	const bool is_gone = t_s >= strokes.news_s() + ABSENCES_S.back();
	if (stage() == Stage::MOVING && t_s >= strokes.news_s() + ABSENCES_S.front()) {
		look_for_end(t_s, strokes, true);
	}
	if (stage() != Stage::RESTING && !claims_ && is_gone) {
		give_way(t_s);
	}
}

/// is_missed: nothing more is expected to be seen of it.
void OpenFollower::look_for_end(double t_s, const StrokeFinder &strokes, bool is_missed) {
	double size = IMPOSSIBLE, under_way = IMPOSSIBLE;
	bool is_hopeless = false;
	for (const Stroke &stroke : strokes.strokes()) {
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < SHORTEST) {
			continue;
		}
		const StrokeEvidence evidence = evidence_of(stroke, strokes, axis_);
		const double path = LOG_PRIOR_OPEN + evidence.so_far();
		aim(stroke.to);
		if (best_odds(evidence) > 0.0) {
			likely_s_ = t_s;
			furthest_ = std::max(furthest_, amplitudes(stroke));
			moved_s_ = std::max(moved_s_, stroke.moved_s);
			const double again = comes_again(stroke) ? std::max(AGAIN - evidence.rest, 0.0) : 0.0;
			under_way = std::max(under_way, path + again);
			set_log_odds(under_way);
		} else if (best_odds(evidence) < HOPELESS &&
				(amplitudes(stroke) > WELL_UNDER_WAY || furthest_ < BARELY_BEGUN)) {
			is_hopeless = true;
		}
		const double ended = LOG_PRIOR_OPEN + evidence.sum();
		if (ended > slowed_odds_ && strokes.speed_m_s() < SLOWED * stroke.peak_m_s) {
			slowed_odds_ = ended;
			slowed_at_ = stroke.to;
		}
		const bool has_stayed = (stroke.to - slowed_at_).norm() < TAIL * task().amplitude_m;
		if (is_missed ? is_near_end(stroke) : is_over(stroke, strokes)) {
			size = std::max({ size, ended, has_stayed ? slowed_odds_ : ended });
		} else if (ended > SURE && is_arriving(t_s, stroke)) {
			size = std::max(size, ended);
		}
	}
	if (size > 0.0) {
		set_log_odds(size);
		claims_ = true;
		end_.end(t_s, strokes.strokes().front(), gone_m(strokes));
	} else if (t_s - moved_s_ > HeldEnd::HOLD_S) {
		give_way(t_s); // half-way; the way back of what is given up is over by now, and no gesture
	} else if (is_hopeless && t_s - likely_s_ > HOPELESS_S) {
		hopeless_s_ = t_s;
		dismiss(t_s);
	}
}

/// The end is predicted as with a task; but how far this hand will go is not known, so that it must have
/// slowed down too.
bool OpenFollower::is_arriving(double t_s, const Stroke &stroke) const {
	return mode() == MotionMode::PHASE && is_at_end(t_s) &&
			task().amplitude_m * estimate(t_s).velocity < end_speed_share_ * stroke.peak_m_s;
}

void OpenFollower::look_for_return(double t_s, const StrokeFinder &strokes) {
	const bool is_on_its_way = !strokes.strokes().empty() && amplitudes(strokes.strokes().front()) > SHORTEST;
	if (is_on_its_way) {
		const Stroke &stroke = strokes.strokes().front();
		end_.follow(t_s, stroke, task().amplitude_m);
		log_odds_of_return_ = LOG_PRIOR_TASK +
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
bool OpenFollower::is_next(const Stroke &stroke, const StrokeFinder &strokes) const {
	if (amplitudes(stroke) < TAIL) {
		return false;
	}
	if ((stroke.to - stroke.from).dot(axis_) > 0.0) {
		return stroke.onset_s >= end_.may_set_out_s() && best_odds(evidence_of(stroke, strokes, axis_)) > 0.0;
	}
	const double stray_m = SHORTEST * task().amplitude_m + STRAYS * begun_.unrest_m;
	if (!model().both_ways ||
			!end_.has_rested(stroke, strokes, std::min(stray_m, FARTHEST_STRAY * task().amplitude_m))) {
		return false;
	}
	const StrokeEvidence evidence = evidence_of(stroke, strokes, -axis_);
	return evidence.rest > 0.0 && best_odds(evidence) > 0.0;
}

void OpenFollower::confirm(double t_s) {
	claims_ = false;
	arrive(t_s);
}

void OpenFollower::give_way(double t_s) {
	not_before_s_ = t_s;
	if (stage() != Stage::RESTING) {
		dismiss(t_s);
	}
}

void OpenFollower::dismiss(double t_s) {
	claims_ = false;
	set_log_odds(LOG_PRIOR_OPEN);
	rest(t_s);
}

} // namespace steadyhand
