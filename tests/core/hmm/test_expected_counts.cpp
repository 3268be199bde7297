#include "hmm/baum_welch.h"
#include "hmm/expected_counts.h"
#include "hmm/forward.h"
#include "hmm_log_space.h"
#include "hmm_random.h"
#include "near.h"

#include <doctest/doctest.h>

using namespace steadyhand;

namespace {

/// Greatest difference, relative to the largest value.
double difference(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b) {
	return (a - b).array().abs().maxCoeff() / b.maxCoeff();
}

void check_against_log_space(const DiscreteHmm &hmm, const SymbolSequence &sequence, double tolerance) {
	const ExpectedCounts expected = test::log_space_counts(hmm, sequence);
	const ExpectedCounts counts = expected_counts(hmm, std::vector<SymbolSequence>{ sequence });
	CHECK(counts.log_likelihood == test::near(expected.log_likelihood).epsilon(tolerance));
	CHECK(log_likelihood(hmm, sequence) == test::near(expected.log_likelihood).epsilon(tolerance));
	CHECK(difference(counts.symbols, expected.symbols) < tolerance);
	if (sequence.size() > 1) {
		CHECK(difference(counts.transitions, expected.transitions) < tolerance);
	}
}

/// Left-right model without skips. Every fourth symbol is by far the likeliest of state i.
DiscreteHmm peaked_left_right(Eigen::Index states, double unlikely) {
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::VectorXd::Constant(states, NEVER);
	hmm.log_pi(0) = 0.0;
	hmm.log_a = Eigen::MatrixXd::Constant(states, states, NEVER);
	hmm.log_b = Eigen::MatrixXd::Constant(states, states, std::log(unlikely));
	for (Eigen::Index i = 0; i < states; ++i) {
		hmm.log_b(i, i) = std::log(1.0 - unlikely * static_cast<double>(states - 1));
		hmm.log_a(i, i) = i + 1 < states ? std::log(0.99) : 0.0;
		if (i + 1 < states) {
			hmm.log_a(i, i + 1) = std::log(0.01);
		}
	}
	return hmm;
}

/// `count` of each symbol, one symbol after the other.
SymbolSequence runs(const std::vector<std::pair<Symbol, std::size_t>> &symbols) {
	SymbolSequence sequence;
	for (const auto &[symbol, count] : symbols) {
		sequence.insert(sequence.end(), count, symbol);
	}
	return sequence;
}

/// Counts of a left-right model of two states, whose paths differ by the frame at which they leave the first
/// one.
ExpectedCounts count_all_paths(const DiscreteHmm &hmm, const SymbolSequence &sequence) {
	const std::size_t length = sequence.size();
	test::LongVector log_p(static_cast<Eigen::Index>(length));
	long double path = 0.0;
	for (const Symbol symbol : sequence) {
		path += hmm.log_b(1, symbol);
	}
	for (std::size_t k = 0; k < length; ++k) { // leaves after frame k
		path += hmm.log_b(0, sequence[k]) - hmm.log_b(1, sequence[k]) + (k > 0 ? hmm.log_a(0, 0) : 0.0);
		log_p(static_cast<Eigen::Index>(k)) = path + (k + 1 < length ? hmm.log_a(0, 1) : 0.0);
	}
	const long double log_likelihood = test::log_sum_exp(log_p);
	ExpectedCounts counts{ Eigen::MatrixXd::Zero(2, 2), Eigen::MatrixXd::Zero(2, hmm.symbols()),
		static_cast<double>(log_likelihood) };
	long double left = 0.0; // probability that the first state has been left before frame k
	for (std::size_t k = 0; k < length; ++k) {
		const long double p = std::exp(log_p(static_cast<Eigen::Index>(k)) - log_likelihood);
		counts.symbols(0, sequence[k]) += static_cast<double>(1.0L - left);
		counts.symbols(1, sequence[k]) += static_cast<double>(left);
		if (k + 1 < length) {
			counts.transitions(0, 0) += static_cast<double>(1.0L - left - p);
			counts.transitions(0, 1) += static_cast<double>(p);
			counts.transitions(1, 1) += static_cast<double>(left);
		}
		left += p;
	}
	return counts;
}

/// The usual recursion (Rabiner 1989, section V.A), with one scale per frame.
double scaled_log_likelihood(const DiscreteHmm &hmm, const SymbolSequence &sequence) {
	const auto exp = [](double x) { return std::exp(x); };
	const Eigen::MatrixXd a = hmm.log_a.unaryExpr(exp), b = hmm.log_b.unaryExpr(exp);
	Eigen::VectorXd alpha = hmm.log_pi.unaryExpr(exp).cwiseProduct(b.col(sequence[0]));
	double log_scales = 0.0;
	for (std::size_t t = 1; t < sequence.size(); ++t) {
		const double scale = alpha.sum();
		log_scales += std::log(scale);
		alpha = (a.transpose() * alpha / scale).cwiseProduct(b.col(sequence[t])).eval();
	}
	return log_scales + std::log(alpha.sum());
}

} // namespace

