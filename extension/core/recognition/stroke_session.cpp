#include "recognition/stroke_session.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// A stroke's onset is told by its speed, when the hand has gone some hundredths of the way already: it set
/// out from the furthest back that it was in this time before, by means over parts of it, in which a
/// tracker's noise counts little.
constexpr double BEFORE_ONSET_S = 0.15, REST_PART_S = 0.05;
/// Strokes that are shorter than so many times the tracker's noise do not say where they go, but for such as
/// are well under way.
constexpr double TREMBLES = 10.0;
/// A gesture that comes again this soon after its own way back needs no rest before it.
constexpr double AGAIN_S = 1.0;
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

/// Where the hand set out that makes one of the finder's strokes. way: unit vector.
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
		if (frame_s > since_s + REST_PART_S) {
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
		GestureSession(model, model.typical_task, synthesis, false),
		end_speed_share_(end_speed_share(model, ENDED_PHASE)), directions_{ FeaturePlace::Zero() } {
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
	may_end_ = false;
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
			look_for_end(frame.t_s, strokes);
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

/// stroke: one of the finder's; way: in its sense.
StrokeEvidence StrokeSession::evidence_of(
		const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way) const {
	Stroke watched = stroke;
	watched.unrest_m = strokes.unrest_m(stroke);
	const auto of = [&](const Stroke &one) {
		return stroke_evidence(one, way, task().amplitude_m, model().duration_mean_s);
	};
	StrokeEvidence evidence = of(watched);
	const StrokeEvidence shown = of(watched.as_shown());
	if (shown.sum() > evidence.sum()) {
		evidence = shown;
	}
	if (comes_again(stroke)) {
		evidence.rest = std::max(evidence.rest, 0.0);
	}
	return evidence;
}

/// The motion is the way along the hand's own direction, once that can be told.
void StrokeSession::aim(const FeaturePlace &to) {
	const FeaturePlace chord = to - from_;
	if (!feature().is_radius && chord.norm() > SHORTEST * task().amplitude_m) {
		way_ = chord.normalized();
	}
}

bool StrokeSession::comes_again(const Stroke &stroke) const {
	return may_come_again_ && stroke.onset_s - returned_s_ < AGAIN_S;
}

double StrokeSession::amplitudes(const Stroke &stroke) const {
	return (stroke.to - stroke.from).norm() / task().amplitude_m;
}

/// A bound on the log odds that the stroke, or what is still to come of it, could come to; quickly told.
double StrokeSession::most_odds(const Stroke &stroke) const {
	return LOG_PRIOR_OPEN + most_evidence(stroke, way_of(stroke), task().amplitude_m);
}

/// What the hand does, or did in several strokes, leads anywhere but along the gesture.
bool StrokeSession::goes_elsewhere(const StrokeFinder &strokes) const {
	return std::ranges::any_of(strokes.strokes(), [this](const Stroke &stroke) {
		return stroke.onset_s >= not_before_s_ && most_odds(stroke) < HOPELESS;
	});
}

void StrokeSession::look_for_start(double t_s, const StrokeFinder &strokes) {
	start_ = last_place();
	way_ = feature().direction(task());
	const double trembling = TREMBLES * strokes.noise_m() / task().amplitude_m;
	const double shortest = std::clamp(trembling, SHORTEST, WELL_UNDER_WAY);
	for (const Stroke &stroke : strokes.strokes()) {
		const double least = stroke.onset_s < hopeless_s_ ? WELL_UNDER_WAY : shortest;
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < least || !stroke.is_from_rest) {
			continue;
		}
		if (most_odds(stroke) < 0.0 || (amplitudes(stroke) < WELL_UNDER_WAY && goes_elsewhere(strokes))) {
			continue;
		}
		const FeaturePlace way = way_of(stroke);
		const StrokeEvidence evidence = evidence_of(stroke, strokes, way);
		const double yet = evidence.outlook + shortfall(stroke, strokes.speed_m_s(), task().amplitude_m);
		if (LOG_PRIOR_OPEN + evidence.so_far() + yet > 0.0) {
			set_log_odds(LOG_PRIOR_OPEN + evidence.so_far());
			from_ = stroke.from;
			way_ = axis_ = way;
			aim(stroke.to);
			// A hand that came into view waving is not excused a second time.
			may_come_again_ = evidence.rest >= 0.0 || stroke.watched_s >= Stroke::REST_S;
			start_ = start_of(stroke, strokes, way_);
			start_from(t_s, stroke, strokes);
			look_for_end(t_s, strokes); // it may be over already
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
	slowed_odds_ = IMPOSSIBLE;
	blend_from(before, t_s, STARTING_RATE_PER_S);
}

void StrokeSession::abort(double t_s) {
	not_before_s_ = t_s;
	if (stage() != Stage::IDLE) {
		dismiss(t_s);
	}
}

void StrokeSession::dismiss(double t_s) {
	may_end_ = false;
	set_log_odds(LOG_PRIOR_OPEN);
	rest(t_s);
}

} // namespace steadyhand
