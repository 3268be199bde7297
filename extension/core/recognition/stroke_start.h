#pragma once

#include "strokes/stroke_finder.h"

namespace steadyhand {

/// A stroke's onset is told by its speed, when the hand has gone some hundredths of the way already: it set
/// out from the furthest back that it was in this time before, in which the estimator sees it at rest.
inline constexpr double BEFORE_ONSET_S = 0.15;

/// Where the hand set out that makes one of the finder's strokes, as the tracker showed it, m. way: unit
/// vector. Where the tracker jumped about then, and shows the hand by now as while it rested, the jump is
/// left out.
[[nodiscard]] FeaturePlace start_of(
		const Stroke &stroke, const StrokeFinder &strokes, const FeaturePlace &way);

} // namespace steadyhand
