#include "hmm/baum_welch.h"
#include "hmm/forward.h"
#include "hmm_all_paths.h"
#include "hmm_random.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace steadyhand;

namespace {

/// Adds the expected counts of transitions and symbols in the sequence, path by path. Returns the log
/// likelihood.
double add_all_paths(const DiscreteHmm &hmm, const SymbolSequence &symbols, Eigen::MatrixXd &r_transitions,
		Eigen::MatrixXd &r_symbols) {
	const double likelihood = test::enumerate(hmm, symbols).ending_in.sum();
	std::vector<int> path(symbols.size(), 0);
	for (std::size_t digit = 0; digit < path.size();) {
		const double share = std::exp(test::path_log_probability(hmm, path, symbols)) / likelihood;
		for (std::size_t t = 0; t < path.size(); ++t) {
			if (t > 0) {
				r_transitions(path[t - 1], path[t]) += share;
			}
			if (symbols[t] != UNSEEN) {
				r_symbols(path[t], symbols[t]) += share;
			}
		}
		for (digit = 0; digit < path.size() && ++path[digit] == hmm.states(); ++digit) {
			path[digit] = 0;
		}
	}
	return std::log(likelihood);
}

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

/// Four states, each with four likely symbols of sixteen, and 20 frames long on average.
DiscreteHmm four_state_left_right() {
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::Vector4d(0.0, NEVER, NEVER, NEVER);
	hmm.log_a = Eigen::MatrixXd::Constant(4, 4, NEVER);
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
	// The standard error of a proportion is 0.2 % over the 500 departures of a state, and 0.4 % of an
	// emission over 10,000 frames.
	CHECK((result.hmm.log_a.array().exp() - truth.log_a.array().exp()).abs().maxCoeff() < 0.01);
	CHECK((result.hmm.log_b.array().exp() - truth.log_b.array().exp()).abs().maxCoeff() < 0.02);
	CHECK(result.hmm.log_pi == truth.log_pi);
}

TEST_CASE("one Baum-Welch step equals the estimate from all paths, with its objective") {
	std::mt19937_64 random(8);
	for (const PseudoCounts &pseudo : { PseudoCounts{}, { .transition = 0.0, .symbol = 0.0 },
				 { .transition = 0.7, .symbol = 0.0 }, { .transition = 0.0, .symbol = 0.3 } }) {
		CAPTURE(pseudo.transition);
		CAPTURE(pseudo.symbol);
		DiscreteHmm start = test::random_hmm(random, 3, 4);
		start.log_a.row(1) = Eigen::RowVector3d(std::log(0.25), NEVER, std::log(0.75));
		const std::vector<SymbolSequence> sequences{ test::random_symbols(random, 6, 4), {},
			{ 0, 2, UNSEEN, 2, 0 } };
		Eigen::MatrixXd transitions = Eigen::MatrixXd::Zero(3, 3), symbols = Eigen::MatrixXd::Zero(3, 4);
		double objective = 0.0;
		for (const SymbolSequence &sequence : sequences) {
			objective += sequence.empty() ? 0.0 : add_all_paths(start, sequence, transitions, symbols);
		}
		for (Eigen::Index i = 0; i < 3; ++i) {
			for (Eigen::Index j = 0; j < 3; ++j) {
				const bool is_allowed = i != 1 || j != 1;
				objective += is_allowed ? pseudo.transition * start.log_a(i, j) : 0.0;
				transitions(i, j) += is_allowed ? pseudo.transition : 0.0;
			}
		}
		objective += pseudo.symbol * start.log_b.sum();
		symbols.array() += pseudo.symbol;

		BaumWelchOptions options;
		options.max_iterations = 1;
		options.pseudo = pseudo;
		const BaumWelchResult result = baum_welch(start, sequences, options);
		REQUIRE(result.objective.size() == 1);
		CHECK(result.objective[0] == test::near(objective).epsilon(1e-12));
		for (Eigen::Index i = 0; i < 3; ++i) {
			const auto row = [i](const Eigen::MatrixXd &of) { return Eigen::ArrayXd(of.row(i)); };
			const Eigen::ArrayXd a = row(transitions) / transitions.row(i).sum(),
								 b = row(symbols) / symbols.row(i).sum();
			CHECK((row(result.hmm.log_a).exp() - a).abs().maxCoeff() < 1e-12);
			CHECK((row(result.hmm.log_b).exp() - b).abs().maxCoeff() < 1e-12);
		}
		CHECK(result.hmm.log_pi == start.log_pi);
	}
}

TEST_CASE("an unreachable state keeps its probabilities") {
	std::mt19937_64 random(9);
	DiscreteHmm start = test::random_hmm(random, 3, 4);
	start.log_pi = Eigen::Vector3d(std::log(0.5), std::log(0.5), NEVER);
	start.log_a.topRows(2) =
			(Eigen::MatrixXd(2, 3) << 0.5, 0.5, 0.0, 0.25, 0.75, 0.0).finished().array().log();
	BaumWelchOptions options;
	options.pseudo = { .transition = 0.0, .symbol = 0.0 };
	const std::vector<SymbolSequence> sequences(3, test::random_symbols(random, 40, 4));
	const DiscreteHmm hmm = baum_welch(start, sequences, options).hmm;
	CHECK(hmm.log_a.row(2) == start.log_a.row(2));
	CHECK(hmm.log_b.row(2) == start.log_b.row(2));
	CHECK(hmm.log_b.row(0) != start.log_b.row(0));
}

TEST_CASE("training ends by the gain per sequence or by go_on()") {
	std::mt19937_64 random(10);
	const DiscreteHmm start = test::random_hmm(random, 3, 4);
	const std::vector<SymbolSequence> once{ test::random_symbols(random, 60, 4),
		test::random_symbols(random, 60, 4) };
	std::vector<SymbolSequence> often;
	for (int i = 0; i < 50; ++i) {
		often.insert(often.end(), once.begin(), once.end());
		often.emplace_back();
	}
	BaumWelchOptions options;
	options.pseudo = { .transition = 0.0, .symbol = 0.0 };
	options.tolerance_nats = 0.01;
	options.max_iterations = 500;
	const BaumWelchResult result = baum_welch(start, once, options);
	const std::size_t n = result.objective.size();
	REQUIRE(n > 3);
	REQUIRE(n < 500);
	CHECK(result.objective[n - 1] - result.objective[n - 2] < 2.0 * 0.01);
	CHECK(result.objective[n - 2] - result.objective[n - 3] >= 2.0 * 0.01);
	CHECK(baum_welch(start, often, options).objective.size() == n);

	int asked = 0;
	options.go_on = [&](int iterations) {
		CHECK(iterations == asked++);
		return iterations < 3;
	};
	CHECK(baum_welch(start, once, options).objective.size() == 3);
	options.go_on = nullptr;
	const BaumWelchResult untrained = baum_welch(start, std::vector<SymbolSequence>(2), options);
	CHECK(untrained.objective.size() == 1);
	CHECK(untrained.hmm.log_a == start.log_a);
}

TEST_CASE("the initial model has the counts of equal segments") {
	// One symbol is not observed, and one is in no codebook.
	const std::vector<SymbolSequence> sequences{ { 0, 0, 1, 1, 2, 2 }, {}, { 0, 3, 1, UNSEEN, 2, 2 }, { 9 } };
	const PseudoCounts pseudo{ .transition = 0.5, .symbol = 0.25 };
	const DiscreteHmm hmm = left_right_from_equal_segments(sequences, 3, 4, pseudo);
	CHECK(validated(hmm).ok());
	CHECK(hmm.log_pi == Eigen::Vector3d(0.0, NEVER, NEVER));
	// The states have 5, 4 and 4 frames. Each but the last is left three times.
	const Eigen::Matrix3d a =
			(Eigen::Matrix3d() << 2.5 / 6.0, 3.5 / 6.0, 0.0, 0.0, 1.5 / 5.0, 3.5 / 5.0, 0.0, 0.0, 1.0)
					.finished();
	CHECK((hmm.log_a.array().exp() - a.array()).abs().maxCoeff() < 1e-12);
	const Eigen::MatrixXd b = (Eigen::MatrixXd(3, 4) << 3.25 / 5.0, 0.25 / 5.0, 0.25 / 5.0, 1.25 / 5.0,
			0.25 / 4.0, 3.25 / 4.0, 0.25 / 4.0, 0.25 / 4.0, 0.25 / 5.0, 0.25 / 5.0, 4.25 / 5.0, 0.25 / 5.0)
									  .finished();
	CHECK((hmm.log_b.array().exp() - b.array()).abs().maxCoeff() < 1e-12);
	// It is left once per sequence, although it has no frame.
	const std::vector<SymbolSequence> tiny{ { 0 }, { 1 } };
	const DiscreteHmm brief = left_right_from_equal_segments(tiny, 3, 4, pseudo);
	CHECK(std::exp(brief.log_a(1, 1)) == test::near(0.5 / 3.0));
}

TEST_CASE("transitions of probability 0 stay 0, and all symbols stay possible") {
	const std::vector<SymbolSequence> constant(3, SymbolSequence(40, 2));
	const DiscreteHmm start = left_right_from_equal_segments(constant, 4, 16, {});
	const DiscreteHmm hmm = baum_welch(start, constant, {}).hmm;
	CHECK(validated(hmm).ok());
	CHECK(std::isinf(hmm.log_a(0, 2)));
	CHECK(std::isinf(hmm.log_a(1, 0)));
	CHECK(hmm.log_b.minCoeff() > std::log(1e-4));
	CHECK(std::isfinite(log_likelihood(hmm, SymbolSequence{ 2, 2, 15, 2 })));
}

TEST_CASE("training on one symbol, one sequence or none gives a valid model") {
	const DiscreteHmm nothing = left_right_from_equal_segments({}, 4, 16, {});
	CHECK(validated(nothing).ok());
	CHECK(validated(baum_welch(nothing, {}, {}).hmm).ok());
	const std::vector<SymbolSequence> tiny{ { 3 }, {} };
	CHECK(validated(baum_welch(left_right_from_equal_segments(tiny, 4, 16, {}), tiny, {}).hmm).ok());
}

TEST_CASE("validated() names the invalid part") {
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
	bad.log_b(0, 3) += 1e-5;
	CHECK_FALSE(validated(bad).ok());
	bad.log_b(0, 3) -= 1e-5 - 1e-7;
	CHECK(validated(bad).ok());
	bad = hmm;
	bad.log_a = test::random_hmm(random, 3, 4).log_b; // rows that sum to 1, one column too many
	CHECK(validated(bad).error() == "the sizes of pi (3), A (3 x 4) and B (3 x 4) do not match");
	bad = hmm;
	bad.log_pi.conservativeResize(2);
	CHECK(validated(bad).error() == "the sizes of pi (2), A (3 x 3) and B (3 x 4) do not match");
}
