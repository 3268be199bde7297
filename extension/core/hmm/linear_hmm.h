#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

/// Parameters of a DiscreteHmm as probabilities. Those below the smallest normal number, 2e-308, become 0.
struct LinearHmm {
	Eigen::VectorXd pi; ///< N
	Eigen::MatrixXd a;  ///< N x N: P(next state = j | state = i) at (i, j)
	Eigen::MatrixXd b;  ///< N x (M + 1): emissions; the last column, all 1, is for UNSEEN

	explicit LinearHmm(const DiscreteHmm &hmm);

	[[nodiscard]] Eigen::Index states() const { return a.rows(); }
	/// Column of b for a symbol.
	[[nodiscard]] Eigen::Index column(Symbol symbol) const {
		return symbol >= 0 && symbol < b.cols() - 1 ? symbol : b.cols() - 1;
	}
};

} // namespace steadyhand
