#pragma once

#include "signal/ring.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace steadyhand {

/// White noise and resolution of a tracker, measured on a hand that moves.
///
/// The k-th divided difference of readings is zero for a motion of degree k - 1, at any spacing. Of white
/// noise it is white noise of a known gain. Of the differences of second and fourth order the lower estimate
/// counts, because motion only adds.
class ReadingNoise {
public:
	/// A new reading; stamps increase by at least 1 ms.
	void push(double t_s, const Eigen::Vector3d &position_m);
	/// The next reading has nothing to do with the last one.
	void interrupt() { readings_.clear(); }

	/// Standard deviation per axis, m, at least that of rounding. FIRST_M until it can be measured.
	[[nodiscard]] Eigen::Vector3d deviation_m() const;
	[[nodiscard]] bool is_measured() const { return second_.size() >= FEWEST; }
	/// Step between the positions that the tracker can report, m; 0: finer than can be seen.
	[[nodiscard]] double resolution_m() const { return resolution_m_; }
	/// Probability that a sound tracker reports a hand at the very same position in its next reading. 1 where
	/// no noise has been seen.
	[[nodiscard]] double repeat_probability() const;

private:
	static constexpr std::size_t WINDOW = 16; ///< readings
	/// Differences of one order: of fewer motion turns as often by chance.
	static constexpr std::size_t FEWEST = 6;
	/// Of no hand tracker known is the noise greater at rest.
	static constexpr double FIRST_M = 1e-3;
	/// What no tracker resolves; Godot's single precision rounds to a fifteenth of it.
	static constexpr double FINEST_M = 1e-6;

	struct Reading {
		double t_s = 0.0;
		Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
	};
	/// Differences of one order, each divided by its gain: as large as the noise.
	using Differences = Ring<Eigen::Vector3d, WINDOW>;

	Ring<Reading, WINDOW> readings_;
	Differences second_, fourth_;
	Eigen::Vector3d deviation_m_{ FIRST_M, FIRST_M, FIRST_M };
	std::array<bool, 3> is_seen_{}; ///< noise of this axis has been told from motion
	double resolution_m_ = 0.0;

	template <std::size_t ORDER> void difference(Differences &r_differences) const;
	void measure();
	void look_for_resolution();
	/// All steps from reading `first`, 1 or later, are whole multiples.
	[[nodiscard]] bool is_rounded_to(double step_m, std::size_t first) const;
};

} // namespace steadyhand
