#include "base/random.h"
#include "moving_hand.h"
#include "near.h"
#include "signal/minimum_jerk.h"
#include "tracking/tracker_monitor.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

using namespace steadyhand;
using Eigen::Vector3d;
using test::MovingHand;
using test::near;

namespace {

constexpr double RATES_HZ[] = { 30.0, 60.0, 90.0, 120.0, 240.0 };

} // namespace

TEST_CASE("a dropout of 0.1 s is reported with its length") {
	for (const double rate_hz : { 60.0, 90.0, 120.0, 240.0 }) {
		for (const double amplitude_m : { 0.02, 0.4 }) {
			CAPTURE(rate_hz);
			Random random(2);
			const MovingHand hand{ .amplitude_m = amplitude_m, .rate_hz = rate_hz, .noise_m = 0.1e-3 };
			TrackerMonitor monitor;
			int reappeared = 0;
			double last_s = 0.0;
			for (int i = 0; i < 3 * rate_hz; ++i) {
				const double t_s = i / rate_hz;
				if (t_s < 1.45 || t_s > 1.55) {
					const Measurement measurement = monitor.push(t_s, hand.seen(t_s, random));
					if (measurement.status == MeasurementStatus::REAPPEARED) {
						++reappeared;
						CHECK(measurement.gap_s == near(t_s - last_s).epsilon(1e-9));
					}
					last_s = t_s;
				}
			}
			CHECK(reappeared == 1);
			CHECK(monitor.faults().dropouts == 1);
			CHECK(monitor.faults().jumps == 0);
		}
	}
}

TEST_CASE("a freeze with 0.1 mm of noise is found within 3.5 periods") {
	for (const double rate_hz : RATES_HZ) {
		// Motion and rest, with a short and a long task.
		for (const double amplitude_m : { 0.0, 0.02, 0.4 }) {
			CAPTURE(rate_hz);
			Random random(2);
			const MovingHand hand{ .amplitude_m = amplitude_m, .rate_hz = rate_hz, .noise_m = 0.1e-3 };
			TrackerMonitor monitor;
			Vector3d seen = Vector3d::Zero();
			double new_s = 0.0;
			std::optional<double> found_s, over_s;
			for (int i = 0; i < 3 * rate_hz; ++i) {
				const double t_s = i / rate_hz;
				const bool is_frozen = t_s > 1.45 && t_s < 1.95;
				seen = is_frozen ? seen : hand.seen(t_s, random);
				new_s = is_frozen ? new_s : t_s;
				const Measurement measurement = monitor.push(t_s, seen);
				if (measurement.status == MeasurementStatus::FROZEN && !found_s) {
					found_s = t_s - new_s;
				}
				if (measurement.status == MeasurementStatus::REAPPEARED && !over_s) {
					over_s = measurement.gap_s;
				}
			}
			CHECK(found_s.value_or(1.0) <= 3.5 / rate_hz);
			CHECK(over_s.value_or(0.0) == near(0.5).epsilon(0.1));
			CHECK(monitor.faults().freezes == 1);
			CHECK(monitor.faults().jumps == 0);
		}
	}
}

TEST_CASE("a hand without noise that stops is not frozen") {
	for (const double rate_hz : RATES_HZ) {
		for (const double length_m : { 0.05, 0.2 }) {
			for (const double share : { 0.25, 0.5, 0.75 }) {
				TrackerMonitor monitor;
				for (int i = 0; i < 2 * rate_hz; ++i) {
					const double t_s = i / rate_hz;
					const double x_m = length_m * std::min(std::max(t_s - 0.5, 0.0) / 0.4, share);
					const Measurement measurement = monitor.push(t_s, { x_m, 0.2, -0.4 });
					CHECK(measurement.status != MeasurementStatus::FROZEN);
					CHECK(measurement.status != MeasurementStatus::OUTLIER);
					CHECK((t_s < 1.5 || measurement.is_new()));
				}
				CHECK(monitor.faults().freezes == 0);
			}
		}
	}
}

TEST_CASE("a quick hand rounded to 0.5 mm that stops is not frozen") {
	for (const double rate_hz : RATES_HZ) {
		for (const double share : { 0.25, 0.5, 0.75 }) {
			CAPTURE(rate_hz);
			CAPTURE(share);
			TrackerMonitor monitor;
			for (int i = 0; i < 2 * rate_hz; ++i) {
				const double t_s = i / rate_hz;
				const double x_m = 0.3 * std::min(minimum_jerk((t_s - 0.5) / 0.4).value, share);
				monitor.push(t_s, { 5e-4 * std::round(x_m / 5e-4), 0.2, -0.4 });
			}
			CHECK(monitor.faults().freezes == 0);
		}
	}
}

