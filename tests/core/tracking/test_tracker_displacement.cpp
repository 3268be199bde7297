// Displacement of a tracker: lasting jumps.

#include "base/random.h"
#include "moving_hand.h"
#include "near.h"
#include "signal/minimum_jerk.h"
#include "tracking/tracker_monitor.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using Eigen::Vector3d;
using test::MovingHand;

namespace {

constexpr double RATES_HZ[] = { 60.0, 90.0, 120.0 };
constexpr double NOISE_M = 0.2e-3;

/// A displacement of the tracker between two times.
struct Aside {
	Vector3d by_m;
	double from_s, to_s;
};

/// Greatest distance between a corrected position and the hand, over usable measurements since a time.
double furthest_off_m(double rate_hz, const Aside &aside, double since_s) {
	Random random(3);
	const MovingHand hand{ .rate_hz = rate_hz, .noise_m = NOISE_M };
	TrackerMonitor monitor;
	double furthest_m = 0.0;
	for (int i = 0; i < 2.5 * rate_hz; ++i) {
		const double t_s = i / rate_hz;
		const bool is_aside = t_s >= aside.from_s && t_s < aside.to_s;
		const Vector3d seen_m = hand.seen(t_s, random) + (is_aside ? 1.0 : 0.0) * aside.by_m;
		const Measurement measurement = monitor.push(t_s, seen_m);
		if (t_s >= since_s && measurement.is_usable()) {
			const Vector3d shown_m = measurement.position_m - measurement.displacement_m;
			furthest_m = std::max(furthest_m, (shown_m - hand.at(t_s)).norm());
		}
	}
	return furthest_m;
}

} // namespace

TEST_CASE("displacement_m corrects 80 % of a lasting jump") {
	for (const double rate_hz : RATES_HZ) {
		for (const double jump_m : { 0.06, 0.12, 0.3 }) {
			// At rest, at the onset, and halfway.
			for (const double from_s : { 0.15, 0.3, 0.5 }) {
				CAPTURE(rate_hz);
				CAPTURE(jump_m);
				CAPTURE(from_s);
				CHECK(furthest_off_m(rate_hz, { { 0.0, jump_m, 0.0 }, from_s, 10.0 }, 0.0) < 0.2 * jump_m);
			}
		}
	}
}

TEST_CASE("a jump undone within 0.3 s leaves no displacement") {
	for (const double rate_hz : RATES_HZ) {
		for (const double lasts_s : { 0.05, 0.15, 0.25, 0.3 }) {
			for (const double from_s : { 0.1, 0.3, 0.5 }) {
				CAPTURE(rate_hz);
				CAPTURE(lasts_s);
				CAPTURE(from_s);
				const double to_s = from_s + lasts_s;
				CHECK(furthest_off_m(rate_hz, { { 0.0, 0.1, 0.0 }, from_s, to_s }, to_s + 0.1) < 0.02);
			}
		}
	}
}

TEST_CASE("a freeze during a movement gives no displacement") {
	for (const double rate_hz : RATES_HZ) {
		for (const double lost_s : { 0.1, 0.2, 0.25 }) {
			CAPTURE(rate_hz);
			CAPTURE(lost_s);
			Random random(5);
			TrackerMonitor monitor;
			Vector3d place_m = Vector3d::Zero();
			Measurement last;
			for (int i = 0; i < 2.0 * rate_hz; ++i) {
				const double t_s = i / rate_hz;
				if (t_s < 0.9 || t_s > 0.9 + lost_s) {
					place_m.x() = 0.26 * minimum_jerk(std::clamp(t_s - 0.5, 0.0, 1.0)).value;
				}
				const Vector3d noise_m(random.normal(), random.normal(), random.normal());
				last = monitor.push(t_s, place_m + NOISE_M * noise_m);
			}
			CHECK(last.displacement_m.norm() == 0.0);
		}
	}
}
