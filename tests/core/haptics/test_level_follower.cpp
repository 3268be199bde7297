// The amplitude of one voice.

#include "haptics/level_follower.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

using namespace steadyhand;

namespace {

constexpr double RATE_HZ = 48000.0;
constexpr double RUN_S = static_cast<double>(RUN) / RATE_HZ;
/// What single precision leaves of an amplitude.
constexpr double ROUNDING = 1e-6;

/// An amplitude over a stretch, and its slope per s.
class Course {
public:
	Course(const Level &level, std::size_t runs) : level_(level), samples_(static_cast<double>(runs * RUN)) {}

	[[nodiscard]] LevelPoint at(double share) const {
		const double s = share * samples_;
		const double linear = level_.linear, quadratic = level_.quadratic, cubic = level_.cubic;
		return { ((cubic * s + quadratic) * s + linear) * s + static_cast<double>(level_.constant),
			((3.0 * cubic * s + 2.0 * quadratic) * s + linear) * RATE_HZ };
	}

private:
	Level level_;
	double samples_;
};

Course wanted_between(const LevelPoint &from, const LevelPoint &to, double length_s, std::size_t runs) {
	return { Level::hermite(from.value, from.slope * length_s, to.value, to.slope * length_s, runs), runs };
}

} // namespace

TEST_CASE("a stretch that is followed stays within what is allowed and near to what is wanted") {
	constexpr double MOST = 0.8;
	constexpr double RAD_PER_S = 100.0 * std::numbers::pi, FASTEST_PER_S = 0.2 * RAD_PER_S;
	constexpr double LENGTH_S = static_cast<double>(MOST_RUNS) * RUN_S;
	std::mt19937_64 random(3);
	std::uniform_real_distribution<double> value(-0.1, 0.9), slope(-1.3 * FASTEST_PER_S, 1.3 * FASTEST_PER_S);
	std::uniform_real_distribution<double> off(-0.04, 0.04), slope_off(-60.0, 60.0);
	int followed = 0;
	for (int trial = 0; trial < 40000; ++trial) {
		const LevelPoint end{ value(random), slope(random) }, to{ value(random), slope(random) };
		const LevelPoint from = trial % 2 == 0 ? LevelPoint{ end.value, end.slope + slope_off(random) }
											   : LevelPoint{ end.value + off(random), end.slope };
		LevelFollower follower;
		follower.start(end);
		if (!follower.can_follow_stretch(from, to, MOST, RAD_PER_S, LENGTH_S)) {
			continue;
		}
		++followed;
		const Course course{ follower.follow(from, to, RAD_PER_S, LENGTH_S, MOST_RUNS), MOST_RUNS };
		const Course wanted = wanted_between(from, to, LENGTH_S, MOST_RUNS);
		for (int i = 0; i <= 20; ++i) {
			const LevelPoint level = course.at(i / 20.0);
			REQUIRE(level.value >= -ROUNDING);
			REQUIRE(level.value <= MOST + ROUNDING);
			REQUIRE(std::abs(level.slope) <= FASTEST_PER_S * (1.0 + 1e-4));
			// 1 % of an amplitude, and a slope that is off by as much over a third of the stretch.
			REQUIRE(std::abs(level.value - wanted.at(i / 20.0).value) <= 0.01 * (1.0 + 4.0 / 9.0) + ROUNDING);
		}
	}
	CHECK(followed > 500);
}

TEST_CASE("a line that it is on is followed as it is, over a run and over a stretch") {
	const LevelPoint from{ 0.2, 20.0 };
	for (const std::size_t runs : { std::size_t{ 1 }, MOST_RUNS }) {
		CAPTURE(runs);
		const double length_s = static_cast<double>(runs) * RUN_S;
		const LevelPoint to{ 0.2 + 20.0 * length_s, 20.0 };
		LevelFollower follower;
		follower.start(from);
		CHECK(follower.can_follow_stretch(from, to, 1.0, 1000.0, length_s));
		const Course course{ follower.follow(from, to, 1000.0, length_s, runs), runs };
		for (const double share : { 0.0, 0.3, 0.7, 1.0 }) {
			CHECK(std::abs(course.at(share).value - (0.2 + 20.0 * share * length_s)) < ROUNDING);
			CHECK(course.at(share).slope == test::near(20.0).epsilon(1e-4));
		}
	}
}

