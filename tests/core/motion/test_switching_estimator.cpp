#include "allocations.h"
#include "monitored_estimator.h"
#include "signal/minimum_jerk.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace steadyhand;

// Positions are in amplitudes of 20 cm.

namespace {

struct Reading {
	double t_s, x;
};

using Path = std::function<double(double t_s)>; ///< of a hand

/// Readings of a tracker whose first frame comes after 0.37 periods. noise: standard deviation.
std::vector<Reading> readings(const Path &hand, double rate_hz, double length_s, double noise = 0.0) {
	std::mt19937_64 random(7);
	std::normal_distribution<double> normal;
	std::vector<Reading> all;
	for (int i = 0; (i + 0.37) / rate_hz < length_s; ++i) {
		const double t_s = (i + 0.37) / rate_hz;
		all.push_back({ t_s, hand(t_s) + noise * normal(random) });
	}
	return all;
}

/// The output at each ms until length_s; begin_s is added to all times.
std::vector<MotionEstimate> replay(const std::vector<Reading> &readings, double length_s,
		double begin_s = 0.0, std::size_t hypotheses = DEFAULT_HYPOTHESES) {
	test::MonitoredEstimator estimator(test::drag_model(), hypotheses);
	std::vector<MotionEstimate> out;
	auto next = readings.begin();
	for (int ms = 0; ms < length_s * 1000.0; ++ms) {
		const double t_s = ms / 1000.0;
		for (; next != readings.end() && next->t_s <= t_s; ++next) {
			estimator.push(begin_s + next->t_s, next->x);
		}
		estimator.wait(begin_s + t_s);
		out.push_back(estimator.at(begin_s + t_s));
	}
	return out;
}

Path drag(double onset_s = 0.5, double duration_s = 0.8) {
	const test::Drag drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = 1.0 };
	return [drag](double t_s) { return drag.x_m(t_s); };
}

Path stopped_at(double stop_s) {
	return [stop_s, moves = drag()](double t_s) { return moves(std::min(t_s, stop_s)); };
}

/// A drag with a dropout of 0.15 s, and its return with a jump. At this rate no frame coincides with a birth,
/// where rounding would decide the order.
std::vector<Reading> faulty_readings() {
	std::vector<Reading> all =
			readings([there = drag(), back = drag(2.0, 0.6)](double t_s) { return there(t_s) - back(t_s); },
					97.0, 3.5, 2e-3);
	std::erase_if(all, [](const Reading &reading) { return reading.t_s > 0.8 && reading.t_s < 0.95; });
	for (Reading &reading : all) {
		reading.x += reading.t_s > 2.2 && reading.t_s < 2.23 ? 0.4 : 0.0;
	}
	return all;
}

bool same_bits(const MotionEstimate &a, const MotionEstimate &b) {
	return a.value == b.value && a.velocity == b.velocity && a.acceleration == b.acceleration &&
			a.phase == b.phase && a.gesture == b.gesture && a.hold == b.hold && a.correction == b.correction;
}

bool is_finite(const MotionEstimate &estimate) {
	return std::isfinite(estimate.value) && std::isfinite(estimate.velocity) &&
			std::isfinite(estimate.acceleration) && std::isfinite(estimate.phase) &&
			std::isfinite(estimate.gesture) && std::isfinite(estimate.hold) &&
			std::isfinite(estimate.correction);
}

/// Time from which on the value stays at 0.95 or more.
double end_s(const std::vector<MotionEstimate> &out) {
	std::size_t ms = out.size();
	while (ms > 0 && out[ms - 1].value >= 0.95) {
		--ms;
	}
	return static_cast<double>(ms) / 1000.0;
}

} // namespace

TEST_CASE("calls of at() change no bit of the motion") {
	test::MonitoredEstimator watched(test::drag_model()), unwatched(test::drag_model());
	for (const Reading &reading : faulty_readings()) {
		for (int i = 0; i < 5; ++i) {
			static_cast<void>(watched.at(reading.t_s + 0.01 * i));
		}
		watched.push(reading.t_s, reading.x);
		unwatched.push(reading.t_s, reading.x);
		CHECK(same_bits(watched.at(reading.t_s + 0.005), unwatched.at(reading.t_s + 0.005)));
	}
}

