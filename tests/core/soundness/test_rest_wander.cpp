#include "soundness/rest_wander.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;

namespace {

/// Of what is shown of a hand at rest: a first-order autoregression of deviation 1 that forgets in that time;
/// the mean of what is told of it in a minute, at 100 frames a second.
double told_of_wander(double lasts_s) {
	constexpr double DT_S = 0.01;
	std::mt19937_64 random(7);
	std::normal_distribution<double> noise;
	RestWander wander;
	const double kept = std::exp(-DT_S / lasts_s);
	double x = noise(random), sum = 0.0;
	int told = 0;
	for (int i = 0; i < 6200; ++i) {
		wander.push(i * DT_S, 0.5 + x);
		x = kept * x + std::sqrt(1.0 - kept * kept) * noise(random);
		sum += i >= 200 ? wander.deviation() : 0.0;
		told += i >= 200 ? 1 : 0;
	}
	return sum / told;
}

} // namespace

TEST_SUITE("rest wander") {
	TEST_CASE("white noise is told by its deviation, what lasts by most of it, what drifts by little") {
		// About a mean of m frames, the last of which is not in it, white noise has a deviation of
		// sqrt(1 + 1 / (2 m - 1)): m = 30 here.
		CHECK(told_of_wander(1e-6) == doctest::Approx(std::sqrt(1.0 + 1.0 / 59.0)).epsilon(0.02));
		// About an exponential mean of time T what lasts as long as t has the variance t / (t + T)
		// subtracted once: 1 + t / (t + T) - 2 t / (t + T) = T / (t + T).
		CHECK(told_of_wander(0.1) == doctest::Approx(std::sqrt(0.3 / 0.4)).epsilon(0.05));
		CHECK(told_of_wander(0.3) == doctest::Approx(std::sqrt(0.3 / 0.6)).epsilon(0.1));
	}

	TEST_CASE("a hand that rests elsewhere after a while has not wandered there") {
		RestWander wander;
		for (int i = 0; i < 100; ++i) {
			wander.push(0.01 * i, 0.0);
		}
		for (int i = 0; i < 100; ++i) {
			wander.push(2.0 + 0.01 * i, 1.0);
		}
		CHECK(wander.deviation() == 0.0);
	}

	TEST_CASE("frames with one stamp count once") {
		RestWander wander;
		for (int i = 0; i < 50; ++i) {
			wander.push(0.01 * i, 0.0);
			wander.push(0.01 * i, 1.0);
		}
		CHECK(wander.deviation() == 0.0);
	}
}
