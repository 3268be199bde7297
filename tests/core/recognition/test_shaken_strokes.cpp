// A tracker that shakes about a hand at rest, and a gesture soon after, nothing given.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("what is left of a tracker's leaps to and fro is no gesture, and hides none") {
	constexpr unsigned SEEDS = 40;
	constexpr double SHAKES_FROM_S = 0.6;
	const Drag drag{ .onset_s = 1.5, .duration_s = 0.9, .amplitude_m = 0.2 };
	std::ptrdiff_t right = 0;
	for (const double noise_m : { 0.005, 0.01, 0.02, 0.03 }) {
		CAPTURE(noise_m);
		std::ptrdiff_t ended = 0;
		for (unsigned seed = 1; seed <= SEEDS; ++seed) {
			for (const double for_s : { 0.1, 0.2, 0.3 }) {
				Tremor tremor(1e-4, seed), shaking(noise_m, seed);
				const Way seen = [&](double t_s) {
					const bool shakes = t_s >= SHAKES_FROM_S && t_s < SHAKES_FROM_S + for_s;
					return Eigen::Vector3d(drag.x_m(t_s) * X + (shakes ? shaking() : tremor()));
				};
				const Events events = in_the_open(seen, 3.4);
				ended += count(events, "ended");
				right += count(events, "ended sideways") == 1 && std::abs(events.last_value_m - 0.2) < 0.02;
			}
		}
		CHECK(static_cast<double>(ended) <= 1.05 * 3 * SEEDS);
	}
	CHECK(static_cast<double>(right) >= 0.9 * 4 * 3 * SEEDS);
}
