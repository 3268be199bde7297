#pragma once

#include "signal/ring.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace steadyhand {

/// Measures white noise and resolution of a tracker while the hand moves.
///
/// The k-th divided difference of readings is 0 for a polynomial motion of degree k - 1, at any spacing.
/// White noise gives a difference with a known gain. The lower estimate of second and fourth differences
/// counts, because motion only increases them.
class ReadingNoise {
public:
	/// Adds a reading. Stamps increase by at least 1 ms.
	void push(double t_s, const Eigen::Vector3d &position_m);
	/// Takes no differences between the readings so far and the next ones.
	void interrupt() { readings_.clear(); }

	/// Standard deviation for each axis, m, at least that of rounding. FIRST_M until it is measured.
	[[nodiscard]] Eigen::Vector3d deviation_m() const;
	[[nodiscard]] bool is_measured() const { return second_.size() >= LEAST_COUNT; }
	/// Step between the positions that the tracker can report, m; 0 if no step is found.
	[[nodiscard]] double resolution_m() const { return resolution_m_; }
	/// Probability that a tracker without faults repeats its last position exactly. 1 if no noise was found.
	[[nodiscard]] double repeat_probability() const;

private:
	static constexpr std::size_t WINDOW = 16; ///< readings
	/// Least number of differences. With fewer, motion may change its sign as often by chance.
	static constexpr std::size_t LEAST_COUNT = 6;
	/// Initial noise: known hand trackers have less at rest.
	static constexpr double FIRST_M = 1e-3;
	/// Finer than the resolution of any tracker. Godot's single precision rounds to a fifteenth of it.
	static constexpr double FINEST_M = 1e-6;

	struct Reading {
		double t_s = 0.0;
		Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
	};
	/// Differences of one order, divided by their gain. Their standard deviation is that of the noise.
	using Differences = Ring<Eigen::Vector3d, WINDOW>;

	Ring<Reading, WINDOW> readings_;
	Differences second_, fourth_;
	Eigen::Vector3d deviation_m_{ FIRST_M, FIRST_M, FIRST_M };
	std::array<bool, 3> has_noise_{}; ///< noise of this axis was distinguished from motion
	double resolution_m_ = 0.0;

	template <std::size_t ORDER> void difference(Differences &r_differences) const;
	void measure();
	void find_resolution();
	/// Whether all differences to the reading before, from reading `first` >= 1 on, are multiples of step_m.
	[[nodiscard]] bool is_rounded_to(double step_m, std::size_t first) const;
};

} // namespace steadyhand
