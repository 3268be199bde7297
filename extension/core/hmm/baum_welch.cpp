#include "hmm/baum_welch.h"

#include "hmm/forward.h"
#include "hmm/log_sum.h"

#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

constexpr double NEVER = -std::numeric_limits<double>::infinity();

/// Expected counts of the E-step.
struct ExpectedCounts {
	Eigen::MatrixXd transitions; ///< N x N: sum over t of xi_t(i, j)
	Eigen::MatrixXd symbols;     ///< N x M: sum over t with o_t = k of gamma_t(j)
	double log_likelihood = 0.0;
};

void accumulate(const DiscreteHmm &hmm, const SymbolSequence &sequence, ExpectedCounts &r_counts) {
	const Eigen::MatrixXd log_alpha = log_forward(hmm, sequence);
	const Eigen::MatrixXd log_beta = log_backward(hmm, sequence);
	const auto length = static_cast<Eigen::Index>(sequence.size());
	const double log_likelihood = log_sum_exp(log_alpha.col(length - 1));
	r_counts.log_likelihood += log_likelihood;
	if (!std::isfinite(log_likelihood)) {
		return; // impossible under a model without pseudo-counts: it says nothing about the parameters
	}
	Eigen::VectorXd log_b(hmm.states());
	for (Eigen::Index t = 0; t < length; ++t) {
		const Symbol symbol = sequence[static_cast<std::size_t>(t)];
		if (symbol >= 0 && symbol < hmm.symbols()) {
			r_counts.symbols.col(symbol) +=
					(log_alpha.col(t) + log_beta.col(t)).array().operator-(log_likelihood).exp().matrix();
		}
		if (t + 1 < length) {
			hmm.emission(sequence[static_cast<std::size_t>(t + 1)], log_b);
			const Eigen::RowVectorXd arrival =
					(log_b + log_beta.col(t + 1)).transpose().array() - log_likelihood;
			r_counts.transitions.array() +=
					((hmm.log_a.colwise() + log_alpha.col(t)).rowwise() + arrival).array().exp();
		}
	}
}

/// Dirichlet(1 + pseudo) log density of the allowed entries, up to a constant.
double log_prior(const DiscreteHmm &hmm, const PseudoCounts &pseudo) {
	double sum = 0.0;
	for (Eigen::Index i = 0; i < hmm.states(); ++i) {
		for (Eigen::Index j = 0; j < hmm.states(); ++j) {
			sum += hmm.log_a(i, j) > NEVER ? pseudo.transition * hmm.log_a(i, j) : 0.0;
		}
	}
	return pseudo.symbol > 0.0 ? sum + pseudo.symbol * hmm.log_b.sum() : sum;
}

/// The M-step for one row; a row without any count keeps its values.
void normalise_row(Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> log_row, Eigen::RowVectorXd counts,
		double pseudo, bool all_allowed) {
	for (Eigen::Index k = 0; k < counts.size(); ++k) {
		counts(k) = all_allowed || log_row(k) > NEVER ? counts(k) + pseudo : 0.0;
	}
	const double total = counts.sum();
	if (total > 0.0) {
		log_row = (counts.array() / total).log();
	}
}

} // namespace

BaumWelchResult baum_welch(
		DiscreteHmm start, std::span<const SymbolSequence> sequences, const BaumWelchOptions &options) {
	BaumWelchResult result{ std::move(start), {} };
	DiscreteHmm &hmm = result.hmm;
	for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
		if (options.go_on && !options.go_on(iteration)) {
			break;
		}
		ExpectedCounts counts;
		counts.transitions = Eigen::MatrixXd::Zero(hmm.states(), hmm.states());
		counts.symbols = Eigen::MatrixXd::Zero(hmm.states(), hmm.symbols());
		std::size_t used = 0;
		for (const SymbolSequence &sequence : sequences) {
			if (!sequence.empty()) {
				accumulate(hmm, sequence, counts);
				++used;
			}
		}
		result.objective.push_back(counts.log_likelihood + log_prior(hmm, options.pseudo));
		const std::size_t n = result.objective.size();
		if (used == 0 ||
				(n > 1 &&
						result.objective[n - 1] - result.objective[n - 2] <
								options.tolerance_nats * static_cast<double>(used))) {
			break;
		}
		for (Eigen::Index i = 0; i < hmm.states(); ++i) {
			normalise_row(hmm.log_a.row(i), counts.transitions.row(i), options.pseudo.transition, false);
			normalise_row(hmm.log_b.row(i), counts.symbols.row(i), options.pseudo.symbol,
					options.pseudo.symbol > 0.0);
		}
	}
	return result;
}

} // namespace steadyhand
