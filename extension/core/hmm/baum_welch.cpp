#include "hmm/baum_welch.h"

#include "hmm/expected_counts.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// Log density of the Dirichlet(1 + pseudo) prior at the allowed entries, up to a constant.
double log_prior(const DiscreteHmm &hmm, const PseudoCounts &pseudo) {
	double sum = 0.0;
	for (Eigen::Index i = 0; i < hmm.states(); ++i) {
		for (Eigen::Index j = 0; j < hmm.states(); ++j) {
			sum += hmm.log_a(i, j) > NEVER ? pseudo.transition * hmm.log_a(i, j) : 0.0;
		}
	}
	return pseudo.symbol > 0.0 ? sum + pseudo.symbol * hmm.log_b.sum() : sum;
}

/// M-step for one row. A row without counts keeps its values.
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
	const auto used = std::count_if(sequences.begin(), sequences.end(),
			[](const SymbolSequence &sequence) { return !sequence.empty(); });
	for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
		if (options.go_on && !options.go_on(iteration)) {
			break;
		}
		const ExpectedCounts counts = expected_counts(hmm, sequences);
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
