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
///
/// In float each symbol may lose 6e-8 of the difference between two states: one that is far behind does not
/// come back on its symbol (bench_quality).
template <class Scalar = double> class OnlineViterbi {
public:
	using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

	explicit OnlineViterbi(const DiscreteHmm &hmm);

	void reset();
	void push(Symbol symbol);

	/// Last state of the best path so far; the most probable first state before any symbol.
	[[nodiscard]] int state() const { return state_; }
	/// log max P(Q, O | lambda), nats.
	[[nodiscard]] double log_probability() const { return taken_out_ + static_cast<double>(delta_(state_)); }

	/// log max P(Q, O | lambda) of the paths that end in each state, less what is the same for all. N, and as
	/// many of -infinity as make whole vectors.
	[[nodiscard]] const Vector &delta() const { return delta_; }
	/// The state before the last on the best path to `state`, the lowest where several are; delta: before the
	/// last symbol.
	[[nodiscard]] int predecessor(int state, const Scalar *delta) const;

private:
	using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

	/// Padded with impossible states to whole vectors of them.
	Matrix log_a_; ///< to, from
	Matrix log_b_; ///< N x (M + 1): the last column, all 0, is of UNSEEN
	Vector log_pi_;
	Vector delta_;
	Vector next_;
	double taken_out_ = 0.0; ///< of all of delta_, nats
	int state_ = 0;
	bool started_ = false;

	void take_out_best();
};

extern template class OnlineViterbi<float>;
extern template class OnlineViterbi<double>;

} // namespace steadyhand
