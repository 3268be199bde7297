// GestureFollower where no task is known: strokes say where a gesture starts, which way it goes and when it
// ends.

#include "motion/gesture_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

/// Shorter strokes (in amplitudes) do not say where they go.
constexpr double SHORTEST = 0.12;
/// How far off the model's axis people go, radians, and how well a tracker sees where they go, amplitudes.
constexpr double AIM = 0.14;
constexpr double AIM_SEEN = 0.03;
/// log odds, at the best that may come, below which a stroke that is well under way was none after all, and
/// how far that is.
constexpr double HOPELESS = -8.0;
constexpr double WELL_UNDER_WAY = 0.3;
/// log odds from which on an end is taken before the hand has come to it.
constexpr double SURE = 1.5;
/// A hand that has slowed down to this share of its peak may be at the end, if it goes no further from there
/// than this, amplitudes: what follows is the tracker's error.
constexpr double SLOWED = 0.5;
constexpr double TAIL = 0.25;
/// A hand that has rested this long half-way has given up; one that has rested so long at the end is at a new
/// start.
constexpr double HOLD_S = 1.0;
/// A gesture that comes again this soon after its own way back needs no rest before it.
constexpr double AGAIN_S = 1.0;
/// The hand has turned back once it is at this share of the furthest that it went.
constexpr double RETURNED = 0.5;
/// Where tracking is lost this near to the end, that was the end.
constexpr double LOST_AT_END = 0.85;
constexpr double STARTING_RATE_PER_S = 100.0;
constexpr double REPLAY_BEFORE_S = 0.15; ///< for the estimator to see the hand at rest

} // namespace

FeaturePlace GestureFollower::way_of(const Stroke &stroke) const {
	const FeaturePlace direction = feature_->direction(task_);
	const bool is_reverse = model_->both_ways && (stroke.to - stroke.from).dot(direction) < 0.0;
	return is_reverse ? FeaturePlace(-direction) : direction;
}

/// way: in the stroke's sense.
StrokeEvidence GestureFollower::evidence_of(const Stroke &stroke, const FeaturePlace &way) const {
	StrokeEvidence evidence = stroke_evidence(stroke, way, task_.amplitude_m, model_->duration_mean_s);
	if (stroke.onset_s - returned_s_ < AGAIN_S) {
		evidence.rest = std::max(evidence.rest, 0.0);
	}
	return evidence;
}

/// The motion is the way along the hand's own direction; while that is short, between it and the axis.
void GestureFollower::aim(const FeaturePlace &to) {
	const FeaturePlace chord = to - from_;
	const double length = chord.norm() / task_.amplitude_m;
	if (feature_->is_radius || length < SHORTEST) {
		return;
	}
	const double seen = AIM_SEEN / length;
	const double share = AIM * AIM / (AIM * AIM + seen * seen);
	way_ = (axis_ + share * (chord.normalized() - axis_)).normalized();
}

double GestureFollower::amplitudes(const Stroke &stroke) const {
	return (stroke.to - stroke.from).norm() / task_.amplitude_m;
}

/// stroke: one of the finder's. What was lost near the end was over too.
bool GestureFollower::is_over(const Stroke &stroke, const StrokeFinder &strokes) const {
	return stroke.is_lost ? amplitudes(stroke) > LOST_AT_END : strokes.ended();
}

void GestureFollower::watch(double t_s, const StrokeFinder &strokes) {
	claims_ = false;
	log_odds_of_return_ = -std::numeric_limits<double>::infinity();
	switch (stage_) {
		case Stage::RESTING:
			look_for_start(t_s, strokes);
			break;
		case Stage::MOVING:
			look_for_end(t_s, strokes);
			break;
		case Stage::ARRIVED:
			look_for_return(t_s, strokes);
			break;
	}
}

void GestureFollower::look_for_start(double t_s, const StrokeFinder &strokes) {
	const bool has_stroke = !strokes.strokes().empty();
	start_ = has_stroke ? strokes.strokes().front().seen_from : place_;
	way_ = feature_->direction(task_);
	for (const Stroke &stroke : strokes.strokes()) {
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < SHORTEST) {
			continue;
		}
		const FeaturePlace way = way_of(stroke);
		if (LOG_PRIOR_OPEN + most_evidence(stroke, way, task_.amplitude_m) < 0.0) {
			continue;
		}
		const StrokeEvidence evidence = evidence_of(stroke, way);
		const double rest = is_over(stroke, strokes) ? std::max(evidence.size, 0.0) : evidence.outlook;
		if (LOG_PRIOR_OPEN + evidence.so_far() + rest > 0.0) {
			log_odds_ = LOG_PRIOR_OPEN + evidence.so_far();
			start_ = stroke.seen_from;
			from_ = stroke.from;
			way_ = axis_ = way;
			aim(stroke.to);
			start_from(t_s, stroke, strokes);
			look_for_end(t_s, strokes); // it may be over already
			return;
		}
	}
}

