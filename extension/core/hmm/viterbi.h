#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

struct ViterbiPath {
	std::vector<int> states;      ///< one per symbol
	double log_probability = 0.0; ///< log max P(Q, O | lambda), nats
};

/// The single best state sequence, Rabiner 1989 eq. (32)-(35). Ties go to the lower state.
ViterbiPath viterbi(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

/// Viterbi over the symbols so far: after each push, the last state of the best path and its probability -
/// exactly what viterbi() over the same symbols ends with, at a constant cost and with no memory of the past.
class OnlineViterbi {
public:
	explicit OnlineViterbi(const DiscreteHmm &hmm);

	void reset();
	void push(Symbol symbol);

	/// Last state of the best path so far; the most probable first state before any symbol.
	[[nodiscard]] int state() const { return state_; }
	/// log max P(Q, O | lambda), nats.
	[[nodiscard]] double log_probability() const { return delta_(state_); }

private:
	/// Padded with impossible states to whole vectors of them.
	Eigen::MatrixXd log_a_; ///< to, from
	Eigen::MatrixXd log_b_; ///< N x (M + 1): the last column, all 0, is of UNSEEN
	Eigen::VectorXd log_pi_;
	Eigen::VectorXd delta_;
	Eigen::VectorXd next_;
	int state_ = 0;
	bool started_ = false;
};

} // namespace steadyhand
