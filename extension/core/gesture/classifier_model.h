#pragma once

#include "gesture/directed_hmm.h"
#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "hmm/filler_filter.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace steadyhand {

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
