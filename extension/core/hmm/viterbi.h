#pragma once

#include "hmm/discrete_hmm.h"

namespace steadyhand {

struct ViterbiPath {
	std::vector<int> states;      ///< one for each symbol
	double log_probability = 0.0; ///< log max P(Q, O | lambda), nats
};

/// Most probable state sequence, Rabiner 1989 eq. (32)-(35). Ties go to the lower state.
ViterbiPath viterbi(const DiscreteHmm &hmm, std::span<const Symbol> symbols);

/// Online Viterbi. After each push it has the last state of the best path over all symbols so far, and its
/// probability. Both equal the end of viterbi(). Each push has the same cost, and no history is kept.
///
/// In float each symbol may lose 6e-8 of the difference between two states. A state that is far behind may
/// then not win when it should (bench_quality).
template <class Scalar = double> class OnlineViterbi {
public:
	using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

	explicit OnlineViterbi(const DiscreteHmm &hmm);

	void reset();
	void push(Symbol symbol);

	/// Last state of the best path; before the first symbol, the most probable first state.
	[[nodiscard]] int state() const { return state_; }
	/// log max P(Q, O | lambda), nats.
	[[nodiscard]] double log_probability() const { return subtracted_ + static_cast<double>(delta_(state_)); }

	/// For each state: log max P(Q, O | lambda) of the paths that end in it, minus a common constant. N
	/// entries, padded with -infinity to whole vectors.
	[[nodiscard]] const Vector &delta() const { return delta_; }
	/// Predecessor of `state` on the best path to it. Ties go to the lower state. delta: the value of delta()
	/// before the last symbol.
	[[nodiscard]] int predecessor(int state, const Scalar *delta) const;

private:
	using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

	/// Padded to whole vectors with impossible states.
	Matrix log_a_; ///< (to, from)
	Matrix log_b_; ///< N x (M + 1): the last column, all 0, is for UNSEEN
	Vector log_pi_;
	Vector delta_;
	Vector next_;
	double subtracted_ = 0.0; ///< sum of what was subtracted from delta_, nats
	int state_ = 0;
	bool started_ = false;

	void subtract_best();
};

extern template class OnlineViterbi<float>;
extern template class OnlineViterbi<double>;

} // namespace steadyhand
