#include "minimum_jerk_drag.h"
#include "near.h"
#include "soundness/tracking_soundness.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double PERIOD_S = 0.009;

/// `frames` of a hand that moves at a speed, in amplitudes per second; returns when the next one is due.
double move(TrackingSoundness &r_soundness, double t_s, double from, double speed_per_s, int frames) {
	for (int i = 0; i < frames; ++i, t_s += PERIOD_S) {
		r_soundness.push(t_s, from + speed_per_s * i * PERIOD_S);
	}
	return t_s;
}

} // namespace

TEST_CASE("a hand that moves as hands do, on a sensor that skips a frame now and then, is sound") {
	TrackingSoundness soundness;
	const double t_s = move(soundness, 0.0, 0.0, 2.0, 50);
	move(soundness, t_s + 2.0 * PERIOD_S, 0.9, 2.0, 50); // one interval of three periods
	CHECK(soundness.unsoundness() == 0.0);
	CHECK_FALSE(soundness.frozen());
}

TEST_CASE("a jump is evidence of one, and fades with a memory of 1 s") {
	TrackingSoundness soundness;
	const double t_s = move(soundness, 0.0, 0.0, 0.1, 50);
	soundness.push(t_s, 0.4);
	CHECK(soundness.unsoundness() == test::near(1.0 - std::exp(-1.0)).epsilon(0.01));
	const double later_s = move(soundness, t_s + PERIOD_S, 0.4, 0.1, 111);
	CHECK(later_s - t_s == test::near(1.0).epsilon(0.01));
	CHECK(soundness.unsoundness() == test::near(1.0 - std::exp(-std::exp(-1.0))).epsilon(0.01));
}

TEST_CASE("a long gap is evidence, a lower rate from then on is none") {
	TrackingSoundness soundness;
	const double t_s = move(soundness, 0.0, 0.0, 0.5, 50);
	soundness.push(t_s + 0.3, 0.4);
	CHECK(soundness.unsoundness() > 0.5);
	for (const double gap_s : { 3.5 * PERIOD_S, 0.05, 0.07, 0.3 }) {
		CAPTURE(gap_s);
		TrackingSoundness lost;
		move(lost, 0.0, 0.0, 0.1, 50);
		const double last_s = 49.0 * PERIOD_S;
		lost.push(last_s + gap_s, 0.1 * (last_s + gap_s));
		const double beyond = gap_s > 4.0 * PERIOD_S ? (gap_s - 2.0 * PERIOD_S) / 0.061 : 0.0;
		CHECK(lost.fault() == test::near(std::min(beyond, 1.0)));
	}
	TrackingSoundness slow;
	for (int i = 0; i < 100; ++i) {
		slow.push(i / 30.0, 0.01 * i);
	}
	CHECK(slow.unsoundness() == 0.0);
}

TEST_CASE("values that repeat on the way are a frozen tracker, exact rest is not") {
	TrackingSoundness on_the_way;
	const double t_s = move(on_the_way, 0.0, 0.0, 1.0, 50);
	move(on_the_way, t_s, 49.0 * PERIOD_S, 0.0, 5);
	CHECK(on_the_way.frozen());
	CHECK(on_the_way.fault() == test::near(0.5));

	TrackingSoundness at_rest;
	move(at_rest, 0.0, 0.2, 0.0, 200);
	CHECK_FALSE(at_rest.frozen());
	CHECK(at_rest.unsoundness() == 0.0);

	TrackingSoundness trembling;
	for (int i = 0; i < 50; ++i) {
		trembling.push(i * PERIOD_S, 1e-4 * std::sin(2.0 * i));
	}
	move(trembling, 50 * PERIOD_S, 0.0, 0.0, 5);
	CHECK(trembling.frozen());
}