void GestureFollower::start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes) {
	const Motion before = motion(t_s);
	const double onset_s = stroke.onset_s;
	window_.reset();
	if (mode_ == MotionMode::PHASE) {
		phase_.reset();
	}
	strokes.frames_since(onset_s - REPLAY_BEFORE_S, [&](double frame_s, const FeaturePlace &place) {
		if (frame_s < t_s) {
			const double x_m = (place - start_).dot(way_);
			window_.push(frame_s, x_m);
			if (mode_ == MotionMode::PHASE) {
				phase_.recall(frame_s, x_m / task_.amplitude_m, place / task_.amplitude_m);
			}
		}
	});
	phase_.catch_up();
	begin(t_s, (place_ - start_).dot(way_) / task_.amplitude_m);
	likely_s_ = t_s;
	slowed_odds_ = -std::numeric_limits<double>::infinity();
	const Motion after = synthesised(t_s);
	blend_.start(t_s, before.value_m - after.value_m, before.velocity_m_s - after.velocity_m_s,
			STARTING_RATE_PER_S);
}

void GestureFollower::look_for_end(double t_s, const StrokeFinder &strokes) {
	double size = -std::numeric_limits<double>::infinity(), under_way = size;
	bool is_hopeless = false;
	for (const Stroke &stroke : strokes.strokes()) {
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < SHORTEST) {
			continue;
		}
		const StrokeEvidence evidence = evidence_of(stroke, axis_);
		const double path = LOG_PRIOR_OPEN + evidence.so_far();
		aim(stroke.to);
		if (path + evidence.outlook > 0.0) {
			likely_s_ = t_s;
			log_odds_ = under_way = std::max(under_way, path);
		} else if (path + evidence.outlook < HOPELESS && amplitudes(stroke) > WELL_UNDER_WAY) {
			is_hopeless = true;
		}
		const double ended = LOG_PRIOR_OPEN + evidence.sum();
		if (ended > slowed_odds_ && strokes.speed_m_s() < SLOWED * stroke.peak_m_s) {
			slowed_odds_ = ended;
			slowed_at_ = stroke.to;
		}
		const bool has_stayed = (stroke.to - slowed_at_).norm() < TAIL * task_.amplitude_m;
		if (is_over(stroke, strokes)) {
			size = std::max({ size, ended, has_stayed ? slowed_odds_ : ended });
		} else if (ended > SURE && is_arriving(t_s, stroke)) {
			size = std::max(size, ended);
		}
	}
	if (size > 0.0) {
		log_odds_ = size;
		claims_ = true;
	} else if (t_s - likely_s_ > (is_hopeless ? 0.1 : HOLD_S)) {
		dismiss(t_s);
	}
}

/// The end is predicted as with a task; but how far this hand will go is not known, so that it must have
/// slowed down too.
bool GestureFollower::is_arriving(double t_s, const Stroke &stroke) const {
	return mode_ == MotionMode::PHASE && has_arrived(t_s) &&
			task_.amplitude_m * phase_.at(t_s).velocity < end_speed_share_ * stroke.peak_m_s;
}

void GestureFollower::look_for_return(double t_s, const StrokeFinder &strokes) {
	const double along = (place_ - start_).dot(way_) / task_.amplitude_m;
	furthest_ = std::max(furthest_, along);
	const bool is_on_its_way = !strokes.strokes().empty() && amplitudes(strokes.strokes().front()) > SHORTEST;
	if (is_on_its_way) {
		likely_s_ = t_s;
		log_odds_of_return_ = LOG_PRIOR_TASK +
				stroke_evidence(strokes.strokes().front(), -axis_, task_.amplitude_m, model_->duration_mean_s)
						.path;
	}
	if (along < RETURNED * furthest_ || t_s - likely_s_ > HOLD_S) {
		not_before_s_ = returned_s_ = t_s; // the way back is no gesture
		dismiss(t_s);
	}
}

void GestureFollower::confirm(double t_s) {
	claims_ = false;
	furthest_ = (place_ - start_).dot(way_) / task_.amplitude_m;
	likely_s_ = t_s;
	enter(Stage::ARRIVED, t_s);
}

void GestureFollower::give_way(double t_s) {
	not_before_s_ = t_s;
	if (stage_ != Stage::RESTING) {
		dismiss(t_s);
	}
}

void GestureFollower::dismiss(double t_s) {
	claims_ = false;
	log_odds_ = LOG_PRIOR_OPEN;
	enter(Stage::RESTING, t_s);
}

} // namespace steadyhand
