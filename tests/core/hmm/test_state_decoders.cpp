#include "hmm/state_decoder.h"
#include "hmm_all_paths.h"
#include "hmm_random.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace steadyhand;

namespace {

constexpr std::array PRECISIONS{ StateDecoding::Precision::DOUBLE, StateDecoding::Precision::SINGLE };

/// A model without skips: most transitions, and all initial states but one, are impossible.
DiscreteHmm random_left_right(std::mt19937_64 &r_random, Eigen::Index states, Eigen::Index symbols) {
	DiscreteHmm hmm = test::random_hmm(r_random, states, symbols);
	hmm.log_pi.setConstant(NEVER);
	hmm.log_pi(0) = 0.0;
	hmm.log_a.setConstant(NEVER);
	for (Eigen::Index i = 0; i + 1 < states; ++i) {
		hmm.log_a.row(i).segment(i, 2) = test::random_log_row(r_random, 2);
	}
	hmm.log_a(states - 1, states - 1) = 0.0;
	return hmm;
}

/// Rabiner 1989 eq. (32)-(33), in long double.
class LongViterbi {
public:
	explicit LongViterbi(const DiscreteHmm &hmm) :
			log_a_(hmm.log_a.cast<long double>()), log_b_(hmm.log_b.cast<long double>()),
			delta_(hmm.log_pi.cast<long double>()), next_(delta_.size()) {}

	void push(Symbol symbol) {
		for (Eigen::Index j = 0; has_started_ && j < delta_.size(); ++j) {
			next_(j) = (delta_ + log_a_.col(j)).maxCoeff();
		}
		delta_ = (has_started_ ? next_ : delta_) + log_b_.col(symbol);
		has_started_ = true;
	}
	[[nodiscard]] int state() const {
		int state = 0;
		delta_.maxCoeff(&state);
		return state;
	}
	[[nodiscard]] long double log_probability() const { return delta_.maxCoeff(); }

private:
	Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> log_a_, log_b_;
	Eigen::Matrix<long double, Eigen::Dynamic, 1> delta_, next_;
	bool has_started_ = false;
};

struct Errors {
	int other_states = 0; ///< symbols after which another state is the last one
	double nats = 0.0;    ///< of log P, the largest
};

template <class Scalar> Errors errors(const DiscreteHmm &hmm, const SymbolSequence &symbols) {
	OnlineViterbi<Scalar> viterbi(hmm);
	LongViterbi exact(hmm);
	Errors errors;
	for (const Symbol symbol : symbols) {
		viterbi.push(symbol);
		exact.push(symbol);
		errors.other_states += viterbi.state() != exact.state();
		errors.nats = std::max(errors.nats,
				static_cast<double>(std::abs(viterbi.log_probability() - exact.log_probability())));
	}
	return errors;
}

} // namespace

TEST_CASE("every decoder has the state of brute force over all paths") {
	std::mt19937_64 random(11);
	for (int round = 0; round < 40; ++round) {
		const DiscreteHmm hmm =
				round % 2 == 0 ? test::random_hmm(random, 3, 4) : random_left_right(random, 3, 4);
		SymbolSequence symbols = test::random_symbols(random, 8, 4);
		if (round % 4 == 0) {
			symbols[3] = UNSEEN;
		}
		std::vector<test::AllPaths> prefixes;
		for (std::size_t length = 1; length <= symbols.size(); ++length) {
			const auto prefix = std::span(symbols).first(length);
			prefixes.push_back(test::enumerate(hmm, { prefix.begin(), prefix.end() }));
		}
		for (const StateDecoding::Precision precision : PRECISIONS) {
			for (const std::size_t lag : { 0, 1, 3, 20 }) {
				StateDecoder viterbi(hmm, { StateDecoding::Rule::VITERBI, static_cast<int>(lag), precision });
				CHECK(viterbi.lag() == static_cast<int>(lag));
				for (int twice = 0; twice < 2; ++twice) {
					viterbi.reset();
					for (std::size_t t = 0; t < symbols.size(); ++t) {
						viterbi.push(symbols[t]);
						CHECK(viterbi.state() == prefixes[t].best_path[t - std::min(t, lag)]);
					}
				}
			}
			StateDecoder filter(hmm, { StateDecoding::Rule::FILTER, 5, precision });
			CHECK(filter.lag() == 0);
			for (int twice = 0; twice < 2; ++twice) {
				filter.reset();
				for (std::size_t t = 0; t < symbols.size(); ++t) {
					filter.push(symbols[t]);
					int expected = 0;
					prefixes[t].ending_in.maxCoeff(&expected);
					CHECK(filter.state() == expected);
				}
			}
		}
	}
}

