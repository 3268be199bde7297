// Strokes, and what they speak for.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "strokes/stroke_evidence.h"
#include "strokes/stroke_finder.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace steadyhand;

namespace {

const test::Drag DRAG{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };

/// The longest stroke of 2.5 s of the way, seen at that rate.
Stroke longest(const std::function<Eigen::Vector3d(double)> &way, double rate_hz) {
	StrokeFinder finder;
	Stroke longest;
	for (int i = 0; i < static_cast<int>(2.5 * rate_hz); ++i) {
		FeaturePlace place = FeaturePlace::Zero();
		place.head<3>() = way(i / rate_hz);
		finder.push({ .t_s = i / rate_hz }, place);
		for (const Stroke &stroke : finder.strokes()) {
			longest = stroke.way_m > longest.way_m ? stroke : longest;
		}
	}
	return longest;
}

Stroke straight(double length_m) {
	Stroke stroke;
	stroke.now_s = 1.0;
	stroke.to = FeaturePlace(length_m, 0.0, 0.0, 0.0);
	stroke.middle = 0.5 * stroke.to;
	stroke.way_m = length_m;
	stroke.watched_s = Stroke::REST_S;
	return stroke;
}

StrokeEvidence evidence(const Stroke &stroke) {
	return stroke_evidence(stroke, FeaturePlace::UnitX(), 0.2, 1.0);
}

/// Density of any hand's.
double other_detour(double detour) {
	return 2.0 / 1.7 * std::pow(1.0 + detour / 1.7, -3.0);
}

/// Of f over 0 .. to, by the midpoint rule.
double integral(const std::function<double(double)> &f, double to) {
	constexpr int STEPS = 20000;
	double sum = 0.0;
	for (int i = 0; i < STEPS; ++i) {
		sum += f(to * (i + 0.5) / STEPS) * to / STEPS;
	}
	return sum;
}

} // namespace

TEST_CASE("a stroke is as long as the hand's way, at any rate") {
	for (const double rate_hz : { 30.0, 110.0, 1000.0 }) {
		CAPTURE(rate_hz);
		const Stroke line =
				longest([](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s), 0.0, 0.0); }, rate_hz);
		CHECK(line.way_m == test::near((line.to - line.from).norm()).epsilon(1e-9));
		CHECK(line.way_m == test::near(0.2).epsilon(0.05));
		const auto half_circle = [](double t_s) {
			const double angle = std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
			return Eigen::Vector3d(-0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
		};
		CHECK(longest(half_circle, rate_hz).way_m == test::near(0.1 * std::numbers::pi).epsilon(0.05));
	}
}

