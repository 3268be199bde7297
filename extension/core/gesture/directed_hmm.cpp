#include "gesture/directed_hmm.h"

#include <cmath>
#include <utility>

namespace steadyhand {
namespace {

constexpr PseudoCounts PSEUDO;
/// Initial probability of each later state. Not 0, because ScaledRecursion would renormalise at each symbol.
constexpr double LATE = 1e-9;

} // namespace

DirectedHmm directed_hmm(std::string gesture, const DirectedCounts &counts,
		const Eigen::RowVectorXd &all_motion, double odd_symbols) {
	const Eigen::Index states = counts.symbols.rows();
	Eigen::MatrixXd a = Eigen::MatrixXd::Zero(states, states);
	for (Eigen::Index i = 0; i < states; ++i) {
		a(i, i) = PSEUDO.transition + counts.transitions(i, 0);
		if (i + 1 < states) {
			a(i, i + 1) = PSEUDO.transition + counts.transitions(i, 1);
		}
	}
	const Eigen::MatrixXd b = counts.symbols.array() + PSEUDO.symbol;
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::VectorXd::Constant(states, std::log(LATE));
	hmm.log_pi(0) = std::log1p(-static_cast<double>(states - 1) * LATE);
	hmm.log_a = (a.array().colwise() / a.rowwise().sum().array()).log();
	hmm.log_b = (b.array().colwise() / b.rowwise().sum().array()).log();
	hmm.log_b = ((1.0 - odd_symbols) * hmm.log_b.array().exp() +
			odd_symbols * all_motion.array().replicate(states, 1))
						.log();
	return { static_cast<const GestureReach &>(counts), std::move(gesture), std::move(hmm) };
}

} // namespace steadyhand
