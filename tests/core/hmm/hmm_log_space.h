#pragma once

#include "hmm/expected_counts.h"

#include <cmath>
#include <limits>

namespace steadyhand::test {

using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// log(sum(exp(x))); -infinity if all x are -infinity.
inline long double log_sum_exp(const LongVector &x) {
	const long double largest = x.maxCoeff();
	return std::isfinite(largest) ? largest + std::log((x.array() - largest).exp().sum()) : largest;
}

/// The E-step (Rabiner 1989 eq. (18)-(37)) in logarithms: slow, but without range limit. In long double,
/// because the logarithm of the small probability of a long sequence has a coarse resolution.
inline ExpectedCounts log_space_counts(const DiscreteHmm &hmm, const SymbolSequence &sequence) {
	const Eigen::Index n = hmm.states(), length = static_cast<Eigen::Index>(sequence.size());
	const LongMatrix log_a = hmm.log_a.cast<long double>();
	LongMatrix log_b = LongMatrix::Zero(n, length), alpha(n, length), beta = LongMatrix::Zero(n, length);
	for (Eigen::Index t = 0; t < length; ++t) {
		const Symbol symbol = sequence[static_cast<std::size_t>(t)];
		if (symbol >= 0 && symbol < hmm.symbols()) {
			log_b.col(t) = hmm.log_b.col(symbol).cast<long double>();
		}
		for (Eigen::Index j = 0; j < n; ++j) {
			alpha(j, t) = log_b(j, t) +
					(t > 0 ? log_sum_exp(alpha.col(t - 1) + log_a.col(j))
						   : static_cast<long double>(hmm.log_pi(j)));
		}
	}
	for (Eigen::Index t = length - 2; t >= 0; --t) {
		for (Eigen::Index i = 0; i < n; ++i) {
			beta(i, t) = log_sum_exp(log_a.row(i).transpose() + log_b.col(t + 1) + beta.col(t + 1));
		}
	}
	const long double log_likelihood = log_sum_exp(alpha.col(length - 1));
	ExpectedCounts counts{ Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, hmm.symbols()),
		static_cast<double>(log_likelihood) };
	for (Eigen::Index t = 0; t < length; ++t) {
		const Symbol symbol = sequence[static_cast<std::size_t>(t)];
		for (Eigen::Index i = 0; i < n; ++i) {
			if (symbol >= 0 && symbol < hmm.symbols()) {
				counts.symbols(i, symbol) +=
						static_cast<double>(std::exp(alpha(i, t) + beta(i, t) - log_likelihood));
			}
			for (Eigen::Index j = 0; t + 1 < length && j < n; ++j) {
				counts.transitions(i, j) += static_cast<double>(std::exp(
						alpha(i, t) + log_a(i, j) + log_b(j, t + 1) + beta(j, t + 1) - log_likelihood));
			}
		}
	}
	return counts;
}

} // namespace steadyhand::test
