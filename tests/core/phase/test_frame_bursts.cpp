// Frames that a link holds up and lets through several at once, stamped as they come.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "phase/frame_bursts.h"
#include "phase/phase_estimator.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace steadyhand;

namespace {

using Frames = std::vector<FrameBursts::Frame>;

/// Of a camera of 120 Hz, let through every 33 ms, half a millisecond apart.
Frames bursts_of(const test::Drag &drag, double until_s, unsigned seed) {
	constexpr int AT_ONCE = 4;
	std::mt19937_64 random(seed);
	std::normal_distribution<double> trembling(0.0, 5e-4);
	Frames frames;
	for (int burst = 0; burst * AT_ONCE / 120.0 < until_s; ++burst) {
		for (int i = 0; i < AT_ONCE; ++i) {
			const double seen_s = (burst * AT_ONCE + i) / 120.0;
			const double comes_s = ((burst + 1) * AT_ONCE - 1) / 120.0 + 5e-4 * i;
			frames.push_back({ comes_s, drag.x_m(seen_s) + trembling(random) });
		}
	}
	return frames;
}

/// Root mean square of the estimate's error over the gesture and 0.2 s after it.
double error(const test::Drag &drag, const Frames &frames) {
	PhaseEstimator estimator(test::drag_model());
	std::size_t next = 0;
	double squared = 0.0;
	int count = 0;
	for (int ms = 0; ms * 1e-3 < drag.onset_s + drag.duration_s + 0.2; ++ms) {
		const double t_s = 1e-3 * ms;
		for (; next < frames.size() && frames[next].t_s <= t_s; ++next) {
			estimator.push(frames[next].t_s, frames[next].x);
		}
		estimator.release(t_s);
		if (t_s > drag.onset_s) {
			squared += std::pow(estimator.at(t_s).value - drag.x_m(t_s), 2);
			++count;
		}
	}
	return std::sqrt(squared / count);
}

} // namespace

TEST_CASE("once frames have come in bursts, the newest of each is used, when no other can be of the same") {
	FrameBursts bursts;
	CHECK_FALSE(bursts.holds({ 1.0, 0.1 }, 0.98));
	CHECK_FALSE(bursts.holds({ 1.001, 0.2 }, 1.0)); // passed over, and known from now on
	CHECK(bursts.holds({ 1.03, 0.3 }, 1.0));
	CHECK(bursts.due_s() == test::near(1.0335));
	CHECK(bursts.holds({ 1.031, 0.4 }, 1.0));
	CHECK(bursts.due_s() == test::near(1.0335));
	const FrameBursts::Frame newest = bursts.take();
	CHECK(newest.t_s == 1.031);
	CHECK(newest.x == 0.4);
	CHECK_FALSE(bursts.is_holding());
	// A second without: as any tracker again.
	CHECK(bursts.holds({ 1.06, 0.5 }, 1.031));
	CHECK(bursts.take().x == 0.5);
	CHECK_FALSE(bursts.holds({ 2.04, 0.6 }, 2.02));
}

TEST_CASE("a fast sensor, one whose frames are told twice, and one that is late once hold nothing") {
	for (const double period_s : { 1e-4, 1e-3, 4e-3, 0.011 }) {
		CAPTURE(period_s);
		FrameBursts bursts;
		double used_s = -1.0;
		for (int frame = 0; frame < 2000; ++frame) {
			const double t_s = frame * period_s;
			for (int time = 0; time < 2; ++time) {
				REQUIRE_FALSE(bursts.holds({ t_s, 1e-3 * frame }, used_s));
				used_s = t_s - used_s >= LEAST_FRAME_S ? t_s : used_s;
			}
		}
	}
}

TEST_CASE("frames in bursts are worth as much as the newest of each" * doctest::test_suite("figures")) {
	double all = 0.0, newest = 0.0, oldest = 0.0;
	for (const double duration_s : { 0.3, 0.5, 0.8 }) {
		for (unsigned seed = 1; seed <= 10; ++seed) {
			const test::Drag drag{
				.onset_s = 1.2 + 0.0033 * seed, .duration_s = duration_s, .amplitude_m = 1.0
			};
			const Frames frames = bursts_of(drag, 2.5, seed);
			Frames last, first;
			for (std::size_t i = 0; i < frames.size(); i += 4) {
				first.push_back(frames[i]);
				last.push_back(frames[i + 3]);
			}
			all += error(drag, frames);
			newest += error(drag, last);
			oldest += error(drag, first);
		}
	}
	CHECK(all < 1.1 * newest);
	CHECK(all < 0.7 * oldest);
}
