#pragma once

#include "base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace steadyhand {

/// Index into a codebook, 0..M-1. UNSEEN is a frame without an observation: its emission probability is 1 in
/// every state.
using Symbol = std::int32_t;
inline constexpr Symbol UNSEEN = -1;

using SymbolSequence = std::vector<Symbol>;

/// Log of probability 0.
inline constexpr double NEVER = -std::numeric_limits<double>::infinity();

/// A discrete hidden Markov model of N states and M symbols, lambda = (A, B, pi) of Rabiner, "A tutorial on
/// hidden Markov models", Proc. IEEE 77(2), 1989, doi:10.1109/5.18626. All parameters are natural logarithms.
struct DiscreteHmm {
	Eigen::VectorXd log_pi; ///< N: log P(first state = i)
	Eigen::MatrixXd log_a;  ///< N x N: log P(next state = j | state = i) at (i, j)
	Eigen::MatrixXd log_b;  ///< N x M: log P(symbol = k | state = j) at (j, k)

	[[nodiscard]] Eigen::Index states() const { return log_a.rows(); }
	[[nodiscard]] Eigen::Index symbols() const { return log_b.cols(); }

	/// log b_j(symbol) for every state j; 0 for UNSEEN and for symbols outside the codebook.
	template <class Vector> void emission(Symbol symbol, Vector &r_log_b) const {
		if (symbol >= 0 && symbol < symbols()) {
			r_log_b = log_b.col(symbol);
		} else {
			r_log_b.setZero();
		}
	}
};

/// Checks a model from outside. Fails if shapes do not match, if a row does not sum to 1 within 1e-6, or if
/// an entry is NaN. Returns the model if it is valid.
Result<DiscreteHmm> validated(DiscreteHmm hmm);

/// Dirichlet pseudo-counts, added to the expected count of each allowed transition and of each symbol (MAP
/// estimate). They keep every symbol possible in every state, so that a symbol without training data costs a
/// finite penalty.
struct PseudoCounts {
	double transition = 1.0;
	double symbol = 0.1;
};

/// Initial model for Baum-Welch. Cuts each sequence into `states` segments of equal length, and counts in
/// them. Left-right without skips: state i leads to itself and to i + 1; the last state leads to itself; pi =
/// (1, 0, ...). Skips empty sequences and symbols outside 0..n_symbols-1. Needs states >= 1, n_symbols >= 1,
/// pseudo-counts > 0.
DiscreteHmm left_right_from_equal_segments(
		std::span<const SymbolSequence> sequences, int states, int n_symbols, const PseudoCounts &pseudo);

} // namespace steadyhand
