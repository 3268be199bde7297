#include "hmm/viterbi.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// max_i delta(i) + log a_ij for every j, and the i that reached it (the lowest, where several do).
void best_predecessors(const DiscreteHmm &hmm, const Eigen::VectorXd &delta, Eigen::VectorXd &r_best,
		Eigen::Ref<Eigen::VectorXi> r_from) {
	for (Eigen::Index j = 0; j < hmm.states(); ++j) {
		Eigen::Index from = 0;
		r_best(j) = (delta + hmm.log_a.col(j)).maxCoeff(&from);
		r_from(j) = static_cast<int>(from);
	}
}

/// Plain loops: for a handful of states they cost half of what Eigen's reductions do.
double best_arrival(const Eigen::VectorXd &delta, const double *log_a_to) {
	double best = delta(0) + log_a_to[0];
	for (Eigen::Index i = 1; i < delta.size(); ++i) {
		best = std::max(best, delta(i) + log_a_to[i]);
	}
	return best;
}

int best_state(const Eigen::VectorXd &delta) {
	Eigen::Index state = 0;
	for (Eigen::Index i = 1; i < delta.size(); ++i) {
		state = delta(i) > delta(state) ? i : state;
	}
	return static_cast<int>(state);
}

} // namespace

ViterbiPath viterbi(const DiscreteHmm &hmm, std::span<const Symbol> symbols) {
	const auto length = static_cast<Eigen::Index>(symbols.size());
	ViterbiPath path;
	if (length == 0) {
		return path;
	}
	Eigen::MatrixXi from(hmm.states(), length);
	Eigen::VectorXd log_b(hmm.states());
	Eigen::VectorXd next(hmm.states());
	hmm.emission(symbols[0], log_b);
	Eigen::VectorXd delta = hmm.log_pi + log_b;
	for (Eigen::Index t = 1; t < length; ++t) {
		hmm.emission(symbols[static_cast<std::size_t>(t)], log_b);
		best_predecessors(hmm, delta, next, from.col(t));
		delta = next + log_b;
	}

	path.states.resize(symbols.size());
	int state = best_state(delta);
	path.log_probability = delta(state);
	for (Eigen::Index t = length - 1; t > 0; --t) {
		path.states[static_cast<std::size_t>(t)] = state;
		state = from(state, t);
	}
	path.states[0] = state;
	return path;
}

OnlineViterbi::OnlineViterbi(const DiscreteHmm &hmm) :
		hmm_(&hmm), delta_(hmm.states()), next_(hmm.states()), log_b_(hmm.states()) {
	reset();
}

void OnlineViterbi::reset() {
	started_ = false;
	delta_ = hmm_->log_pi;
	state_ = best_state(delta_);
}

void OnlineViterbi::push(Symbol symbol) {
	hmm_->emission(symbol, log_b_);
	if (started_) {
		for (Eigen::Index j = 0; j < hmm_->states(); ++j) {
			next_(j) = best_arrival(delta_, hmm_->log_a.col(j).data()) + log_b_(j);
		}
		delta_.swap(next_);
	} else {
		delta_ = hmm_->log_pi + log_b_;
		started_ = true;
	}
	state_ = best_state(delta_);
}

} // namespace steadyhand