TEST_CASE("a stroke begins and ends where the hand has a quarter of its peak speed") {
	// 16 s^2 (1 - s)^2 of the peak, at s = (1 -+ sqrt(1/2)) / 2; a slope over 0.1 s is that of 0.05 s before.
	const double begins = 0.5 - std::sqrt(0.125), ends = 0.5 + std::sqrt(0.125);
	for (const double duration_s : { 0.5, 1.0, 2.0 }) {
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

TEST_CASE("the middle of a stroke is its mean over the way, of two strokes that of both") {
	for (const double rate_hz : { 30.0, 110.0 }) {
		CAPTURE(rate_hz);
		for (const double turn : { 0.5, 1.0 }) { // of a half circle
			CAPTURE(turn);
			const auto arc = [&](double t_s) {
				const double angle = turn * std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
				return Eigen::Vector3d(0.1 * std::sin(angle), 0.1 * (1.0 - std::cos(angle)), 0.0);
			};
			const Stroke stroke = longest(arc, rate_hz);
			// From angle a to b: (cos a - cos b, sin a - sin b) / (b - a) from the centre, which is at (0,
			// 0.1).
			const auto angle_of = [](const FeaturePlace &place) {
				return std::atan2(place.x(), 0.1 - place.y());
			};
			const double a = angle_of(stroke.from), b = angle_of(stroke.to);
			const double x = 0.1 * (std::cos(a) - std::cos(b)) / (b - a);
			const double y = 0.1 - 0.1 * (std::sin(b) - std::sin(a)) / (b - a);
			CHECK((stroke.middle - FeaturePlace(x, y, 0.0, 0.0)).norm() < 3e-3);
		}
	}
	Stroke first = straight(0.2), second = straight(0.1);
	second.onset_s = 1.3;
	second.now_s = 1.8;
	second.peak_m_s = 0.7;
	for (FeaturePlace *const place : { &second.from, &second.to, &second.middle }) {
		*place += FeaturePlace(0.2, 0.03, 0.0, 0.0);
	}
	const Stroke both = joined(first, second);
	CHECK((both.middle - (first.middle + 0.5 * second.middle) / 1.5).norm() < 1e-12);
	CHECK(both.way_m == test::near(0.2 + 0.03 + 0.1));
	CHECK(both.peak_m_s == 0.7);
	CHECK(both.onset_s == first.onset_s);
	CHECK(both.now_s == second.now_s);
	CHECK(both.from == first.from);
	CHECK(both.to == second.to);
	CHECK(both.is_joined);
}

TEST_CASE("a stroke knows how still the hand was before it, as long as it was seen") {
	const auto from_rest = [](double t_s) { return Eigen::Vector3d(DRAG.x_m(t_s), 0.0, 0.0); };
	const Stroke rested = longest(from_rest, 110.0);
	CHECK(rested.unrest_m < 0.01);
	CHECK(rested.watched_s > 0.4);
	CHECK(rested.watched_s <= Stroke::REST_S);
	// Comes from 10 cm above and is there 0.1 s before it sets out.
	const auto from_above = [&](double t_s) {
		const test::Drag down{ .onset_s = 0.5, .duration_s = 0.4, .amplitude_m = 0.1 };
		return Eigen::Vector3d(from_rest(t_s).x(), 0.1 - down.x_m(t_s), 0.0);
	};
	CHECK(longest(from_above, 110.0).unrest_m == test::near(0.1).epsilon(0.1));
	const auto just_seen = [&](double t_s) { return from_rest(t_s + 0.9); };
	// A quarter of the peak speed is reached after 0.145 of the time: 0.245 s after the first frame.
	CHECK(longest(just_seen, 110.0).watched_s < 0.245);
}

TEST_CASE("the evidence of a stroke is the ratio of its densities") {
	// What the gesture's density is, summed up, is 1; the null model's are those of stroke_evidence.h.
	constexpr double BOW = 0.18, LARGEST_BOW = 0.5;
	const double straightness = std::log(LARGEST_BOW / (BOW * std::tgamma(1.25)));
	const auto directions = [&](double angle) {
		Stroke turned = straight(0.2);
		turned.to = 0.2 * FeaturePlace(std::cos(angle), std::sin(angle), 0.0, 0.0);
		turned.middle = 0.5 * turned.to;
		CHECK(evidence(turned).size == test::near(evidence(straight(0.2)).size));
		return std::exp(evidence(turned).path - straightness) * 0.5 * std::sin(angle);
	};
	CHECK(integral(directions, std::numbers::pi) == test::near(1.0).epsilon(1e-3));
	const auto bows = [&](double bow) {
		Stroke bent = straight(0.2);
		bent.middle.y() += 0.2 * bow;
		return std::exp(evidence(bent).path - evidence(straight(0.2)).path + straightness) / LARGEST_BOW;
	};
	CHECK(integral(bows, 1.0) == test::near(1.0).epsilon(1e-3));
	const auto detours = [](double detour) {
		Stroke winding = straight(0.2);
		winding.way_m = (1.0 + detour) * 0.2;
		return std::exp(evidence(winding).detour) * other_detour(detour);
	};
	CHECK(integral(detours, 10.0) == test::near(1.0).epsilon(1e-3));
	const auto unrest = [](double amplitudes) {
		Stroke stroke = straight(0.2);
		stroke.unrest_m = 0.2 * amplitudes;
		const double deviation = std::hypot(0.07 + 0.002 / 0.2, 1.5 * 0.5);
		const double z = amplitudes / deviation;
		return std::exp(evidence(stroke).rest - 0.5 * z * z) * std::sqrt(2.0 / std::numbers::pi) / deviation;
	};
	CHECK(integral(unrest, 10.0) == test::near(1.0).epsilon(1e-3));
}

TEST_CASE(
		"of ten gestures one goes astray, by detours three times as long as the others' and the tracker's") {
	// docs/method.md: 0.03 + (1 cm + 3 mm/s) / 20 cm in the mean, of a stroke of a second.
	constexpr double MEAN = 0.03 + 0.013 / 0.2;
	const auto density = [](double detour) {
		Stroke winding = straight(0.2);
		winding.way_m = (1.0 + detour) * 0.2;
		return std::exp(evidence(winding).detour) * other_detour(detour);
	};
	for (const double times : { 1.0, 3.0, 6.0, 12.0 }) {
		CAPTURE(times);
		const double beyond = 1.0 - integral(density, times * MEAN);
		const double expected = 0.9 * std::exp(-times) + 0.1 * std::exp(-times / 3.0);
		CHECK(beyond / expected == test::near(1.0).epsilon(0.01));
	}
}

TEST_CASE("lengths are 0.15 below and 0.5 above the usual one, one pace in four is anybody's") {
	// In logarithms; the null model's are uniform over 3.7 and, of 0.1 to 5 s, 3.9.
	const auto of_length = [](double times) {
		Stroke stroke = straight(0.2 * times);
		stroke.middle = 0.5 * stroke.to;
		return evidence(stroke).size;
	};
	CHECK(of_length(std::exp(-0.15)) == test::near(of_length(1.0) - 0.5).epsilon(1e-9));
	CHECK(of_length(std::exp(0.5)) == test::near(of_length(1.0) - 0.5).epsilon(1e-9));
	const double lengths = integral(
			[&](double log_times) { return std::exp(of_length(std::exp(log_times - 3.0))) / 3.7; }, 7.0);
	const auto of_time = [](double time_s) {
		Stroke stroke = straight(0.2);
		stroke.now_s = time_s;
		return evidence(stroke).size;
	};
	const double both = integral(
			[&](double log_times) { return std::exp(of_time(0.1 * std::exp(log_times))) / 3.7 / 3.9; },
			std::log(50.0));
	// The integral over both densities is 1.
	CHECK(lengths * both / std::exp(of_length(1.0)) * 3.7 == test::near(1.0).epsilon(0.01));
}

TEST_CASE("with the task known too: of direction, bow and start") {
	const FeaturePlace start(0.3, -0.2, 0.1, 0.0);
	constexpr double AMPLITUDE_M = 0.2;
	const auto evidence_at = [&](const Stroke &stroke) {
		return task_evidence(stroke, start, FeaturePlace::UnitX(), AMPLITUDE_M);
	};
	const auto stroke = [&](const Eigen::Vector3d &off_m, double angle, double bow) {
		Stroke moved = straight(AMPLITUDE_M);
		moved.from = start;
		moved.from.head<3>() += off_m;
		moved.shown_from = moved.from;
		// Hands aim at the end, from wherever beside the start they began.
		const Eigen::Vector3d aim = Eigen::Vector3d(AMPLITUDE_M, -off_m.y(), -off_m.z()).normalized();
		const Eigen::AngleAxisd turn(angle, aim.unitOrthogonal());
		moved.to = moved.from;
		moved.to.head<3>() += AMPLITUDE_M * (turn * aim);
		moved.middle = 0.5 * (moved.from + moved.to) + bow * AMPLITUDE_M * FeaturePlace::UnitZ();
		return moved;
	};
	const double best = evidence_at(stroke({ 0.0, 0.0, 0.0 }, 0.0, 0.0));
	const auto share = [&](const Stroke &of) { return std::exp(evidence_at(of) - best); };
	// Each density by its own integral; that of the null model is the uniform one.
	const double directions = integral(
			[&](double angle) {
				return share(stroke({ 0.0, 0.0, 0.0 }, angle, 0.0)) * 0.5 * std::sin(angle);
			},
			std::numbers::pi);
	const double bows = integral(
			[&](double bow) {
				return share(stroke({ 0.0, 0.0, 0.0 }, 0.0, bow)) / 0.5;
			},
			0.5);
	const double ball_m3 = 4.0 / 3.0 * std::numbers::pi * std::pow(1.5 * AMPLITUDE_M, 3.0);
	const Eigen::Vector3d way = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
	const double starts = integral(
			[&](double off_m) {
				return share(stroke(off_m * way, 0.0, 0.0)) * 4.0 * std::numbers::pi * off_m * off_m /
						ball_m3;
			},
			1.5 * AMPLITUDE_M);
	CHECK(best == test::near(-std::log(directions * bows * starts)).epsilon(1e-3));

	// Where on its way the hand was longest is no bow.
	Stroke late = stroke({ 0.01, 0.0, 0.0 }, 0.1, 0.02);
	const double path = evidence(late).path, of_task = evidence_at(late);
	late.middle += 0.3 * (late.to - late.from);
	CHECK(evidence(late).path == test::near(path).epsilon(1e-12));
	CHECK(evidence_at(late) == test::near(of_task).epsilon(1e-12));
}

TEST_CASE("a gesture of several strokes has 0.5 nats less, one without a time is none") {
	Stroke stroke = straight(0.2);
	const double alone = evidence(stroke).sum();
	stroke.is_joined = true;
	CHECK(evidence(stroke).sum() == test::near(alone - 0.5).epsilon(1e-12));
	stroke = straight(0.2);
	stroke.now_s = stroke.onset_s;
	CHECK(evidence(stroke).sum() < -100.0);
	// A way that rounding made shorter than its chord has no detour.
	stroke = straight(0.2);
	stroke.way_m = 0.2 * (1.0 - 1e-3);
	CHECK(evidence(stroke).sum() == test::near(alone).epsilon(1e-12));
}

TEST_CASE("a start counts by its distance from the task's; of a radius, by its size alone") {
	const FeaturePlace start = FeaturePlace::Zero();
	const auto at = [&](double from_m, const FeaturePlace &way) {
		Stroke stroke;
		stroke.from = FeaturePlace(0.0, from_m, 0.0, 0.0);
		stroke.shown_from = stroke.from;
		stroke.to = stroke.from + 0.2 * way;
		stroke.middle = 0.5 * (stroke.from + stroke.to);
		return task_evidence(stroke, start, way, 0.2);
	};
	const FeaturePlace along = FeaturePlace::UnitX(), larger = FeaturePlace::UnitW();
	CHECK(at(0.09, along) < at(0.03, along) - 1.0);
	CHECK(at(0.09, larger) == test::near(at(0.0, larger)).epsilon(1e-12));
}

TEST_CASE("no pace speaks against a gesture by more than the share of people who have their own") {
	for (const double mean_s : { 0.2, 0.35, 1.0, 4.0, 10.0 }) {
		CAPTURE(mean_s);
		const StrokeEvidence usual = stroke_evidence(straight(0.2), FeaturePlace::UnitX(), 0.2, 1.0);
		const StrokeEvidence other = stroke_evidence(straight(0.2), FeaturePlace::UnitX(), 0.2, mean_s);
		CHECK(other.size <= usual.size);
		CHECK(other.size > usual.size - 3.0);
	}
}

TEST_CASE("no stroke speaks more for a gesture than at most it may; the best one nearly does") {
	std::mt19937_64 random(1);
	std::uniform_real_distribution<double> uniform(0.0, 1.0);
	for (int i = 0; i < 20000; ++i) {
		Stroke stroke = straight(0.5 * std::pow(uniform(random), 3.0));
		const double turned = 2.0 * std::pow(uniform(random), 2.0);
		stroke.to = stroke.to.x() * FeaturePlace(std::cos(turned), std::sin(turned), 0.0, 0.0);
		stroke.middle = 0.5 * stroke.to + FeaturePlace(0.0, 0.0, 0.02 * uniform(random), 0.0);
		stroke.way_m *= 1.0 + 10.0 * std::pow(uniform(random), 4.0);
		stroke.now_s = 0.1 + 3.0 * uniform(random);
		stroke.unrest_m = 0.2 * std::pow(uniform(random), 3.0);
		stroke.watched_s = Stroke::REST_S * uniform(random);
		const StrokeEvidence come = evidence(stroke);
		const double most = most_evidence(stroke, FeaturePlace::UnitX(), 0.2);
		REQUIRE(come.so_far() + come.outlook <= most + 1e-12);
		REQUIRE(come.sum() <= most + 1e-12);
	}
	CHECK(evidence(straight(0.2)).sum() > most_evidence(straight(0.2), FeaturePlace::UnitX(), 0.2) - 2.0);
	CHECK(most_evidence(Stroke{}, FeaturePlace::UnitX(), 0.2) < -100.0);
}

TEST_CASE("a hand that comes back to where it set out has gone a detour, however near it comes") {
	for (const double way_m : { 0.4, 1.0, 3.0 }) {
		for (const double length_m : { 0.1, 0.05, 0.03, 0.02, 0.01, 0.005 }) {
			CAPTURE(way_m);
			CAPTURE(length_m);
			Stroke back = straight(length_m);
			back.way_m = way_m;
			back.now_s = way_m / 0.4;
			CHECK(evidence(back).detour < -2.0);
		}
	}
}

TEST_CASE("the longer a stroke takes, the less a winding way speaks against it: a tracker's error goes on") {
	Stroke quick = straight(0.2), slow = quick;
	quick.way_m = slow.way_m = 0.3;
	quick.now_s = 0.5;
	slow.now_s = 4.0;
	CHECK(evidence(slow).detour > evidence(quick).detour + 0.5);
}

TEST_CASE("a stroke that a faster one follows is still part of what both are") {
	// 5 cm slowly, and on at once four times as fast: the slow part is as good as rest to the fast one.
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

TEST_CASE("what a stroke could yet say is never less than what it comes to say") {
	for (const double angle : { 0.0, 0.2, 0.4 }) {
		for (const double length : { 0.2, 0.5, 1.0, 1.5 }) {
			Stroke turned = straight(0.2 * length);
			turned.to = 0.2 * length * FeaturePlace(std::cos(angle), std::sin(angle), 0.0, 0.0);
			turned.middle = 0.5 * turned.to;
			CHECK(evidence(turned).outlook >= evidence(turned).size);
		}
	}
}

TEST_CASE("a stroke that leads nowhere, or without end, speaks against every gesture") {
	CHECK(evidence(straight(0.0)).sum() < -100.0);
	CHECK(evidence(straight(INFINITY)).sum() < -100.0);
	Stroke endless = straight(0.2);
	endless.way_m = 1e9;
	CHECK(std::isfinite(evidence(endless).sum()));
	CHECK(evidence(endless).sum() < -100.0);
}
