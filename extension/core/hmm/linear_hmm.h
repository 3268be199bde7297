#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

/// The parameters of a DiscreteHmm as probabilities; those under the smallest normal number, 2e-308, are 0.
struct LinearHmm {
	Eigen::VectorXd pi; ///< N
	Eigen::MatrixXd a;  ///< N x N, from, to
	Eigen::MatrixXd b;  ///< N x (M + 1): the last column, all 1, is of UNSEEN

	explicit LinearHmm(const DiscreteHmm &hmm);

	[[nodiscard]] Eigen::Index states() const { return a.rows(); }
	/// Column of b.
	[[nodiscard]] Eigen::Index column(Symbol symbol) const {
		return symbol >= 0 && symbol < b.cols() - 1 ? symbol : b.cols() - 1;
	}
};

} // namespace steadyhand