TEST_CASE("a new or reset decoder has only the initial states") {
	std::mt19937_64 random(14);
	for (int round = 0; round < 10; ++round) {
		const DiscreteHmm hmm = test::random_hmm(random, 5, 4);
		const SymbolSequence symbols = test::random_symbols(random, 30, 4);
		int first = 0;
		hmm.log_pi.maxCoeff(&first);
		for (const StateDecoding::Precision precision : PRECISIONS) {
			for (const StateDecoding &decoding :
					{ StateDecoding{ StateDecoding::Rule::VITERBI, 0, precision },
							StateDecoding{ StateDecoding::Rule::VITERBI, 4, precision },
							StateDecoding{ StateDecoding::Rule::FILTER, 0, precision } }) {
				StateDecoder decoder(hmm, decoding);
				CHECK(decoder.state() == first);
				for (const Symbol symbol : symbols) {
					decoder.push(symbol);
				}
				decoder.reset();
				CHECK(decoder.state() == first);
			}
		}
		OnlineViterbi<float> used(hmm), fresh(hmm);
		ForwardFilter<float> filter(hmm);
		for (const Symbol symbol : symbols) {
			used.push(symbol);
			filter.push(symbol);
		}
		used.reset();
		filter.reset();
		CHECK(filter.log_likelihood() == 0.0);
		used.push(symbols[0]);
		fresh.push(symbols[0]);
		filter.push(symbols[0]);
		CHECK(used.log_probability() == fresh.log_probability());
		CHECK(filter.log_likelihood() ==
				test::near(log_likelihood(hmm, std::span(symbols).first(1))).epsilon(1e-6));
	}
}

TEST_CASE("the lowest of equally likely states is decoded") {
	for (const int states : { 2, 4, 7 }) {
		DiscreteHmm hmm;
		hmm.log_pi = Eigen::VectorXd::Constant(states, -std::log(states));
		hmm.log_a = Eigen::MatrixXd::Constant(states, states, -std::log(states));
		hmm.log_b = Eigen::MatrixXd::Constant(states, 2, -std::log(2.0));
		const SymbolSequence symbols{ 0, 1, 1, 0, 1, 0 };
		CHECK(viterbi(hmm, symbols).states == std::vector<int>(symbols.size(), 0));
		for (const StateDecoding &decoding :
				{ StateDecoding{}, StateDecoding{ StateDecoding::Rule::VITERBI, 3 },
						StateDecoding{ StateDecoding::Rule::FILTER } }) {
			StateDecoder decoder(hmm, decoding);
			for (const Symbol symbol : symbols) {
				decoder.push(symbol);
				CHECK(decoder.state() == 0);
			}
		}
		// The last states are likelier. Their predecessors are equally likely.
		hmm.log_pi(0) = NEVER;
		hmm.log_a.rightCols(1).setConstant(std::log(0.9));
		FixedLagViterbi<double> late(hmm, 1);
		late.push(0);
		late.push(1);
		CHECK(late.state() == (states > 2 ? 1 : states - 1));
	}
}

TEST_CASE("an impossible sequence has probability 0 until a reset, in both precisions") {
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::Vector2d(0.0, NEVER);
	hmm.log_a = (Eigen::Matrix2d() << 0.5, 0.5, 0.0, 1.0).finished().array().log();
	hmm.log_b = (Eigen::Matrix2d() << 1.0, 0.0, 0.5, 0.5).finished().array().log();
	const auto check = [](auto decoder, const auto &log_p) {
		decoder.push(1);
		decoder.push(0);
		CHECK(log_p(decoder) == NEVER);
		decoder.reset();
		decoder.push(0);
		decoder.push(1);
		CHECK(log_p(decoder) == test::near(std::log(0.25)));
	};
	const auto viterbi = [](const auto &decoder) { return decoder.log_probability(); };
	const auto filter = [](const auto &decoder) { return decoder.log_likelihood(); };
	check(OnlineViterbi<double>(hmm), viterbi);
	check(OnlineViterbi<float>(hmm), viterbi);
	check(ForwardFilter<double>(hmm), filter);
	check(ForwardFilter<float>(hmm), filter);
}

