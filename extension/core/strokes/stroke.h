#pragma once

#include "gesture/feature.h"

namespace steadyhand {

/// What a hand did from where it was last as good as still to where it is.
struct Stroke {
	double onset_s = 0.0;
	double now_s = 0.0;
	double moved_s = 0.0; ///< when the hand was last on its way: earlier than now while it rests
	FeaturePlace from = FeaturePlace::Zero();
	FeaturePlace to = FeaturePlace::Zero();
	FeaturePlace middle = FeaturePlace::Zero(); ///< mean over its way
	/// `from` and `to` as the tracker shows them; the other places are without its displacement.
	FeaturePlace shown_from = FeaturePlace::Zero();
	FeaturePlace shown_to = FeaturePlace::Zero();
	double peak_m_s = 0.0;
	double way_m = 0.0; ///< length of the way from `from` to `to`, >= their distance
	/// How far from `from` the hand was before the onset, at most; before slow strokes there is more to it:
	/// StrokeFinder::unrest_m.
	double unrest_m = 0.0;
	/// For how long before the onset: no more than parameters::strokes::REST_S, less where it was not
	/// tracked.
	double watched_s = 0.0;
	bool is_joined = false; ///< of several, between which the hand hesitated
	/// It set out from rest. Otherwise the hand came into view on its way, at `from`.
	bool is_from_rest = true;

	/// The same if the hand made all jumps of the tracker.
	[[nodiscard]] Stroke as_shown() const;
};

/// Both as one, as far as a task's evidence asks: what the hand did between them adds its way only.
[[nodiscard]] Stroke joined(const Stroke &first, const Stroke &second);

} // namespace steadyhand
