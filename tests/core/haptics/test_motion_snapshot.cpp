#include "haptics/arrival_detector.h"
#include "haptics/latest_value.h"
#include "haptics/motion_clock.h"
#include "haptics/motion_snapshot.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace steadyhand;
using steadyhand::test::Movement;

TEST_CASE("a snapshot is the quintic that it was taken of, derivatives and all") {
	const Movement movement{ 0.35 };
	const MotionSnapshot snapshot = movement.snapshot(0.05);
	MotionCurve curve;
	curve.set(snapshot);
	for (int i = 0; i < 270; ++i) {
		const double t_s = 0.05 + 0.00037 * i;
		const MotionPoint truth = movement.at(t_s);
		for (const MotionPoint &made : { snapshot.at(t_s), curve.at(t_s) }) {
			REQUIRE(std::abs(made.position - truth.position) < 1e-12);
			REQUIRE(std::abs(made.velocity - truth.velocity) < 1e-10);
			REQUIRE(std::abs(made.acceleration - truth.acceleration) < 1e-7);
			const double jerk = (movement.at(t_s + 1e-6).acceleration - truth.acceleration) / 1e-6;
			REQUIRE(std::abs(made.jerk - jerk) < 0.05); // of up to 1400
		}
	}
}

TEST_CASE("a snapshot whose quintics are made before is the same to the last bit") {
	MotionSnapshot fitted = Movement{ 0.35 }.snapshot(0.05);
	MotionCurve before, now;
	now.set(fitted);
	fitted.fit();
	before.set(fitted);
	for (int i = 0; i < 300; ++i) {
		const double t_s = 0.04 + 0.0004 * i;
		REQUIRE(before.at(t_s).position == now.at(t_s).position);
		REQUIRE(before.at(t_s).jerk == now.at(t_s).jerk);
	}
}

TEST_CASE("what a cubic over a stretch is off by is bounded, and not by much too much") {
	// With knots that no polynomial leads through: another jerk in each piece.
	std::uint64_t random = 1;
	int crossing = 0;
	double bounds = 0.0, offs = 0.0;
	for (int round = 0; round < 3000; ++round) {
		random = random * 6364136223846793005ULL + 1442695040888963407ULL;
		const auto part = [&](unsigned shift) {
			return static_cast<double>((random >> shift) & 0xFFFU) / 4096.0;
		};
		MotionSnapshot snapshot = Movement{ 0.2 + part(0) }.snapshot(0.0);
		for (std::size_t i = 0; i < snapshot.count; ++i) {
			snapshot.knots[i].moving = true;
			snapshot.knots[i].acceleration += round % 2 == 0 ? 0.0 : part(12) * static_cast<double>(i % 3);
		}
		MotionCurve curve;
		curve.set(snapshot);
		const double from_s = 0.08 * part(24), to_s = from_s + 0.001 + 0.012 * part(36);
		const MotionPoint from = curve.at(from_s), to = curve.at(to_s);
		const double bound = curve.from_cubic(from_s, from, to_s, to);
		const double length_s = to_s - from_s;
		double off = 0.0, velocity_off = 0.0;
		for (int i = 1; i < 100; ++i) {
			const double u = 0.01 * i, v = 1.0 - u;
			const auto cubic = [&](double at_0, double slope_0, double at_1, double slope_1) {
				return v * v * (1.0 + 2.0 * u) * at_0 + u * u * (3.0 - 2.0 * u) * at_1 +
						u * v * length_s * (v * slope_0 - u * slope_1);
			};
			const MotionPoint truth = snapshot.at(from_s + u * length_s);
			off = std::max(off,
					std::abs(cubic(from.position, from.velocity, to.position, to.velocity) - truth.position));
			velocity_off = std::max(velocity_off,
					std::abs(cubic(from.velocity, from.acceleration, to.velocity, to.acceleration) -
							truth.velocity));
		}
		const auto piece = [](double t_s) { return std::floor(100.0 * t_s); };
		REQUIRE(off <= bound + 1e-13);
		REQUIRE(velocity_off <= curve.velocity_from_cubic(from_s, to_s) + 1e-12);
		if (piece(from_s) == piece(to_s)) {
			bounds += bound;
			offs += off;
		} else if (piece(to_s) == piece(from_s) + 1.0) {
			REQUIRE(std::isfinite(bound));
			REQUIRE(curve.velocity_from_cubic(from_s, to_s) == HUGE_VAL);
			++crossing;
		} else {
			REQUIRE(bound == HUGE_VAL);
		}
	}
	CHECK(crossing > 500);
	CHECK(bounds < 4.0 * offs);
	MotionSnapshot ending = Movement{ 0.5 }.snapshot(0.0);
	ending.knots[2].moving = false;
	MotionCurve curve;
	curve.set(ending);
	CHECK(curve.from_cubic(0.012, curve.at(0.012), 0.018, curve.at(0.018)) < 1e-6);
	CHECK(curve.from_cubic(0.015, curve.at(0.015), 0.025, curve.at(0.025)) == HUGE_VAL);
	CHECK(curve.from_cubic(0.095, curve.at(0.095), 0.105, curve.at(0.105)) == HUGE_VAL);
}

