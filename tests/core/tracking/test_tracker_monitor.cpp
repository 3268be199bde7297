#include "moving_hand.h"
#include "near.h"
#include "signal/minimum_jerk.h"
#include "tracking/tracker_monitor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace steadyhand;
using Eigen::Vector3d;
using test::MovingHand;
using test::near;

namespace {

constexpr double RATES_HZ[] = { 30.0, 60.0, 90.0, 120.0, 240.0 };

/// Frames of `hand` from 0 to until_s.
TrackerMonitor watched(const MovingHand &hand, double until_s, std::uint64_t seed = 1) {
	Random random(seed);
	TrackerMonitor monitor;
	for (int i = 0; i / hand.rate_hz <= until_s; ++i) {
		monitor.push(i / hand.rate_hz, hand.seen(i / hand.rate_hz, random));
	}
	return monitor;
}

std::uint64_t all_faults(const TrackerMonitor &monitor) {
	const TrackerFaults &faults = monitor.faults();
	return faults.dropouts + faults.freezes + faults.jumps;
}

} // namespace

TEST_CASE("noise of a moving hand is measured within 16 frames") {
	for (const double rate_hz : RATES_HZ) {
		for (const double noise_m : { 0.05e-3, 0.2e-3, 2e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(noise_m);
			constexpr int RUNS = 60;
			double sum = 0.0;
			int near_enough = 0;
			for (int run = 0; run < RUNS; ++run) {
				const MovingHand hand{
					.duration_s = 0.9, .rest_s = 0.0, .rate_hz = rate_hz, .noise_m = noise_m
				};
				const double measured_m =
						watched(hand, 15.5 / rate_hz, static_cast<std::uint64_t>(run)).noise_m();
				sum += measured_m / noise_m;
				near_enough += std::abs(measured_m / noise_m - 1.0) < 0.4 ? 1 : 0;
			}
			CHECK(sum / RUNS == near(1.0).epsilon(0.2));
			CHECK(near_enough >= RUNS * 9 / 10);
		}
	}
}

TEST_CASE("a hand without noise is measured without noise") {
	for (const double rate_hz : { 60.0, 120.0, 240.0 }) {
		const MovingHand hand{ .duration_s = 0.9, .rest_s = 0.0, .rate_hz = rate_hz };
		CHECK(watched(hand, 2.0).noise_m() < 1e-5);
	}
}

TEST_CASE("a repeated stamp of a hand without noise is no fault") {
	for (const double rate_hz : RATES_HZ) {
		CAPTURE(rate_hz);
		TrackerMonitor monitor;
		const auto tip = [](double t_s) { return Vector3d(0.2 * minimum_jerk(t_s / 0.5).value, 0.1, 0.0); };
		for (int i = 0; i < 3.0 * rate_hz; ++i) {
			const double t_s = i / rate_hz;
			const Vector3d moved = t_s < 1.5 ? tip(t_s) : tip(2.0 - t_s);
			CHECK(monitor.push(t_s, moved).status != MeasurementStatus::OUTLIER);
			if (i == static_cast<int>(rate_hz)) {
				monitor.push(t_s, moved);
			}
		}
		CHECK(all_faults(monitor) == 0);
	}
}

TEST_CASE("rounding counts as noise") {
	for (const double rounding_m : { 1e-3, 0.1e-3 }) {
		for (const double noise_m : { 0.0, 0.2e-3 }) {
			const MovingHand hand{ .rest_s = 0.0, .noise_m = noise_m, .rounding_m = rounding_m };
			const TrackerMonitor monitor = watched(hand, 3.3);
			CHECK(monitor.noise_m() >= rounding_m / std::sqrt(12.0));
		}
	}
}

TEST_CASE("a tracker without faults has none at any rate and noise") {
	for (const double rate_hz : RATES_HZ) {
		for (const double noise_m : { 0.0, 0.1e-3, 1e-3 }) {
			for (const double amplitude_m : { 0.02, 0.2, 0.4 }) {
				CAPTURE(rate_hz);
				CAPTURE(noise_m);
				CAPTURE(amplitude_m);
				const MovingHand hand{
					.amplitude_m = amplitude_m, .duration_s = 0.35, .rate_hz = rate_hz, .noise_m = noise_m
				};
				const TrackerMonitor monitor = watched(hand, 20.0);
				CHECK(all_faults(monitor) == 0);
				CHECK(monitor.period_s() == near(1.0 / rate_hz).epsilon(1e-6));
			}
		}
	}
}

TEST_CASE("a camera read faster than its frame rate has no fault") {
	for (const double polled_hz : { 90.0, 144.0, 1000.0 }) {
		Random random(3);
		const MovingHand hand{ .rate_hz = 30.0, .noise_m = 0.1e-3 };
		TrackerMonitor monitor;
		int new_readings = 0;
		Vector3d seen = hand.seen(0.0, random);
		double looked_s = 0.0;
		for (double t_s = 0.0; t_s < 10.0; t_s += 1.0 / polled_hz) {
			if (t_s - looked_s > 1.0 / 30.0) {
				looked_s += 1.0 / 30.0;
				seen = hand.seen(looked_s, random);
			}
			new_readings += monitor.push(t_s, seen).is_new() ? 1 : 0;
		}
		CHECK(new_readings == 300);
		CHECK(all_faults(monitor) == 0);
		CHECK(monitor.period_s() == near(1.0 / 30.0).epsilon(0.1));
	}
}

TEST_CASE("frames in bursts are no dropouts and no jumps") {
	Random random(5);
	const MovingHand hand{ .noise_m = 0.1e-3 };
	TrackerMonitor monitor;
	for (int i = 0; i < 1000; ++i) {
		const double burst_s = 0.04 * (i / 4 + 1);
		monitor.push(burst_s + 10e-6 * (i % 4), hand.seen(0.01 * i, random));
	}
	CHECK(all_faults(monitor) == 0);
}

TEST_CASE("the last frame of a burst replaces those before it") {
	constexpr int FRAMES = 4;
	constexpr double SPACING_S = 10e-6;
	for (const bool has_outlier : { false, true }) {
		CAPTURE(has_outlier);
		Random random(5);
		const MovingHand hand{ .noise_m = 0.1e-3 };
		TrackerMonitor monitor;
		int used = 0;
		Measurement kept;
		for (int i = 0; i < 1000; ++i) {
			const bool is_other = has_outlier && i > 100 && i % 100 == 2;
			const Vector3d other_m = is_other ? Vector3d(0.0, 0.0, 0.5) : Vector3d::Zero();
			const double stamp_s = 0.01 * (i - i % FRAMES + FRAMES - 1) + SPACING_S * (i % FRAMES);
			const Measurement measurement = monitor.push(stamp_s, hand.seen(0.01 * i, random) + other_m);
			CHECK(measurement.is_usable() == !is_other);
			CHECK(measurement.replaces_last == (i % FRAMES > 0 && !is_other));
			used += measurement.is_usable() ? 1 - static_cast<int>(measurement.replaces_last) : 0;
			kept = measurement.is_usable() ? measurement : kept;
			if (i % FRAMES == FRAMES - 1) {
				// The position is that of the time stamp, not of 10 to 30 ms before: a hand at 0.6 m/s moves
				// 18 mm.
				CHECK((kept.position_m - hand.at(kept.t_s)).norm() < 1e-3);
			}
		}
		CHECK(used == 1000 / FRAMES);
	}
}

TEST_CASE("no frame of a camera of up to 240 Hz replaces another") {
	for (const double rate_hz : RATES_HZ) {
		Random random(6);
		const MovingHand hand{ .rate_hz = rate_hz, .noise_m = 0.1e-3 };
		TrackerMonitor monitor;
		for (int i = 0; i < 1000; ++i) {
			CHECK_FALSE(monitor.push(i / rate_hz, hand.seen(i / rate_hz, random)).replaces_last);
		}
	}
}

TEST_CASE("a clock reset restarts the monitor with at most one fault") {
	for (const double step_s : { 200000.0, -10.0 }) {
		Random random(5);
		const MovingHand hand{ .noise_m = 0.1e-3 };
		TrackerMonitor monitor;
		for (int i = 0; i < 400; ++i) {
			const double t_s = 100.0 + 0.01 * i + (i < 200 ? 0.0 : step_s);
			const Measurement measurement = monitor.push(t_s, hand.seen(0.01 * i, random));
			CHECK(std::isfinite(measurement.outlier_probability));
			CHECK(measurement.status != MeasurementStatus::OUTLIER);
		}
		CHECK(all_faults(monitor) <= 1);
		CHECK(monitor.noise_m() == near(0.1e-3).epsilon(0.5));
	}
}

TEST_CASE("a frame is overdue after 3.5 periods and 30 ms") {
	const TrackerMonitor fast = watched({ .rate_hz = 240.0 }, 1.0);
	CHECK_FALSE(fast.is_overdue(1.0 + 0.029));
	CHECK(fast.is_overdue(1.0 + 0.031));
	const TrackerMonitor slow = watched({ .rate_hz = 30.0 }, 1.0);
	CHECK_FALSE(slow.is_overdue(1.0 + 0.115));
	CHECK(slow.is_overdue(1.0 + 0.118));
	CHECK_FALSE(TrackerMonitor().is_overdue(1e9));
}

TEST_CASE("impossible positions and times give finite results") {
	for (const double far_m : { 1e-9, 1.0, 1e9 }) {
		for (const double step_s : { 0.0, 1e-12, 0.01, 3600.0 }) {
			Random random(8);
			TrackerMonitor monitor;
			double t_s = 0.0;
			for (int i = 0; i < 3000; ++i) {
				// Pairs of equal time stamps; two positions in the first half, then noise.
				t_s += step_s * (i % 2);
				const Vector3d place_m = i < 1500 ? Vector3d(i % 3 == 0 ? far_m : 0.1, 0.0, -0.3)
												  : Vector3d(far_m * random.normal(), far_m * (i % 5), 0.0);
				const Measurement measurement = monitor.push(t_s, place_m);
				for (const double number : { measurement.noise_m, measurement.outlier_probability,
							 measurement.gap_s, monitor.period_s() }) {
					REQUIRE(std::isfinite(number));
				}
			}
		}
	}
}