TEST_CASE("a burst of frames at the start does not make what follows a row of gaps") {
	TrackingSoundness soundness;
	for (int i = 0; i < 6; ++i) {
		soundness.push(0.0005 * i, 0.0001 * i);
	}
	move(soundness, 0.003 + PERIOD_S, 0.001, 0.5, 100);
	CHECK(soundness.unsoundness() == 0.0);
}

TEST_CASE("a tracker that repeats itself at the start and shows the hand there still has lost nothing") {
	// Trembles, repeats itself for 0.3 s, and shows the hand somewhere again.
	const auto suspected = [](double rests_at, double shown_at) {
		TrackingSoundness soundness;
		std::mt19937_64 random(4);
		std::normal_distribution<double> trembling(0.0, 0.001);
		double t_s = 0.0, x = 0.0;
		for (int i = 0; i < 150; ++i, t_s += PERIOD_S) {
			x = i < 110 ? rests_at + trembling(random) : x;
			soundness.push(t_s, x);
		}
		REQUIRE(soundness.frozen());
		REQUIRE(soundness.unsoundness() > 0.9);
		soundness.push(t_s, x + shown_at - rests_at);
		REQUIRE_FALSE(soundness.frozen());
		CHECK((soundness.lateness() > 0.0) == (soundness.unsoundness() > 0.0));
		return soundness.unsoundness();
	};
	CHECK(suspected(0.0, 0.003) == 0.0);
	CHECK(suspected(-0.03, -0.033) == 0.0);
	CHECK(suspected(0.0, 0.009) == 0.0);
	CHECK(suspected(0.0, 0.015) > 0.9);
	CHECK(suspected(0.3, 0.303) > 0.9);
}

TEST_CASE("what comes back from a freeze further on has returned, and the news is as old as the freeze") {
	TrackingSoundness soundness;
	const double frozen_s = move(soundness, 0.0, 0.0, 0.1, 20) - PERIOD_S;
	const double x = 0.1 * 19 * PERIOD_S;
	double t_s = frozen_s;
	for (int i = 0; i < 20; ++i) {
		soundness.push(t_s += PERIOD_S, x);
		CHECK_FALSE(soundness.returned());
	}
	soundness.push(t_s += PERIOD_S, x + 0.5);
	CHECK(soundness.returned());
	CHECK(soundness.news_s() == test::near(frozen_s));
	soundness.push(t_s += PERIOD_S, x + 0.52);
	CHECK(soundness.news_s() == test::near(t_s));
}

TEST_CASE("a value off the way by more than a hand can bend it has jumped, the fastest drag has not") {
	TrackingSoundness fastest;
	constexpr double DURATION_S = 0.15;
	for (int i = 0; i < 40; ++i) {
		const double s = std::min(i * PERIOD_S / DURATION_S, 1.0);
		fastest.push(i * PERIOD_S, s * s * s * (10.0 - 15.0 * s + 6.0 * s * s));
		CHECK_FALSE(fastest.jumped());
	}
	fastest.push(40 * PERIOD_S, 1.06);
	CHECK(fastest.jumped());
}

TEST_CASE("white noise of a moving sensor is told by its deviation, and jumps are none of it") {
	for (const double deviation : { 0.0005, 0.002, 0.004 }) {
		CAPTURE(deviation);
		std::mt19937_64 random(6);
		std::normal_distribution<double> noise(0.0, deviation);
		TrackingSoundness soundness;
		double sum = 0.0;
		int counted = 0;
		for (int i = 0; i < 4000; ++i) {
			soundness.push(i * PERIOD_S, 0.5 * i * PERIOD_S + noise(random) + (i % 500 < 5 ? 0.3 : 0.0));
			if (i > 200) {
				sum += soundness.jitter();
				++counted;
			}
		}
		CHECK(sum / counted == test::near(deviation).epsilon(0.15));
	}
}