TEST_CASE("outside its knots a snapshot goes on as it began and coasts to a stop, without a step") {
	const MotionSnapshot snapshot = Movement{ 0.35 }.snapshot(0.05);
	for (const double t_s : { snapshot.time_s, snapshot.end_s() }) {
		const MotionPoint before = snapshot.at(t_s - 1e-9), after = snapshot.at(t_s + 1e-9);
		CHECK(after.position == test::near(before.position).epsilon(1e-6));
		CHECK(after.velocity == test::near(before.velocity).epsilon(1e-6));
		CHECK(after.acceleration == test::near(before.acceleration).epsilon(1e-5));
	}
	CHECK(snapshot.at(1e9).velocity == 0.0);
	CHECK(std::abs(snapshot.at(-1e9).position) < 1.0);
	CHECK(MotionSnapshot{}.at(0.0).position == 0.0);
	CHECK_FALSE(MotionSnapshot{}.is_moving(0.0));
	CHECK_FALSE(snapshot.is_moving(NAN));
}

TEST_CASE("a snapshot of one knot goes on from it either way") {
	MotionSnapshot snapshot;
	snapshot.time_s = 1e5;
	snapshot.count = 1;
	snapshot.knots[0] = { .position = 0.5, .velocity = 2.0 };
	CHECK(snapshot.at(1e5).position == 0.5);
	CHECK(snapshot.at(1e5 - 0.01).position == test::near(0.48));
	CHECK(snapshot.at(1e5 + 1.0).position == test::near(0.54));
	for (const double t_s : { -1e300, 0.0, 1e5 - 1e-4, 1e300 }) {
		CHECK(std::abs(snapshot.at(t_s).position - 0.5) < 0.1);
	}
}

TEST_CASE("motion that is not heard of any more is at rest a tenth of a second later, hardly further on") {
	// As far as in a fiftieth of a second: at 2 m/s, fast for a hand, 4 cm.
	const MotionSnapshot snapshot = Movement{ 0.35 }.snapshot(0.05);
	const MotionPoint last = snapshot.at(snapshot.end_s());
	const auto later = [&](double dt_s) { return snapshot.at(snapshot.end_s() + dt_s); };
	CHECK(later(0.01).velocity > 0.5 * last.velocity);
	CHECK(later(0.1).velocity < 0.05 * last.velocity);
	CHECK(later(1.0).position - last.position == test::near(0.02 * last.velocity).epsilon(0.3));
}

TEST_CASE("a snapshot that comes late tells the last frames before it, and nothing of what was long ago") {
	const Movement movement{ 0.8 };
	const MotionSnapshot snapshot = movement.snapshot(0.2);
	CHECK(std::abs(snapshot.at(0.2 - 0.025).position - movement.at(0.2 - 0.025).position) < 1e-3);
	CHECK(snapshot.at(0.2 - 0.05).position == snapshot.at(-10.0).position);
	CHECK(std::abs(snapshot.at(-10.0).position - movement.at(0.2).position) < 0.05);
}

TEST_CASE("before its first knot the motion is what it was without what corrects it there") {
	// A hand at rest, which a frame that has just come puts elsewhere.
	MotionSnapshot snapshot;
	snapshot.time_s = 1.0;
	snapshot.period_s = 0.01;
	snapshot.count = 2;
	snapshot.knots[0] = { .position = 0.5, .acceleration = 40.0, .correction = 40.0 };
	snapshot.knots[1] = { .position = 0.502 };
	for (const double dt_s : { 1e-9, 0.005, 0.011, 0.03, 1.0 }) {
		const MotionPoint motion = snapshot.at(1.0 - dt_s);
		CHECK(motion.own_acceleration() == 0.0);
		CHECK(motion.velocity == 0.0);
		CHECK(motion.position == 0.5);
	}
	// One that speeds up by itself meanwhile.
	snapshot.knots[0].acceleration += 3.0;
	snapshot.knots[1].acceleration = 3.0;
	CHECK(snapshot.at(0.99).own_acceleration() == test::near(3.0));
	CHECK(snapshot.at(0.99).velocity == test::near(-0.03));
	CHECK(snapshot.at(1.005).own_acceleration() == test::near(3.0));
}

