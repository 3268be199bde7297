// With a task, hands that are shown far off its way: with a player whom the game moves, or by a tracker that
// errs for a while.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr Drag GOES{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.2 };
constexpr double ENDS_S = GOES.onset_s + GOES.duration_s;

/// Aside by that much between the two times.
Events of(const Eigen::Vector3d &aside_m, double from_s, double to_s, double noise_m) {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	const Way way = [=](double t_s) {
		const bool is_aside = t_s >= from_s && t_s < to_s;
		return Eigen::Vector3d(GOES.x_m(t_s) * X + (is_aside ? 1.0 : 0.0) * aside_m);
	};
	return watch(recogniser, way, ENDS_S + 2.5, 1e9, 1e9, 110.0, noise_m);
}

} // namespace

TEST_CASE("a hand that is moved away with its player on the way has not come to the end, and gives up") {
	for (const Eigen::Vector3d &aside_m : { Eigen::Vector3d(0.3 * Y), Eigen::Vector3d(-0.5 * Z),
				 Eigen::Vector3d(1.0 * X), Eigen::Vector3d(3.0 * Y + 1.0 * X), Eigen::Vector3d(-2.0 * X) }) {
		for (const double share : { 0.3, 0.4, 0.5, 0.6, 0.7 }) {
			for (const double noise_m : { 1e-4, 1e-3 }) {
				CAPTURE(aside_m.transpose());
				CAPTURE(share);
				CAPTURE(noise_m);
				CHECK(of(aside_m, GOES.onset_s + share * GOES.duration_s, 1e9, noise_m).said ==
						std::vector<std::string>{ "started sideways", "aborted sideways" });
			}
		}
	}
}

TEST_CASE("a hand that a tracker shows elsewhere for less than a second has made its gesture") {
	for (const Eigen::Vector3d &aside_m : { Eigen::Vector3d(0.25 * Y), Eigen::Vector3d(-0.4 * Z) }) {
		for (const double from : { 0.3, 0.5, 0.8, 0.95 }) { // of its time
			for (const double lasts_s : { 0.1, 0.25, 0.5, 0.9 }) {
				CAPTURE(aside_m.transpose());
				CAPTURE(from);
				CAPTURE(lasts_s);
				const double from_s = GOES.onset_s + from * GOES.duration_s;
				const Events events = of(aside_m, from_s, from_s + lasts_s, 1e-4);
				CHECK(events.said == times(1, "sideways"));
				CHECK(events.last_ended_s < std::max(ENDS_S, from_s + lasts_s) + 0.15);
			}
		}
	}
}
