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
	double peak_m_s = 0.0;
	/// `from` and `to` as the tracker showed them: the other places are without the steps that no hand makes.
	FeaturePlace seen_from = FeaturePlace::Zero();
	FeaturePlace seen_to = FeaturePlace::Zero();
	int leaps = 0;      ///< steps that no hand makes, meanwhile
	double way_m = 0.0; ///< length of the way from `from` to `to`, >= their distance
	/// How far from `from` the hand was before the onset, at most; before slow strokes there is more to it:
	/// StrokeFinder::unrest_m.
	double unrest_m = 0.0;
	/// For how long before the onset: no more than REST_S, less where it was not seen.
	double watched_s = 0.0;
	bool is_joined = false; ///< of several, between which the hand hesitated
	/// Of a hand that came into view on its way, at `from`: how fast, of its peak speed; 0 where it was slow.
	double entry_share = 0.0;
	bool is_lost = false; ///< it was under way before a gap that the newest frame has ended

	static constexpr double REST_S = 0.5;

	/// Which share of its way the tracker shows: not all where it leapt along it, next to nothing where the
	/// way is what its leaps to and fro leave when they are taken out; more than 1 where strokes count a
	/// place for less than is shown. NaN of one that goes nowhere.
	[[nodiscard]] double seen_share() const {
		const FeaturePlace chord = to - from;
		return (seen_to - seen_from).dot(chord) / chord.squaredNorm();
	}
};

/// Both as one, as far as a task's evidence asks: what the hand did between them adds its way only.
[[nodiscard]] Stroke joined(const Stroke &first, const Stroke &second);

} // namespace steadyhand