TEST_CASE("the instant at which a level is reached is found to the nanosecond") {
	const Movement movement{ 0.14 };
	const MotionSnapshot snapshot = movement.snapshot(0.02);
	CHECK(std::abs(snapshot.reaches_s(0.95, 0.02) - movement.end_s()) < 1e-9);
	CHECK(snapshot.reaches_s(0.0, 0.03) == 0.03);
	CHECK(std::isnan(snapshot.reaches_s(1.5, 0.02)));
	CHECK(std::isnan(MotionSnapshot{}.reaches_s(0.0, 0.0)));
}

TEST_CASE("an arrival is found between instants, once, and is foretold at the same time") {
	const Movement movement{ 0.3 };
	ArrivalDetector detector;
	const double end_s = movement.end_s();
	for (int i = 0; i < 400; ++i) {
		const double t_s = 0.001 * i;
		detector.push(t_s, movement.knot(t_s), 1, 0.2);
		const Arrival expected = detector.expected(movement.snapshot(t_s), t_s);
		CAPTURE(t_s);
		if (t_s < end_s && t_s + 0.1 > end_s) {
			REQUIRE(expected.number == 1);
			REQUIRE(std::abs(expected.time_s - end_s) < 1e-9);
			REQUIRE(expected.speed_m_s == test::near(0.2 * movement.at(end_s).velocity).epsilon(1e-6));
		} else {
			REQUIRE(expected.number == 0);
		}
		REQUIRE(detector.is_moving() == (t_s < end_s));
		REQUIRE(detector.last().number == (t_s < end_s ? 0 : 1));
	}
	CHECK(std::abs(detector.last().time_s - end_s) < 1e-9);
	CHECK(detector.last().speed_m_s == test::near(0.2 * movement.at(end_s).velocity).epsilon(1e-6));
}

TEST_CASE("a condition that holds its frames arrives as fast as the hand that they show") {
	constexpr double SPEED = 5.0; // amplitudes a second
	for (const int held_ms : { 5, 11, 33 }) {
		CAPTURE(held_ms);
		ArrivalDetector detector;
		for (int ms = 0; ms < 400; ++ms) {
			const int frame_ms = ms - ms % held_ms;
			detector.push(
					0.001 * ms, { 0.001 * SPEED * std::max(frame_ms - 100, 0), 0.0, 0.0, true }, 1, 0.2);
		}
		CHECK(detector.last().number == 1);
		CHECK(detector.last().speed_m_s == test::near(0.2 * SPEED).epsilon(1e-6));
	}
}

TEST_CASE("a hand that trembles at the end arrives once; one that goes back by half arrives again") {
	ArrivalDetector detector;
	double t_s = 0.0;
	const auto push = [&](double position, std::uint32_t gesture = 1) {
		detector.push(t_s += 0.01, { position, 0.0, 0.0, true }, gesture, 0.2);
		return detector.last().number;
	};
	CHECK(push(0.99, 0) == 0);
	CHECK(push(0.3) == 0);
	CHECK(detector.is_moving());
	CHECK(push(0.96) == 1);
	CHECK(push(0.9) == 1);
	CHECK(push(0.97) == 1);
	CHECK(push(0.4) == 1);
	CHECK_FALSE(detector.is_moving()); // on its way back
	CHECK(push(1.0) == 2);
	// Broken off, then another begins when it is there already.
	CHECK(push(0.2) == 2);
	CHECK(push(0.2, 0) == 2);
	CHECK_FALSE(detector.is_moving());
	CHECK(push(0.98, 2) == 4);
	// The next follows without a rest.
	CHECK(push(0.1, 3) == 4);
	CHECK(detector.is_moving());
	CHECK(push(0.99, 3) == 5);
	CHECK(push(NAN, 3) == 5);
}

TEST_CASE("a gesture that ends short of the level arrives there and then, once") {
	ArrivalDetector detector;
	const MotionSnapshot::Knot short_of_it{ 0.91, 0.4, 0.0, true };
	detector.push(1.0, short_of_it, 1, 0.2);
	CHECK(detector.last().number == 0);
	detector.push(1.05, { 0.91, 1.0, 0.0, true }, 1, 0.2, true); // will be there within 40 ms
	CHECK(detector.last().number == 0);
	detector.push(1.1, short_of_it, 1, 0.2, true);
	CHECK(detector.last().number == 1);
	CHECK(detector.last().time_s == 1.1);
	CHECK(detector.last().speed_m_s == test::near(0.08));
	CHECK_FALSE(detector.is_moving());
	detector.push(1.2, { 0.96, 0.0, 0.0, true }, 1, 0.2, true);
	// Back, while it is still held to have ended.
	detector.push(1.3, { 0.2, 0.0, 0.0, true }, 1, 0.2, true);
	CHECK(detector.last().number == 1);
	detector.push(1.4, { 0.97, 0.0, 0.0, true }, 1, 0.2, true);
	CHECK(detector.last().number == 2);
}