TEST_CASE("expected counts equal those of the recursion in log space") {
	std::mt19937_64 random(11);
	for (const Eigen::Index states : { 1, 2, 4, 9 }) {
		for (const std::size_t length : { 1, 2, 75, 1000 }) {
			const DiscreteHmm hmm = test::random_hmm(random, states, 6);
			SymbolSequence sequence = test::random_symbols(random, length, 6);
			if (length > 2) {
				sequence[1] = sequence[length - 1] = UNSEEN;
				sequence[length / 2] = 6; // not in the codebook
			}
			check_against_log_space(hmm, sequence, 1e-10);
		}
	}
}

TEST_CASE("counts of sequences of different lengths are the sum of each") {
	std::mt19937_64 random(12);
	const DiscreteHmm hmm = test::random_hmm(random, 4, 5);
	std::vector<SymbolSequence> sequences;
	ExpectedCounts expected{ Eigen::MatrixXd::Zero(4, 4), Eigen::MatrixXd::Zero(4, 5), 0.0 };
	for (const std::size_t length : { 3, 700, 0, 1, 90, 12'000, 90, 41, 5, 5, 2, 300, 64 }) {
		const SymbolSequence &sequence = sequences.emplace_back(test::random_symbols(random, length, 5));
		if (length > 0) {
			const ExpectedCounts one = test::log_space_counts(hmm, sequence);
			expected.transitions += one.transitions;
			expected.symbols += one.symbols;
			expected.log_likelihood += one.log_likelihood;
		}
	}
	const ExpectedCounts counts = expected_counts(hmm, sequences);
	CHECK(counts.log_likelihood == test::near(expected.log_likelihood).epsilon(1e-12));
	CHECK(difference(counts.transitions, expected.transitions) < 1e-11);
	CHECK(difference(counts.symbols, expected.symbols) < 1e-11);
}

TEST_CASE("probabilities down to e^-700 count as in log space, in float too") {
	std::mt19937_64 random(14);
	std::uniform_real_distribution<double> uniform(0.0, 1.0);
	for (int round = 0; round < 2000; ++round) {
		CAPTURE(round);
		const auto n = static_cast<Eigen::Index>(1.0 + 4.99 * uniform(random));
		const auto symbols = static_cast<int>(1.0 + 2.99 * uniform(random));
		const double lowest = -660.0 * std::pow(10.0, 2.0 * uniform(random) - 2.0);
		const double zeros = 0.7 * uniform(random);
		const auto draw_row = [&](Eigen::Index size) {
			Eigen::RowVectorXd row(size);
			const auto likely = static_cast<Eigen::Index>(uniform(random) * static_cast<double>(size));
			for (Eigen::Index j = 0; j < size; ++j) {
				const bool is_zero = uniform(random) < zeros;
				row(j) = j == likely ? 0.0 : is_zero ? NEVER : lowest * uniform(random);
			}
			return Eigen::RowVectorXd(row.array() - std::log(row.array().exp().sum()));
		};
		DiscreteHmm hmm;
		hmm.log_pi = draw_row(n).transpose();
		hmm.log_a.resize(n, n);
		hmm.log_b.resize(n, symbols);
		for (Eigen::Index i = 0; i < n; ++i) {
			hmm.log_a.row(i) = draw_row(n);
			hmm.log_b.row(i) = draw_row(symbols);
		}
		const auto length = static_cast<std::size_t>(1.0 + 59.0 * uniform(random));
		const SymbolSequence sequence = test::random_symbols(random, length, symbols);
		const ExpectedCounts expected = test::log_space_counts(hmm, sequence);
		if (expected.log_likelihood == NEVER) {
			continue;
		}
		const ExpectedCounts counts = expected_counts(hmm, std::vector<SymbolSequence>{ sequence });
		REQUIRE((counts.transitions - expected.transitions).cwiseAbs().maxCoeff() < 1e-10);
		REQUIRE((counts.symbols - expected.symbols).cwiseAbs().maxCoeff() < 1e-10);
		ForwardFilter<float> filter(hmm);
		for (const Symbol symbol : sequence) {
			filter.push(symbol);
		}
		REQUIRE(std::abs(filter.log_likelihood() - expected.log_likelihood) < 1e-4);
		const double tolerance = 1e-12 * (1.0 + std::abs(expected.log_likelihood));
		REQUIRE(std::abs(log_likelihood(hmm, sequence) - expected.log_likelihood) < tolerance);
	}
}

TEST_CASE("states whose probability underflows come back") {
	// The last state is likeliest for all symbols but the last run. For that run only paths are possible that
	// stayed in the first states, which were less likely by some thousand nats.
	for (const double unlikely : { 1e-2, 1e-5, 1e-30 }) {
		const DiscreteHmm hmm = peaked_left_right(4, unlikely);
		check_against_log_space(
				hmm, runs({ { 3, 1000 }, { 0, 1500 }, { 2, 1000 }, { 1, 4000 }, { 3, 2500 } }), 1e-9);
		check_against_log_space(hmm, runs({ { 3, 10 }, { 0, 15 }, { 2, 10 }, { 1, 40 } }), 1e-10);
	}
}

TEST_CASE("over a million frames the counts equal a sum over all paths" * doctest::test_suite("figures")) {
	const DiscreteHmm hmm = peaked_left_right(2, 1e-3);
	for (const std::size_t tenth : { 1'000, 10'000, 100'000 }) {
		// Symbols of the second state, then of the first one; the last tenth is of the second state again.
		const SymbolSequence sequence = runs({ { 1, 4 * tenth }, { 0, 5 * tenth }, { 1, tenth } });
		const ExpectedCounts expected = count_all_paths(hmm, sequence);
		const ExpectedCounts counts = expected_counts(hmm, std::vector<SymbolSequence>{ sequence });
		CHECK(counts.log_likelihood == test::near(expected.log_likelihood).epsilon(1e-12));
		CHECK(log_likelihood(hmm, sequence) == test::near(expected.log_likelihood).epsilon(1e-12));
		CHECK(difference(counts.symbols, expected.symbols) < 1e-9);
		CHECK(difference(counts.transitions, expected.transitions) < 1e-9);
		CHECK(scaled_log_likelihood(hmm, sequence) < expected.log_likelihood - 1000.0);
	}
}

TEST_CASE("zeros in A and B give the exact counts") {
	// A cycle of three states without self-transitions, of two symbols each.
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::Vector3d(std::log(0.5), std::log(0.5), NEVER);
	hmm.log_a = Eigen::MatrixXd::Constant(3, 3, NEVER);
	hmm.log_a(0, 1) = hmm.log_a(1, 2) = 0.0;
	hmm.log_a(2, 0) = std::log(0.9);
	hmm.log_a(2, 1) = std::log(0.1);
	hmm.log_b = (Eigen::MatrixXd(3, 3) << 0.999, 0.001, 0.0, 0.5, 0.5, 0.0, 0.0, 0.25, 0.75)
						.finished()
						.array()
						.log();
	for (const std::size_t rounds : { 1, 5, 200, 2000 }) {
		SymbolSequence sequence;
		for (std::size_t i = 0; i < rounds; ++i) {
			sequence.insert(sequence.end(), { 0, i % 3 == 0 ? 0 : 1, 2 });
		}
		check_against_log_space(hmm, sequence, 1e-10);
	}
	const ExpectedCounts impossible =
			expected_counts(hmm, std::vector<SymbolSequence>{ { 2, 2, 2 }, { 0, 0, 2 } });
	CHECK(impossible.log_likelihood == NEVER);
	const ExpectedCounts possible = expected_counts(hmm, std::vector<SymbolSequence>{ { 0, 0, 2 } });
	CHECK(impossible.symbols == possible.symbols);
	CHECK(impossible.transitions == possible.transitions);
}

TEST_CASE("Baum-Welch trains on one sequence of a million frames") {
	std::mt19937_64 random(13);
	const std::vector<SymbolSequence> sequences{ test::random_symbols(random, 1'000'000, 16) };
	BaumWelchOptions options;
	options.max_iterations = 2;
	const DiscreteHmm start = left_right_from_equal_segments(sequences, 4, 16, {});
	const BaumWelchResult result = baum_welch(start, sequences, options);
	CHECK(validated(result.hmm).ok());
	REQUIRE(result.objective.size() == 2);
	CHECK(result.objective[1] > result.objective[0]);
	// All symbols are equally likely.
	CHECK(result.objective[0] / 1e6 == test::near(-std::log(16.0)).epsilon(1e-3));
}
