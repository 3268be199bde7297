#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

/// Forward variables log alpha_t(j) = log P(o_1..o_t, q_t = j | lambda), Rabiner 1989 eq. (18)-(20), N x T.
Eigen::MatrixXd log_forward(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

/// Backward variables log beta_t(i) = log P(o_t+1..o_T | q_t = i, lambda), Rabiner 1989 eq. (24)-(25), N x T.
Eigen::MatrixXd log_backward(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

/// The forward variable one symbol at a time, for streams: no history kept, no allocation after construction.
class ForwardFilter {
public:
	explicit ForwardFilter(const DiscreteHmm &hmm);

	void reset();
	void push(Symbol symbol);

	/// log P(o_1..o_t | lambda), nats; 0 before the first symbol.
	[[nodiscard]] double log_likelihood() const;
	/// log alpha_t(j), N.
	[[nodiscard]] const Eigen::VectorXd &log_alpha() const { return log_alpha_; }

private:
	const DiscreteHmm *hmm_;
	Eigen::VectorXd log_alpha_;
	Eigen::VectorXd next_;
	Eigen::VectorXd log_b_;
	bool started_ = false;
};

/// log P(O | lambda) in nats; 0 for an empty sequence.
double log_likelihood(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

} // namespace steadyhand
