#pragma once

#include "gesture/feature.h"
#include "signal/ring.h"
#include "signal/slope_window.h"
#include "tracking/measurement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steadyhand {

/// Evidence of the hand's movement for a gesture with a task: whether it has begun, and its log odds. The
/// onset is the last moment at which the hand was slow, compared with the peak speed since then, or turned.
/// Direction and bow of the path from the onset count, and the onset's place. The hand may rest on the way.
class TaskEvidence {
public:
	/// A feature without a position has no straight path. Then has_onset() is always true and the log odds
	/// are 0.
	TaskEvidence(const Feature &feature, const Task &task);

	/// Movements with an onset before t_s are not used. A hand in the first measurement soon after t_s has
	/// not just come into view.
	void ignore_before(double t_s);
	/// place_m: position of the feature, finite, corrected for the tracker's displacement. is_idle: no
	/// gesture is active; otherwise the onset stays. A measurement that is not usable, or too soon after the
	/// last one, is ignored.
	void push(const Measurement &measurement, const FeaturePlace &place_m, bool is_idle);

	/// The hand moves along the task's axis from near its start.
	[[nodiscard]] bool has_onset() const;
	/// The direction from the onset is near the axis (parameters::sessions::PARALLEL).
	[[nodiscard]] bool is_along_axis() const;
	/// log of the posterior odds of the gesture against none, nats.
	[[nodiscard]] double log_odds() const;

	/// Distance, m, of a hand from the start of the gesture; for features with a position.
	[[nodiscard]] double start_distance_m(const FeaturePlace &place_m) const;
	/// Distance, m, of a hand from the straight path of the task; 0 for a radius, which may grow anywhere.
	[[nodiscard]] double path_distance_m(const FeaturePlace &place_m) const;

private:
	static constexpr std::size_t SAMPLES = 64;
	static constexpr double APART_S = 0.019; ///< of samples: they last at least 1.2 s, longer than a pause

	/// Positions are weighted by Feature::coordinate_weights.
	struct Sample {
		double t_s = -INFINITY;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace displacement_m = FeaturePlace::Zero(); ///< of the tracker
		FeaturePlace velocity_m_s = FeaturePlace::Zero();
		double path_m = 0.0;                     ///< length of the path so far
		FeaturePlace sum = FeaturePlace::Zero(); ///< integral of place_m over the path, m^2
		bool is_entry = false;                   ///< the hand has just come into view
	};

	const Feature *feature_;
	double amplitude_m_;
	double not_before_s_ = -INFINITY;
	FeaturePlace start_ = FeaturePlace::Zero();
	FeaturePlace direction_ = FeaturePlace::Zero(); ///< unit vector in which the motion element grows
	SlopeWindow<FeaturePlace, SAMPLES> window_;
	Ring<Sample, SAMPLES> samples_;
	Sample now_, onset_;
	Sample knot_; ///< start of the newest straight piece of the path: tremor does not lengthen the path

	void find_onset();
	[[nodiscard]] FeaturePlace chord_m() const { return now_.place_m - onset_.place_m; }
	[[nodiscard]] FeaturePlace start_error() const;
	[[nodiscard]] double bow() const;
	[[nodiscard]] double max_log_odds() const;
};

} // namespace steadyhand
