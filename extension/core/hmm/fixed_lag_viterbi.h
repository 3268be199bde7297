#pragma once

#include "hmm/viterbi.h"

#include <algorithm>

namespace steadyhand {

/// Fixed-lag Viterbi. After n symbols it gives the state of symbol n - lag on the best path over all n
/// symbols, equal to viterbi(). With lag or fewer symbols it gives the first state of that path. Only the
/// constructor allocates.
template <class Scalar = double> class FixedLagViterbi {
public:
	/// lag: symbols, >= 0.
	FixedLagViterbi(const DiscreteHmm &hmm, int lag) :
			newest_(hmm), before_(newest_.delta().size(), lag), state_(newest_.state()) {}

	void reset() {
		newest_.reset();
		count_ = 0;
		state_ = newest_.state();
	}

	void push(Symbol symbol) {
		const Eigen::Index lag = before_.cols();
		if (count_ > 0 && lag > 0) {
			newest_column_ = newest_column_ + 1 < lag ? newest_column_ + 1 : 0;
			before_.col(newest_column_) = newest_.delta();
		}
		newest_.push(symbol);
		state_ = newest_.state();
		Eigen::Index column = newest_column_;
		for (Eigen::Index back = std::min(count_, lag); back > 0; --back) {
			state_ = newest_.predecessor(state_, before_.col(column).data());
			column = column > 0 ? column - 1 : lag - 1;
		}
		count_ = std::min(count_ + 1, lag + 1);
	}

	[[nodiscard]] int state() const { return state_; }
	[[nodiscard]] int lag() const { return static_cast<int>(before_.cols()); }

private:
	OnlineViterbi<Scalar> newest_;
	/// Ring buffer of the last `lag` deltas before the newest one, for the backtracking.
	Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> before_;
	Eigen::Index newest_column_ = 0;
	Eigen::Index count_ = 0; ///< number of symbols so far, at most lag + 1
	int state_;
};

} // namespace steadyhand
