#include "hmm/filler_filter.h"
#include "hmm/hmm_log_space.h"
#include "hmm/hmm_random.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr int SYMBOLS = 5;

FillerModel random_filler(std::mt19937_64 &r_random, Eigen::Index states) {
	std::uniform_real_distribution<double> stay(0.3, 0.95);
	FillerModel filler;
	filler.stay.resize(states);
	filler.b = Eigen::MatrixXd::Ones(states, SYMBOLS + 1);
	for (Eigen::Index i = 0; i < states; ++i) {
		filler.stay(i) = stay(r_random);
		filler.b.row(i).head(SYMBOLS) = random_log_row(r_random, SYMBOLS).array().exp();
	}
	return filler;
}

/// The filler as an HMM, with equal transitions from each state to all others.
DiscreteHmm as_hmm(const FillerModel &filler) {
	const Eigen::Index n = filler.stay.size();
	Eigen::MatrixXd a = ((1.0 - filler.stay.array()) / static_cast<double>(n - 1)).matrix().replicate(1, n);
	a.diagonal() = filler.stay;
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::VectorXd::Constant(n, -std::log(static_cast<double>(n)));
	hmm.log_a = a.array().log();
	hmm.log_b = filler.b.leftCols(SYMBOLS).array().log();
	return hmm;
}

void push(FillerFilter<2> &r_filter, const FillerModel &filler, int lane, const SymbolSequence &symbols) {
	for (std::size_t t = 0; t < symbols.size(); ++t) {
		const double *b = filler.b.col(symbols[t] == UNSEEN ? SYMBOLS : symbols[t]).data();
		t == 0 ? r_filter.start(lane, b) : r_filter.step(lane, b);
	}
}

TEST_CASE("the filler's likelihood equals the forward recursion in logarithms, gaps included") {
	std::mt19937_64 random(1);
	for (const Eigen::Index states : { 2, 3, 12 }) {
		const FillerModel filler = random_filler(random, states);
		FillerFilter<2> filter(filler);
		SymbolSequence symbols = random_symbols(random, 400, SYMBOLS),
					   others = random_symbols(random, 30, SYMBOLS);
		symbols[17] = symbols[18] = UNSEEN;
		push(filter, filler, 0, symbols);
		push(filter, filler, 1, others);
		CHECK(filter.likelihood(0).log() ==
				near(log_space_counts(as_hmm(filler), symbols).log_likelihood).epsilon(1e-9));
		CHECK(filter.likelihood(1).log() ==
				near(log_space_counts(as_hmm(filler), others).log_likelihood).epsilon(1e-9));
	}
}

TEST_CASE("over a million symbols the filler's likelihood stays finite and additive") {
	std::mt19937_64 random(2);
	const FillerModel filler = random_filler(random, 8);
	FillerFilter<2> filter(filler);
	const SymbolSequence symbols = random_symbols(random, 1000, SYMBOLS);
	push(filter, filler, 0, symbols);
	const double after_one = filter.likelihood(0).log();
	double last = after_one;
	for (int repetition = 1; repetition < 1000; ++repetition) {
		for (const Symbol symbol : symbols) {
			filter.step(0, filler.b.col(symbol).data());
		}
		const double now = filter.likelihood(0).log();
		// With equal symbols the likelihood falls by the same factor, except for the initial states.
		CHECK(std::abs((now - last) - after_one) < 10.0);
		last = now;
	}
}

} // namespace
