#pragma once

#include "gesture/gesture_model.h"
#include "hmm/discrete_hmm.h"

#include <cstddef>
#include <span>

namespace steadyhand {

struct MeanAndDeviation {
	double mean = 0.0;
	double deviation = 0.0; ///< of a sample: n - 1; 0 for one value
};
[[nodiscard]] MeanAndDeviation mean_and_deviation(std::span<const double> values);

/// Cuts the reference curve where the states change on average, and fits each piece (paper, "primitive
/// elements are synthesized from polynomial curves with the best fit in each state"). The pieces are joined:
/// value and slope are continuous from rest at 0 on, and the last one ends at 1. Where a curve leaves the
/// range of its piece, the degree of all is lowered until none does: of few points a high degree swings
/// between them.
///
/// sequences, durations_s: one of each recording; r_model: reference curve, HMM and mean duration are read,
/// the elements are made. Returns the degree of the fit, at most `degree`; 0 where the ends of the
/// pieces are joined without a fit.
std::size_t cut_into_elements(std::span<const SymbolSequence> sequences, std::span<const double> durations_s,
		std::size_t degree, GestureModel &r_model);

} // namespace steadyhand