TEST_CASE("stamps 1e5 s later give the same motion within 1e-6") {
	const std::vector<Reading> all = faulty_readings();
	const std::vector<MotionEstimate> now = replay(all, 3.5), later = replay(all, 3.5, 1e5);
	double largest = 0.0;
	for (std::size_t i = 0; i < now.size(); ++i) {
		largest = std::max(largest, std::abs(now[i].value - later[i].value));
	}
	CHECK(largest < 1e-6);
}

TEST_CASE("value and velocity do not step at a reading") {
	test::MonitoredEstimator estimator(test::drag_model());
	for (const Reading &reading : faulty_readings()) {
		const MotionEstimate before = estimator.at(reading.t_s);
		estimator.push(reading.t_s, reading.x);
		const MotionEstimate after = estimator.at(reading.t_s);
		if (reading.t_s > 0.1) { // the motion steps to the first reading
			CHECK(std::abs(after.value - before.value) < 1e-9);
			CHECK(std::abs(after.velocity - before.velocity) < 1e-7);
		}
	}
}

TEST_CASE("between readings velocity and acceleration are the value's derivatives") {
	constexpr double STEP_S = 1e-6;
	test::MonitoredEstimator estimator(test::drag_model());
	for (const Reading &reading : faulty_readings()) {
		estimator.push(reading.t_s, reading.x);
		for (const double later_s : { 0.001, 0.004, 0.008 }) {
			const double t_s = reading.t_s + later_s;
			CAPTURE(t_s);
			const MotionEstimate before = estimator.at(t_s - STEP_S), now = estimator.at(t_s),
								 after = estimator.at(t_s + STEP_S);
			CHECK(std::abs(now.velocity - (after.value - before.value) / (2.0 * STEP_S)) < 1e-3);
			CHECK(std::abs(now.acceleration - (after.velocity - before.velocity) / (2.0 * STEP_S)) < 0.1);
		}
	}
}

TEST_CASE("the motion is finite at any rate and amplitude") {
	for (const double rate_hz : { 1.0, 15.0, 120.0, 10000.0 }) {
		for (const double scale : { 0.0, 1e-9, 1.0, 1e6, 1e9 }) {
			INFO("rate ", rate_hz, ", scale ", scale);
			test::MonitoredEstimator estimator(test::drag_model());
			bool all_finite = true;
			for (const Reading &reading : readings(drag(), rate_hz, rate_hz > 1000.0 ? 2.0 : 10.0, 1e-3)) {
				estimator.push(reading.t_s, scale * reading.x);
				all_finite = all_finite && is_finite(estimator.at(reading.t_s + 0.5 / rate_hz));
			}
			CHECK(all_finite);
		}
	}
}

TEST_CASE("the motion is finite if stamps are equal or an hour apart") {
	test::MonitoredEstimator estimator(test::drag_model());
	for (const Reading &reading : readings(drag(), 60.0, 3.0, 1e-3)) {
		for (int i = 0; i < 3; ++i) {
			estimator.push(reading.t_s, reading.x + 0.1 * i);
			CHECK(is_finite(estimator.at(reading.t_s)));
		}
	}
	for (int i = 1; i < 10; ++i) {
		estimator.push(3600.0 * i, 0.1 * i);
		CHECK(is_finite(estimator.at(3600.0 * i + 1800.0)));
	}
}

TEST_CASE("a reset estimator puts out the same bits as a new one") {
	SwitchingEstimator used(test::drag_model(), 0.2), fresh(test::drag_model(), 0.2);
	for (int i = 0; i < 100; ++i) {
		used.push({ .t_s = 0.01 * i, .noise_m = 1e-4 }, 1e9 * i);
	}
	used.reset();
	for (const Reading &reading : readings(drag(), 90.0, 2.0, 1e-3)) {
		const Measurement measurement{ .t_s = reading.t_s, .noise_m = 1e-4 };
		used.push(measurement, reading.x);
		fresh.push(measurement, reading.x);
		CHECK(same_bits(used.at(reading.t_s), fresh.at(reading.t_s)));
	}
}

TEST_CASE("an estimator allocates nothing after construction") {
	for (const Quality quality : { Quality::FAST, Quality::BALANCED, Quality::ACCURATE }) {
		test::MonitoredEstimator estimator(test::drag_model(), hypotheses_of(quality));
		const std::vector<Reading> all = faulty_readings();
		double sum = 0.0;
		const std::size_t allocated = test::allocations_of([&] {
			for (const Reading &reading : all) {
				estimator.push(reading.t_s, reading.x);
				sum += estimator.at(reading.t_s + 0.003).value;
			}
		});
		CHECK(allocated == 0);
		CHECK(sum > 0.0);
	}
}

