// Gestures with a task: start, pause and abort.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double TASK_M = 0.2; ///< amplitude of Task{}

Drag going(double far, double onset_s, double duration_s) {
	return { .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = far * TASK_M };
}

/// Events in `phase` mode with a tracker of 90 Hz.
Events watch_at_90_hz(const TestPath &path, double length_s, double noise_m = 1e-4) {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	return watch(recogniser, path, length_s, 1e9, 1e9, 90.0, noise_m);
}

/// Delay of the hand in a repetition. The noise of watch() is always equal, so the delay varies it.
constexpr double later_s(int repetition) {
	return 0.003 * repetition;
}

} // namespace

TEST_CASE("with a task a drag with noise of 1 mm starts once") {
	for (const double duration_s : { 0.8, 4.0 }) {
		for (int repetition = 0; repetition < 12; ++repetition) {
			CAPTURE(duration_s);
			CAPTURE(repetition);
			const double onset_s = 1.2 + later_s(repetition);
			const TestPath path = along(X, { going(1.0, onset_s, duration_s) });
			CHECK(watch_at_90_hz(path, onset_s + duration_s + 0.6, 1e-3).names == times(1, "sideways"));
		}
	}
}

TEST_CASE("with a task a hand that moves back first makes one gesture") {
	const Drag back{ .onset_s = 0.5, .duration_s = 0.35, .amplitude_m = -0.04 };
	const Drag forth{ .onset_s = 0.8, .duration_s = 0.5, .amplitude_m = 0.24 };
	CHECK(watch_with_task(along(X, { back, forth }), 3.0).names == times(1, "sideways"));
}

TEST_CASE("a hand that overshoots and corrects makes one gesture") {
	const Drag back{ .onset_s = 1.5, .duration_s = 0.3, .amplitude_m = -0.03 };
	const Drag over{ .onset_s = 0.6, .duration_s = 0.9, .amplitude_m = 0.23 };
	CHECK(watch_without_task(along(X, { over, back }), 3.0).names == times(1, "sideways"));
	CHECK(watch_with_task(along(X, { over, back }), 3.0).names == times(1, "sideways"));
}

TEST_CASE("a hand that pauses shortly half-way makes one gesture") {
	const TestPath quick = along(X, { going(0.5, 0.6, 0.6), going(0.5, 1.4, 0.6) });
	CHECK(watch_without_task(quick, 3.0).names == times(1, "sideways"));
	CHECK(watch_with_task(quick, 3.0).names == times(1, "sideways"));
	const TestPath slow = along(X, { going(0.5, 0.6, 1.2), going(0.5, 2.2, 1.2) });
	CHECK(watch_without_task(slow, 4.2).names == times(1, "sideways"));
}

TEST_CASE("with a task a pause of 0.3 to 5 s does not abort") {
	for (const double rest_s : { 0.3, 5.0 }) {
		for (const double share : { 0.3, 0.5, 0.7 }) {
			CAPTURE(rest_s);
			CAPTURE(share);
			const TestPath path = along(X, { going(share, 0.6, 0.6), going(1.0 - share, 1.2 + rest_s, 0.6) });
			CHECK(watch_with_task(path, 3.0 + rest_s).names == times(1, "sideways"));
		}
	}
}

TEST_CASE("with a task progress falls less than 5 % after a pause") {
	for (const double halt_s : { 0.3, 5.0 }) {
		CAPTURE(halt_s);
		const Drag first = going(0.5, 1.3, 0.5), second = going(0.5, 1.8 + halt_s, 0.5);
		const double end_s = second.onset_s + second.duration_s;
		GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
		double most = 0.0, fell_by = 0.0, at_last = 0.0;
		const TestPath path = [&](double t_s) {
			at_last = recogniser.motion(MotionSource::SYNTHESISED).progress;
			if (t_s > second.onset_s && t_s < end_s) {
				most = std::max(most, at_last);
				fell_by = std::max(fell_by, most - at_last);
			}
			return along(X, { first, second })(t_s);
		};
		CHECK(watch(recogniser, path, end_s + 0.5, 1e9, 1e9, 90.0).names == times(1, "sideways"));
		CHECK(fell_by < 0.05);
		CHECK(at_last > 0.9);
	}
}

TEST_CASE("with a task a stop half-way ends nothing; its return aborts") {
	const Drag half = going(0.5, 0.6, 0.8), back = going(-0.5, 2.5, 0.8);
	CHECK(watch_with_task(along(X, { half }), 4.0).names == std::vector<std::string>{ "started sideways" });
	const Events returned = watch_with_task(along(X, { half, back }), 5.0);
	CHECK(returned.names == started_and_aborted("sideways"));
	CHECK(returned.largest_step < 0.003);
}

