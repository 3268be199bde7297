#include "hmm/viterbi.h"

#include <algorithm>
#include <type_traits>

namespace steadyhand {
namespace {

constexpr Eigen::Index WIDTH = 4;
template <class Scalar> using States = Eigen::Array<Scalar, WIDTH, 1>;
/// Eigen's allocations are aligned, and so are all multiples of WIDTH from there.
template <class Scalar> using ConstStates = Eigen::Map<const States<Scalar>, Eigen::Aligned16>;

/// max_i delta(i) + log a_ij for every j, and its argument i. Ties go to the lower i.
void best_predecessors(const DiscreteHmm &hmm, const Eigen::VectorXd &delta, Eigen::VectorXd &r_best,
		Eigen::Ref<Eigen::VectorXi> r_from) {
	for (Eigen::Index j = 0; j < hmm.states(); ++j) {
		Eigen::Index from = 0;
		r_best(j) = (delta + hmm.log_a.col(j)).maxCoeff(&from);
		r_from(j) = static_cast<int>(from);
	}
}

/// Most probable state. Ties go to the lower state. states >= 1.
template <class Scalar, class Count> int best_state(const Scalar *delta, Count states) {
	Scalar best = delta[0];
	int state = 0;
	for (int i = 1; i < states; ++i) {
		state = delta[i] > best ? i : state;
		best = std::max(best, delta[i]);
	}
	return state;
}

/// r_next_j = max_i (delta_i + log a_ij) + log b_j, in the layout of OnlineViterbi. Returns the best state.
/// r_next may be delta if states == WIDTH.
template <class Scalar, class Count>
int step(Count states, const Scalar *delta, const Scalar *log_a, const Scalar *log_b, Scalar *r_next) {
	for (Eigen::Index to = 0; to < states; to += WIDTH) {
		const auto best_from = [&](Eigen::Index i) -> States<Scalar> {
			const auto from = [&](Eigen::Index k) {
				return delta[i + k] + ConstStates<Scalar>(log_a + (i + k) * states + to);
			};
			return from(0).max(from(1)).max(from(2).max(from(3)));
		};
		States<Scalar> best = best_from(0);
		for (Eigen::Index i = WIDTH; i < states; i += WIDTH) {
			best = best.max(best_from(i));
		}
		Eigen::Map<States<Scalar>, Eigen::Aligned16>(r_next + to) = best + ConstStates<Scalar>(log_b + to);
	}
	return best_state(r_next, states);
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
	int state = best_state(delta.data(), delta.size());
	path.log_probability = delta(state);
	for (Eigen::Index t = length - 1; t > 0; --t) {
		path.states[static_cast<std::size_t>(t)] = state;
		state = from(state, t);
	}
	path.states[0] = state;
	return path;
}

template <class Scalar> OnlineViterbi<Scalar>::OnlineViterbi(const DiscreteHmm &hmm) {
	const Eigen::Index n = hmm.states(), symbols = hmm.symbols(), padded = (n + WIDTH - 1) / WIDTH * WIDTH;
	constexpr auto IMPOSSIBLE = static_cast<Scalar>(NEVER);
	log_a_.setConstant(padded, padded, IMPOSSIBLE);
	log_a_.topLeftCorner(n, n) = hmm.log_a.transpose().template cast<Scalar>();
	log_b_.setZero(padded, symbols + 1);
	log_b_.topLeftCorner(n, symbols) = hmm.log_b.template cast<Scalar>();
	log_pi_.setConstant(padded, IMPOSSIBLE);
	log_pi_.head(n) = hmm.log_pi.template cast<Scalar>();
	next_.resize(padded);
	reset();
}

template <class Scalar> void OnlineViterbi<Scalar>::reset() {
	started_ = false;
	subtracted_ = 0.0;
	delta_ = log_pi_;
	state_ = best_state(delta_.data(), delta_.size());
}

template <class Scalar> void OnlineViterbi<Scalar>::push(Symbol symbol) {
	const Eigen::Index unseen = log_b_.cols() - 1;
	const Scalar *const log_b = log_b_.col(symbol >= 0 && symbol < unseen ? symbol : unseen).data();
	if (!started_) {
		delta_ += Eigen::Map<const Vector>(log_b, delta_.size());
		state_ = best_state(delta_.data(), delta_.size());
		started_ = true;
	} else if (delta_.size() == WIDTH) {
		constexpr std::integral_constant<Eigen::Index, WIDTH> ONE_VECTOR;
		state_ = step(ONE_VECTOR, delta_.data(), log_a_.data(), log_b, delta_.data());
	} else {
		state_ = step(delta_.size(), delta_.data(), log_a_.data(), log_b, next_.data());
		delta_.swap(next_);
	}
	subtract_best();
}

/// Subtracts the best delta from all in float: the log probability of a long stream would leave no digits for
/// the differences between states. double resolves 4e-9 nats after 10^7 symbols.
template <class Scalar> void OnlineViterbi<Scalar>::subtract_best() {
	if constexpr (std::is_same_v<Scalar, float>) {
		const Scalar best = delta_(state_);
		if (best > static_cast<Scalar>(NEVER)) {
			for (Eigen::Index i = 0; i < delta_.size(); i += WIDTH) {
				Eigen::Map<States<Scalar>, Eigen::Aligned16>(delta_.data() + i) -= best;
			}
			subtracted_ += static_cast<double>(best);
		}
	}
}

template <class Scalar> int OnlineViterbi<Scalar>::predecessor(int state, const Scalar *delta) const {
	Scalar best = delta[0] + log_a_(state, 0);
	int from = 0;
	for (int i = 1; i < delta_.size(); ++i) {
		const Scalar here = delta[i] + log_a_(state, i);
		from = here > best ? i : from;
		best = std::max(best, here);
	}
	return from;
}

template class OnlineViterbi<float>;
template class OnlineViterbi<double>;

} // namespace steadyhand
