#pragma once

#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "hmm/filler_filter.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace steadyhand {

/// The last states of a DirectedHmm are the time after the gesture's end, in which the hand stays or comes
/// back.
inline constexpr int END_STATES = 2;

/// HMM of one gesture in one direction at one pace. The first state is the rest before the onset.
struct DirectedHmm {
	std::string gesture;
	Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< unit vector; zero if is_radius
	bool is_radius = false;                         ///< reach_m is a growth of the radius
	double reach_m = 0.0;                           ///< greatest distance from the onset, median
	double reach_deviation = 0.0; ///< standard deviation of the natural logarithm of the reach
	DiscreteHmm hmm;
};

/// Model of GestureClassifier: HMMs of all gestures and of other motion, over one codebook.
struct ClassifierModel {
	MotionCodebook codebook;
	std::vector<DirectedHmm> gestures;
	DiscreteHmm other; ///< of other motion, and of gestures relative to wrong onsets

	/// Number of HMMs of the same gesture in the same direction.
	[[nodiscard]] std::size_t paces(const DirectedHmm &gesture) const;
};

/// Filler with the states of all gestures and of other motion. evidence: ClassifierOptions::evidence.
[[nodiscard]] FillerModel filler_of(const ClassifierModel &model, double evidence);

} // namespace steadyhand