TEST_CASE("an arrival outlasts another task, and not a clock that begins anew") {
	ArrivalDetector detector;
	const MotionSnapshot::Knot there{ 0.97, 0.0, 0.0, true };
	detector.push(2.0, { 0.5, 1.0, 0.0, true }, 1, 0.2);
	detector.push(2.05, there, 1, 0.2);
	REQUIRE(detector.last().number == 1);
	detector.restart();
	detector.push(2.06, {}, 0, 0.2);
	CHECK(detector.last().number == 1);
	detector.restart();
	detector.push(0.0, {}, 0, 0.2);
	CHECK(detector.last().number == 0);
	detector.push(2.0, { 0.5, 1.0, 0.0, true }, 2, 0.2);
	detector.push(2.05, there, 2, 0.2);
	CHECK(detector.last().number == 2); // who has felt the first waits for a higher one
}

TEST_CASE("the motion's clock shifts by less than a millisecond under the jitter of frames") {
	MotionClock clock;
	std::uint32_t random = 1;
	double told_s = 0.0, from_s = 0.0;
	double least = 1e9, most = -1e9;
	// Blocks of 512 at 44.1 kHz, frames of 60 Hz that come up to 5 ms late.
	for (int block = 0; block < 20000; ++block) {
		const double now_s = block * 512.0 / 44100.0;
		while (told_s + 1.0 / 60.0 < now_s) {
			told_s += 1.0 / 60.0;
			random = random * 1664525U + 1013904223U;
			const double late_s = 0.005 * static_cast<double>(random >> 8U) * 0x1p-24;
			clock.follow(told_s - late_s);
		}
		for (int run = 0; run < 8; ++run) {
			clock.advance(64.0 / 44100.0);
		}
		const double off_s = clock.now_s() - now_s;
		if (block > 1000) {
			from_s = from_s == 0.0 ? off_s : from_s;
			least = std::min(least, off_s);
			most = std::max(most, off_s);
		}
	}
	CHECK(most - least < 2e-3);
}

TEST_CASE("the motion's clock runs at most 2 % off, and steps where it is far off") {
	MotionClock clock;
	clock.follow(100.0);
	CHECK(clock.now_s() == 100.0);
	clock.follow(100.04);
	clock.advance(0.1);
	CHECK(clock.now_s() == test::near(100.102));
	for (int i = 0; i < 3000; ++i) {
		clock.advance(0.001);
	}
	CHECK(clock.now_s() == test::near(103.14).epsilon(1e-4));
	clock.follow(104.0);
	CHECK(clock.now_s() == 104.0);
	clock.follow(103.92); // a frame or two are no pause, five are
	CHECK(clock.now_s() == 103.92);
	clock.follow(103.955);
	CHECK(clock.now_s() == 103.92);
	clock.follow(104.0);
	for (const double bad : { std::numeric_limits<double>::quiet_NaN(), HUGE_VAL }) {
		clock.follow(bad);
		CHECK(clock.now_s() == 104.0);
	}
}

TEST_CASE("in slow motion the motion's clock does not step once it knows how slow that is") {
	MotionClock clock;
	double motion_s = 5.0, greatest_step_s = 0.0, greatest_off_s = 0.0;
	// Frames of 60 Hz, each with its samples; 2 s at a pace, the second of which is looked at.
	for (const double pace : { 1.0, 0.25, 1.0, 2.0, 0.5, 1.0 }) {
		for (int frame = 0; frame < 120; ++frame) {
			const double before_s = clock.now_s();
			clock.follow(motion_s);
			const double off_s = clock.now_s() - motion_s;
			if (frame > 60) {
				greatest_step_s = std::max(greatest_step_s, std::abs(clock.now_s() - before_s));
				greatest_off_s = std::max(greatest_off_s, std::abs(off_s));
			}
			clock.advance(1.0 / 60.0);
			motion_s += pace / 60.0;
		}
	}
	CHECK(greatest_step_s == 0.0);
	CHECK(greatest_off_s < 1e-3);
}

TEST_CASE("the motion's clock goes on at the samples' pace after a leap, and after two") {
	MotionClock clock;
	clock.follow(1.0);
	clock.advance(0.5);
	clock.follow(2.0);
	CHECK(clock.pace() == 1.0);
	clock.advance(0.5);
	clock.follow(2.6);
	CHECK(clock.pace() == 1.0);
	clock.follow(2.7); // no sample later
	clock.follow(2.8);
	CHECK(clock.pace() == 1.0);
}

TEST_CASE("the reader takes the newest value once") {
	LatestValue<int> box;
	CHECK(box.take() == nullptr);
	box.publish(1);
	box.publish(2);
	const int *const taken = box.take();
	REQUIRE(taken != nullptr);
	CHECK(*taken == 2);
	CHECK(box.take() == nullptr);
	box.publish(3);
	CHECK(*taken == 2); // until the next call
	box.publish(4);
	CHECK(*taken == 2);
	CHECK(*box.take() == 4);
}
