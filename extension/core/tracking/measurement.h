#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace steadyhand {

enum class MeasurementStatus : std::uint8_t {
	TRACKED,    ///< shows where the hand is: a new reading, or a rest without noise
	REPEATED,   ///< the last reading again, to the last bit: the tracker has not looked since
	FROZEN,     ///< repeated for too long for a tracker with this noise
	OUTLIER,    ///< where the hand cannot be
	REAPPEARED, ///< the first reading after a dropout or a freeze
};

/// One reading of a tracked point, and how far to trust it.
struct Measurement {
	double t_s = 0.0; ///< as the tracker stamped it
	Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
	double noise_m = 0.0;             ///< standard deviation of white noise per axis, rounding included
	double outlier_probability = 0.0; ///< that the tracker shows another place than the hand's
	MeasurementStatus status = MeasurementStatus::TRACKED;
	/// Arrived in one burst with the last reading that is_usable(), which was therefore stamped too late:
	/// take that one back and use this one instead.
	bool replaces_last = false;
	double gap_s = 0.0; ///< time without news that this reading ended; 0: none
	/// Sum of the jumps that the tracker made and has not undone: it shows the hand by this beside where it
	/// would without them. 0 again after a dropout in which the hand may have gone anywhere.
	Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero();
	double jump_m = 0.0; ///< of an outlier: distance from where a hand could be

	/// A reading that says where the hand is now; its noise and outlier probability say how well.
	[[nodiscard]] bool has_news() const {
		return status != MeasurementStatus::REPEATED && status != MeasurementStatus::FROZEN;
	}
	/// Has news of the hand, and not of another place.
	[[nodiscard]] bool is_usable() const { return has_news() && status != MeasurementStatus::OUTLIER; }
};

/// What a tracker did wrong so far.
struct TrackerFaults {
	std::uint64_t dropouts = 0;
	std::uint64_t freezes = 0;
	std::uint64_t jumps = 0;          ///< to another place, and those that return count once
	std::uint64_t skipped_frames = 0; ///< in intervals too short for a dropout
};

} // namespace steadyhand
