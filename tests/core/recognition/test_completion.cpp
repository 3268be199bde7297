// With a task, a gesture ends if the hand stops beyond `completion`, a fraction of the amplitude. Scenes
// lower it for people who stop short of a target that they cannot feel.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double TASK_M = 0.2; ///< amplitude of Task{}

/// A drag to `far` of the amplitude, where the hand stays.
std::vector<Drag> to(double far, double onset_s = 0.5, double duration_s = 1.0) {
	return { Drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = far * TASK_M } };
}

std::vector<Drag> and_on(std::vector<Drag> path, double far, double onset_s, double duration_s) {
	path.push_back(to(far, onset_s, duration_s).front());
	return path;
}

/// Events with a completion of 70 %.
Events lowered(const TestPath &path, double length_s, double noise_m = 1e-4) {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	recogniser.set_completion(0.7);
	return watch(recogniser, path, length_s, 1e9, 1e9, 110.0, noise_m);
}

} // namespace

TEST_CASE("a hand that stops short of completion ends nothing") {
	for (const double far : { 0.3, 0.9 }) {
		for (const double duration_s : { 0.3, 2.5 }) {
			INFO("far ", far, ", duration ", duration_s);
			CHECK(has_no_end(watch_with_task(along(X, to(far, 0.5, duration_s)), duration_s + 4.0)));
		}
	}
}

TEST_CASE("a hand that stops beyond a completion of 70 % ends there") {
	for (const double far : { 0.75, 0.88 }) {
		for (const double duration_s : { 0.3, 2.5 }) {
			for (const double noise_m : { 0.0, 1e-4 }) {
				INFO("far ", far, ", duration ", duration_s, ", noise ", noise_m);
				const std::vector<Drag> strokes = to(far, 0.5, duration_s);
				const Events events = lowered(along(X, strokes), duration_s + 2.0, noise_m);
				CHECK(events.names == times(1, "sideways"));
				CHECK(x_m(strokes, events.last_ended_s) > (far - 0.01) * TASK_M);
				CHECK(events.last_ended_s < 0.5 + duration_s + 0.8);
				CHECK(std::abs(events.last_value_m - far * TASK_M) < 0.002);
			}
		}
	}
}

TEST_CASE("a movement of 4 s ends beyond 90 % of its amplitude") {
	const std::vector<Drag> slow = to(1.0, 0.5, 4.0);
	const Events events = watch_with_task(along(X, slow), 6.5);
	CHECK(events.names == times(1, "sideways"));
	CHECK(x_m(slow, events.last_ended_s) > 0.9 * TASK_M);
}

TEST_CASE("a gesture with a pause ends within 0.2 s of its endpoint") {
	for (const double far : { 0.3, 0.4 }) {
		for (const double halts_s : { 0.2, 0.5 }) {
			INFO("far ", far, ", halts ", halts_s);
			const double continues_s = 0.5 + 0.4 + halts_s;
			const auto strokes = and_on(to(far, 0.5, 0.4), 1.0 - far, continues_s, 0.6);
			const Events events = watch_with_task(along(X, strokes), continues_s + 2.0);
			CHECK(events.names == times(1, "sideways"));
			CHECK(events.last_ended_s < continues_s + 0.6 + 0.2);
		}
	}
	const Events late = watch_with_task(along(X, and_on(to(0.75, 0.5, 0.8), 0.25, 1.6, 0.5)), 3.5);
	CHECK(late.names == times(1, "sideways"));
	CHECK_MESSAGE(late.last_ended_s > 1.6, "not during the pause at three quarters");
}

TEST_CASE("a hand that turns back ends only beyond completion") {
	const auto turns = [](double far) { return along(X, and_on(to(far, 0.5, 0.4), -far, 0.95, 0.5)); };
	CHECK(lowered(turns(0.8), 3.0).names == times(1, "sideways"));
	CHECK(lowered(turns(0.98), 3.0).names == times(1, "sideways"));
	CHECK(has_no_end(lowered(turns(0.6), 3.0)));
	CHECK(has_no_end(watch_with_task(turns(0.5), 3.0)));
	CHECK(has_no_end(watch_with_task(turns(0.88), 3.0)));
}

TEST_CASE("a hand that stops beside the target ends nothing") {
	const TestPath beside = [](double t_s) {
		const double moved_m = x_m(to(1.0), t_s);
		return Eigen::Vector3d(moved_m, 0.5 * TASK_M + 0.5 * moved_m, 0.0);
	};
	CHECK(has_no_end(watch_with_task(beside, 3.5)));
	const auto oblique = [](double angle_rad) {
		const Eigen::Vector3d axis(std::cos(angle_rad), std::sin(angle_rad), 0.0);
		return along(axis, to(0.8 / std::cos(angle_rad)));
	};
	CHECK(lowered(oblique(0.15), 3.5).names == times(1, "sideways"));
	CHECK(has_no_end(lowered(oblique(0.5), 3.5)));
}

TEST_CASE("only a hand that returns near its start makes the gesture again") {
	for (const double left : { 0.05, 0.08, 0.22, 0.5 }) {
		CAPTURE(left);
		auto strokes = and_on(to(1.0, 0.5, 0.8), left - 1.0, 2.0, 0.8);
		strokes = and_on(strokes, 1.0 - left, 3.5, 0.8);
		CHECK(watch_with_task(along(X, strokes), 6.0).names == times(left < 0.15 ? 2 : 1, "sideways"));
	}
}
