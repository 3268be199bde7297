#pragma once

#include "hmm/discrete_hmm.h"

#include <functional>

namespace steadyhand {

struct BaumWelchOptions {
	int max_iterations = 50;
	double tolerance_nats = 1e-3; ///< stop when the objective grows by less than this per sequence
	PseudoCounts pseudo;
	/// Called before each iteration with the number of those done; false ends the training there.
	std::function<bool(int iterations)> go_on;
};

struct BaumWelchResult {
	DiscreteHmm hmm;
	/// Per iteration: sum over the sequences of log P(O | lambda) plus the log of the Dirichlet prior (up to
	/// its constant), under the parameters that the iteration started from. Never decreases.
	std::vector<double> objective;
};

/// Baum-Welch over many sequences (Rabiner 1989 eq. (109)-(110)), with Dirichlet pseudo-counts
/// on the rows of A and B; pi stays as it is, and a transition that `start` forbids stays forbidden.
/// Deterministic. Empty sequences are passed over; UNSEEN frames count for transitions only.
BaumWelchResult baum_welch(
		DiscreteHmm start, std::span<const SymbolSequence> sequences, const BaumWelchOptions &options);

} // namespace steadyhand
