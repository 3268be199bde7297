// Gestures with a task: start, pause and abort.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

TestPath from(const Eigen::Vector3d &start_m, const TestPath &path) {
	return [=](double t_s) { return Eigen::Vector3d(start_m + path(t_s)); };
}

/// Half of the task, then on and at the same time aside.
Eigen::Vector3d goes_elsewhere(double t_s) {
	const Drag aside{ .onset_s = 2.2, .duration_s = 0.6, .amplitude_m = 0.3 };
	return { x_m({ { 0.6, 0.6, 0.1 }, { 2.2, 0.6, 0.1 } }, t_s), aside.x_m(t_s), 0.0 };
}

} // namespace

TEST_CASE("with a task each hand makes its events") {
	const TestPath drag = along(X, { { 1.3, 0.8, 0.2 } });
	const Eigen::Vector3d across(std::cos(1.309), std::sin(1.309), 0.0); // 75 degrees
	for (const auto &[hand, path, length_s, events] : {
				 HandRow{ "moves back first", along(X, { { 0.5, 0.35, -0.04 }, { 0.8, 0.5, 0.24 } }), 3.0,
						 ENDS },
				 { "overshoots and corrects", along(X, { { 0.6, 0.9, 0.23 }, { 1.5, 0.3, -0.03 } }), 3.0,
						 ENDS },
				 { "pauses for 0.2 s", along(X, { { 0.6, 0.6, 0.1 }, { 1.4, 0.6, 0.1 } }), 3.0, ENDS },
				 { "pauses for 5 s at 30 %", along(X, { { 0.6, 0.6, 0.06 }, { 6.2, 0.6, 0.14 } }), 8.0,
						 ENDS },
				 { "pauses for 5 s at 70 %", along(X, { { 0.6, 0.6, 0.14 }, { 6.2, 0.6, 0.06 } }), 8.0,
						 ENDS },
				 { "stops half-way", along(X, { { 0.6, 0.8, 0.1 } }), 4.0, STARTS },
				 { "stops and returns", along(X, { { 0.6, 0.8, 0.1 }, { 2.5, 0.8, -0.1 } }), 5.0, ABORTS },
				 { "stops and goes elsewhere", goes_elsewhere, 5.0, ABORTS },
				 { "turns at 10 %", along(X, { { 1.3, 0.2, 0.02 }, { 1.5, 0.2, -0.02 } }), 2.0, ABORTS },
				 { "turns at 30 %", along(X, { { 1.3, 0.5, 0.06 }, { 1.8, 0.5, -0.06 } }), 2.6, ABORTS },
				 { "turns at 60 %", along(X, { { 1.0, 0.25, 0.12 }, { 1.25, 0.25, -0.12 } }), 3.5, ABORTS },
				 { "twitches across", along(across, { { 1.0, 0.25, 0.12 }, { 1.25, 0.25, -0.12 } }), 3.5,
						 NOTHING },
				 { "comes to the target", from(0.2 * X + 0.2 * Y, along(-Y, { DRAG })), 3.0, NOTHING },
				 { "starts 4 cm beside", from(0.04 * Y, drag), 3.0, ENDS },
				 { "starts 15 cm beside", from(0.15 * Y, drag), 3.0, NOTHING },
				 { "starts a metre behind", from(-Z, drag), 3.0, NOTHING },
		 }) {
		INFO(hand);
		const Events seen = watch_with_task(path, length_s);
		CHECK(seen.names == events);
		CHECK((events != ABORTS || seen.largest_step < 0.003));
	}
}

TEST_CASE("with a task a drag with noise of 1 mm starts once") {
	for (const double duration_s : { 0.8, 4.0 }) {
		for (int i = 0; i < 12; ++i) { // the noise of watch() is always equal, so the onset varies it
			INFO("duration ", duration_s, ", delay ", i);
			const double onset_s = 1.2 + 0.003 * i;
			CHECK(watch_with_task(along(X, { { onset_s, duration_s, 0.2 } }), onset_s + duration_s + 0.6,
						  { .rate_hz = 90.0, .noise_m = 1e-3 })
							.names == ENDS);
		}
	}
}

