// Hands that turn while the tracker is frozen.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("of a row of quick gestures a freeze takes those that it hides, and not all that come after it") {
	constexpr int GESTURES = 8;
	constexpr double PERIOD_S = 0.38;
	std::vector<Drag> strokes;
	for (int i = 0; i < GESTURES; ++i) {
		const double onset_s = 1.0 + PERIOD_S * i;
		strokes.push_back({ .onset_s = onset_s, .duration_s = 0.12, .amplitude_m = 0.2 });
		strokes.push_back({ .onset_s = onset_s + 0.18, .duration_s = 0.15, .amplitude_m = -0.2 });
	}
	for (int step = 0; step < 19; ++step) {
		for (const double loss_s : { 0.16, 0.2, 0.24, 0.28 }) {
			const double from_s = 1.0 + PERIOD_S + 0.02 * step;
			CAPTURE(from_s);
			CAPTURE(loss_s);
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			const Way way = held(along(X, strokes), from_s, from_s + loss_s);
			const Events events = watch(recogniser, way, 5.0, 1e9, 1e9, 110.0, 0.0);
			CHECK(std::ranges::count(events.said, "ended sideways") >= GESTURES - 2);
		}
	}
}
