#include "hmm/linear_hmm.h"

#include <limits>

namespace steadyhand {
namespace {

Eigen::MatrixXd probabilities(const Eigen::MatrixXd &logs) {
	const Eigen::ArrayXXd p = logs.array().exp();
	// Eigen's vectorised exp(-infinity) is not 0, but a tiny number.
	return (p >= std::numeric_limits<double>::min()).select(p, 0.0);
}

} // namespace

LinearHmm::LinearHmm(const DiscreteHmm &hmm) :
		pi(probabilities(hmm.log_pi)), a(probabilities(hmm.log_a)), b(hmm.states(), hmm.symbols() + 1) {
	b << probabilities(hmm.log_b), Eigen::VectorXd::Ones(hmm.states());
}

} // namespace steadyhand
