// Tasks beside one another, as the keys of a keypad: one press looks like each of them.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <utility>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double LIFT_M = 0.12;

Task key(double x_m, double surface_m) {
	return { { x_m, 0.0, LIFT_M - surface_m }, -Z, LIFT_M };
}

/// A finger presses at x_m, beyond the surface by deep_m, and comes back.
Events press(const std::vector<ExpectedGesture> &keys, double x_m, double duration_s, double deep_m) {
	const double down_m = LIFT_M + deep_m;
	const std::vector<Drag> strokes{ { 0.8, duration_s, down_m },
		{ 0.8 + duration_s + 0.08, duration_s, -down_m } };
	GestureRecogniser recogniser(keys);
	return watch(
			recogniser,
			[&](double t_s) { return Eigen::Vector3d(x_m, 0.0, LIFT_M - test::x_m(strokes, t_s)); }, 4.0);
}

std::ptrdiff_t ends(const Events &events) {
	return std::ranges::count_if(
			events.said, [](const std::string &said) { return said.starts_with("ended"); });
}

} // namespace

TEST_CASE("a press ends at one key, though the next one's surface lies a little deeper") {
	for (const double pitch_m : { 0.04, 0.05, 0.06, 0.07, 0.08, 0.1 }) {
		for (const double deeper_m : { 0.002, 0.005, 0.01 }) {
			for (const double duration_s : { 0.3, 0.5 }) {
				for (const double beside_m : { 0.0, 0.01 }) {
					CAPTURE(pitch_m);
					CAPTURE(deeper_m);
					CAPTURE(duration_s);
					CAPTURE(beside_m);
					const Events events =
							press({ { models()[2], key(0.0, 0.0) }, { models()[2], key(pitch_m, deeper_m) } },
									beside_m, duration_s, 0.003);
					CHECK(ends(events) == 1);
				}
			}
		}
	}
}

TEST_CASE("of tasks on one way each is begun and ends once at most") {
	const auto drag = [](double start_m, double amplitude_m) {
		return ExpectedGesture{ models()[0], Task{ start_m * X, X, amplitude_m } };
	};
	for (const double duration_s : { 0.3, 0.6, 1.2 }) {
		CAPTURE(duration_s);
		GestureRecogniser recogniser({ drag(0.12, 0.28), drag(0.02, 0.1), drag(0.01, 0.28) });
		const Drag whole{ 1.0, duration_s, 0.28 };
		GestureShown shown;
		std::array<int, 3> ended{};
		int changes = 0, frames = 0;
		for (int ms = 0; ms < 3000; ++ms) {
			for (; frames / 80.0 <= ms / 1000.0; ++frames) {
				HandFrame frame;
				frame.t_s = frames / 80.0;
				frame.set(Joint::INDEX, whole.x_m(frame.t_s) * X);
				recogniser.push(frame);
			}
			recogniser.advance(ms / 1000.0);
			const GestureShown now = shown_by(recogniser);
			const GestureNews happened = news(std::exchange(shown, now), now);
			changes += happened.started ? 1 : 0;
			ended[static_cast<std::size_t>(std::max(now.gesture, 0))] += happened.ended ? 1 : 0;
		}
		CHECK(changes <= 4);
		CHECK(*std::ranges::max_element(ended) == 1);
	}
}
