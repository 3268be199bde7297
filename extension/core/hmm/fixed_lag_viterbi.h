#pragma once

#include "hmm/viterbi.h"

#include <algorithm>

namespace steadyhand {

/// Viterbi that waits: after n symbols, the state of symbol n - lag on the best path over all of them,
/// exactly as viterbi() over these symbols has it; the first state of that path while there are no more than
/// lag. After construction nothing is allocated.
template <class Scalar = double> class FixedLagViterbi {
public:
	/// lag: symbols, >= 0.
	FixedLagViterbi(const DiscreteHmm &hmm, int lag) :
			newest_(hmm), before_(newest_.delta().size(), lag), state_(newest_.state()) {}

	void reset() {
		newest_.reset();
		seen_ = 0;
		state_ = newest_.state();
	}

	void push(Symbol symbol) {
		const Eigen::Index lag = before_.cols();
		if (seen_ > 0 && lag > 0) {
			newest_column_ = newest_column_ + 1 < lag ? newest_column_ + 1 : 0;
			before_.col(newest_column_) = newest_.delta();
		}
		newest_.push(symbol);
		state_ = newest_.state();
		Eigen::Index column = newest_column_;
		for (Eigen::Index back = std::min(seen_, lag); back > 0; --back) {
			state_ = newest_.predecessor(state_, before_.col(column).data());
			column = column > 0 ? column - 1 : lag - 1;
		}
		seen_ = std::min(seen_ + 1, lag + 1);
	}

	[[nodiscard]] int state() const { return state_; }
	[[nodiscard]] int lag() const { return static_cast<int>(before_.cols()); }

private:
	OnlineViterbi<Scalar> newest_;
	/// A ring of the last `lag` deltas before the newest one, from which the path is traced back.
	Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> before_;
	Eigen::Index newest_column_ = 0;
	Eigen::Index seen_ = 0; ///< symbols, up to one more than the ring holds
	int state_;
};

} // namespace steadyhand
