#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

/// E-step of Baum-Welch over many sequences.
struct ExpectedCounts {
	Eigen::MatrixXd transitions; ///< N x N: sum over t of xi_t(i, j), Rabiner 1989 eq. (37)
	Eigen::MatrixXd symbols;     ///< N x M: sum over t with o_t = k of gamma_t(j), eq. (27)
	double log_likelihood = 0.0; ///< nats, sum over the sequences
};

/// Skips empty sequences. An impossible sequence makes log_likelihood -infinity and adds no counts.
ExpectedCounts expected_counts(const DiscreteHmm &hmm, std::span<const SymbolSequence> sequences);

} // namespace steadyhand
