#include "hmm/baum_welch.h"
#include "hmm/forward.h"
#include "hmm_random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

namespace {

/// Draws a sequence from the model.
SymbolSequence sample(const DiscreteHmm &hmm, std::mt19937_64 &r_random, std::size_t length) {
	const auto draw = [&](const Eigen::RowVectorXd &log_p) {
		double u = std::uniform_real_distribution<double>()(r_random);
		for (Eigen::Index k = 0; k + 1 < log_p.size(); ++k) {
			u -= std::exp(log_p(k));
			if (u < 0.0) {
				return k;
			}
		}
		return log_p.size() - 1;
	};
	SymbolSequence symbols;
	Eigen::Index state = draw(hmm.log_pi.transpose());
	for (std::size_t t = 0; t < length; ++t) {
		symbols.push_back(static_cast<Symbol>(draw(hmm.log_b.row(state))));
		state = draw(hmm.log_a.row(state));
	}
	return symbols;
}

/// Four states that each like four of sixteen symbols, 20 frames long on average.
DiscreteHmm four_state_left_right() {
	DiscreteHmm hmm;
	const double never = -std::numeric_limits<double>::infinity();
	hmm.log_pi = Eigen::Vector4d(0.0, never, never, never);
	hmm.log_a = Eigen::MatrixXd::Constant(4, 4, never);
	hmm.log_b = Eigen::MatrixXd::Constant(4, 16, std::log(0.1 / 12.0));
	for (Eigen::Index i = 0; i < 4; ++i) {
		hmm.log_a(i, i) = i < 3 ? std::log(0.95) : 0.0;
		if (i < 3) {
			hmm.log_a(i, i + 1) = std::log(0.05);
		}
		hmm.log_b.row(i).segment(4 * i, 4).setConstant(std::log(0.9 / 4.0));
	}
	return hmm;
}

} // namespace

TEST_CASE("Baum-Welch never lowers its objective") {
	std::mt19937_64 random(5);
	std::vector<SymbolSequence> sequences;
	for (int i = 0; i < 10; ++i) {
		sequences.push_back(test::random_symbols(random, 30, 6));
	}
	sequences[3][7] = UNSEEN;
	BaumWelchOptions options;
	options.tolerance_nats = -1.0;
	const BaumWelchResult result = baum_welch(test::random_hmm(random, 4, 6), sequences, options);
	REQUIRE(result.objective.size() == 50);
	for (std::size_t i = 1; i < result.objective.size(); ++i) {
		CHECK(result.objective[i] >= result.objective[i - 1] - 1e-9);
	}
	CHECK(validated(result.hmm).ok());
}

TEST_CASE("Baum-Welch recovers the model that made the data") {
	std::mt19937_64 random(6);
	const DiscreteHmm truth = four_state_left_right();
	std::vector<SymbolSequence> sequences;
	for (int i = 0; i < 500; ++i) {
		sequences.push_back(sample(truth, random, 100));
	}
	const DiscreteHmm start = left_right_from_equal_segments(sequences, 4, 16, {});
	const BaumWelchResult result = baum_welch(start, sequences, {});
	// Standard error of a proportion over the 500 departures of a state is 0.2 %, of an emission over 10,000
	// frames 0.4 %.
	CHECK((result.hmm.log_a.array().exp() - truth.log_a.array().exp()).abs().maxCoeff() < 0.01);
	CHECK((result.hmm.log_b.array().exp() - truth.log_b.array().exp()).abs().maxCoeff() < 0.02);
	CHECK(result.hmm.log_pi == truth.log_pi);
}

TEST_CASE("what the start forbids stays forbidden, and every symbol stays possible") {
	const std::vector<SymbolSequence> constant(3, SymbolSequence(40, 2));
	const DiscreteHmm start = left_right_from_equal_segments(constant, 4, 16, {});
	const DiscreteHmm hmm = baum_welch(start, constant, {}).hmm;
	CHECK(validated(hmm).ok());
	CHECK(std::isinf(hmm.log_a(0, 2)));
	CHECK(std::isinf(hmm.log_a(1, 0)));
	CHECK(hmm.log_b.minCoeff() > std::log(1e-4));
	CHECK(std::isfinite(log_likelihood(hmm, SymbolSequence{ 2, 2, 15, 2 })));
}

TEST_CASE("one symbol, one sequence and no sequence at all train without harm") {
	const DiscreteHmm nothing = left_right_from_equal_segments({}, 4, 16, {});
	CHECK(validated(nothing).ok());
	CHECK(validated(baum_welch(nothing, {}, {}).hmm).ok());
	const std::vector<SymbolSequence> tiny{ { 3 }, {} };
	CHECK(validated(baum_welch(left_right_from_equal_segments(tiny, 4, 16, {}), tiny, {}).hmm).ok());
}

TEST_CASE("validated() names what is wrong") {
	std::mt19937_64 random(7);
	DiscreteHmm hmm = test::random_hmm(random, 3, 4);
	CHECK(validated(hmm).ok());
	DiscreteHmm bad = hmm;
	bad.log_b(1, 2) = 0.0;
	CHECK(validated(bad).error() == "B, row 1: the probabilities do not sum to 1");
	bad = hmm;
	bad.log_a(2, 0) = std::nan("");
	CHECK(validated(bad).error() == "A, row 2: the probabilities do not sum to 1");
	bad = hmm;
	bad.log_pi.conservativeResize(2);
	CHECK(validated(bad).error() == "the sizes of pi (2), A (3 x 3) and B (3 x 4) do not belong together");
}
