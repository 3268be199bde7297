#pragma once

#include "gesture/feature.h"

namespace steadyhand {

/// A stroke: movement of the hand from its last slow moment on. Positions are scaled as StrokeFinder's.
struct Stroke {
	double onset_s = 0.0;
	double now_s = 0.0;
	double moved_s = 0.0; ///< when the hand last moved: earlier than now_s while it rests
	FeaturePlace from = FeaturePlace::Zero();
	FeaturePlace to = FeaturePlace::Zero();
	FeaturePlace middle = FeaturePlace::Zero(); ///< mean over the length of the path
	/// `from` and `to` as measured. The other positions are corrected for the tracker's displacement.
	FeaturePlace measured_from = FeaturePlace::Zero();
	FeaturePlace measured_to = FeaturePlace::Zero();
	double peak_m_s = 0.0;
	double path_m = 0.0; ///< length of the path from `from` to `to`, >= their distance
	/// Greatest distance of the hand from `from` in the REST_S before the onset. Slow strokes need a longer
	/// time: StrokeFinder::motion_before_m.
	double motion_before_m = 0.0;
	/// Time before the onset in which the hand was tracked, at most parameters::strokes::REST_S.
	double tracked_before_s = 0.0;
	/// False if the hand came into view while it moved, at `from`.
	bool is_from_rest = true;

	/// The stroke without correction for the tracker's displacement.
	[[nodiscard]] Stroke as_measured() const;
};

} // namespace steadyhand
