#pragma once

#include "base/result.h"
#include "soundness/tracking_soundness.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace steadyhand {

/// How well a point of the hand is tracked at each place that it visits, judged by its motion alone; and,
/// from that, where a study's stable and unstable positions are to be. A practice run, in which the hand
/// moves through the whole space within its reach, feeds it.
class TrackingSurvey {
public:
	/// What was seen within POOL_M of a place.
	struct Place {
		Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
		double seconds = 0.0;
		/// Gaps, freezes and jumps; those less than 0.25 s apart are one, and what lasts is one each 0.25 s.
		double faults_per_s = 0.0;
		double jitter_m = 0.0; ///< deviation of the white noise that shakes the values as much, an axis

		/// Faults a second; jitter of 2 mm counts as one.
		[[nodiscard]] double unsoundness() const { return faults_per_s + jitter_m / JITTER_OF_A_FAULT_M; }
	};

	/// Stable and unstable position, at least APART_M apart, both where the hand has been.
	struct Proposal {
		Place stable;
		Place unstable;
		/// Between all that was seen nearer to the one and nearer to the other: how many of its standard
		/// deviations the difference in unsoundness is. Where tracking is alike everywhere it is seldom
		/// DISTINCT. 0 where no fault was seen at the less sound one: positions that are rounded, as a
		/// mouse's are to pixels, shake too, and are tracked alike everywhere.
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
	[[nodiscard]] std::optional<double> newest_s() const {
		return begun_ ? std::optional(t_s_) : std::nullopt;
	}
	/// How long the run has been, s, without gaps of more than 10 s: the hand was elsewhere.
	[[nodiscard]] double duration_s() const { return duration_s_; }
	/// Or what the hand has yet to do.
	[[nodiscard]] Result<Proposal> propose() const;

private:
	static constexpr double JITTER_OF_A_FAULT_M = 0.002;
	static constexpr double CELL_M = 0.1;
	/// What a hand reaches, 2 m wide, has half as many. Once all are taken other places are left out.
	static constexpr std::size_t MOST_CELLS = 8192;
	static constexpr std::size_t NO_CELL = MOST_CELLS;
	/// TrackingSoundness knows a hand's speed and bend in amplitudes: those of a 20 cm drag.
	static constexpr double AMPLITUDE_M = 0.2;

	struct Cell {
		Eigen::Vector3i number = Eigen::Vector3i::Zero(); ///< along each axis, from the origin
		double seconds = 0.0;
		double faults = 0.0;
		double frames = 0.0;
		double jitter_m = 0.0;                                                     ///< sum over the frames
		Eigen::Matrix<double, 3, 1, Eigen::DontAlign> position_m{ 0.0, 0.0, 0.0 }; ///< sum over the frames
	};

	std::array<TrackingSoundness, 3> axes_;
	std::vector<Cell> cells_; ///< MOST_CELLS, those visited first
	std::size_t visited_ = 0;
	std::vector<std::uint16_t> slots_; ///< a hash table of the cells visited: which one, counted from 1
	std::size_t last_ = NO_CELL;       ///< where the newest frame's error began
	bool begun_ = false;
	double t_s_ = 0.0;
	double duration_s_ = 0.0;
	double fault_s_ = -std::numeric_limits<double>::infinity();
	double lost_s_ = 0.0; ///< of a gap or freeze, what has not been counted

	/// Faults of the last dt_s, up to the newest frame.
	[[nodiscard]] double faults(double dt_s, bool frozen, bool fault);
	/// NO_CELL where there is none, and none can be taken.
	[[nodiscard]] std::size_t cell_at(const Eigen::Vector3d &position_m);
	[[nodiscard]] std::span<const Cell> visited() const { return std::span(cells_).first(visited_); }
	/// What was seen in the cells whose middles are `wanted`.
	template <class Wanted> [[nodiscard]] Place gathered(Wanted wanted) const;
	[[nodiscard]] std::vector<Place> candidates() const;
};

} // namespace steadyhand
