#include "recognition/rest_drift.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;

TEST_CASE("rest drift is the standard deviation of noise over 0.1 s") {
	constexpr double DT_S = 0.01;
	for (const double lasts_s : { 1e-6, 0.1, 1.0 }) { // time constant of a first-order autoregression
		CAPTURE(lasts_s);
		std::mt19937_64 random(7);
		std::normal_distribution<double> noise;
		RestDrift drift;
		const double kept = std::exp(-DT_S / lasts_s);
		double x = noise(random), sum = 0.0;
		for (int i = 0; i < 6200; ++i) {
			drift.push(i * DT_S, 0.5 + x);
			x = kept * x + std::sqrt(1.0 - kept * kept) * noise(random);
			sum += i >= 200 ? drift.deviation(i * DT_S) : 0.0;
		}
		// Standard deviation of its second differences over 0.1 s, relative to white noise.
		const double r = std::exp(-0.1 / lasts_s);
		CHECK(std::abs(sum / 6000.0 / std::sqrt((6.0 - 8.0 * r + 2.0 * r * r) / 6.0) - 1.0) < 0.07);
	}
}

TEST_CASE("constant velocity, arrival and onset do not add to rest drift") {
	RestDrift drift;
	for (int i = 0; i < 100; ++i) {
		const double t_s = 0.01 * i;
		const double came = t_s < 0.2 ? 25.0 * (t_s - 0.2) * (t_s - 0.2) : 0.0;
		const double begins = t_s > 0.9 ? 25.0 * (t_s - 0.9) * (t_s - 0.9) : 0.0;
		drift.push(t_s, 0.1 * t_s + came + begins);
		drift.push(t_s, 1.0); // of two frames with equal stamps the first one counts
	}
	CHECK(drift.deviation(1.0) < 1e-9);
}

TEST_CASE("a rest below 0.4 s or with dropouts gives the default") {
	RestDrift shortly, rarely;
	for (int i = 0; i < 36; ++i) {
		shortly.push(0.01 * i, 0.0);
		rarely.push(0.4 * i, 0.0);
	}
	CHECK(shortly.deviation(0.36) == parameters::sessions::UNKNOWN_DRIFT);
	CHECK(rarely.deviation(14.4) == parameters::sessions::UNKNOWN_DRIFT);
	for (int i = 36; i < 60; ++i) {
		shortly.push(0.01 * i, 0.0);
	}
	CHECK(shortly.deviation(0.6) == 0.0);
}
