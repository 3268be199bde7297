#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

/// The E-step of Baum-Welch, over many sequences.
struct ExpectedCounts {
	Eigen::MatrixXd transitions; ///< N x N: sum over t of xi_t(i, j), Rabiner 1989 eq. (37)
	Eigen::MatrixXd symbols;     ///< N x M: sum over t with o_t = k of gamma_t(j), eq. (27)
	double log_likelihood = 0.0; ///< nats, sum over the sequences
};

/// Empty sequences are passed over; one that is impossible under the model counts in the likelihood alone,
/// which is -infinity then.
ExpectedCounts expected_counts(const DiscreteHmm &hmm, std::span<const SymbolSequence> sequences);

} // namespace steadyhand
