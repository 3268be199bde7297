#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace steadyhand {

enum class MeasurementStatus : std::uint8_t {
	TRACKED,    ///< a new reading, or a hand at rest and a tracker without noise
	REPEATED,   ///< the last reading again with equal bits: the tracker has no new data
	FROZEN,     ///< repeated for longer than a tracker with this noise can repeat
	OUTLIER,    ///< a position that the hand cannot reach
	REAPPEARED, ///< the first reading after a dropout, a freeze or a jump
};

/// One reading of a tracked point, with its quality.
struct Measurement {
	double t_s = 0.0; ///< stamp of the tracker
	Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
	double noise_m = 0.0; ///< standard deviation of white noise for each axis, with rounding
	double outlier_probability = 0.0;
	MeasurementStatus status = MeasurementStatus::TRACKED;
	/// Arrived in one burst with the last usable reading, whose stamp is therefore too late. The receiver
	/// must undo the last one and the wait for it, and use this one.
	bool replaces_last = false;
	double gap_s = 0.0; ///< length of the dropout, freeze or jump that ended with this reading; 0: none
	/// Sum of the tracker's jumps that it has not undone: the offset of its positions. It is 0 again after a
	/// long dropout, in which the hand may have moved anywhere.
	Eigen::Vector3d displacement_m = Eigen::Vector3d::Zero();

	/// Whether the reading is new data.
	[[nodiscard]] bool is_new() const {
		return status != MeasurementStatus::REPEATED && status != MeasurementStatus::FROZEN;
	}
	/// Whether the reading is new data and no outlier.
	[[nodiscard]] bool is_usable() const { return is_new() && status != MeasurementStatus::OUTLIER; }
};

/// Numbers of faults of a tracker.
struct TrackerFaults {
	std::uint64_t dropouts = 0;
	std::uint64_t freezes = 0;
	std::uint64_t jumps = 0; ///< a jump and its return count once
};

} // namespace steadyhand
