#include "near.h"
#include "signal/one_euro.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

using steadyhand::OneEuro;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("One Euro without beta is a first-order low-pass") {
	// Step response on irregular instants: the error shrinks by tau / (tau + step) at each, product over the
	// steps.
	const double tau_s = 1.0 / (2.0 * std::numbers::pi * 1.5);
	OneEuro filter(OneEuro::Tuning{ 1.5, 0.0, 1.0 });
	CHECK(filter.push(0.0, 0.0) == 0.0);
	double t_s = 0.0;
	double error = 1.0;
	for (int frame = 1; frame < 300; ++frame) {
		const double step_s = 0.001 * (1 + frame * 7 % 23);
		t_s += step_s;
		error *= tau_s / (tau_s + step_s);
		CHECK(filter.push(t_s, 1.0) == steadyhand::test::near(1.0 - error).epsilon(1e-12));
	}
}

TEST_CASE("One Euro on a steady ramp settles where its own equations meet") {
	// Behind by e before a step of v dt: the speed seen is (v dt + e) / dt, and the part w = r / (1 + r) of v
	// dt + e is made up, r = 2 pi fc dt. Steady: w (v dt + e) = v dt, so e = v / (2 pi fc), fc = min + beta
	// (v + e / dt).
	const double v = 0.4;
	const double step_s = 1.0 / 90.0;
	const OneEuro::Tuning tuning;
	OneEuro filter;
	double output = 0.0;
	for (int frame = 0; frame < 4000; ++frame) {
		output = filter.push(frame * step_s, v * frame * step_s);
	}
	// The second in the first: a quadratic in e.
	const double a = tuning.beta_per_m / step_s;
	const double b = tuning.min_cutoff_hz + tuning.beta_per_m * v;
	const double c = -v / (2.0 * std::numbers::pi);
	const double lag_m = (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
	CHECK(v * 3999 * step_s - output == steadyhand::test::near(lag_m).epsilon(1e-9));
	CHECK(std::abs(lag_m / v - 0.010) < 0.001); // what one_euro.h says of its tuning
}

TEST_CASE("One Euro is not poisoned by what is no number") {
	OneEuro clean;
	OneEuro poisoned;
	CHECK(poisoned.push(0.0, NOT_A_NUMBER) == 0.0);
	for (int frame = 0; frame < 500; ++frame) {
		const double x_m = 0.1 * std::sin(0.1 * frame);
		const double expected = clean.push(frame * 0.011, x_m);
		CHECK(poisoned.push(frame * 0.011, x_m) == expected);
		for (const double bad : { NOT_A_NUMBER, INF, -INF, 1e300 }) {
			CHECK(poisoned.push(frame * 0.011 + 0.001, bad) == expected);
			CHECK(poisoned.push(bad, 1.0) == expected);
		}
	}
}

TEST_CASE("One Euro takes late and repeated frames as none, and starts anew when the clock does") {
	OneEuro filter;
	filter.push(100.0, 0.0);
	const double output = filter.push(100.01, 0.1);
	CHECK(filter.push(100.01, 5.0) == output);
	CHECK(filter.push(99.5, 5.0) == output);
	CHECK(filter.push(0.0, 5.0) == 5.0);    // the device restarted
	CHECK(filter.push(3600.0, 7.0) == 7.0); // an hour of nothing
	CHECK(filter.push(3601.0, 7.0) == 7.0);
}

TEST_CASE("One Euro stays finite and inside its input's range at any rate and scale") {
	for (const double rate_hz : { 1.0, 90.0, 1e4 }) {
		for (const double scale_m : { 1e-9, 1.0, 1e9, 1e99 }) {
			OneEuro filter;
			for (int frame = 0; frame < 20000; ++frame) {
				const double output = filter.push(frame / rate_hz, scale_m * std::sin(frame * frame));
				REQUIRE(std::abs(output) <= scale_m);
			}
		}
	}
}
