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

/// Measures the tracking quality of a point of the hand at each place, and proposes the stable and the
/// unstable position of a study. Its input is a practice run, in which the hand moves through all the space
/// in reach.
class TrackingSurvey {
public:
	/// Tracking quality within POOL_M of a place.
	struct Place {
		Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
		double seconds = 0.0;
		double lost_share = 0.0;    ///< fraction of the time in dropouts, freezes and jumps: 0..1
		double lost_variance = 0.0; ///< of lost_share, if faults are a Poisson process
		double noise_m = 0.0;       ///< standard deviation of white noise for each axis

		/// Fraction of lost time, plus noise: NOISE_LIKE_LOSS_M of noise counts as 100 % lost.
		[[nodiscard]] double error() const { return lost_share + noise_m / NOISE_LIKE_LOSS_M; }
	};

	/// Stable and unstable position, at least APART_M apart. The hand was at both.
	struct Proposal {
		Place stable;
		Place unstable;
		/// Difference of error() between the two halves of the space, in standard deviations for equal
		/// tracking everywhere. It is 0 if the worse half has no fault, because rounding (a mouse in pixels)
		/// looks like more noise where the hand is fast.
		double contrast = 0.0;

		[[nodiscard]] bool distinct() const { return contrast >= DISTINCT; }
	};

	static constexpr double LEAST_S = 20.0;
	static constexpr double POOL_M = 0.15;
	static constexpr double APART_M = 0.25;
	static constexpr double DISTINCT = 2.0;
	/// Limit of |coordinate|. Positions beyond it do not count.
	static constexpr double FURTHEST_M = 1e5;

	/// Only the constructor and propose() allocate.
	TrackingSurvey();

	/// Adds a frame in which the point is tracked. t_s and position_m are finite; stamps do not decrease. The
	/// origin may be anywhere within FURTHEST_M.
	void push(double t_s, const Eigen::Vector3d &position_m);
	/// Stamp of the newest frame; nullopt before the first.
	[[nodiscard]] std::optional<double> newest_s() const { return newest_s_; }
	/// Duration of the run, s, without gaps of more than 10 s.
	[[nodiscard]] double duration_s() const { return duration_s_; }
	/// The proposal. The error says what the hand still has to do.
	[[nodiscard]] Result<Proposal> propose() const;

private:
	static constexpr double NOISE_LIKE_LOSS_M = 0.01;
	static constexpr double CELL_M = 0.1;
	/// Twice the cells in a hand's reach, 2 m wide. If all are taken, further places do not count.
	static constexpr std::size_t MOST_CELLS = 8192;
	static constexpr std::size_t NO_CELL = MOST_CELLS;

	struct Cell {
		Eigen::Vector3i number = Eigen::Vector3i::Zero(); ///< along each axis, from the origin
		double seconds = 0.0;
		double lost_s = 0.0;
		double squares_s2 = 0.0;  ///< sum of the squared lost times of all faults
		double readings = 0.0;    ///< number of usable readings
		double noise_sum_m = 0.0; ///< over the readings
		Eigen::Matrix<double, 3, 1, Eigen::DontAlign> position_sum_m{ 0.0, 0.0, 0.0 };
	};

	TrackerMonitor monitor_;
	std::vector<Cell> cells_; ///< MOST_CELLS; the first visited_ ones are in use
	std::size_t visited_ = 0;
	std::vector<std::uint16_t> slots_; ///< hash table of the cells in use: index + 1; 0 is empty
	std::size_t last_ = NO_CELL;       ///< cell of the last usable reading
	std::optional<double> newest_s_;
	double duration_s_ = 0.0;

	/// Finds or takes the cell of a position; NO_CELL if it is beyond FURTHEST_M or all cells are taken.
	[[nodiscard]] std::size_t cell_at(const Eigen::Vector3d &position_m);
	[[nodiscard]] std::span<const Cell> visited() const { return std::span(cells_).first(visited_); }
	/// Pools all cells whose mean position is `is_wanted`. There must be at least one.
	template <class Predicate> [[nodiscard]] Place pooled(Predicate is_wanted) const;
	[[nodiscard]] std::vector<Place> candidates() const;
};

} // namespace steadyhand
