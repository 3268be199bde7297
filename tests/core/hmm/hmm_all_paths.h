#pragma once

#include "hmm/discrete_hmm.h"

#include <cmath>
#include <limits>

namespace steadyhand::test {

inline double path_log_probability(
		const DiscreteHmm &hmm, const std::vector<int> &path, const SymbolSequence &symbols) {
	double sum = hmm.log_pi(path[0]);
	for (std::size_t t = 0; t < path.size(); ++t) {
		sum += t > 0 ? hmm.log_a(path[t - 1], path[t]) : 0.0;
		sum += symbols[t] >= 0 ? hmm.log_b(path[t], symbols[t]) : 0.0;
	}
	return sum;
}

struct AllPaths {
	double best = -std::numeric_limits<double>::infinity();
	std::vector<int> best_path;
	Eigen::VectorXd ending_in; ///< probability of all paths that end in each state
};

/// Brute force over states^length paths.
inline AllPaths enumerate(const DiscreteHmm &hmm, const SymbolSequence &symbols) {
	AllPaths all;
	all.ending_in = Eigen::VectorXd::Zero(hmm.states());
	std::vector<int> path(symbols.size(), 0);
	while (true) {
		const double p = path_log_probability(hmm, path, symbols);
		all.ending_in(path.back()) += std::exp(p);
		if (p > all.best) {
			all.best = p;
			all.best_path = path;
		}
		std::size_t digit = 0;
		while (digit < path.size() && ++path[digit] == hmm.states()) {
			path[digit++] = 0;
		}
		if (digit == path.size()) {
			return all;
		}
	}
}

} // namespace steadyhand::test
