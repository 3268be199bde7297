#pragma once

#include "gesture/gesture_model.h"
#include "hmm/discrete_hmm.h"

#include <cstddef>
#include <span>

namespace steadyhand {

struct MeanAndDeviation {
	double mean = 0.0;
	double deviation = 0.0; ///< sample standard deviation (n - 1); 0 for one value
};
[[nodiscard]] MeanAndDeviation mean_and_deviation(std::span<const double> values);

/// Cuts the reference curve at the mean phases of the state changes, and fits each piece (paper, "primitive
/// elements are synthesized from polynomial curves with the best fit in each state"). Value and slope are
/// continuous. The first piece begins at rest at 0; the last one ends at 1. If a curve leaves the range of
/// its piece, the degree of all is lowered, because high degrees oscillate between few points.
///
/// sequences, durations_s: one entry for each recording. r_model: reads reference curve, HMM and mean
/// duration, and sets the elements. Returns the degree of the fit, at most `degree`; 0 if the pieces are
/// chords.
std::size_t cut_into_elements(std::span<const SymbolSequence> sequences, std::span<const double> durations_s,
		std::size_t degree, GestureModel &r_model);

} // namespace steadyhand
