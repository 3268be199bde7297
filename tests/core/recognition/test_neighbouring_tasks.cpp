// Tasks beside one another, as the keys of a keypad: one press looks like each of them.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double LIFT_M = 0.12;

Task key(double x_m, double surface_m) {
	return { { x_m, 0.0, LIFT_M - surface_m }, -Z, LIFT_M };
}

/// A finger presses 3 mm beyond a surface at 0, beside_m of the middle of the first key, and comes back.
/// Where it sets out it is set_out_m further beside it.
Events press(const std::vector<ExpectedGesture> &keys, double beside_m, double duration_s, double noise_m,
		double set_out_m = 0.0) {
	const double down_m = LIFT_M + 0.003;
	const std::vector<Drag> strokes{ { 0.8, duration_s, down_m },
		{ 0.8 + duration_s + 0.08, duration_s, -down_m } };
	const Way finger = [&](double t_s) {
		const double gone_m = x_m(strokes, t_s);
		return Eigen::Vector3d(beside_m + set_out_m * (1.0 - gone_m / down_m), 0.0, LIFT_M - gone_m);
	};
	GestureRecogniser recogniser(keys);
	return watch(recogniser, finger, 3.0, 1e9, 1e9, 90.0, noise_m);
}

} // namespace

TEST_CASE("a press ends at the key that it is made at, though the next one's surface lies a little deeper" *
		doctest::test_suite("figures")) {
	for (const double pitch_m : { 0.04, 0.05, 0.06, 0.07, 0.08, 0.1 }) {
		for (const double deeper_m : { 0.002, 0.005, 0.01 }) {
			for (const double duration_s : { 0.3, 0.5 }) {
				for (const double beside_m : { 0.0, 0.01 }) {
					for (const double noise_m : { 1e-4, 1e-3 }) {
						CAPTURE(pitch_m);
						CAPTURE(deeper_m);
						CAPTURE(duration_s);
						CAPTURE(beside_m);
						CAPTURE(noise_m);
						const ExpectedGesture here{ model("this", -Z, false), key(0.0, 0.0) },
								next{ model("next", -Z, false), key(pitch_m, deeper_m) };
						for (const std::vector<ExpectedGesture> &keys :
								{ std::vector{ here, next }, std::vector{ next, here } }) {
							CHECK(press(keys, beside_m, duration_s, noise_m).said == times(1, "this"));
						}
					}
				}
			}
		}
	}
}

TEST_CASE("a press ends at the key that it comes down on, also where it set out above the next one") {
	for (const double pitch_m : { 0.04, 0.05, 0.06 }) {
		const ExpectedGesture here{ model("this", -Z, false), key(0.0, 0.0) },
				beside{ model("beside", -Z, false), key(pitch_m, 0.0) };
		for (const std::vector<ExpectedGesture> &keys :
				{ std::vector{ here, beside }, std::vector{ beside, here } }) {
			for (const double duration_s : { 0.3, 0.5 }) {
				for (const double share : { 0.5, 0.7, 0.9, 1.0 }) {
					CAPTURE(pitch_m);
					CAPTURE(duration_s);
					CAPTURE(share);
					const Events pressed = press(keys, 0.0, duration_s, 1e-4, share * pitch_m);
					CHECK(count(pressed, "ended this") == 1);
					CHECK(ends(pressed) == 1);
				}
			}
		}
	}
}

TEST_CASE("of tasks on one way each is begun and ends once at most") {
	const auto drag = [](const char *name, double start_m, double amplitude_m) {
		return ExpectedGesture{ model(name, X, true), Task{ start_m * X, X, amplitude_m } };
	};
	for (const double duration_s : { 0.3, 0.6, 1.2 }) {
		CAPTURE(duration_s);
		GestureRecogniser recogniser(
				{ drag("later", 0.12, 0.28), drag("short", 0.02, 0.1), drag("whole", 0.01, 0.28) });
		const Events events =
				watch(recogniser, along(X, { { 1.0, duration_s, 0.28 } }), 3.0, 1e9, 1e9, 80.0, 0.0);
		CHECK(count(events, "started") <= 4);
		const auto most = std::max(
				{ count(events, "ended later"), count(events, "ended short"), count(events, "ended whole") });
		CHECK(most == 1);
	}
}
