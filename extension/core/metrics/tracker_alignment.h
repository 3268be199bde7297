#pragma once

#include "base/result.h"
#include "metrics/smoothed_track.h"
#include "signal/ring.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>

namespace steadyhand {

/// Lag and rigid offset between two trackers that follow one joint of the same hand on one clock.
///
/// The speeds of both, which do not depend on the coordinate frames, are cross-correlated within
/// +-LARGEST_LAG_S. The lag is then refined to where the rigid transform of Umeyama (1991, doi
/// 10.1109/34.88573; without scaling that of Kabsch) leaves the least residual. Jumps are left out.
class TrackerAlignment {
public:
	struct Alignment {
		double lag_s = 0.0; ///< positive: the other tracker shows the hand later than the reference
		/// T_reference_other: reference = rotation * other + translation_m.
		Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
		Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
		/// Distance between both after the alignment, over `samples` pairs.
		double residual_rms_m = 0.0;
		double residual_max_m = 0.0;
		std::size_t samples = 0; ///< pairs near in time, without outliers
		double overlap_s = 0.0;  ///< how long both trackers followed the hand
	};

	/// Of each tracker: two minutes at 240 Hz, the rate of the fastest tracker (Polhemus Liberty).
	static constexpr std::size_t CAPACITY = 28800;
	/// The newest part of the samples that align() uses.
	static constexpr double LONGEST_S = 120.0;
	/// Some five movements of a hand. Fewer may correlate by chance.
	static constexpr double LEAST_OVERLAP_S = 5.0;
	/// A residual of 1 cm then turns the rotation by less than 0.1 rad.
	static constexpr double LEAST_SPREAD_M = 0.1;
	/// Spread across the main direction, as a share of that along it. Below it the rotation about the main
	/// direction rests on the noise.
	static constexpr double LEAST_FLATNESS = 0.1;
	/// Cameras with a network in between are late by 0.3 s.
	static constexpr double LARGEST_LAG_S = 0.5;
	/// Of the speeds. Two unrelated movements of 10 s stay below it.
	static constexpr double LEAST_CORRELATION = 0.6;
	/// Residual as a share of the spread. Mirrored axes, other units and other joints leave more.
	static constexpr double LARGEST_RESIDUAL = 0.25;

	/// Allocates all memory that the samples will need.
	TrackerAlignment();

	/// False, and no change, for a sample that is not finite or not later than the newest one of its tracker.
	/// A full buffer forgets its oldest sample.
	bool push_reference(double t_s, const Eigen::Vector3d &position_m);
	bool push_other(double t_s, const Eigen::Vector3d &position_m);
	void clear();

	/// How long both have followed the hand since clear(), without dropouts. An upper bound of the overlap.
	[[nodiscard]] double followed_s() const;

	/// The error says what the user must do.
	[[nodiscard]] Result<Alignment> align() const;

private:
	struct Track {
		Ring<TrackSample, CAPACITY> samples;
		double followed_s = 0.0;
	};
	struct Tracks {
		Track reference, other;
	};

	std::unique_ptr<Tracks> tracks_; ///< too large for the stack

	static bool push(Track &track, double t_s, const Eigen::Vector3d &position_m);
};

} // namespace steadyhand