TEST_CASE("a minimum-jerk hand without noise is followed within 1 %") {
	for (const double rate_hz : { 60.0, 90.0, 120.0 }) {
		for (const double duration_s : { 0.8, 1.2, 2.0 }) {
			INFO("rate ", rate_hz, ", duration ", duration_s);
			const Path hand = drag(0.5, duration_s);
			const std::vector<MotionEstimate> out = replay(readings(hand, rate_hz, 3.5), 3.5);
			double square = 0.0;
			int count = 0;
			for (int ms = 500; ms < 500 + static_cast<int>(1000.0 * duration_s); ++ms, ++count) {
				square += std::pow(out[static_cast<std::size_t>(ms)].value - hand(ms / 1000.0), 2);
			}
			CHECK(std::sqrt(square / count) < 0.01);
		}
	}
}

TEST_CASE("a noiseless dead stop is held within 2 % after 0.3 s") {
	for (const double rate_hz : { 30.0, 60.0, 90.0, 120.0 }) {
		for (const double share : { 0.25, 0.5, 0.75 }) { // of the amplitude
			INFO("rate ", rate_hz, ", share ", share);
			const double stop_s = 0.5 + 0.8 * minimum_jerk_share(share);
			const std::vector<MotionEstimate> out =
					replay(readings(stopped_at(stop_s), rate_hz, stop_s + 2.0), stop_s + 2.0);
			double furthest = 0.0;
			for (auto i = static_cast<std::size_t>(1000.0 * (stop_s + 0.3)); i < out.size(); ++i) {
				furthest = std::max(furthest, std::abs(out[i].value - share));
			}
			CHECK(furthest < 0.02);
		}
	}
}

TEST_CASE("a dropout of 0.1 s shifts the end by under 30 ms") {
	for (const double rate_hz : { 60.0, 120.0 }) {
		for (const double duration_s : { 0.5, 0.8, 1.2 }) {
			for (const double lost_from : { 0.3, 0.5, 0.7 }) { // shares of the duration
				INFO("rate ", rate_hz, ", duration ", duration_s, ", lost from ", lost_from);
				const Path hand = drag(0.5, duration_s);
				std::vector<Reading> seen = readings(hand, rate_hz, 3.0, 1e-3);
				const double lost_s = 0.5 + lost_from * duration_s;
				std::erase_if(seen, [&](const Reading &reading) {
					return reading.t_s > lost_s && reading.t_s < lost_s + 0.1;
				});
				const double truth_s = 0.5 + duration_s * minimum_jerk_share(0.95);
				CHECK(std::abs(end_s(replay(seen, 3.0)) - truth_s) < 0.03);
			}
		}
	}
}

TEST_CASE("a late tracker is corrected after a fault, however long the hand rested before") {
	constexpr double DURATION_S = 0.9, LAG_S = 0.09;
	for (const double rest_s : { 1.0, 10.0, 60.0 }) {
		for (const double lost_from : { 0.3, 0.5 }) { // shares of the duration
			INFO("rest ", rest_s, ", lost from ", lost_from);
			const Path hand = drag(rest_s, DURATION_S);
			const Path late = [&](double t_s) { return hand(t_s - LAG_S * hand(t_s)); };
			const double lost_s = rest_s + lost_from * DURATION_S, found_s = lost_s + 0.2;
			const double length_s = rest_s + DURATION_S;
			std::vector<Reading> seen = readings(late, 90.0, length_s, 1e-3);
			std::erase_if(seen,
					[&](const Reading &reading) { return reading.t_s > lost_s && reading.t_s < found_s; });
			const std::vector<MotionEstimate> out = replay(seen, length_s, 0.0, MOST_HYPOTHESES);
			double shown = 0.0, measured = 0.0; // sums of squared errors
			for (auto ms = static_cast<std::size_t>(1000.0 * found_s); ms < out.size(); ++ms) {
				const double t_s = static_cast<double>(ms) / 1000.0;
				shown += std::pow(out[ms].value - hand(t_s), 2);
				measured += std::pow(late(t_s) - hand(t_s), 2);
			}
			CHECK(std::sqrt(shown / measured) < 0.99);
		}
	}
}