TEST_CASE("two frames of one instant that differ are no jump for ever") {
	TrackingSoundness soundness;
	const double t_s = move(soundness, 0.0, 0.0, 0.1, 20);
	soundness.push(t_s - PERIOD_S, 0.03); // where it was 0.017
	int jumps = 0;
	for (int i = 0; i < 20; ++i) {
		soundness.push(t_s + i * PERIOD_S, 0.03 + 0.1 * i * PERIOD_S);
		jumps += soundness.jumped() ? 1 : 0;
	}
	CHECK(jumps <= 2);
}

TEST_CASE("a jump beside the way is a fault and is remembered, a hand that sweeps round is none") {
	const auto show = [](TrackingSoundness &r_soundness, int from, int frames, double beside) {
		for (int i = from; i < from + frames; ++i) {
			const double t_s = i * PERIOD_S;
			r_soundness.push(t_s, t_s, FeaturePlace(t_s, beside, 0.0, 0.0));
		}
	};
	TrackingSoundness jumping;
	show(jumping, 0, 50, 0.0);
	CHECK(jumping.lasting_unsoundness() == 0.0);
	show(jumping, 50, 1, 0.2);
	CHECK(jumping.fault() == test::near(0.3));
	CHECK_FALSE(jumping.jumped()); // not along the way
	CHECK(jumping.lasting_unsoundness() > 0.6);
	show(jumping, 51, 222, 0.2); // 2 s
	CHECK(jumping.fault() == 0.0);
	CHECK(jumping.lasting_unsoundness() > 2.0 * jumping.unsoundness());

	TrackingSoundness sweeping;
	for (int i = 0; i < 100; ++i) { // half an amplitude round, twice a second
		const double angle = 4.0 * std::numbers::pi * i * PERIOD_S;
		sweeping.push(i * PERIOD_S, 0.5 * std::sin(angle),
				0.5 * FeaturePlace(std::sin(angle), std::cos(angle), 0.0, 0.0));
	}
	CHECK(sweeping.lasting_unsoundness() == 0.0);
}

TEST_CASE("a tracker that loses the hand is late for all that is known, one that jumps hardly") {
	TrackingSoundness jumps, loses;
	const double t_s = move(jumps, 0.0, 0.0, 0.5, 100);
	move(loses, 0.0, 0.0, 0.5, 100);
	move(jumps, t_s, 0.5 * t_s + 0.4, 0.5, 3);
	move(loses, t_s + 0.1, 0.5 * (t_s + 0.1), 0.5, 3);
	CHECK(loses.lateness() > 0.6);
	CHECK(loses.lateness() == test::near(loses.lasting_unsoundness()));
	CHECK(jumps.lasting_unsoundness() > 0.6);
	CHECK(jumps.lateness() < 0.3);
	CHECK(jumps.lateness() > 0.2);
}

TEST_CASE("of a hand that rests at the start, is lost and is there again, nothing tells that it is late") {
	const auto lateness = [](double rests_at, double found_at, double beside) {
		TrackingSoundness soundness;
		const auto show = [&](double t_s, double x, double y) {
			soundness.push(t_s, x, FeaturePlace(x, y, 0.0, 0.0));
		};
		std::mt19937_64 random(4);
		std::normal_distribution<double> trembling(0.0, 0.001);
		for (int i = 0; i < 110; ++i) {
			const double along_m = trembling(random);
			show(i * PERIOD_S, rests_at + along_m, trembling(random));
		}
		show(109 * PERIOD_S + 0.2, found_at, beside);
		CHECK(soundness.lasting_unsoundness() > 0.6);
		return soundness.lateness();
	};
	CHECK(lateness(0.0, 0.005, 0.0) == 0.0);
	CHECK(lateness(-0.04, -0.036, 0.02) == 0.0);
	CHECK(lateness(0.0, 0.02, 0.0) > 0.6);
	CHECK(lateness(0.1, 0.1, 0.0) > 0.6);
	CHECK(lateness(0.0, 0.0, 0.3) > 0.6);
}

