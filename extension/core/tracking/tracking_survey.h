#pragma once

#include "base/result.h"
#include "tracking/tracker_monitor.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steadyhand {

/// Measures with TrackerMonitor how well a point of the hand is tracked at each place that it visits, and
/// proposes a study's stable and unstable positions. A practice run feeds it, in which the hand moves through
/// the whole space within its reach.
class TrackingSurvey {
public:
	/// What was seen within POOL_M of a place.
	struct Place {
		Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
		double seconds = 0.0;
		double lost_share = 0.0;    ///< of the time, in dropouts, freezes and jumps: 0..1
		double lost_variance = 0.0; ///< of lost_share, where faults come by chance
		double noise_m = 0.0;       ///< standard deviation of white noise per axis

		/// Time lost, as a share; NOISE_LIKE_LOSS_M of noise is as bad as a hand that is never seen.
		[[nodiscard]] double error() const { return lost_share + noise_m / NOISE_LIKE_LOSS_M; }
	};

	/// Stable and unstable position, at least APART_M apart, both where the hand has been.
	struct Proposal {
		Place stable;
		Place unstable;
		/// The space is halved between the two. By how many standard deviations the halves' error() differs,
		/// if tracking were alike everywhere: then it is seldom DISTINCT. 0 where the worse half has no
		/// fault: rounding, as of a mouse to pixels, looks like more noise where the hand is fast.
		double contrast = 0.0;

		[[nodiscard]] bool distinct() const { return contrast >= DISTINCT; }
	};

	static constexpr double LEAST_S = 20.0;
	static constexpr double POOL_M = 0.15;
	static constexpr double APART_M = 0.25;
	static constexpr double DISTINCT = 2.0;
	/// From the origin, along an axis; beyond is no hand, and left out.
	static constexpr double FURTHEST_M = 1e5;

	/// Allocates all that it will ever need.
	TrackingSurvey();

	/// A frame in which the point was tracked; `t_s` and `position_m` are finite, stamps do not decrease. The
	/// origin may be anywhere within FURTHEST_M.
	void push(double t_s, const Eigen::Vector3d &position_m);
	/// Stamp of the newest frame; nothing before the first.
	[[nodiscard]] std::optional<double> newest_s() const { return newest_s_; }
	/// How long the run has been, s, without gaps of more than 10 s: the hand was elsewhere.
	[[nodiscard]] double duration_s() const { return duration_s_; }
	/// Or what the hand has yet to do.
	[[nodiscard]] Result<Proposal> propose() const;

private:
	static constexpr double NOISE_LIKE_LOSS_M = 0.01;
	static constexpr double CELL_M = 0.1;
	/// What a hand reaches, 2 m wide, has half as many. Once all are taken other places are left out.
	static constexpr std::size_t MOST_CELLS = 8192;
	static constexpr std::size_t NO_CELL = MOST_CELLS;

	struct Cell {
		Eigen::Vector3i number = Eigen::Vector3i::Zero(); ///< along each axis, from the origin
		double seconds = 0.0;
		double lost_s = 0.0;
		double squares_s2 = 0.0;  ///< of the times lost, summed over the faults
		double readings = 0.0;    ///< that show where the hand is
		double noise_sum_m = 0.0; ///< over the readings
		Eigen::Matrix<double, 3, 1, Eigen::DontAlign> position_sum_m{ 0.0, 0.0, 0.0 };
	};

	TrackerMonitor monitor_;
	std::vector<Cell> cells_; ///< MOST_CELLS, those visited first
	std::size_t visited_ = 0;
	std::vector<std::uint16_t> slots_; ///< a hash table of the cells visited: which one, counted from 1
	std::size_t last_ = NO_CELL;       ///< where the hand was last seen
	std::optional<double> newest_s_;
	double duration_s_ = 0.0;

	/// NO_CELL where there is none, and none can be taken.
	[[nodiscard]] std::size_t cell_at(const Eigen::Vector3d &position_m);
	[[nodiscard]] std::span<const Cell> visited() const { return std::span(cells_).first(visited_); }
	/// Sum over the cells whose middles are `wanted`; the hand was in at least one of them.
	template <class Wanted> [[nodiscard]] Place gathered(Wanted wanted) const;
	[[nodiscard]] std::vector<Place> candidates() const;
};

} // namespace steadyhand
