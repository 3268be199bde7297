#include "hmm/forward.h"
#include "hmm/viterbi.h"
#include "hmm_all_paths.h"
#include "hmm_random.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace steadyhand;

namespace {

DiscreteHmm two_state_left_right() {
	DiscreteHmm hmm;
	const double never = -std::numeric_limits<double>::infinity();
	hmm.log_pi = Eigen::Vector2d(0.0, never);
	hmm.log_a.resize(2, 2);
	hmm.log_a << std::log(0.99), std::log(0.01), never, 0.0;
	hmm.log_b.resize(2, 2);
	hmm.log_b << std::log(0.9), std::log(0.1), std::log(0.1), std::log(0.9);
	return hmm;
}

} // namespace

TEST_CASE("Viterbi and the forward variable agree with brute force over all paths") {
	std::mt19937_64 random(1);
	for (int round = 0; round < 40; ++round) {
		const DiscreteHmm hmm = test::random_hmm(random, 3, 4);
		SymbolSequence symbols = test::random_symbols(random, 7, 4);
		if (round % 4 == 0) {
			symbols[3] = UNSEEN;
		}
		const test::AllPaths all = test::enumerate(hmm, symbols);
		const ViterbiPath best = viterbi(hmm, symbols);
		CHECK(best.log_probability == test::near(all.best).epsilon(1e-12));
		CHECK(best.states == all.best_path);
		CHECK(log_likelihood(hmm, symbols) == test::near(std::log(all.ending_in.sum())).epsilon(1e-12));
	}
}

TEST_CASE("online Viterbi equals Viterbi over each prefix to the last bit") {
	std::mt19937_64 random(2);
	for (const int states : { 1, 3, 4, 5, 8, 9 }) {
		const DiscreteHmm hmm = test::random_hmm(random, states, 16);
		SymbolSequence symbols = test::random_symbols(random, 100, 16);
		symbols[40] = UNSEEN;
		OnlineViterbi online(hmm);
		for (int round = 0; round < 2; ++round) {
			online.reset();
			for (std::size_t t = 0; t < symbols.size(); ++t) {
				online.push(symbols[t]);
				const ViterbiPath path = viterbi(hmm, std::span(symbols).first(t + 1));
				REQUIRE(online.state() == path.states.back());
				REQUIRE(online.log_probability() == path.log_probability);
			}
		}
	}
}

TEST_CASE("a left-right model keeps its early states over 100,000 frames") {
	// After n symbols '0' the likelihood has a closed form, the sum over the frame k at which state 0 is
	// left: 0.9^n (0.99^(n-1)) + sum_k 0.99^(k-1) 0.01 0.9^k 0.1^(n-k).
	const DiscreteHmm hmm = two_state_left_right();
	const int n = 100'000;
	const double stay = n * std::log(0.9) + (n - 1) * std::log(0.99);
	// Each term k is the stay term times (0.01 / 0.99^(n-k)) (1/9)^(n-k): a geometric series in 1 / (9 *
	// 0.99).
	const double ratio = 1.0 / (9.0 * 0.99);
	const double expected = stay + std::log1p(0.01 * ratio / (1.0 - ratio));
	const SymbolSequence zeros(static_cast<std::size_t>(n), 0);
	CHECK(log_likelihood(hmm, zeros) == test::near(expected).epsilon(1e-12));
}

TEST_CASE("frames without an observation do not change the state weights") {
	std::mt19937_64 random(4);
	const DiscreteHmm hmm = test::random_hmm(random, 3, 4);
	CHECK(log_likelihood(hmm, SymbolSequence{}) == 0.0);
	CHECK(std::abs(log_likelihood(hmm, SymbolSequence(50, UNSEEN))) < 1e-12);
	CHECK(log_likelihood(hmm, SymbolSequence{ 1, 4 }) ==
			test::near(log_likelihood(hmm, SymbolSequence{ 1, UNSEEN })));
	CHECK(viterbi(hmm, SymbolSequence{}).states.empty());
}
