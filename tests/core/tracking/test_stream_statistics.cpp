#include "base/random.h"
#include "moving_hand.h"
#include "tracking/stream_statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;

namespace {

HandFrame frame_at(double t_s) {
	HandFrame frame;
	frame.t_s = t_s;
	frame.set(Joint::INDEX, Eigen::Vector3d::UnitX());
	return frame;
}

} // namespace

TEST_CASE("dropouts do not change the measured frame rate") {
	for (const double rate_hz : { 10.0, 60.0, 110.6, 240.0 }) {
		StreamStatistics statistics;
		for (int i = 0; i < 400; ++i) {
			if (i % 50 != 7) {
				statistics.add(frame_at(i / rate_hz));
			}
		}
		CHECK(statistics.rate_hz() == doctest::Approx(rate_hz).epsilon(1e-6));
	}
}

TEST_CASE("few frames have no statistics") {
	StreamStatistics statistics;
	statistics.add(frame_at(0.0));
	statistics.add(frame_at(0.01));
	CHECK(statistics.rate_hz() == 0.0);
	CHECK(statistics.jitter_s() == 0.0);
}

TEST_CASE("jitter is the median deviation of the intervals") {
	std::mt19937 random(4);
	std::normal_distribution<double> normal(0.0, 0.0005);
	StreamStatistics statistics;
	double t_s = 0.0;
	for (int i = 0; i < 2000; ++i) {
		t_s += 0.01 + normal(random);
		statistics.add(frame_at(t_s));
	}
	// The median absolute deviation of a normal distribution is 0.6745 standard deviations.
	CHECK(statistics.jitter_s() == doctest::Approx(0.6745 * 0.0005).epsilon(0.25));
}

TEST_CASE("empty frames and silence are one dropout of the index tip each") {
	StreamStatistics statistics;
	Random random(2);
	const test::MovingHand hand{ .noise_m = 0.2e-3 };
	double t_s = 0.0;
	const auto run = [&](int frames, bool is_tracked) {
		for (int i = 0; i < frames; ++i) {
			HandFrame frame;
			frame.t_s = t_s += 0.01;
			if (is_tracked) {
				frame.set(Joint::THUMB, Eigen::Vector3d::UnitX());
				frame.set(Joint::INDEX, hand.seen(t_s, random));
			}
			statistics.add(frame);
		}
	};
	const auto dropouts = [&] { return statistics.monitor().faults().dropouts; };
	CHECK_FALSE(statistics.monitor().is_noise_known());
	run(100, true);
	CHECK(statistics.monitor().noise_m() == doctest::Approx(0.2e-3).epsilon(0.4));
	CHECK(statistics.monitor().period_s() == doctest::Approx(0.01));
	run(20, false);
	run(100, true);
	CHECK(dropouts() == 1);
	t_s += 0.3;
	run(100, true);
	CHECK(dropouts() == 2);
	run(5, false);
	t_s += 0.5;
	run(5, true);
	CHECK(dropouts() == 3);
}

TEST_CASE("a tracker without an index tip is judged by the joint that it has") {
	StreamStatistics statistics;
	for (int i = 0; i < 100; ++i) {
		HandFrame frame;
		frame.t_s = 0.01 * i;
		frame.set(Joint::PALM, { 0.3 * std::sin(0.05 * i), 0.0, i == 50 ? 0.6 : 0.1 });
		statistics.add(frame);
	}
	CHECK(statistics.monitor().faults().jumps == 1);
}
