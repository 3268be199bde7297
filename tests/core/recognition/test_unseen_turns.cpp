// A hand on its way back that is lost, and is on its way out again once it is seen: it turned in between, and
// its next gesture began there or before, not where its way back had begun.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

const Drag BACK{ .onset_s = 1.9, .duration_s = 0.4, .amplitude_m = -0.2 };
const Drag AGAIN{ .onset_s = 2.35, .duration_s = 0.4, .amplitude_m = 0.2 };
constexpr double LENGTH_S = 3.5;

template <class Lose> void check_losses(const Lose &lose) {
	for (const double from_s : { 2.15, 2.2, 2.25 }) {
		for (const double to_s : { 2.55, 2.6, 2.65, 2.75 }) {
			CAPTURE(from_s);
			CAPTURE(to_s);
			CHECK(lose(from_s, to_s).said == times(2, "sideways"));
		}
	}
}

} // namespace

TEST_CASE("a gesture whose beginning is lost with the end of the way back before it is told") {
	const Way way = along(X, { DRAG, BACK, AGAIN });
	check_losses([&](double from_s, double to_s) { return in_the_open(way, LENGTH_S, from_s, to_s); });
	check_losses([&](double from_s, double to_s) {
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
		return watch(recogniser, held(way, from_s, to_s), LENGTH_S, 1e9, 1e9, 110.0, 0.0);
	});
}

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
