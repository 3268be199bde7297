#pragma once

#include "signal/resample.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace steadyhand {

/// One measured position of a joint.
struct TrackSample {
	double t_s = 0.0;
	Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
};

/// A track at the instants of a grid, as a weighted straight line through the samples around each instant.
/// The window is symmetric, so that the smoothing adds no lag.
struct SmoothedTrack {
	std::vector<Eigen::Vector3d> positions_m;
	std::vector<double> speeds_m_s;
	std::vector<std::uint8_t> known; ///< 0: too few samples near the instant

	[[nodiscard]] bool is_known(std::size_t i) const { return i < known.size() && known[i] != 0; }
};

/// Samples further apart are separated by a dropout. Trackers at 20 Hz, with some jitter, have none.
inline constexpr double LONGEST_SAMPLE_GAP_S = 0.06;

/// The samples without those that jump away from their neighbours. Stamps must increase.
[[nodiscard]] std::vector<TrackSample> without_jumps(std::span<const TrackSample> samples);

/// Stamps must increase.
[[nodiscard]] SmoothedTrack smoothed(
		std::span<const TrackSample> samples, const UniformGrid &grid, std::size_t count);

} // namespace steadyhand
