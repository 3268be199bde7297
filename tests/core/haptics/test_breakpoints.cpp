#include "haptics/breakpoints.h"
#include "near.h"

#include "base/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("an envelope is straight between its points, and steps where two have one time") {
	const std::vector<Breakpoint> points{ { 1.0, 0.2 }, { 3.0, 0.6 }, { 3.0, 1.0 }, { 4.0, 0.0 } };
	CHECK(value_at(points, 0.9, -7.0) == -7.0);
	CHECK(value_at(points, 1.0, -7.0) == near(0.2));
	CHECK(value_at(points, 2.0, -7.0) == near(0.4));
	CHECK(value_at(points, 3.0, -7.0) == near(1.0));
	CHECK(value_at(points, 3.25, -7.0) == near(0.75));
	CHECK(value_at(points, 9.0, -7.0) == near(0.0));
	CHECK(value_at({}, 1.0, -7.0) == -7.0);
}

TEST_CASE("a simplified envelope stays within the error at every point left out") {
	for (std::uint64_t seed = 0; seed < 200; ++seed) {
		std::vector<Breakpoint> points;
		double value = 0.5, time_s = 0.0;
		for (std::uint64_t i = 0; i < 100; ++i) {
			const std::uint64_t bits = stream_seed(seed, i);
			value = std::clamp(value + 0.2 * (static_cast<double>(bits % 1000) / 1000.0 - 0.5), 0.0, 1.0);
			time_s += bits % 7 == 0 ? 0.0 : 0.001 * static_cast<double>(1 + bits % 5);
			points.push_back({ time_s, value });
		}
		const std::vector<Breakpoint> kept = simplified(points, 0.05);
		REQUIRE(kept.size() >= 2);
		CHECK(kept.front().value == points.front().value);
		CHECK(kept.back().time_s == points.back().time_s);
		CHECK(kept.size() < points.size());
		for (std::size_t i = 0; i + 1 < points.size(); ++i) {
			if (points[i].time_s < points[i + 1].time_s) {
				CHECK(std::abs(value_at(kept, points[i].time_s, 0.0) - points[i].value) <= 0.05 + 1e-9);
			}
		}
	}
}

TEST_CASE("a straight line is simplified to its ends") {
	std::vector<Breakpoint> points;
	for (int i = 0; i <= 1000; ++i) {
		points.push_back({ 0.001 * i, 0.0005 * i });
	}
	CHECK(simplified(points, 1e-9).size() == 2);
	CHECK(simplified({}, 0.1).empty());
}
