// Strokes of a hand's path, and the knots of the path.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "strokes/stroke_finder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace steadyhand;

namespace {

const test::Drag DRAG{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };

/// The longest stroke within 2.5 s.
Stroke longest(const std::function<Eigen::Vector3d(double)> &path, double rate_hz) {
	StrokeFinder finder;
	Stroke longest;
	for (int i = 0; i < static_cast<int>(2.5 * rate_hz); ++i) {
		FeaturePlace place = FeaturePlace::Zero();
		place.head<3>() = path(i / rate_hz);
		finder.push({ .t_s = i / rate_hz }, place);
		for (const Stroke &stroke : finder.strokes()) {
			longest = stroke.path_m > longest.path_m ? stroke : longest;
		}
	}
	return longest;
}

} // namespace

TEST_CASE("a stroke's path_m is the length of the path at any rate") {
	for (const double rate_hz : { 30.0, 1000.0 }) {
		CAPTURE(rate_hz);
		const Stroke line =
				longest([](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s), 0.0, 0.0); }, rate_hz);
		CHECK(line.path_m == test::near((line.to - line.from).norm()).epsilon(1e-9));
		CHECK(line.path_m == test::near(0.2).epsilon(0.05));
		const auto half_circle = [](double t_s) {
			const double angle = std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
			return Eigen::Vector3d(-0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
		};
		CHECK(longest(half_circle, rate_hz).path_m == test::near(0.1 * std::numbers::pi).epsilon(0.05));
	}
}

TEST_CASE("a stroke begins and ends at a quarter of its peak speed") {
	// The speed is 16 s^2 (1 - s)^2 of the peak: a quarter at s = (1 -+ sqrt(1/2)) / 2. A slope over 0.1 s is
	// the speed 0.05 s earlier.
	const double begins = 0.5 - std::sqrt(0.125), ends = 0.5 + std::sqrt(0.125);
	for (const double duration_s : { 0.5, 2.0 }) {
		CAPTURE(duration_s);
		const test::Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
		StrokeFinder finder;
		for (int ms = 0; !finder.ended() && ms < 4000; ++ms) {
			const double t_s = ms / 1000.0;
			finder.push({ .t_s = t_s }, FeaturePlace(drag.x_m(t_s), 1e-6 * t_s, 0.0, 0.0));
		}
		REQUIRE(finder.ended());
		const auto share = [&](double at_s) { return (at_s - 0.05 - drag.onset_s) / duration_s; };
		CHECK(std::abs(share(finder.strokes().front().onset_s) - begins) < 0.03);
		CHECK(std::abs(share(finder.strokes().front().now_s) - ends) < 0.03);
	}
}

TEST_CASE("a stroke's middle is its mean position over the path") {
	for (const double rate_hz : { 30.0, 110.0 }) {
		CAPTURE(rate_hz);
		for (const double turn : { 0.5, 1.0 }) { // of a half circle
			CAPTURE(turn);
			const auto arc = [&](double t_s) {
				const double angle = turn * std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
				return Eigen::Vector3d(0.1 * std::sin(angle), 0.1 * (1.0 - std::cos(angle)), 0.0);
			};
			const Stroke stroke = longest(arc, rate_hz);
			// From angle a to b: (cos a - cos b, sin a - sin b) / (b - a) from the centre (0, 0.1).
			const auto angle_of = [](const FeaturePlace &place) {
				return std::atan2(place.x(), 0.1 - place.y());
			};
			const double a = angle_of(stroke.from), b = angle_of(stroke.to);
			const double x = 0.1 * (std::cos(a) - std::cos(b)) / (b - a);
			const double y = 0.1 - 0.1 * (std::sin(b) - std::sin(a)) / (b - a);
			CHECK((stroke.middle - FeaturePlace(x, y, 0.0, 0.0)).norm() < 3e-3);
		}
	}
}

TEST_CASE("a stroke measures the motion before its onset") {
	const auto from_rest = [](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s), 0.0, 0.0); };
	const Stroke rested = longest(from_rest, 110.0);
	CHECK(rested.motion_before_m < 0.01);
	CHECK(rested.tracked_before_s > 0.4);
	CHECK(rested.tracked_before_s <= parameters::strokes::REST_S);
	// The hand comes from 10 cm above, and rests for 0.1 s before the onset.
	const auto from_above = [&](double t_s) {
		const test::Drag down{ .onset_s = 0.5, .duration_s = 0.4, .amplitude_m = 0.1 };
		return Eigen::Vector3d(from_rest(t_s).x(), 0.1 - down.x_m(t_s), 0.0);
	};
	CHECK(longest(from_above, 110.0).motion_before_m == test::near(0.1).epsilon(0.1));
	const auto just_seen = [&](double t_s) { return from_rest(t_s + 0.9); };
	// A quarter of the peak speed is reached after 0.145 of the time: 0.245 s after the first frame.
	CHECK(longest(just_seen, 110.0).tracked_before_s < 0.245);
}

TEST_CASE("a slow stroke that speeds up is one stroke") {
	// 5 cm slowly, then at once faster. By the peak speed of the fast part the slow part is rest.
	const auto twofold = [](double t_s) {
		const test::Drag slow{ .onset_s = 0.6, .duration_s = 0.9, .amplitude_m = 0.05 };
		const test::Drag fast{ .onset_s = 1.4, .duration_s = 0.4, .amplitude_m = 0.15 };
		return Eigen::Vector3d(slow.x_m(t_s) + fast.x_m(t_s), 0.0, 0.0);
	};
	StrokeFinder finder(FeaturePlace::Ones(), 0.012);
	double longest_m = 0.0;
	for (int i = 0; i < 220; ++i) {
		finder.push({ .t_s = i / 110.0 }, FeaturePlace(twofold(i / 110.0).x(), 0.0, 0.0, 0.0));
		for (const Stroke &stroke : finder.strokes()) {
			longest_m = std::max(longest_m, (stroke.to - stroke.from).norm());
		}
	}
	CHECK(longest_m > 0.19);
}

TEST_CASE("a path is straight between knots and constant after the last") {
	const auto at = [](double x_m) { return FeaturePlace(x_m, 2.0 * x_m, 0.0, 0.0); };
	PathKnots path;
	path.restart(1.0, at(0.0));
	// At steps of 0.06 s each position is a knot, at 0.03 s every second one.
	for (const double step_s : { 0.06, 0.03 }) {
		for (int i = 1; i <= 20; ++i) {
			path.push(1.0 + step_s * i, at(0.01 * i));
		}
		const double end_s = 1.0 + step_s * 20;
		CHECK((path.place_m(0.0) - at(0.0)).norm() == 0.0);
		CHECK((path.place_m(1.0 + step_s * 9.5) - at(0.095)).norm() < 1e-12);
		for (const double later_s : { 0.0, 100.0 }) {
			CHECK((path.place_m(end_s + later_s) - at(0.2)).norm() == 0.0);
			CHECK(path.max_distance_m(end_s, end_s + later_s + 0.5 * PathKnots::APART_S) == 0.0);
		}
		CHECK(path.max_distance_m(1.0, end_s + 1.0) == test::near(at(0.2).norm()));
		path.restart(1.0, at(0.0));
	}
}
