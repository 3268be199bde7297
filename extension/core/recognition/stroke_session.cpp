#include "recognition/stroke_session.h"

#include "base/parameters.h"

#include <algorithm>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::strokes;
using namespace parameters::sessions;

/// Start of the movement of a stroke. At its onset the hand has already moved: the start is the least
/// position along `direction`, a unit vector, shortly before the onset. Means suppress the noise.
FeaturePlace start_of(const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &direction) {
	FeaturePlace start = stroke.from, sum = FeaturePlace::Zero();
	int count = 0;
	double since_s = -INFINITY;
	const auto end_part = [&] {
		const bool is_behind = count > 0 && (sum / count - start).dot(direction) < 0.0;
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
		element_m_ = along(last_place());
		max_element_m_ = std::max(max_element_m_, element_m_);
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

FeaturePlace StrokeSession::model_direction(const Stroke &stroke) const {
	const FeaturePlace chord = stroke.to - stroke.from;
	return *std::ranges::max_element(
			directions_, {}, [&chord](const FeaturePlace &direction) { return direction.dot(chord); });
}

/// Evidence of a stroke of `strokes` for the model's `direction`. Also tries the stroke as measured: a jump
/// of the tracker may have been a motion of the hand.
StrokeEvidence StrokeSession::evidence_of(
		const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &direction) const {
	Stroke with_rest = stroke;
	with_rest.motion_before_m = strokes.motion_before_m(stroke);
	const auto of = [&](const Stroke &one) { return stroke_evidence(one, direction, usual_); };
	StrokeEvidence evidence = of(with_rest);
	const StrokeEvidence as_measured = of(with_rest.as_measured());
	if (as_measured.sum() > evidence.sum()) {
		evidence = as_measured;
	}
	if (is_repetition(stroke)) {
		evidence.rest = std::max(evidence.rest, 0.0);
	}
	return evidence;
}

/// Measures the motion along the hand's own direction, when the stroke is long enough to have one.
void StrokeSession::update_direction(const FeaturePlace &to) {
	const FeaturePlace chord = to - from_;
	if (!feature().is_radius && chord.norm() > SHORTEST * task().amplitude_m) {
		direction_ = chord.normalized();
	}
}

bool StrokeSession::is_repetition(const Stroke &stroke) const {
	return may_repeat_ && stroke.onset_s - returned_s_ < PAUSE_S;
}

double StrokeSession::amplitudes(const Stroke &stroke) const {
	return (stroke.to - stroke.from).norm() / task().amplitude_m;
}

void StrokeSession::look_for_start(double t_s, const StrokeFinder &strokes) {
	start_ = last_place();
	direction_ = feature().direction(task());
	for (const Stroke &stroke : strokes.strokes()) {
		const bool is_slow = strike_evidence(stroke, usual_) < 0.0;
		const double least = stroke.onset_s < rejected_s_ || is_slow ? UNDER_WAY : SHORTEST;
		if (stroke.onset_s < not_before_s_ || amplitudes(stroke) < least || !stroke.is_from_rest) {
			continue;
		}
		const FeaturePlace direction = model_direction(stroke);
		const StrokeEvidence evidence = evidence_of(stroke, strokes, direction);
		const double remaining =
				evidence.max_remaining + slowing_evidence(stroke, strokes.speed_m_s(), task().amplitude_m);
		if (LOG_PRIOR_NO_TASK + evidence.without_size() + remaining > 0.0) {
			set_log_odds(LOG_PRIOR_NO_TASK + evidence.without_size());
			from_ = stroke.from;
			direction_ = model_direction_ = direction;
			update_direction(stroke.to);
			// A hand that waves when it comes into view must rest before each gesture.
			may_repeat_ = evidence.rest >= 0.0 || stroke.tracked_before_s >= REST_S;
			start_ = start_of(stroke, strokes, direction_);
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
	element_m_ = max_element_m_ = along(last_place());
	blend_from(before, t_s, START_BLEND_PER_S);
}

void StrokeSession::abort(double t_s) {
	not_before_s_ = t_s;
	if (stage() != Stage::IDLE) {
		go_idle(t_s);
	}
}

void StrokeSession::go_idle(double t_s) {
	end_.reset();
	set_log_odds(LOG_PRIOR_NO_TASK);
	enter_idle(t_s);
}

} // namespace steadyhand
