#pragma once

#include "gesture/gesture_model.h"
#include "strokes/stroke_finder.h"
#include "strokes/usual_stroke.h"

namespace steadyhand {

/// How much a stroke of the hand speaks for a gesture and against the null model, in nats:
/// log P(stroke | gesture) - log P(stroke | none). The null model is a hand that goes anywhere: each
/// direction as likely as any other, lengths and durations log-uniform, any bow and detour, from one stroke
/// into the next. A gesture goes about along its axis, straight, about as far and as long as it was trained,
/// and begins at rest. stroke_evidence.cpp has the densities.
struct StrokeEvidence {
	double path = 0.0;    ///< of direction and straightness: known while the stroke is under way
	double detour = 0.0;  ///< of turns on its way: known as well
	double rest = 0.0;    ///< of the rest before it: known from its onset on
	double size = 0.0;    ///< of length and duration: once it has ended
	double outlook = 0.0; ///< the most that the rest of the way, and size, could yet add

	[[nodiscard]] double so_far() const { return path + detour + rest; }
	[[nodiscard]] double sum() const { return so_far() + size; }
};

/// way: unit vector of the motion element's growth.
[[nodiscard]] StrokeEvidence stroke_evidence(
		const Stroke &stroke, const FeaturePlace &way, const UsualStroke &usual);

/// Evidence of the pace of a stroke that has ended or goes on, nats, <= 0: a strike is never slow. 0 for
/// other gestures: they have any pace. Only gestures along one path are compared by it.
[[nodiscard]] double strike_evidence(const Stroke &stroke, const UsualStroke &usual);

/// Evidence of what the hand does after its stroke, nats: it comes back at once, or it stays.
[[nodiscard]] double return_evidence(const UsualStroke &usual, bool comes_back);

/// By how much the outlook of a stroke is less that slows down long before the gesture's length, nats, <= 0:
/// a minimum jerk whose speed has fallen as far would go little further. speed_m_s: the hand's by now.
[[nodiscard]] double shortfall(const Stroke &stroke, double speed_m_s, double amplitude_m);

/// What so_far() and the rest of the way, or size, come to at most, nats: quickly told of strokes that go
/// elsewhere.
[[nodiscard]] double most_evidence(const Stroke &stroke, const FeaturePlace &way, double amplitude_m);

/// The same for a task that says where the stroke should begin, and from there exactly which way it should
/// go, to the task's end, instead of how long it should be: of direction, straightness and start, nats.
[[nodiscard]] double task_evidence(
		const Stroke &stroke, const FeaturePlace &start, const FeaturePlace &way, double amplitude_m);

/// What that comes to at most, of a stroke that has begun there.
[[nodiscard]] double most_task_evidence(
		const Stroke &stroke, const FeaturePlace &start, const FeaturePlace &way, double amplitude_m);

} // namespace steadyhand