TEST_CASE("a camera that is read more often than it looks is sound, and only its own frames tell something") {
	for (const int reads : { 2, 3, 4, 8 }) {
		CAPTURE(reads);
		std::mt19937_64 random(3);
		std::normal_distribution<double> noise(0.0, 2e-4);
		TrackingSoundness soundness;
		double shown = 0.0;
		double learnt = 0.0;
		for (int i = 0; i < 360; ++i) {
			const double t_s = i / 120.0;
			const bool looks = i % reads == 0;
			shown = looks ? std::clamp(t_s - 2.0, 0.0, 1.0) + noise(random) : shown;
			soundness.push(t_s, shown);
			if (t_s < 1.0) { // how often it looks is learnt on the way
				learnt = soundness.unsoundness();
				continue;
			}
			CHECK(soundness.told() == looks);
			CHECK(soundness.fault() == 0.0);
		}
		CHECK(learnt < 0.05);
	}
}

TEST_CASE("so is one of which nothing is known, after a hand that rested to the last bit") {
	const test::Drag drag{ .onset_s = 1.003, .duration_s = 0.6 };
	for (const int camera_hz : { 15, 20, 30, 45 }) {
		for (const int read_hz : { 90, 200, 500 }) {
			CAPTURE(camera_hz);
			CAPTURE(read_hz);
			TrackingSoundness soundness;
			for (int i = 0; i < 1.6 * read_hz; ++i) { // when it last moved
				const double t_s = static_cast<double>(i) / read_hz;
				const double looked_s = std::floor(t_s * camera_hz + 1e-9) / camera_hz;
				soundness.push(t_s, drag.x_m(looked_s) / drag.amplitude_m);
				CHECK(soundness.fault() == 0.0);
			}
			CHECK(soundness.unsoundness() < 0.05);
		}
	}
}

TEST_CASE("a tracker that rounds is not frozen while it moves, and not silent while the hand trembles") {
	for (const double resolution : { 0.0005, 0.001, 0.005 }) {
		for (const double trembling : { 0.1, 0.3, 0.4, 1.0 }) {
			CAPTURE(resolution);
			CAPTURE(trembling);
			std::mt19937_64 random(4);
			std::normal_distribution<double> noise(0.0, trembling * resolution);
			TrackingSoundness soundness;
			int frozen = 0;
			for (int i = 0; i < 1000; ++i) {
				const double t_s = i * PERIOD_S;
				const double s = std::clamp(t_s - 4.0, 0.0, 1.0);
				const double x = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) + noise(random);
				soundness.push(t_s, std::round(x / resolution) * resolution);
				frozen += soundness.frozen() ? 1 : 0;
			}
			CHECK(frozen < 5); // of 1000
		}
	}
}

TEST_CASE("a tracker that rounds is known whichever way the motion element goes") {
	constexpr double RESOLUTION = 0.005;
	for (const Eigen::Vector3d &way : { Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0),
				 Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.96, 0.28, 0) }) {
		CAPTURE(way.transpose());
		std::mt19937_64 random(4);
		std::normal_distribution<double> noise(0.0, 0.3 * RESOLUTION);
		TrackingSoundness soundness;
		int frozen = 0;
		for (int i = 0; i < 3000; ++i) {
			FeaturePlace place = FeaturePlace::Zero();
			for (Eigen::Index axis = 0; axis < 3; ++axis) {
				place[axis] = std::round((0.3 + noise(random)) / RESOLUTION) * RESOLUTION;
			}
			soundness.push(i * PERIOD_S, way.normalized().dot(place.head<3>()), place);
			frozen += soundness.frozen() ? 1 : 0;
		}
		CHECK(frozen == 0);
	}
}

