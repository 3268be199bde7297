#pragma once

#include "hmm/discrete_hmm.h"

#include <random>

namespace steadyhand::test {

/// A row of `size` probabilities drawn from the flat Dirichlet distribution, as logarithms.
inline Eigen::RowVectorXd random_log_row(std::mt19937_64 &r_random, Eigen::Index size) {
	std::exponential_distribution<double> exponential;
	Eigen::RowVectorXd row(size);
	for (double &p : row) {
		p = exponential(r_random);
	}
	return (row / row.sum()).array().log();
}

inline DiscreteHmm random_hmm(std::mt19937_64 &r_random, Eigen::Index states, Eigen::Index symbols) {
	DiscreteHmm hmm;
	hmm.log_pi = random_log_row(r_random, states).transpose();
	hmm.log_a.resize(states, states);
	hmm.log_b.resize(states, symbols);
	for (Eigen::Index i = 0; i < states; ++i) {
		hmm.log_a.row(i) = random_log_row(r_random, states);
		hmm.log_b.row(i) = random_log_row(r_random, symbols);
	}
	return hmm;
}

inline SymbolSequence random_symbols(std::mt19937_64 &r_random, std::size_t length, int symbols) {
	std::uniform_int_distribution<int> draw(0, symbols - 1);
	SymbolSequence sequence(length);
	for (Symbol &symbol : sequence) {
		symbol = draw(r_random);
	}
	return sequence;
}

} // namespace steadyhand::test