TEST_CASE("no stretch is followed while a step fades") {
	for (const double rad_per_s : { 400.0, 1000.0, 1900.0 }) {
		CAPTURE(rad_per_s);
		const double fading_per_s = std::min(rad_per_s, 1000.0);
		const LevelPoint held{ 0.7, 0.0 };
		LevelFollower follower;
		follower.start({ 0.2, 0.0 });
		double left = 0.5;
		for (int run = 1; left > 1e-8; ++run) {
			const Course course{ follower.follow(held, held, rad_per_s, RUN_S, 1), 1 };
			const double x = fading_per_s * run * RUN_S;
			left = 0.5 * (1.0 + x) * std::exp(-x);
			const bool can_follow = follower.can_follow_stretch(held, held, 1.0, rad_per_s, 8.0 * RUN_S);
			if (left > 2e-7) {
				REQUIRE(std::abs(0.7 - left - course.at(1.0).value) < ROUNDING);
				REQUIRE_FALSE(can_follow);
			}
		}
		static_cast<void>(follower.follow(held, held, rad_per_s, RUN_S, 1));
		CHECK(follower.can_follow_stretch(held, held, 1.0, rad_per_s, 8.0 * RUN_S));
	}
}

TEST_CASE("a sine of whatever is wanted changes by no more than 2 % faster than the full one") {
	for (const double frequency_hz : { 60.0, 150.0, 300.0 }) {
		CAPTURE(frequency_hz);
		const double rad_per_s = 2.0 * std::numbers::pi * frequency_hz;
		std::mt19937_64 random(4);
		std::uniform_real_distribution<double> share(0.0, 1.0);
		LevelFollower follower;
		double swing_per_s = 0.0, phase = 0.0, greatest = 0.0;
		for (int run = 0; run < 20000; ++run) {
			if (share(random) < 0.1) { // it leaps, and goes on at another pace
				swing_per_s = 0.8 * rad_per_s * std::pow(share(random), 2.0);
				phase = 2.0 * std::numbers::pi * share(random);
			}
			const auto wanted = [&](double at) {
				return LevelPoint{ 0.5 + 0.5 * std::sin(at), 0.5 * swing_per_s * std::cos(at) };
			};
			const LevelPoint from = wanted(phase), to = wanted(phase += swing_per_s * RUN_S);
			const Course course{ follower.follow(from, to, rad_per_s, RUN_S, 1), 1 };
			for (int i = 0; i <= 8; ++i) {
				const LevelPoint level = course.at(i / 8.0);
				greatest = std::max(greatest, std::hypot(level.value * rad_per_s, level.slope));
			}
		}
		CHECK(greatest <= 1.02 * rad_per_s);
	}
}

TEST_CASE("no amplitude leaves 0..1 by more than a hundredth, however steep what is wanted is") {
	for (const double rate_hz : { 8000.0, 48000.0, 192000.0 }) {
		for (const double frequency_hz : { 20.0, 250.0, 1000.0 }) {
			CAPTURE(rate_hz);
			CAPTURE(frequency_hz);
			const double rad_per_s = 2.0 * std::numbers::pi * frequency_hz;
			const double run_s = static_cast<double>(RUN) / rate_hz;
			std::mt19937_64 random(6);
			std::uniform_real_distribution<double> share(0.0, 1.0), slope(-0.3 * rad_per_s, 0.3 * rad_per_s);
			LevelFollower follower;
			LevelPoint from;
			for (int stretch = 0; stretch < 20000; ++stretch) {
				const LevelPoint to{ share(random), slope(random) };
				const bool is_long = follower.can_follow_stretch(from, to, 1.0, rad_per_s, 8.0 * run_s);
				const std::size_t runs = is_long ? 8 : 1;
				const Course course{
					follower.follow(from, to, rad_per_s, static_cast<double>(runs) * run_s, runs), runs
				};
				for (int i = 0; i <= 16; ++i) {
					REQUIRE(course.at(i / 16.0).value > -0.01);
					REQUIRE(course.at(i / 16.0).value < 1.01);
				}
				from = share(random) < 0.1 ? LevelPoint{ share(random), slope(random) } : to;
			}
		}
	}
}
