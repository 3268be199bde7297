#include "near.h"
#include "signal/lanes.h"
#include "signal/minimum_jerk.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace steadyhand;

namespace {

constexpr double ULP = std::numeric_limits<double>::epsilon();

template <class Function> Lanes of(const Lanes &x, const Function &f) {
	Lanes result;
	store(result, f(load(x)));
	return result;
}

} // namespace

TEST_CASE("exponentials and logarithms of lanes are those of the standard library, to two units in the last "
		  "place") {
	std::mt19937_64 random(2);
	std::uniform_real_distribution<double> exponent(-707.0, 708.0), near(-1.5, 1.5);
	for (int i = 0; i < 100000; ++i) {
		const Lanes x{ exponent(random), near(random), 1e-3 * near(random), 1e-9 * near(random) };
		const Lanes e = of(x, [](const LaneVector &v) STEADYHAND_INLINE_LAMBDA { return exponential(v); });
		for (std::size_t l = 0; l < LANES; ++l) {
			REQUIRE(std::abs(e[l] / std::exp(x[l]) - 1.0) <= 2.0 * ULP);
		}
		const Lanes log_e = of(e, [](const LaneVector &v) STEADYHAND_INLINE_LAMBDA { return logarithm(v); });
		for (std::size_t l = 0; l < LANES; ++l) {
			const double log = std::log(e[l]);
			REQUIRE(std::abs(log_e[l] - log) <= 2.0 * ULP * std::max(std::abs(log), 1.0));
		}
	}
	const Lanes edges = of({ -708.0, -1e9, -std::numeric_limits<double>::infinity(), 0.0 },
			[](const LaneVector &v) STEADYHAND_INLINE_LAMBDA { return exponential(v); });
	CHECK(edges == Lanes{ 0.0, 0.0, 0.0, 1.0 });
	const Lanes logs =
			of({ std::numeric_limits<double>::min(), 1.0, 2.0, std::numeric_limits<double>::max() },
					[](const LaneVector &v) STEADYHAND_INLINE_LAMBDA { return logarithm(v); });
	CHECK(logs[0] == test::near(std::log(std::numeric_limits<double>::min())).epsilon(2.0 * ULP));
	CHECK(logs[1] == 0.0);
	CHECK(logs[2] == test::near(std::log(2.0)).epsilon(2.0 * ULP));
	CHECK(logs[3] == test::near(std::log(std::numeric_limits<double>::max())).epsilon(2.0 * ULP));
}

TEST_CASE("each lane picks the number at its index") {
	Lanes picked;
	store(picked, pick({ 0.5, 1.5, 2.5, 3.5 }, { 2, 0, 3, 2 }));
	CHECK(picked == Lanes{ 2.5, 0.5, 3.5, 2.5 });
}

TEST_CASE("the minimum jerk of lanes is that of one number") {
	for (int i = 0; i <= 100; ++i) {
		const double s = i / 100.0;
		const LaneMinimumJerk jerk(all(s));
		const Polynomial::Point point = minimum_jerk(s);
		CHECK(jerk.value[1] == test::near(point.value));
		CHECK(jerk.first[2] == test::near(point.first));
		CHECK(jerk.second[3] == test::near(point.second));
	}
}

TEST_CASE("the share of the duration after which a part of the way is covered gives that part") {
	for (int hundredths = 0; hundredths <= 100; ++hundredths) {
		const double share = 0.01 * hundredths;
		CAPTURE(share);
		CHECK(minimum_jerk_share(minimum_jerk(share).value) == test::near(share).epsilon(1e-7));
	}
	CHECK(minimum_jerk_share(-1.0) == 0.0);
	CHECK(minimum_jerk_share(2.0) == 1.0);
}
