#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using test::Drag;
using test::Events;
using test::in_a_task;
using test::X;

// A hand that ends short of its task has made the gesture all the same: people stop a tenth or two of the way
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

} // namespace

TEST_CASE("a hand that stays short of its task's end has made the gesture, once it has stayed") {
	for (const double far : { 0.72, 0.8, 0.88 }) {
		for (const double duration_s : { 0.3, 1.0, 2.5 }) {
			CAPTURE(far);
			CAPTURE(duration_s);
			const Events events = in_a_task(test::along(X, to(far, 0.5, duration_s)), duration_s + 2.0);
			CHECK(events.said == test::times(1, "sideways"));
			CHECK(test::x_m(to(far, 0.5, duration_s), events.last_ended_s) > (far - 0.01) * TASK_M);
			CHECK(events.last_ended_s < 0.5 + duration_s + 0.6);
			CHECK(std::abs(events.last_value_m - far * TASK_M) < 0.002);
		}
	}
}

TEST_CASE("a hand that sways by some millimetres where it ended short has stayed there, one that goes on has "
		  "not") {
	const auto staying = [](double sway, double creep_per_s) {
		return [=](double t_s) {
			const double since_s = std::max(t_s - 1.5, 0.0);
			const double share = sway * std::sin(9.0 * since_s) + creep_per_s * since_s;
			return Eigen::Vector3d(test::x_m(to(0.78), t_s) + share * TASK_M, 0.0, 0.0);
		};
	};
	const Events swaying = in_a_task(staying(0.018, 0.0), 3.0);
	CHECK(swaying.said == test::times(1, "sideways"));
	CHECK(swaying.last_ended_s < 2.1);
	// By a fifth of the way a second: it is on its way to the end.
	CHECK(in_a_task(staying(0.0, 0.2), 2.05).said == std::vector<std::string>{ "started sideways" });
}

TEST_CASE("one that halts half-way has not, however long it stays") {
	for (const double far : { 0.3, 0.5, 0.65 }) {
		CAPTURE(far);
		CHECK(test::none_ends(in_a_task(test::along(X, to(far)), 6.0)));
	}
}

TEST_CASE("a hand that hesitates before its end, or is slow there, ends where it ends") {
	const auto hesitating = and_on(to(0.75, 0.5, 0.8), 0.25, 1.6, 0.5); // stands for 0.3 s
	const Events events = in_a_task(test::along(X, hesitating), 3.5);
	CHECK(events.said == test::times(1, "sideways"));
	CHECK(events.last_ended_s > 1.6);

	constexpr double SLOW_S = 4.0;
	const Events slow = in_a_task(test::along(X, to(1.0, 0.5, SLOW_S)), 6.5);
	CHECK(slow.said == test::times(1, "sideways"));
	CHECK(test::x_m(to(1.0, 0.5, SLOW_S), slow.last_ended_s) > 0.9 * TASK_M);
}

TEST_CASE("a hand that hesitated half-way and goes on ends soon after it has come to its end") {
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

TEST_CASE("a hand that halted short of the end and is not seen there has ended nothing yet") {
	constexpr double LOST_S = 1.45, FOUND_S = 2.2;
	const auto way = and_on(to(0.75, 0.5, 0.8), 0.25, 2.3, 0.5);
	const Events events = in_a_task(test::along(X, way), 4.0, LOST_S, FOUND_S);
	CHECK(events.said == test::times(1, "sideways"));
	CHECK(events.last_ended_s > FOUND_S);
}

TEST_CASE("a hand that turns back shortly before its end has made the gesture, one that does half-way has "
		  "not") {
	for (const double far : { 0.84, 0.9, 0.95 }) {
		CAPTURE(far);
		CHECK(in_a_task(test::along(X, and_on(to(far, 0.5, 0.4), -far, 0.95, 0.5)), 3.0).said ==
				test::times(1, "sideways"));
	}
	for (const double far : { 0.5, 0.7 }) {
		CAPTURE(far);
		CHECK(test::none_ends(in_a_task(test::along(X, and_on(to(far, 0.5, 0.4), -far, 0.95, 0.5)), 3.0)));
	}
}

TEST_CASE(
		"a hand that slips back a little before its end goes on to it, one that slips further ended there") {
	constexpr double TURNS_S = 1.3, GOES_ON_S = 1.55;
	for (const double slip : { 0.06, 0.07, 0.14, 0.15 }) {
		CAPTURE(slip);
		auto way = and_on(to(0.85, 0.5, 0.8), -slip, TURNS_S, GOES_ON_S - TURNS_S);
		way = and_on(way, 0.15 + slip, GOES_ON_S, 0.4);
		const Events events = in_a_task(test::along(X, way), 3.5);
		CHECK(events.said == test::times(1, "sideways"));
		const double ends_s = events.last_ended_s;
		CHECK((slip < 0.1 ? ends_s > GOES_ON_S + 0.13 : ends_s < GOES_ON_S - 0.02));
	}
}

TEST_CASE("a hand that comes to its end far beside the way has a quarter of a second to have made the "
		  "gesture") {
	const test::Way beside = [](double t_s) {
		const double x_m = test::x_m(to(1.0), t_s);
		return Eigen::Vector3d(x_m, 0.5 * TASK_M + 0.5 * x_m, 0.0);
	};
	// It is at the end 0.02 s before it stops there.
	constexpr double END_S = 1.48;
	CHECK(in_a_task(beside, END_S + 0.22).said == std::vector<std::string>{ "started sideways" });
	CHECK(in_a_task(beside, END_S + 0.47).said ==
			std::vector<std::string>{ "started sideways", "aborted sideways" });
}

TEST_CASE("a hand that comes back to near its start makes the gesture again, one that comes half-way back "
		  "does not") {
	for (const double left : { 0.05, 0.08, 0.22, 0.3, 0.5 }) {
		CAPTURE(left);
		auto way = and_on(to(1.0, 0.5, 0.8), left - 1.0, 2.0, 0.8);
		way = and_on(way, 1.0 - left, 3.5, 0.8);
		CHECK(in_a_task(test::along(X, way), 6.0).said == test::times(left < 0.15 ? 2 : 1, "sideways"));
	}
}

TEST_CASE("a hand that stops short and beside the task's way goes about something else") {
	const auto beside = [](double angle_rad) {
		const Eigen::Vector3d way(std::cos(angle_rad), std::sin(angle_rad), 0.0);
		return in_a_task(test::along(way, to(0.8 / std::cos(angle_rad))), 3.5);
	};
	CHECK(beside(0.15).said == test::times(1, "sideways"));
	CHECK(test::none_ends(beside(0.5)));
}

TEST_CASE("a hand that ends short has made the gesture also before a tracker that repeats itself") {
	for (const double far : { 0.75, 0.85 }) {
		CAPTURE(far);
		GestureRecogniser recogniser({ test::models()[0] }, Task{}, MotionMode::PHASE);
		const Events events = test::watch(recogniser, test::along(X, to(far)), 3.5, 1e9, 1e9, 90.0, 0.0);
		CHECK(events.said == test::times(1, "sideways"));
	}
}
