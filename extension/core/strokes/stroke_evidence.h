#pragma once

#include "gesture/gesture_model.h"
#include "strokes/stroke_finder.h"
#include "strokes/usual_stroke.h"

namespace steadyhand {

/// Log likelihood ratio of a stroke, gesture against null model, in nats: log P(stroke | gesture) -
/// log P(stroke | none). The null model is a hand that goes anywhere. Its directions are uniform on the
/// sphere, its lengths and durations log-uniform. It has any bow and detour, and no rest between strokes. A
/// gesture is straight, along its axis, starts at rest, and is about as long as the trained one.
/// stroke_evidence.cpp has the densities.
struct StrokeEvidence {
	double path = 0.0;          ///< of direction and straightness; valid during the stroke
	double detour = 0.0;        ///< of the length of the path; valid during the stroke
	double rest = 0.0;          ///< of the rest before the onset; valid from the onset on
	double size = 0.0;          ///< of length and duration; valid after the end
	double max_remaining = 0.0; ///< upper bound of what the rest of the stroke can add, with size

	[[nodiscard]] double without_size() const { return path + detour + rest; }
	[[nodiscard]] double sum() const { return without_size() + size; }
};

/// direction: unit vector in which the motion element grows.
[[nodiscard]] StrokeEvidence stroke_evidence(
		const Stroke &stroke, const FeaturePlace &direction, const UsualStroke &usual);

/// Evidence of the pace of a stroke, during it or after its end, nats, <= 0. A strike is never slow. 0 for
/// other gestures, which have any pace. It only compares gestures along one path.
[[nodiscard]] double strike_evidence(const Stroke &stroke, const UsualStroke &usual);

/// Evidence of the motion after the stroke, nats: the hand comes back at once, or it stays.
[[nodiscard]] double return_evidence(const UsualStroke &usual, bool comes_back);

/// Correction of StrokeEvidence::max_remaining for a stroke that slows down long before the gesture's length,
/// nats, <= 0. A minimum-jerk movement of the same fraction of its peak speed is almost at its end.
/// speed_m_s: present speed of the hand.
[[nodiscard]] double slowing_evidence(const Stroke &stroke, double speed_m_s, double amplitude_m);

} // namespace steadyhand
