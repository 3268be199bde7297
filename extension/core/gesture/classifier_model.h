#pragma once

#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "hmm/filler_filter.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace steadyhand {

/// HMM of one gesture in one direction. The first state is the rest before the onset, the last state the
/// dwell after the end.
struct DirectedHmm {
	std::string gesture;
	Eigen::Vector3d axis = Eigen::Vector3d::Zero(); ///< unit vector; zero if is_radius
	bool is_radius = false;                         ///< reach_m is a growth of the radius
	double reach_m = 0.0;                           ///< distance of the end from the onset, geometric mean
	double reach_deviation = 0.0; ///< standard deviation of the natural logarithm of the reach
	DiscreteHmm hmm;
};

/// Model of GestureClassifier: HMMs of all gestures and of other motion, over one codebook.
struct ClassifierModel {
	MotionCodebook codebook;
	std::vector<DirectedHmm> gestures;
	DiscreteHmm other; ///< of other motion, and of gestures relative to wrong onsets
};

/// Filler with the states of all gestures and of other motion. evidence: ClassifierOptions::evidence.
[[nodiscard]] FillerModel filler_of(const ClassifierModel &model, double evidence);

} // namespace steadyhand
