#include "hmm/discrete_hmm.h"

#include <cmath>
#include <string>

namespace steadyhand {
namespace {

constexpr double SUM_TOLERANCE = 1e-6;

bool is_log_distribution(const Eigen::RowVectorXd &row) {
	return !row.hasNaN() && std::abs(row.array().exp().sum() - 1.0) <= SUM_TOLERANCE;
}

std::string bad_row(const char *matrix, Eigen::Index row) {
	return std::string(matrix) + ", row " + std::to_string(row) + ": the probabilities do not sum to 1";
}

} // namespace

Result<DiscreteHmm> validated(DiscreteHmm hmm) {
	const Eigen::Index n = hmm.log_pi.size();
	if (n < 1 || hmm.log_a.rows() != n || hmm.log_a.cols() != n || hmm.log_b.rows() != n ||
			hmm.log_b.cols() < 1) {
		return Error{ "the sizes of pi (" + std::to_string(n) + "), A (" + std::to_string(hmm.log_a.rows()) +
			" x " + std::to_string(hmm.log_a.cols()) + ") and B (" + std::to_string(hmm.log_b.rows()) +
			" x " + std::to_string(hmm.log_b.cols()) + ") do not match" };
	}
	if (!is_log_distribution(hmm.log_pi.transpose())) {
		return Error{ "pi: the probabilities do not sum to 1" };
	}
	for (Eigen::Index i = 0; i < n; ++i) {
		if (!is_log_distribution(hmm.log_a.row(i))) {
			return Error{ bad_row("A", i) };
		}
		if (!is_log_distribution(hmm.log_b.row(i))) {
			return Error{ bad_row("B", i) };
		}
	}
	return hmm;
}

DiscreteHmm left_right_from_equal_segments(
		std::span<const SymbolSequence> sequences, int states, int n_symbols, const PseudoCounts &pseudo) {
	const Eigen::Index n = states;
	Eigen::MatrixXd symbol_counts = Eigen::MatrixXd::Constant(n, n_symbols, pseudo.symbol);
	Eigen::VectorXd frames = Eigen::VectorXd::Zero(n);
	Eigen::VectorXd departures = Eigen::VectorXd::Zero(n);
	for (const SymbolSequence &sequence : sequences) {
		const auto length = static_cast<Eigen::Index>(sequence.size());
		for (Eigen::Index t = 0; t < length; ++t) {
			const Eigen::Index state = t * n / length;
			const Symbol symbol = sequence[static_cast<std::size_t>(t)];
			frames(state) += 1.0;
			if (symbol >= 0 && symbol < n_symbols) {
				symbol_counts(state, symbol) += 1.0;
			}
		}
		if (length > 0) {
			departures.array() += 1.0;
		}
	}

	DiscreteHmm hmm;
	hmm.log_pi = Eigen::VectorXd::Constant(n, NEVER);
	hmm.log_pi(0) = 0.0;
	hmm.log_a = Eigen::MatrixXd::Constant(n, n, NEVER);
	for (Eigen::Index i = 0; i + 1 < n; ++i) {
		const double leave = departures(i) + pseudo.transition;
		const double stay = std::max(frames(i) - departures(i), 0.0) + pseudo.transition;
		hmm.log_a(i, i) = std::log(stay / (stay + leave));
		hmm.log_a(i, i + 1) = std::log(leave / (stay + leave));
	}
	hmm.log_a(n - 1, n - 1) = 0.0;
	hmm.log_b = (symbol_counts.array().colwise() / symbol_counts.rowwise().sum().array()).log();
	return hmm;
}

} // namespace steadyhand
