#pragma once

#include "hmm/scaled_recursion.h"

namespace steadyhand {

/// The forward variable alpha_t(j) = P(o_1..o_t, q_t = j | lambda), Rabiner 1989 eq. (18)-(20), one symbol at
/// a time: no history kept, no allocation after construction, exact at any length (scaled_recursion.h).
class ForwardFilter {
public:
	explicit ForwardFilter(const DiscreteHmm &hmm);

	void reset();
	void push(Symbol symbol);

	/// log P(o_1..o_t | lambda), nats; 0 before the first symbol.
	[[nodiscard]] double log_likelihood() const { return started_ ? alpha_.total(0).log() : 0.0; }

private:
	LinearHmm hmm_;
	ScaledRecursion<1> alpha_;
	Eigen::VectorXd first_;
	bool started_ = false;
};

/// log P(O | lambda) in nats; 0 for an empty sequence.
double log_likelihood(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

} // namespace steadyhand
