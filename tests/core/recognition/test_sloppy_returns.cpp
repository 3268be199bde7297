// With a task, hands that come back from a gesture only about to where it began.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("a hand that comes back nearly to the start and rests there has not set out again") {
	for (const double turns_m : { 0.1, 0.14, 0.2 }) {
		for (const double rests_m : { 0.016, 0.02, 0.024, 0.028 }) {
			for (const double noise_m : { 1e-4, 1e-3 }) {
				CAPTURE(turns_m);
				CAPTURE(rests_m);
				CAPTURE(noise_m);
				const Drag forth{ .onset_s = 0.6, .duration_s = 0.6, .amplitude_m = turns_m },
						back{ .onset_s = 1.2, .duration_s = 0.6, .amplitude_m = rests_m - turns_m },
						again{ .onset_s = 4.0, .duration_s = 0.7, .amplitude_m = 0.2 - rests_m };
				GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
				bool is_under_way = false;
				double farthest_off_m = 0.0;
				const Way way = [&](double t_s) {
					const bool rests = t_s > 2.0 && t_s < again.onset_s;
					is_under_way = is_under_way || (rests && recogniser.gesture() >= 0);
					const double shown_m = recogniser.motion(MotionSource::SYNTHESISED).value_m;
					farthest_off_m = t_s > 2.5 && rests
							? std::max(farthest_off_m, std::abs(shown_m - rests_m))
							: farthest_off_m;
					return along(X, { forth, back, again })(t_s);
				};
				const Events events = watch(recogniser, way, 5.5, 1e9, 1e9, 110.0, noise_m);
				CHECK_FALSE(is_under_way);
				CHECK(farthest_off_m < (noise_m < 1e-3 ? 2e-3 : 4e-3)); // once 10, as it may have set out
				const std::string first = turns_m < 0.2 ? "aborted sideways" : "ended sideways";
				CHECK(events.said ==
						std::vector<std::string>{
								"started sideways", first, "started sideways", "ended sideways" });
			}
		}
	}
}

TEST_CASE("a hand that turns right at the start, or a little before, makes the next gesture at once") {
	for (const double turns_m : { 0.0, 0.01, 0.02 }) {
		for (const double duration_s : { 0.3, 0.6 }) {
			CAPTURE(turns_m);
			CAPTURE(duration_s);
			std::vector<Drag> ways{ { .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 } };
			for (int i = 1; i < 5; ++i) {
				const double way_m = i % 2 == 0 ? 0.2 - turns_m : turns_m - 0.2;
				ways.push_back({ ways.back().onset_s + duration_s, duration_s, way_m });
			}
			GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
			CHECK(watch(recogniser, along(X, ways), 1.5 + 5.0 * duration_s).said == times(3, "sideways"));
		}
	}
}
