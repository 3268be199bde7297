#pragma once

#include "hmm/discrete_hmm.h"

#include <functional>

namespace steadyhand {

struct BaumWelchOptions {
	int max_iterations = 50;
	double tolerance_nats = 1e-3; ///< training stops if the objective grows by less, per sequence
	PseudoCounts pseudo;
	/// Called before each iteration with the number of finished ones. If it returns false, training stops.
	std::function<bool(int iterations)> go_on;
};

struct BaumWelchResult {
	DiscreteHmm hmm;
	/// For each iteration: sum of log P(O | lambda) over the sequences, plus the log of the Dirichlet prior
	/// (up to a constant), for the parameters before the iteration. Never decreases.
	std::vector<double> objective;
};

/// Baum-Welch over many sequences (Rabiner 1989 eq. (109)-(110)), with Dirichlet pseudo-counts on the rows of
/// A and B. pi does not change. Transitions with probability 0 in `start` keep it. Deterministic. Skips empty
/// sequences. UNSEEN frames count for transitions only.
BaumWelchResult baum_welch(
		DiscreteHmm start, std::span<const SymbolSequence> sequences, const BaumWelchOptions &options);

} // namespace steadyhand