TEST_CASE("a hand at rest before a tracker that rounds is at rest after its first steps too") {
	constexpr double RESOLUTION = 0.02;
	for (const std::vector<int> &steps : { std::vector{ 1 }, { -1 }, { 1, -1 }, { 1, 1 } }) {
		CAPTURE(steps.size());
		for (const double apart_s : { 0.009, 0.2 }) {
			CAPTURE(apart_s);
			const bool walks = steps.size() == 2 && steps[0] == steps[1] && apart_s < 0.1;
			TrackingSoundness soundness;
			for (int i = 0; i < 150; ++i) {
				const double t_s = i * PERIOD_S;
				int shown = 0;
				for (std::size_t k = 0; k < steps.size(); ++k) {
					shown += t_s >= 0.5 + static_cast<double>(k) * apart_s ? steps[k] : 0;
				}
				soundness.push(t_s, RESOLUTION * shown);
				if (!walks) { // two on end are a motion of two amplitudes a second
					CHECK_FALSE(soundness.frozen());
				}
			}
			CHECK(soundness.frozen() == walks);
		}
	}
}

TEST_CASE("a tracker that rounds, and makes a step as soon as it shows a hand at rest, has not lost it") {
	constexpr double RESOLUTION = 0.02;
	for (const int first : { 1, 2, 3 }) {
		for (const double step : { RESOLUTION, -RESOLUTION }) {
			CAPTURE(first);
			CAPTURE(step);
			TrackingSoundness soundness;
			for (int i = 0; i < 150; ++i) {
				soundness.push(i * PERIOD_S, i < first ? 0.0 : step);
				CHECK_FALSE(soundness.frozen());
			}
			CHECK(soundness.unsoundness() == 0.0);
		}
	}
}

TEST_CASE("a tracker that trembled while the hand was at rest is frozen on a smooth way too") {
	TrackingSoundness soundness;
	for (int i = 0; i < 60; ++i) {
		soundness.push(i * PERIOD_S, 1e-4 * std::sin(2.0 * i));
	}
	const double t_s = move(soundness, 60 * PERIOD_S, 0.0, 0.15, 30); // slowly
	move(soundness, t_s, 0.15 * 29 * PERIOD_S, 0.0, 6);
	CHECK(soundness.frozen());
	CHECK_FALSE(soundness.told());
}

TEST_CASE("white noise of any size is no fault, and jumps stand out of it") {
	for (const double deviation : { 0.005, 0.025, 0.05 }) { // 1, 5 and 10 mm of 20 cm
		CAPTURE(deviation);
		std::mt19937_64 random(5);
		std::normal_distribution<double> noise(0.0, deviation);
		TrackingSoundness soundness;
		int jumps = 0, frozen = 0;
		double jitters = 0.0; // of the later half
		for (int i = 0; i < 1000; ++i) {
			const double t_s = i * PERIOD_S;
			const double x = std::clamp(t_s - 4.0, 0.0, 1.0) + noise(random);
			soundness.push(t_s, x, FeaturePlace{ x, noise(random), noise(random), 0.0 });
			jumps += soundness.jumped() || soundness.fault() > 0.0 ? 1 : 0;
			frozen += soundness.frozen() ? 1 : 0;
			jitters += i >= 500 ? soundness.jitter() : 0.0;
		}
		CHECK(jumps < 10); // of 1000
		CHECK(frozen == 0);
		CHECK(jitters / 500.0 == test::near(deviation).epsilon(0.05));
		soundness.push(1000 * PERIOD_S, 1.0 + 20.0 * deviation + 0.2);
		CHECK(soundness.jumped());
	}
}

