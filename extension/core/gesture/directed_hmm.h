#pragma once

#include "hmm/discrete_hmm.h"

#include <Eigen/Core>

#include <string>

namespace steadyhand {

/// The last states of a DirectedHmm are the time after the gesture's end, in which the hand stays or comes
/// back.
inline constexpr int END_STATES = 2;

/// Direction and length of a gesture.
struct GestureReach {
	Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< unit vector; zero if is_radius
	bool is_radius = false;                         ///< reach_m is a growth of the radius
	double reach_m = 0.0;                           ///< greatest distance from the onset, median
	double reach_deviation = 0.0; ///< standard deviation of the natural logarithm of the reach
};

/// HMM of one gesture in one direction at one pace. The first state is the rest before the onset.
struct DirectedHmm : GestureReach {
	std::string gesture;
	DiscreteHmm hmm;
};

/// Counts of a DirectedHmm in recordings that mark its states.
struct DirectedCounts : GestureReach {
	Eigen::MatrixXd transitions; ///< N x 2: how often each state stayed, and led to the next one
	Eigen::MatrixXd symbols;     ///< N x M: how often each state had each symbol
};

/// Left-right HMM without skips. odd_symbols: the fraction of each state's emissions that has the
/// distribution of all motion (1 x M).
[[nodiscard]] DirectedHmm directed_hmm(std::string gesture, const DirectedCounts &counts,
		const Eigen::RowVectorXd &all_motion, double odd_symbols);

} // namespace steadyhand
