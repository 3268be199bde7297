// Numbers beyond the range of double, and the forward variable with them.

#include "hmm/forward.h"
#include "hmm/scaled_number.h"
#include "hmm_log_space.h"
#include "hmm_random.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace steadyhand;

namespace {

/// Checks the arithmetic with numbers in the range of long double.
long double value(const ScaledNumber &number) {
	return std::ldexp(static_cast<long double>(number.mantissa),
			number.mantissa > 0.0 ? static_cast<int>(number.exponent) : 0);
}

bool is_near(long double a, long double b) {
	return std::abs(a - b) <= 4e-16L * std::max(std::abs(a), std::abs(b));
}

} // namespace

TEST_CASE("power_of_two equals ldexp, and is 0 below the normal numbers") {
	for (int exponent = -1100; exponent <= 1100; ++exponent) {
		CAPTURE(exponent);
		const double power = std::ldexp(1.0, exponent);
		CHECK(power_of_two(exponent) == (power >= std::numeric_limits<double>::min() ? power : 0.0));
	}
	CHECK(power_of_two(ScaledNumber::NEVER) == 0.0);
	CHECK(power_of_two(-ScaledNumber::NEVER) == std::numeric_limits<double>::infinity());
}

TEST_CASE("scaled numbers multiply, add and compare as long doubles do") {
	std::mt19937_64 random(1);
	std::uniform_real_distribution<double> mantissa(1.0, 2.0);
	std::uniform_int_distribution<int> exponent(-4000, 4000), near(-60, 60), kind(0, 9);
	for (int i = 0; i < 5'000; ++i) {
		const int e = exponent(random);
		const ScaledNumber a{ kind(random) == 0 ? 0.0 : std::ldexp(mantissa(random), -300), e },
				b{ kind(random) == 0 ? 0.0 : mantissa(random), kind(random) < 5 ? e + near(random) : -e };
		const int power = near(random);
		const double factor = std::ldexp(mantissa(random), power);
		CHECK(is_near(value(a * factor), value(a) * factor));
		CHECK(is_near(value(a + b), value(a) + value(b)));
		CHECK((a < b) == (value(a) < value(b)));
		const auto log = static_cast<double>(std::log(value(a)));
		CHECK((a.log() == log || is_near(a.log(), log)));
	}
	CHECK(ScaledNumber().log() == NEVER);
	CHECK_FALSE(ScaledNumber(1.5, 7) < ScaledNumber(1.5, 7));
}

TEST_CASE("an underflowed state comes back when the other state's emission is 0") {
	// '0' is a thousand times likelier in the second state. '1' is impossible there: then the whole sequence
	// is of the first state.
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::Vector2d(std::log(0.5), std::log(0.5));
	hmm.log_a = (Eigen::Matrix2d() << 0.9, 0.1, 0.0, 1.0).finished().array().log();
	hmm.log_b = (Eigen::Matrix2d() << 0.001, 0.999, 1.0, 0.0).finished().array().log();
	for (int zeros = 1; zeros < 400; zeros += 3) {
		CAPTURE(zeros);
		ForwardFilter<double> filter(hmm);
		ForwardFilter<float> float_filter(hmm);
		for (int i = 0; i < zeros; ++i) {
			filter.push(0);
			float_filter.push(0);
		}
		filter.push(1);
		float_filter.push(1);
		const double expected = std::log(0.5) + zeros * (std::log(0.001) + std::log(0.9)) + std::log(0.999);
		CHECK(filter.log_likelihood() == test::near(expected).epsilon(1e-12));
		CHECK(float_filter.log_likelihood() == test::near(expected).epsilon(1e-5));
		CHECK(filter.state() == 0);
		CHECK(float_filter.state() == 0);
		// After it, the second state has only what the first one passes on.
		double first = 1.0, second = 0.0;
		for (int i = 0; i < 3; ++i) {
			filter.push(0);
			second += 0.1 * first;
			first *= 0.9 * 0.001;
		}
		CHECK(filter.log_likelihood() == test::near(expected + std::log(first + second)).epsilon(1e-12));
		CHECK(filter.state() == 1);
	}
}

TEST_CASE("models with zeros anywhere have the likelihood of the log-space recursion") {
	std::mt19937_64 random(2);
	std::uniform_real_distribution<double> uniform(0.0, 1.0);
	for (int round = 0; round < 60; ++round) {
		CAPTURE(round);
		DiscreteHmm hmm = test::random_hmm(random, 5, 4);
		// Half of A and a third of B are 0. The other values differ by orders of magnitude.
		const auto thin_out = [&](Eigen::MatrixXd &r_log, double zeros) {
			for (Eigen::Index i = 0; i < r_log.rows(); ++i) {
				const Eigen::Index stays = static_cast<Eigen::Index>(uniform(random) * 3.99);
				for (Eigen::Index j = 0; j < r_log.cols(); ++j) {
					r_log(i, j) = j != stays && uniform(random) < zeros ? NEVER : 8.0 * r_log(i, j);
				}
				r_log.row(i).array() -= std::log(r_log.row(i).array().exp().sum());
			}
		};
		thin_out(hmm.log_a, 0.5);
		thin_out(hmm.log_b, 0.3);
		// Drawn from the model, so that the sequence is possible.
		SymbolSequence symbols;
		Eigen::Index state = 0;
		const auto draw = [&](const Eigen::RowVectorXd &log_p) {
			double left = uniform(random);
			Eigen::Index k = 0;
			log_p.maxCoeff(&k);
			for (Eigen::Index i = 0; i < log_p.size(); ++i) {
				left -= std::exp(log_p(i));
				if (left < 0.0) {
					return i;
				}
			}
			return k;
		};
		for (int t = 0; t < 400; ++t) {
			symbols.push_back(static_cast<Symbol>(draw(hmm.log_b.row(state))));
			state = draw(hmm.log_a.row(state));
		}
		CHECK(log_likelihood(hmm, symbols) ==
				test::near(test::log_space_counts(hmm, symbols).log_likelihood).epsilon(1e-11));
	}
}
