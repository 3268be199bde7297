// With a task, a gesture ends if the hand stops beyond `completion`, a fraction of the amplitude. Scenes
// lower it for people who stop short of a target that they cannot feel.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// With a completion of 70 %.
GestureRecogniser lowered() {
	GestureRecogniser recogniser = with_task();
	recogniser.set_completion(0.7);
	return recogniser;
}

} // namespace

TEST_CASE("a hand that stops beyond a completion of 70 % ends there") {
	for (const double far_m : { 0.15, 0.176 }) {
		for (const double duration_s : { 0.3, 2.5 }) {
			for (const double noise_m : { 0.0, 1e-4 }) {
				INFO("far ", far_m, ", duration ", duration_s, ", noise ", noise_m);
				const Drag drag{ 0.5, duration_s, far_m };
				const Events events =
						watch(lowered(), along(X, { drag }), duration_s + 2.0, { .noise_m = noise_m });
				CHECK(events.names == ENDS);
				CHECK(drag.x_m(events.last_ended_s) > far_m - 0.002);
				CHECK(events.last_ended_s < 0.5 + duration_s + 0.8);
				CHECK(std::abs(events.last_value_m - far_m) < 0.002);
			}
		}
	}
}

TEST_CASE("a gesture with a pause ends within 0.2 s of its endpoint") {
	for (const double far_m : { 0.06, 0.08 }) {
		for (const double halts_s : { 0.2, 0.5 }) {
			INFO("far ", far_m, ", halts ", halts_s);
			const double on_s = 0.9 + halts_s;
			const Events events = watch_with_task(
					along(X, { { 0.5, 0.4, far_m }, { on_s, 0.6, 0.2 - far_m } }), on_s + 2.0);
			CHECK(events.names == ENDS);
			CHECK(events.last_ended_s < on_s + 0.6 + 0.2);
		}
	}
	const Events late = watch_with_task(along(X, { { 0.5, 0.8, 0.15 }, { 1.6, 0.5, 0.05 } }), 3.5);
	CHECK(late.names == ENDS);
	CHECK_MESSAGE(late.last_ended_s > 1.6, "not during the pause at three quarters");
}

TEST_CASE("a hand that stops or turns short of completion ends nothing") {
	const auto stops = [](double far, double duration_s) {
		return along(X, { { 0.5, duration_s, far * 0.2 } });
	};
	const auto turns = [](double far) {
		return along(X, { { 0.5, 0.4, far * 0.2 }, { 0.95, 0.5, -far * 0.2 } });
	};
	CHECK(has_no_end(watch_with_task(stops(0.3, 2.5), 6.5)));
	CHECK(has_no_end(watch_with_task(stops(0.9, 0.3), 4.3)));
	CHECK(has_no_end(watch_with_task(stops(0.9, 2.5), 6.5)));
	CHECK(has_no_end(watch_with_task(turns(0.5), 3.0)));
	CHECK(has_no_end(watch_with_task(turns(0.88), 3.0)));
	CHECK(has_no_end(watch(lowered(), turns(0.6), 3.0)));
	CHECK(watch(lowered(), turns(0.8), 3.0).names == ENDS);
	CHECK(watch(lowered(), turns(0.98), 3.0).names == ENDS);
}

TEST_CASE("a hand that stops beside the target ends nothing") {
	const TestPath beside = [](double t_s) {
		const double moved_m = Drag{ 0.5, 1.0, 0.2 }.x_m(t_s);
		return Eigen::Vector3d(moved_m, 0.1 + 0.5 * moved_m, 0.0);
	};
	CHECK(has_no_end(watch_with_task(beside, 3.5)));
	const auto oblique = [](double angle_rad) {
		const Eigen::Vector3d axis(std::cos(angle_rad), std::sin(angle_rad), 0.0);
		return along(axis, { { 0.5, 1.0, 0.16 / std::cos(angle_rad) } });
	};
	CHECK(watch(lowered(), oblique(0.15), 3.5).names == ENDS);
	CHECK(has_no_end(watch(lowered(), oblique(0.5), 3.5)));
}

TEST_CASE("only a hand that returns near its start makes the gesture again") {
	for (const double left_m : { 0.01, 0.016, 0.044, 0.1 }) {
		CAPTURE(left_m);
		const TestPath path =
				along(X, { { 0.5, 0.8, 0.2 }, { 2.0, 0.8, left_m - 0.2 }, { 3.5, 0.8, 0.2 - left_m } });
		CHECK(watch_with_task(path, 6.0).names == times(left_m < 0.03 ? 2 : 1, "horizontal_drag"));
	}
}
