#include "near.h"
#include "signal/moving_average.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

using steadyhand::MovingAverage;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("a moving average of a ramp is 20 frames late") {
	MovingAverage average;
	for (int frame = 0; frame < 500; ++frame) {
		const double output = average.push(frame / 90.0, frame);
		// While the window fills: the mean of 0..frame.
		const double expected = frame < 40 ? frame / 2.0 : frame - 20.0;
		CHECK(output == steadyhand::test::near(expected).epsilon(1e-15));
	}
}

TEST_CASE("a moving average forgets: after 10^7 frames it is exact on the last 41") {
	MovingAverage average;
	double output = 0.0;
	for (int frame = 0; frame < 10'000'000; ++frame) {
		// Magnitudes that would leave a running sum 1e-7 off for good.
		const double x = frame % 1000 == 0 ? 1e9 : 0.1 * (frame % 7);
		output = average.push(frame * 1e-4, x);
	}
	// The last 41 frames hold no 1e9: 35 of them are five periods of 0 + 0.1 + ... + 0.6, the rest is summed
	// here.
	long double sum = 0.0L;
	for (int frame = 10'000'000 - 41; frame < 10'000'000; ++frame) {
		sum += 0.1 * (frame % 7);
	}
	CHECK(output == steadyhand::test::near(static_cast<double>(sum / 41.0L)).epsilon(1e-15));
}

TEST_CASE("a moving average leaves a constant exactly as it is, wherever it lies") {
	for (const double constant : { 0.0, 1e-9, -0.3, 1e9, 1e99 }) {
		MovingAverage average;
		for (int frame = 0; frame < 100; ++frame) {
			CHECK(average.push(frame, constant) == constant);
		}
	}
}

TEST_CASE("a moving average does not count what is no number as a frame") {
	MovingAverage clean;
	MovingAverage poisoned;
	CHECK(poisoned.push(0.0, NOT_A_NUMBER) == 0.0);
	for (int frame = 0; frame < 200; ++frame) {
		const double x = std::sin(0.1 * frame);
		const double expected = clean.push(frame, x);
		CHECK(poisoned.push(frame, x) == expected);
		for (const double bad : { NOT_A_NUMBER, INF, -INF, 1e300 }) {
			CHECK(poisoned.push(frame, bad) == expected);
			CHECK(poisoned.push(bad, 1.0) == expected);
		}
	}
}
