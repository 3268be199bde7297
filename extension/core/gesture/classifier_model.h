#pragma once

#include "gesture/directed_hmm.h"
#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "hmm/filler_filter.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// Model of GestureClassifier: HMMs of all gestures and of other motion, over one codebook.
struct ClassifierModel {
	MotionCodebook codebook;
	std::vector<DirectedHmm> gestures;
	DiscreteHmm other; ///< of other motion, and of gestures relative to wrong onsets
};

/// The HMMs of one gesture, for GestureClassifier.
struct GestureHmms {
	std::string gesture;
	/// Those with another DirectedHmm::gesture do not count.
	std::shared_ptr<const std::vector<DirectedHmm>> hmms;
};

/// Number of HMMs of the same gesture in the same direction.
[[nodiscard]] std::size_t paces(std::span<const DirectedHmm> hmms, const DirectedHmm &gesture);

/// Hexadecimal checksum of a codebook. Counts of symbols are valid with one codebook only.
[[nodiscard]] std::string checksum(const MotionCodebook &codebook);

/// Distribution of the symbols of other motion (1 x M): that of the stationary HMM.
[[nodiscard]] Eigen::RowVectorXd symbols_of_other(const DiscreteHmm &other);

/// Filler with the states of all gestures and of other motion. evidence: ClassifierOptions::evidence.
[[nodiscard]] FillerModel filler_of(const ClassifierModel &model, double evidence);

} // namespace steadyhand
