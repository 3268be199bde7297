#pragma once

#include "hmm/discrete_hmm.h"

#include <limits>

namespace steadyhand {

/// The parameters of a DiscreteHmm as probabilities; those under the smallest normal number, 2e-308, are 0.
struct LinearHmm {
	Eigen::VectorXd pi; ///< N
	Eigen::MatrixXd a;  ///< N x N, from, to
	Eigen::MatrixXd b;  ///< N x (M + 1): the last column, all 1, is of UNSEEN

	explicit LinearHmm(const DiscreteHmm &hmm) :
			pi(probabilities(hmm.log_pi)), a(probabilities(hmm.log_a)), b(hmm.states(), hmm.symbols() + 1) {
		b << probabilities(hmm.log_b), Eigen::VectorXd::Ones(hmm.states());
	}

	[[nodiscard]] Eigen::Index states() const { return a.rows(); }
	/// Column of b.
	[[nodiscard]] Eigen::Index column(Symbol symbol) const {
		return symbol >= 0 && symbol < b.cols() - 1 ? symbol : b.cols() - 1;
	}

private:
	static Eigen::MatrixXd probabilities(const Eigen::MatrixXd &logs) {
		const Eigen::ArrayXXd p = logs.array().exp();
		// Eigen's vectorised exp(-infinity) is tiny, not 0.
		return (p >= std::numeric_limits<double>::min()).select(p, 0.0);
	}
};

} // namespace steadyhand
