#include "recognition/stroke_session.h"

#include "base/parameters.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::strokes;
using namespace parameters::sessions;

/// Where the movement of a stroke of the finder starts. A stroke's onset is some hundredths of the amplitude
/// late: the start is the hindmost place of the time before it. way: unit vector.
FeaturePlace start_of(const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) {
	FeaturePlace start = stroke.from, sum = FeaturePlace::Zero();
	int count = 0;
	double since_s = -INFINITY;
	const auto end_part = [&] {
		const bool is_behind = count > 0 && (sum / count - start).dot(way) < 0.0;
		start = is_behind ? FeaturePlace(sum / count) : start;
		sum = FeaturePlace::Zero();
		count = 0;
	};
	strokes.frames_since(stroke.onset_s - BEFORE_ONSET_S, [&](double frame_s, const FeaturePlace &place) {
		if (frame_s > stroke.onset_s) {
			return;
		}
		if (frame_s > since_s + MEAN_S) {
			end_part();
			since_s = frame_s;
		}
		sum += place;
		++count;
	});
	end_part();
	return start;
}

} // namespace

StrokeSession::StrokeSession(const GestureModel &model, const Synthesis &synthesis) :
		GestureSession(model, model.typical_task, synthesis, false), usual_(usual_stroke(model)),
		end_speed_share_(SLOWED_LESS + speed_share(model, END_PHASE)), directions_{ FeaturePlace::Zero() } {
	if (feature().direction == nullptr) {
		return; // its strokes have no direction
	}
	directions_ = { feature().direction(task()) };
	for (const Eigen::Vector3d &axis : model.other_axes) {
		directions_.push_back(feature().direction({ task().start_m, axis, task().amplitude_m }));
	}
}

std::optional<double> StrokeSession::measure(
		const HandFrame &frame, bool has_place, const StrokeFinder &strokes) {
	if (!has_place) {
		return std::nullopt;
	}
	if (measurement().is_usable()) {
		gone_m_ = along(last_place());
		furthest_m_ = std::max(furthest_m_, gone_m_);
	}
	switch (stage()) {
		case Stage::IDLE:
			look_for_start(frame.t_s, strokes);
			break;
		case Stage::ACTIVE:
			watch_end(frame.t_s, strokes);
			break;
		case Stage::ENDED:
			look_for_return(frame.t_s, strokes);
			break;
	}
	return along(last_place());
}

FeaturePlace StrokeSession::way_of(const Stroke &stroke) const {
	const FeaturePlace chord = stroke.to - stroke.from;
	return *std::ranges::max_element(
			directions_, {}, [&chord](const FeaturePlace &direction) { return direction.dot(chord); });
}

/// stroke: one of the finder's; way: direction of the model that it follows. A jump of the tracker may have
/// been the hand's.
StrokeEvidence StrokeSession::evidence_of(
		const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) const {
	Stroke watched = stroke;
	watched.motion_before_m = strokes.motion_before_m(stroke);
	const auto of = [&](const Stroke &one) { return stroke_evidence(one, way, usual_); };
	StrokeEvidence evidence = of(watched);
	const StrokeEvidence shown = of(watched.as_measured());
	if (shown.sum() > evidence.sum()) {
		evidence = shown;
	}
	if (comes_again(stroke)) {
		evidence.rest = std::max(evidence.rest, 0.0);
	}
	return evidence;
}

/// The motion is measured along the hand's own direction, once that is clear.
void StrokeSession::aim(const FeaturePlace &to) {
	const FeaturePlace chord = to - from_;
	if (!feature().is_radius && chord.norm() > SHORTEST * task().amplitude_m) {
		way_ = chord.normalized();
	}
}

bool StrokeSession::comes_again(const Stroke &stroke) const {
	return may_come_again_ && stroke.onset_s - returned_s_ < PAUSE_S;
}

double StrokeSession::amplitudes(const Stroke &stroke) const {
	return (stroke.to - stroke.from).norm() / task().amplitude_m;
}

/// An upper bound of the log odds that the stroke can reach; cheap.
double StrokeSession::most_odds(const Stroke &stroke) const {
	return LOG_PRIOR_NO_TASK + max_evidence(stroke, way_of(stroke), task().amplitude_m);
}

/// One of the strokes cannot become the gesture.
bool StrokeSession::goes_elsewhere(const StrokeFinder &strokes) const {
	return std::ranges::any_of(strokes.strokes(), [this](const Stroke &stroke) {
		return stroke.onset_s >= not_before_s_ && most_odds(stroke) < HOPELESS;
	});
}

void StrokeSession::look_for_start(double t_s, const StrokeFinder &strokes) {
	start_ = last_place();
	way_ = feature().direction(task());
	const double trembling = NOISE_TIMES * strokes.noise_m() / task().amplitude_m;
	const double shortest = std::clamp(trembling, SHORTEST, UNDER_WAY);
	for (const Stroke &stroke : strokes.strokes()) {
		const bool is_slow = strike_evidence(stroke, usual_) < 0.0;
		const double least = stroke.onset_s < hopeless_s_ || is_slow ? UNDER_WAY : shortest;
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < least || !stroke.is_from_rest) {
			continue;
		}
		if (most_odds(stroke) < 0.0 || (amplitudes(stroke) < UNDER_WAY && goes_elsewhere(strokes))) {
			continue;
		}
		const FeaturePlace way = way_of(stroke);
		const StrokeEvidence evidence = evidence_of(stroke, strokes, way);
		const double yet =
				evidence.max_remaining + slowing_evidence(stroke, strokes.speed_m_s(), task().amplitude_m);
		if (LOG_PRIOR_NO_TASK + evidence.without_size() + yet > 0.0) {
			set_log_odds(LOG_PRIOR_NO_TASK + evidence.without_size());
			from_ = stroke.from;
			way_ = axis_ = way;
			aim(stroke.to);
			// Not of a hand that waved when it came into view.
			may_come_again_ = evidence.rest >= 0.0 || stroke.tracked_before_s >= REST_S;
			start_ = start_of(stroke, strokes, way_);
			start_from(t_s, stroke, strokes);
			look_for_end(t_s, strokes); // it may have ended already
			return;
		}
	}
}

void StrokeSession::start_from(double t_s, const Stroke &stroke, const StrokeFinder &strokes) {
	const Motion before = motion(t_s);
	reset_frames();
	strokes.frames_since(stroke.onset_s - BEFORE_ONSET_S, [&](double frame_s, const FeaturePlace &place) {
		if (frame_s < t_s) {
			replay(frame_s, along(place));
		}
	});
	begin(t_s, along(last_place()) / task().amplitude_m);
	likely_s_ = moved_s_ = t_s;
	furthest_ = 0.0;
	gone_m_ = furthest_m_ = along(last_place());
	blend_from(before, t_s, START_BLEND_PER_S);
}

void StrokeSession::abort(double t_s) {
	not_before_s_ = t_s;
	if (stage() != Stage::IDLE) {
		dismiss(t_s);
	}
}

void StrokeSession::dismiss(double t_s) {
	end_.reset();
	set_log_odds(LOG_PRIOR_NO_TASK);
	rest(t_s);
}

} // namespace steadyhand
