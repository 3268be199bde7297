#pragma once

#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "hmm/filler_filter.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace steadyhand {

/// The HMM of one gesture in one direction. Its first state is the hand at rest before the onset, its last
/// the hand that has arrived.
struct DirectedHmm {
	std::string gesture;
	Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< unit vector; zero where the gesture has none
	bool is_radius = false;                         ///< reach_m is a growth of the radius
	double reach_m = 0.0;         ///< geometric mean of how far the hand has gone at the end
	double reach_deviation = 0.0; ///< standard deviation of its natural logarithm
	DiscreteHmm hmm;
};

/// What GestureClassifier compares hands with: HMMs of all gestures over one codebook, and the symbols of
/// hands that do something else.
struct ClassifierModel {
	MotionCodebook codebook;
	std::vector<DirectedHmm> gestures;
	DiscreteHmm other; ///< of hands that make no gesture, and of gestures looked at from elsewhere
};

/// The states of all gestures and of other motion. evidence: ClassifierOptions::evidence.
[[nodiscard]] FillerModel filler_of(const ClassifierModel &model, double evidence);

} // namespace steadyhand