TEST_CASE("with a task a hand that stops and goes elsewhere aborts") {
	const Drag aside{ .onset_s = 2.2, .duration_s = 0.6, .amplitude_m = 0.3 };
	const TestPath path = [=](double t_s) {
		const double moved_m = x_m({ going(0.5, 0.6, 0.6), going(0.5, 2.2, 0.6) }, t_s);
		return Eigen::Vector3d(moved_m, aside.x_m(t_s), 0.0);
	};
	CHECK(watch_with_task(path, 5.0).names == started_and_aborted("sideways"));
}

TEST_CASE("with a task an early return aborts within 0.3 s") {
	struct Turn {
		double far, duration_s; ///< of each of the two movements
	};
	for (const Turn turn : { Turn{ 0.1, 0.2 }, { 0.3, 0.5 } }) {
		for (int repetition = 0; repetition < 3; ++repetition) {
			CAPTURE(turn.far);
			CAPTURE(repetition);
			const Drag out = going(turn.far, 1.3 + later_s(repetition), turn.duration_s);
			const Drag back = going(-turn.far, out.onset_s + turn.duration_s, turn.duration_s);
			const double back_s = back.onset_s + back.duration_s;
			CHECK(watch_at_90_hz(along(X, { out, back }), back_s + 0.3).names ==
					started_and_aborted("sideways"));
		}
	}
}

TEST_CASE("a twitch across the axis starts nothing; along it ends nothing") {
	for (const double degrees : { 0.0, 75.0 }) {
		const double angle_rad = degrees * std::numbers::pi / 180.0;
		const Eigen::Vector3d direction = std::cos(angle_rad) * X + std::sin(angle_rad) * Y;
		for (const double far_m : { 0.04, 0.12 }) {
			CAPTURE(degrees);
			CAPTURE(far_m);
			const Drag there{ .onset_s = 1.0, .duration_s = 0.25, .amplitude_m = far_m },
					back{ .onset_s = 1.25, .duration_s = 0.25, .amplitude_m = -far_m };
			const Events events = watch_with_task(along(direction, { there, back }), 3.5);
			CHECK(has_no_end(events));
			CHECK(events.names.empty() == (degrees > 50.0));
		}
	}
}

TEST_CASE("with a task a return that stops near the start starts nothing") {
	for (const double turns_m : { 0.1, 0.2 }) {
		for (const double rests_m : { 0.016, 0.028 }) {
			for (const double noise_m : { 1e-4, 1e-3 }) {
				CAPTURE(turns_m);
				CAPTURE(rests_m);
				CAPTURE(noise_m);
				const TestPath path = along(X,
						{ { 0.6, 0.6, turns_m }, { 1.2, 0.6, rests_m - turns_m },
								{ 4.0, 0.7, 0.2 - rests_m } });
				GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
				bool is_active = false;
				const TestPath noted = [&](double t_s) {
					is_active = is_active || (t_s > 2.0 && t_s < 4.0 && recogniser.gesture() >= 0);
					return path(t_s);
				};
				const Events events = watch(recogniser, noted, 5.5, 1e9, 1e9, 110.0, noise_m);
				CHECK_FALSE(is_active);
				const std::string first = turns_m < 0.2 ? "aborted sideways" : "ended sideways";
				CHECK(events.names ==
						std::vector<std::string>{
								"started sideways", first, "started sideways", "ended sideways" });
			}
		}
	}
}

TEST_CASE("with a task a turn near the start begins the next gesture") {
	for (const double turns_m : { 0.0, 0.02 }) {
		for (const double duration_s : { 0.3, 0.6 }) {
			CAPTURE(turns_m);
			CAPTURE(duration_s);
			std::vector<Drag> ways{ { .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 } };
			for (int i = 1; i < 5; ++i) {
				const double way_m = i % 2 == 0 ? 0.2 - turns_m : turns_m - 0.2;
				ways.push_back({ ways.back().onset_s + duration_s, duration_s, way_m });
			}
			CHECK(watch_with_task(along(X, ways), 1.5 + 5.0 * duration_s).names == times(3, "sideways"));
		}
	}
}

TEST_CASE("with a task a movement far from the start starts nothing") {
	const TestPath from_above = [](double t_s) { return Eigen::Vector3d(0.2, 0.2 - DRAG.x_m(t_s), 0.0); };
	CHECK(watch_with_task(from_above, 3.0).names.empty());
	const auto beside = [](const Eigen::Vector3d &off_m) {
		const TestPath path = [=](double t_s) {
			return Eigen::Vector3d(off_m + going(1.0, 1.3, 0.8).x_m(t_s) * X);
		};
		return watch_at_90_hz(path, 3.0).names;
	};
	CHECK(beside(0.15 * Y).empty());
	CHECK(beside(-Z).empty());
	CHECK(beside(0.04 * Y) == times(1, "sideways"));
}