TEST_CASE("a step that shaking makes now and then is seldom a fault, or a return; one of twice that mostly "
		  "is") {
	constexpr int TRACKERS = 200;
	constexpr double FASTEST_PER_S = 12.5, GAP_S = 0.2;
	for (const double deviation : { 0.025, 0.05 }) { // 5 and 10 mm of 20 cm
		CAPTURE(deviation);
		// Of trackers that shake and, so much later, show the hand so much further.
		const auto share = [&](double later_s, double step, const auto &is_so) {
			int count = 0;
			for (unsigned seed = 0; seed < TRACKERS; ++seed) {
				std::mt19937_64 random(seed);
				std::normal_distribution<double> noise(0.0, deviation);
				TrackingSoundness soundness;
				for (int i = 0; i < 60; ++i) {
					soundness.push(i * PERIOD_S, noise(random));
				}
				soundness.push(59 * PERIOD_S + later_s, step + noise(random));
				count += is_so(soundness) ? 1 : 0;
			}
			return static_cast<double>(count) / TRACKERS;
		};
		const auto faults = [&](double deviations) {
			return share(PERIOD_S, FASTEST_PER_S * PERIOD_S + deviations * deviation,
					[](const TrackingSoundness &soundness) { return soundness.fault() >= 1.0; });
		};
		const auto returns = [&](double deviations) {
			return share(GAP_S, deviations * deviation,
					[](const TrackingSoundness &soundness) { return soundness.returned(); });
		};
		CHECK(faults(5.0) < 0.4);
		CHECK(returns(5.0) < 0.4);
		CHECK(faults(10.0) > 0.6);
		CHECK(returns(10.0) > 0.6);
	}
}

TEST_CASE("a jump out of exact rest is one") {
	TrackingSoundness soundness;
	const double t_s = move(soundness, 0.0, 0.0, 0.0, 50);
	soundness.push(t_s, 0.2);
	CHECK(soundness.jumped());
	CHECK(soundness.fault() == 1.0);
}

TEST_CASE("a hand that stops before a tracker that repeats itself is seen wherever that changes") {
	TrackingSoundness soundness;
	double t_s = move(soundness, 0.0, 0.0, 1.0, 30);
	const double stopped = 29.0 * PERIOD_S;
	move(soundness, t_s, stopped, 0.0, 2);
	t_s += 2.0 * PERIOD_S;
	for (int i = 1; i < 20; ++i, t_s += PERIOD_S) {
		soundness.push(t_s, stopped + 1e-4 * i); // of no tremble
		CHECK(soundness.told());
	}
}

TEST_CASE("a single frame elsewhere is taken back by the next, a step is not") {
	for (const int elsewhere : { 1, 2 }) {
		CAPTURE(elsewhere);
		TrackingSoundness soundness;
		for (int i = 0; i < 100; ++i) {
			const bool is_off = i >= 60 && i < 60 + elsewhere;
			soundness.push(i * PERIOD_S, 0.5 * i * PERIOD_S + (is_off ? 0.3 : 0.0));
			if (i == 60) {
				CHECK(soundness.fault() == 1.0);
			}
			if (i == 61) {
				CHECK(soundness.fault() == (elsewhere == 1 ? -1.0 : 0.0));
				CHECK(soundness.jumped() == false);
			}
		}
		CHECK((soundness.lasting_unsoundness() < 0.01) == (elsewhere == 1));
	}
}

TEST_CASE(
		"a hand that shakes as a whole while its size is exact is no fault, one that is shown elsewhere is") {
	for (const double shaking : { 0.0, 0.007, 0.03 }) { // of 3 cm: 0.2 and 1 mm
		CAPTURE(shaking);
		std::mt19937_64 random(7);
		std::normal_distribution<double> normal;
		const auto noise = [&] { return shaking * normal(random); };
		TrackingSoundness soundness;
		const test::Drag opening{ .onset_s = 1.0, .duration_s = 0.8, .amplitude_m = 1.0 };
		double fault = 0.0;
		for (int i = 0; i < 220; ++i) {
			const double x = opening.x_m(i / 100.0), off = i >= 150 ? 4.0 : 0.0;
			const FeaturePlace place(noise() + off, noise(), 0.0, 1.0 + x);
			soundness.push(i / 100.0, x, place);
			fault += soundness.fault();
			if (i == 149) {
				CHECK(fault == 0.0);
			}
		}
		CHECK(fault > 0.0);
	}
}