TEST_CASE("a mouse whose positions are rounded to pixels has no fault") {
	Random random(1);
	const MovingHand hand{ .rest_s = 0.7, .rate_hz = 60.0, .rounding_m = 1e-3 };
	TrackerMonitor monitor;
	for (int i = 0; i < 1200; ++i) {
		const double t_s = i / 60.0;
		const Measurement measurement = monitor.push(t_s, hand.seen(t_s, random));
		CHECK(measurement.status != MeasurementStatus::FROZEN);
	}
	CHECK(monitor.faults().freezes == 0);
	CHECK(monitor.faults().jumps == 0);
}

TEST_CASE("six frames of the other hand are one jump, reported as a gap") {
	for (const double rate_hz : { 60.0, 90.0, 120.0, 240.0 }) {
		for (const double amplitude_m : { 0.02, 0.4 }) {
			for (int first = 40; first < 140; first += 7) {
				CAPTURE(rate_hz);
				CAPTURE(amplitude_m);
				CAPTURE(first);
				Random random(static_cast<std::uint64_t>(first));
				const MovingHand hand{ .amplitude_m = amplitude_m, .rate_hz = rate_hz, .noise_m = 0.1e-3 };
				TrackerMonitor monitor;
				for (int i = 0; i < 180; ++i) {
					const double t_s = i / rate_hz;
					Vector3d seen = hand.seen(t_s, random);
					const bool is_other = i >= first && i < first + 6;
					if (is_other) {
						seen.x() = -0.2 - seen.x(); // mirrored
					}
					const Measurement measurement = monitor.push(t_s, seen);
					if (is_other && i == first) {
						CHECK(measurement.status == MeasurementStatus::OUTLIER);
						CHECK(measurement.outlier_probability > 0.99);
					}
					if (i == first + 6) {
						CHECK(measurement.status == MeasurementStatus::REAPPEARED);
						CHECK(measurement.gap_s == near(6.0 / rate_hz));
					} else if (!is_other) {
						CHECK(measurement.outlier_probability < 0.5);
						CHECK(measurement.gap_s == 0.0);
					}
				}
				CHECK(monitor.faults().jumps == 1);
			}
		}
	}
}

TEST_CASE("a tracker with a moved origin is accepted within 0.1 s") {
	for (const double rate_hz : RATES_HZ) {
		CAPTURE(rate_hz);
		Random random(7);
		const MovingHand hand{ .rate_hz = rate_hz, .noise_m = 0.1e-3 };
		TrackerMonitor monitor;
		double last_outlier_s = 0.0;
		for (int i = 0; i < 3 * rate_hz; ++i) {
			const double t_s = i / rate_hz;
			const Vector3d shift_m = t_s > 1.5 ? Vector3d(0.0, 0.1, 0.15) : Vector3d::Zero();
			const Measurement measurement = monitor.push(t_s, hand.seen(t_s, random) + shift_m);
			last_outlier_s = measurement.status == MeasurementStatus::OUTLIER ? t_s : last_outlier_s;
		}
		CHECK(last_outlier_s > 1.5);
		CHECK(last_outlier_s < 1.6 + 1.0 / rate_hz);
		CHECK(monitor.faults().jumps == 1);
	}
}

TEST_CASE("a mouse that is set elsewhere and rests there is accepted") {
	TrackerMonitor monitor;
	Measurement measurement;
	for (int i = 0; i < 200; ++i) {
		measurement = monitor.push(i / 60.0, { i < 100 ? 0.0 : 0.5, 1e-3 * std::min(i, 50), 0.0 });
	}
	CHECK(measurement.status == MeasurementStatus::TRACKED);
	CHECK(monitor.faults().jumps == 1);
}

TEST_CASE("an accepted shift undone within 0.3 s is reported as a gap") {
	Random random(7);
	const MovingHand hand{ .rate_hz = 100.0, .noise_m = 0.1e-3 };
	TrackerMonitor monitor;
	for (int i = 0; i < 300; ++i) {
		const double t_s = i / 100.0;
		const bool is_off = i >= 150 && i < 175;
		const Vector3d off_m = is_off ? Vector3d(0.0, 0.05, 0.0) : Vector3d::Zero();
		const Measurement measurement = monitor.push(t_s, hand.seen(t_s, random) + off_m);
		if (i == 175) {
			CHECK(measurement.status == MeasurementStatus::REAPPEARED);
			CHECK(measurement.gap_s == near(0.25));
		}
	}
}

TEST_CASE("a hand that hits a surface at 1.5 m/s is no outlier") {
	for (const double rate_hz : RATES_HZ) {
		TrackerMonitor monitor;
		Random random(9);
		for (int i = 0; i < 2 * rate_hz; ++i) {
			const double t_s = i / rate_hz;
			// The hand accelerates at 20 m/s^2 for 75 ms, moves on for 50 ms, and stops at once.
			const double u_s = std::clamp(t_s - 1.0, 0.0, 0.125);
			const double y_m = u_s < 0.075 ? 10.0 * u_s * u_s : 0.05625 + 1.5 * (u_s - 0.075);
			const Measurement measurement =
					monitor.push(t_s, { 1e-5 * random.normal(), -y_m, 1e-5 * random.normal() });
			CHECK(measurement.status != MeasurementStatus::OUTLIER);
		}
	}
}
