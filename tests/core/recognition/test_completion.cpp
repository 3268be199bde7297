#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using test::Drag;
using test::Events;
using test::in_a_task;
using test::none_ends;
using test::X;

// A gesture counts from `completion` on, a share of its task's way. Scenes lower it for people who stop
// before a target that they cannot feel.

namespace {

constexpr double TASK_M = 0.2; ///< of Task{}

/// To `far` of the task's way, where it stays.
std::vector<Drag> to(double far, double onset_s = 0.5, double duration_s = 1.0) {
	return { Drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = far * TASK_M } };
}

std::vector<Drag> and_on(std::vector<Drag> way, double far, double onset_s, double duration_s) {
	way.push_back(to(far, onset_s, duration_s).front());
	return way;
}

Events with_completion(double share, const std::vector<Drag> &way, double length_s) {
	GestureRecogniser recogniser({ test::models()[0] }, Task{}, MotionMode::PHASE);
	recogniser.set_completion(share);
	return test::watch(recogniser, test::along(X, way), length_s);
}

} // namespace

TEST_CASE("a hand that stays short of completion ends nothing") {
	for (const double far : { 0.3, 0.5, 0.65, 0.8, 0.9 }) {
		for (const double duration_s : { 0.3, 1.0, 2.5 }) {
			CAPTURE(far);
			CAPTURE(duration_s);
			CHECK(none_ends(in_a_task(test::along(X, to(far, 0.5, duration_s)), duration_s + 4.0)));
		}
	}
}

TEST_CASE("a hand that stays beyond a completion of 70 % ends once, where it stays") {
	for (const double far : { 0.75, 0.8, 0.88 }) {
		for (const double duration_s : { 0.3, 1.0, 2.5 }) {
			CAPTURE(far);
			CAPTURE(duration_s);
			const Events events = with_completion(0.7, to(far, 0.5, duration_s), duration_s + 2.0);
			CHECK(events.said == test::times(1, "sideways"));
			CHECK(test::x_m(to(far, 0.5, duration_s), events.last_ended_s) > (far - 0.01) * TASK_M);
			CHECK(events.last_ended_s < 0.5 + duration_s + 0.8);
			CHECK(std::abs(events.last_value_m - far * TASK_M) < 0.002);
		}
	}
}

TEST_CASE("a hand that hesitates, or is slow, before its end ends there") {
	const auto hesitating = and_on(to(0.75, 0.5, 0.8), 0.25, 1.6, 0.5); // stands for 0.3 s
	const Events events = in_a_task(test::along(X, hesitating), 3.5);
	CHECK(events.said == test::times(1, "sideways"));
	CHECK(events.last_ended_s > 1.6);

	constexpr double SLOW_S = 4.0;
	const Events slow = in_a_task(test::along(X, to(1.0, 0.5, SLOW_S)), 6.5);
	CHECK(slow.said == test::times(1, "sideways"));
	CHECK(test::x_m(to(1.0, 0.5, SLOW_S), slow.last_ended_s) > 0.9 * TASK_M);
}

TEST_CASE("a hand that halts half-way and goes on ends within 0.2 s") {
	for (const double far : { 0.3, 0.4 }) {
		for (const double stands_s : { 0.2, 0.3, 0.5 }) {
			CAPTURE(far);
			CAPTURE(stands_s);
			const double goes_on_s = 0.5 + 0.4 + stands_s;
			const auto way = and_on(to(far, 0.5, 0.4), 1.0 - far, goes_on_s, 0.6);
			const Events events = in_a_task(test::along(X, way), goes_on_s + 2.0);
			CHECK(events.said == test::times(1, "sideways"));
			CHECK(events.last_ended_s < goes_on_s + 0.6 + 0.2);
		}
	}
}

TEST_CASE("a hand lost short of its end ends nothing until it is back") {
	constexpr double LOST_S = 1.45, FOUND_S = 2.2;
	const auto way = and_on(to(0.75, 0.5, 0.8), 0.25, 2.3, 0.5);
	const Events events = in_a_task(test::along(X, way), 4.0, LOST_S, FOUND_S);
	CHECK(events.said == test::times(1, "sideways"));
	CHECK(events.last_ended_s > FOUND_S);
}

TEST_CASE("only a hand that turns back beyond completion has made the gesture") {
	const auto turns = [](double far) { return and_on(to(far, 0.5, 0.4), -far, 0.95, 0.5); };
	for (const double far : { 0.8, 0.9, 0.98 }) {
		CAPTURE(far);
		CHECK(with_completion(0.7, turns(far), 3.0).said == test::times(1, "sideways"));
	}
	for (const double far : { 0.4, 0.6 }) {
		CAPTURE(far);
		CHECK(none_ends(with_completion(0.7, turns(far), 3.0)));
	}
	for (const double far : { 0.5, 0.7, 0.88 }) {
		CAPTURE(far);
		CHECK(none_ends(in_a_task(test::along(X, turns(far)), 3.0)));
	}
}

TEST_CASE("a hand at its end but far aside ends nothing") {
	const test::Way beside = [](double t_s) {
		const double x_m = test::x_m(to(1.0), t_s);
		return Eigen::Vector3d(x_m, 0.5 * TASK_M + 0.5 * x_m, 0.0);
	};
	CHECK(none_ends(in_a_task(beside, 3.5)));
}

TEST_CASE("only a hand that comes back near its start makes the gesture again") {
	for (const double left : { 0.05, 0.08, 0.22, 0.3, 0.5 }) {
		CAPTURE(left);
		auto way = and_on(to(1.0, 0.5, 0.8), left - 1.0, 2.0, 0.8);
		way = and_on(way, 1.0 - left, 3.5, 0.8);
		CHECK(in_a_task(test::along(X, way), 6.0).said == test::times(left < 0.15 ? 2 : 1, "sideways"));
	}
}

TEST_CASE("a hand that stops beyond completion but aside makes no gesture") {
	const auto beside = [](double angle_rad) {
		GestureRecogniser recogniser({ test::models()[0] }, Task{}, MotionMode::PHASE);
		recogniser.set_completion(0.7);
		const Eigen::Vector3d way(std::cos(angle_rad), std::sin(angle_rad), 0.0);
		return test::watch(recogniser, test::along(way, to(0.8 / std::cos(angle_rad))), 3.5);
	};
	CHECK(beside(0.15).said == test::times(1, "sideways"));
	CHECK(none_ends(beside(0.5)));
}

TEST_CASE("a hand that stops beyond completion without noise ends its gesture") {
	for (const double far : { 0.75, 0.85 }) {
		CAPTURE(far);
		GestureRecogniser recogniser({ test::models()[0] }, Task{}, MotionMode::PHASE);
		recogniser.set_completion(0.7);
		const Events events = test::watch(recogniser, test::along(X, to(far)), 3.5, 1e9, 1e9, 90.0, 0.0);
		CHECK(events.said == test::times(1, "sideways"));
	}
}