TEST_CASE("fixed-lag Viterbi equals Viterbi over the symbols so far, lag symbols earlier") {
	std::mt19937_64 random(12);
	for (const int states : { 1, 4, 5, 9 }) {
		const DiscreteHmm hmm = test::random_hmm(random, states, 16);
		SymbolSequence symbols = test::random_symbols(random, 60, 16);
		symbols[40] = UNSEEN;
		for (const int lag : { 3, 8 }) {
			FixedLagViterbi decoder(hmm, lag);
			for (std::size_t t = 0; t < symbols.size(); ++t) {
				decoder.push(symbols[t]);
				const ViterbiPath path = viterbi(hmm, std::span(symbols).first(t + 1));
				REQUIRE(decoder.state() == path.states[t - std::min(t, static_cast<std::size_t>(lag))]);
			}
		}
	}
}

TEST_CASE("over a million symbols float decodes as double, likelihood to 7 digits" *
		doctest::test_suite("figures")) {
	std::mt19937_64 random(13);
	const DiscreteHmm hmm = test::random_hmm(random, 4, 16);
	const SymbolSequence symbols = test::random_symbols(random, 1'000'000, 16);
	const Errors in_double = errors<double>(hmm, symbols), in_float = errors<float>(hmm, symbols);
	CHECK(in_double.other_states == 0);
	CHECK(in_double.nats < 1e-4);
	CHECK(in_float.other_states <= 10);
	CHECK(in_float.nats < 0.3); // of three million
	ForwardFilter<double> filter(hmm);
	ForwardFilter<float> float_filter(hmm);
	int other_states = 0;
	for (const Symbol symbol : symbols) {
		filter.push(symbol);
		float_filter.push(symbol);
		other_states += filter.state() != float_filter.state();
	}
	CHECK(other_states <= 10);
	CHECK(std::abs(filter.log_likelihood() - float_filter.log_likelihood()) < 0.3);
}

TEST_CASE("a long excluded state comes back on its symbols, in float too") {
	// One symbol '0', n symbols '1', then '0' again. State 0 emits '0' with 0.9 and stays with 0.99; state 1
	// emits '1' with 0.9 and is never left. After m more '0', the log odds of the path that stays in state 0
	// against the path that leaves after the first symbol are (m - n) log 9 + (n + m) log 0.99 - log 0.01.
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::Vector2d(0.0, NEVER);
	hmm.log_a = (Eigen::Matrix2d() << std::log(0.99), std::log(0.01), NEVER, 0.0).finished();
	hmm.log_b = (Eigen::Matrix2d() << 0.9, 0.1, 0.1, 0.9).finished().array().log();
	const double gained = std::log(9.0) + std::log(0.99), lost = std::log(9.0) - std::log(0.99);
	for (const int n : { 1'000, 100'000 }) {
		const auto zeros_to_come_back = [&](auto decoder) {
			decoder.push(0);
			for (int i = 0; i < n; ++i) {
				decoder.push(1);
			}
			int zeros = 0;
			while (decoder.state() != 0 && zeros < 2 * n) {
				decoder.push(0);
				++zeros;
			}
			return zeros;
		};
		const int expected = static_cast<int>(std::ceil((n * lost + std::log(0.01)) / gained));
		CHECK(zeros_to_come_back(OnlineViterbi<double>(hmm)) == expected);
		CHECK(zeros_to_come_back(StateDecoder(hmm)) == expected);
		// The forward filter sums all paths that leave; the one that leaves before the '1' dominates.
		CHECK(zeros_to_come_back(ForwardFilter<double>(hmm)) == expected);
		CHECK(zeros_to_come_back(ForwardFilter<float>(hmm)) == expected);
		CHECK(std::abs(zeros_to_come_back(OnlineViterbi<float>(hmm)) - expected) <= n / 200);
	}
}
