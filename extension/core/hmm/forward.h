#pragma once

#include "hmm/scaled_recursion.h"

namespace steadyhand {

/// Forward variable alpha_t(j) = P(o_1..o_t, q_t = j | lambda), Rabiner 1989 eq. (18)-(20), one symbol at a
/// time. Keeps no history. Only the constructor allocates. Exact at any length (scaled_recursion.h).
template <class Scalar = double> class ForwardFilter {
public:
	explicit ForwardFilter(const DiscreteHmm &hmm);

	void reset();
	void push(Symbol symbol);

	/// log P(o_1..o_t | lambda), nats; 0 before the first symbol.
	[[nodiscard]] double log_likelihood() const { return started_ ? alpha_.total(0).log() : 0.0; }
	/// Most probable state, argmax_j P(q_t = j | o_1..o_t, lambda); argmax of pi before the first symbol.
	[[nodiscard]] int state() const { return started_ ? alpha_.greatest(0) : first_state_; }

private:
	LinearHmm hmm_;
	Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> b_; ///< hmm_.b
	ScaledRecursion<1, Scalar> alpha_;
	int first_state_;
	bool started_ = false;
};

extern template class ForwardFilter<float>;
extern template class ForwardFilter<double>;

/// log P(O | lambda) in nats; 0 for an empty sequence.
double log_likelihood(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

} // namespace steadyhand