TEST_CASE("with a task gestures end within 60 ms at any rate" * doctest::test_suite("figures")) {
	for (const double rate_hz : { 30.0, 120.0, 10000.0 }) {
		for (const double duration_s : { 0.5, 1.5 }) {
			INFO("rate ", rate_hz, ", duration ", duration_s);
			const Events events = watch_with_task(
					along(X, { { 1.5, duration_s, 0.2 } }), 4.0, { .rate_hz = rate_hz, .noise_m = 5e-5 });
			CHECK(events.names == ENDS);
			CHECK(std::abs(events.last_ended_s - 1.5 - duration_s) < 0.0605); // checked each millisecond
		}
	}
}

TEST_CASE("with a task progress falls less than 5 % after a pause") {
	for (const double halt_s : { 0.3, 5.0 }) {
		CAPTURE(halt_s);
		const Drag first{ 1.3, 0.5, 0.1 }, second{ 1.8 + halt_s, 0.5, 0.1 };
		const double end_s = second.onset_s + second.duration_s;
		GestureRecogniser recogniser = with_task();
		double most = 0.0, fell_by = 0.0, at_last = 0.0;
		const TestPath path = [&](double t_s) {
			at_last = recogniser.motion(MotionSource::SYNTHESISED).progress;
			if (t_s > second.onset_s && t_s < end_s) {
				most = std::max(most, at_last);
				fell_by = std::max(fell_by, most - at_last);
			}
			return along(X, { first, second })(t_s);
		};
		CHECK(watch(recogniser, path, end_s + 0.5, { .rate_hz = 90.0 }).names == ENDS);
		CHECK(fell_by < 0.05);
		CHECK(at_last > 0.9);
	}
}

TEST_CASE("with a task a return that stops near the start starts nothing") {
	for (const double turns_m : { 0.1, 0.2 }) {
		for (const double rests_m : { 0.016, 0.028 }) {
			for (const double noise_m : { 1e-4, 1e-3 }) {
				INFO("turns ", turns_m, ", rests ", rests_m, ", noise ", noise_m);
				const TestPath path = along(X,
						{ { 0.6, 0.6, turns_m }, { 1.2, 0.6, rests_m - turns_m },
								{ 4.0, 0.7, 0.2 - rests_m } });
				GestureRecogniser recogniser = with_task();
				bool is_active = false;
				const TestPath noted = [&](double t_s) {
					is_active = is_active || (t_s > 2.0 && t_s < 4.0 && recogniser.gesture() >= 0);
					return path(t_s);
				};
				EventNames expected = turns_m < 0.2 ? ABORTS : ENDS;
				expected.insert(expected.end(), ENDS.begin(), ENDS.end());
				CHECK(watch(recogniser, noted, 5.5, { .noise_m = noise_m }).names == expected);
				CHECK_FALSE(is_active);
			}
		}
	}
}

TEST_CASE("with a task a turn near the start begins the next gesture") {
	for (const double turns_m : { 0.0, 0.02 }) {
		for (const double duration_s : { 0.3, 0.6 }) {
			INFO("turns ", turns_m, ", duration ", duration_s);
			std::vector<Drag> ways{ { .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 } };
			for (int i = 1; i < 5; ++i) {
				const double way_m = i % 2 == 0 ? 0.2 - turns_m : turns_m - 0.2;
				ways.push_back({ ways.back().onset_s + duration_s, duration_s, way_m });
			}
			CHECK(watch_with_task(along(X, ways), 1.5 + 5.0 * duration_s).names ==
					times(3, "horizontal_drag"));
		}
	}
}

TEST_CASE("ten taps in a row each start and end once") {
	std::vector<Drag> strokes;
	for (int i = 0; i < 10; ++i) {
		strokes.push_back({ .onset_s = 0.6 + i, .duration_s = 0.45, .amplitude_m = 0.2 });
		strokes.push_back({ .onset_s = 1.02 + i, .duration_s = 0.4, .amplitude_m = -0.2 });
	}
	CHECK(watch_without_task(along(-Z, strokes), 11.0).names == times(10, "tap"));
	CHECK(watch_with_task(along(X, strokes), 11.0).names == times(10, "horizontal_drag"));
}
