#include "minimum_jerk_drag.h"
#include "motion/gesture_recogniser.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace steadyhand;

namespace {

constexpr std::array SOURCES{ MotionSource::SYNTHESISED, MotionSource::MEASURED, MotionSource::AVERAGE,
	MotionSource::ONE_EURO, MotionSource::KALMAN };

GestureRecogniser recogniser() {
	static const auto model = std::make_shared<const GestureModel>(test::trained_drag_model());
	return GestureRecogniser({ model }, Task{});
}

using Row = std::array<double, SOURCES.size()>;

/// Every condition's value each `step_ms` up to end_s.
std::vector<Row> play(const Track &track, double end_s, int step_ms = 1) {
	GestureRecogniser hmm = recogniser();
	std::vector<Row> rows;
	std::size_t next = 0;
	for (int ms = 0; ms <= static_cast<int>(end_s * 1000.0); ms += step_ms) {
		const double t_s = ms / 1000.0;
		while (next < track.frames.size() && track.frames[next].t_s <= t_s) {
			hmm.push(track.frames[next++]);
		}
		hmm.advance(t_s);
		Row &row = rows.emplace_back();
		for (std::size_t i = 0; i < SOURCES.size(); ++i) {
			row[i] = hmm.motion(SOURCES[i]).value_m;
		}
	}
	return rows;
}

Track shaky_drag() {
	Track track = test::drag_track({ .onset_s = 0.5, .duration_s = 1.1, .amplitude_m = 0.2 }, 97.0, 2.5);
	std::mt19937_64 random(3);
	std::normal_distribution<double> noise(0.0, 0.003);
	for (HandFrame &frame : track.frames) {
		frame.set(Joint::INDEX, frame.position(Joint::INDEX) + Eigen::Vector3d(noise(random), 0.0, 0.0));
	}
	track.frames.erase(track.frames.begin() + 80, track.frames.begin() + 95);
	return track;
}

} // namespace

TEST_CASE("a clean drag is followed from its start to its end") {
	const test::Drag drag{ .onset_s = 0.5, .duration_s = 1.0, .amplitude_m = 0.2 };
	const std::vector<Row> rows = play(test::drag_track(drag, 110.0, 2.5), 2.4);
	double largest = 0.0, largest_step = 0.0;
	for (std::size_t ms = 0; ms < rows.size(); ++ms) {
		largest = std::max(largest, std::abs(rows[ms][0] - drag.x_m(static_cast<double>(ms) / 1000.0)));
		largest_step = ms > 0 ? std::max(largest_step, std::abs(rows[ms][0] - rows[ms - 1][0])) : 0.0;
	}
	CHECK(largest < 0.02); // a tenth of the way
	CHECK(largest_step < 0.008); // the start is spotted at 3 % of the way; nothing else steps
	CHECK(rows.back()[0] == doctest::Approx(0.2).epsilon(0.01));
}

TEST_CASE("what is put out before a cut does not depend on what comes after it") {
	const Track whole = shaky_drag();
	const std::vector<Row> expected = play(whole, 2.4);
	std::mt19937_64 random(4);
	for (int round = 0; round < 20; ++round) {
		const double cut_s = std::uniform_real_distribution<double>(0.0, 2.4)(random);
		Track cut = whole;
		std::erase_if(cut.frames, [&](const HandFrame &frame) { return frame.t_s > cut_s; });
		const std::vector<Row> rows = play(cut, cut_s);
		for (std::size_t ms = 0; ms < rows.size(); ++ms) {
			REQUIRE(rows[ms] == expected[ms]); // to the last bit
		}
	}
}

TEST_CASE("the motion does not depend on how often it is asked for") {
	const Track track = shaky_drag();
	const std::vector<Row> fine = play(track, 2.4, 1);
	const std::vector<Row> coarse = play(track, 2.4, 8);
	for (std::size_t i = 0; i < coarse.size(); ++i) {
		REQUIRE(coarse[i] == fine[8 * i]);
	}
}

TEST_CASE("the synthesised velocity and acceleration are the value's derivatives") {
	GestureRecogniser hmm = recogniser();
	const Track track = test::drag_track({}, 110.0, 2.0);
	std::size_t next = 0;
	const double h = 1e-5;
	int compared = 0;
	for (int tick = 0; tick < 200; ++tick) {
		// Between two symbols nothing changes, so that the derivative can be taken there.
		const double t_s = 0.004 + 0.01 * tick;
		while (next < track.frames.size() && track.frames[next].t_s <= t_s) {
			hmm.push(track.frames[next++]);
		}
		hmm.advance(t_s);
		const Motion before = hmm.motion(MotionSource::SYNTHESISED);
		hmm.advance(t_s + h);
		const Motion after = hmm.motion(MotionSource::SYNTHESISED);
		if (before.progress > 0.05 && after.progress < 0.99 && after.velocity_m_s > 0.0) {
			CHECK((after.value_m - before.value_m) / h == doctest::Approx(before.velocity_m_s).epsilon(1e-3));
			CHECK(std::abs((after.velocity_m_s - before.velocity_m_s) / h - before.acceleration_m_s2) < 0.01);
			++compared;
		}
	}
	CHECK(compared > 50);
}

TEST_CASE("a hand at rest makes no gesture, and one that only twitches is let go") {
	CHECK(play(test::drag_track({ .onset_s = 1e9 }, 110.0, 5.0), 5.0).back()[0] == 0.0);
	Track twitch = test::drag_track({ .onset_s = 0.5, .duration_s = 0.2, .amplitude_m = 0.015 }, 110.0, 4.0);
	CHECK(play(twitch, 3.9).back()[0] == 0.0);
}

TEST_CASE("ten drags in a row are ten gestures") {
	GestureRecogniser hmm = recogniser();
	int arrivals = 0;
	auto stage = GestureFollower::Stage::RESTING;
	for (int ms = 0; ms < 30000; ms += 5) {
		const double t_s = ms / 1000.0;
		const double in_cycle = std::fmod(t_s, 3.0);
		const double out = test::Drag{ .onset_s = 0.3 }.x_m(in_cycle), back = test::Drag{ .onset_s = 1.8 }.x_m(in_cycle);
		HandFrame frame;
		frame.t_s = t_s;
		frame.set(Joint::INDEX, { out - back, 0.0, 0.0 });
		hmm.push(frame);
		const auto now = hmm.follower() != nullptr ? hmm.follower()->stage() : GestureFollower::Stage::RESTING;
		arrivals += now == GestureFollower::Stage::ARRIVED && stage != now;
		stage = now;
	}
	CHECK(arrivals == 10);
}

TEST_CASE("broken input leaves every output a number") {
	const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
	GestureRecogniser hmm = recogniser();
	double t_s = 0.0;
	for (const double x_m : { 0.0, nan, 1e9, -1e9, infinity, 1e-9, 0.1, nan, 0.2 }) {
		for (const double t : { t_s, t_s - 1.0, nan, infinity }) {
			HandFrame frame;
			frame.t_s = t;
			frame.set(Joint::INDEX, { x_m, 0.0, 0.0 });
			hmm.push(frame);
			for (const MotionSource source : SOURCES) {
				CHECK(std::isfinite(hmm.motion(source).value_m));
			}
		}
		t_s += 0.01;
	}
	hmm.advance(t_s + 3600.0);
	CHECK(std::isfinite(hmm.motion(MotionSource::SYNTHESISED).value_m));
	CHECK(GestureRecogniser({}, std::nullopt).motion(MotionSource::SYNTHESISED).value_m == 0.0);
}
