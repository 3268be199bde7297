#include "gesture/task_watch.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

namespace {

constexpr double FRAME_S = 0.01;

/// Number of reports. The hand moves from `from_m` by `move_m` and back within 3 s, for `duration_s`.
int reports(TaskWatch &r_watch, const Eigen::Vector3d &from_m, const Eigen::Vector3d &move_m,
		double duration_s, std::optional<TaskFault> &r_last) {
	int count = 0;
	for (int i = 0; i * FRAME_S < duration_s; ++i) {
		const double t_s = i * FRAME_S;
		const double share = 0.5 - 0.5 * std::cos(t_s * 2.0 * 3.14159265358979 / 3.0);
		HandFrame frame;
		frame.t_s = t_s;
		frame.set(Joint::INDEX, from_m + share * move_m);
		if (const auto fault = r_watch.push(frame)) {
			++count;
			r_last = fault;
		}
	}
	return count;
}

Task task_at(const Eigen::Vector3d &start_m) {
	return { start_m, Eigen::Vector3d::UnitX(), 0.2 };
}

} // namespace

TEST_CASE("a hand that is never near a task is reported once") {
	TaskWatch watch;
	watch.expect({ task_at({ 5.0, 0.0, 0.0 }), task_at({ 0.5, 0.0, 0.0 }) });
	std::optional<TaskFault> last;
	CHECK(reports(watch, Eigen::Vector3d::Zero(), { 0.0, 0.3, 0.0 }, 60.0, last) == 1);
	REQUIRE(last);
	CHECK(last->kind == TaskFault::Kind::FAR);
	CHECK(last->task == 1);
	CHECK(last->distance_m == doctest::Approx(0.5));
}

TEST_CASE("a hand that leaves the start in another direction is reported once") {
	TaskWatch watch;
	watch.expect({ task_at(Eigen::Vector3d::Zero()) });
	std::optional<TaskFault> last;
	CHECK(reports(watch, Eigen::Vector3d::Zero(), { -0.2, 0.0, 0.0 }, 60.0, last) == 1);
	REQUIRE(last);
	CHECK(last->kind == TaskFault::Kind::OTHER_DIRECTION);
	CHECK(last->direction.isApprox(-Eigen::Vector3d::UnitX()));
}

TEST_CASE("a hand that rests far from a task is not reported") {
	TaskWatch watch;
	watch.expect({ task_at({ 1.0, 0.0, 0.0 }) });
	std::optional<TaskFault> last;
	CHECK(reports(watch, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 60.0, last) == 0);
}

TEST_CASE("a hand on the task's path, or after a gesture, is not reported") {
	TaskWatch watch;
	watch.expect({ task_at(Eigen::Vector3d::Zero()) });
	std::optional<TaskFault> last;
	CHECK(reports(watch, Eigen::Vector3d::Zero(), { 0.2, 0.05, 0.0 }, 60.0, last) == 0);
	watch.gesture_started();
	watch.expect({ task_at({ 1.0, 0.0, 0.0 }) });
	CHECK(reports(watch, Eigen::Vector3d::Zero(), { 0.0, 0.3, 0.0 }, 60.0, last) == 0);
}

TEST_CASE("a short track that is repeated is judged as one long track") {
	TaskWatch beside, far;
	std::optional<TaskFault> last;
	int of_beside = 0, of_far = 0;
	for (int i = 0; i < 20; ++i) {
		beside.expect({ task_at(Eigen::Vector3d::Zero()) });
		of_beside += reports(beside, Eigen::Vector3d::Zero(), { 0.0, 0.2, 0.0 }, 3.0, last);
		far.expect({ task_at({ 0.5, 0.0, 0.0 }) });
		of_far += reports(far, Eigen::Vector3d::Zero(), { 0.0, 0.2, 0.0 }, 3.0, last);
	}
	CHECK(of_beside == 1);
	CHECK(of_far == 1);
}

TEST_CASE("moved tasks are watched from the beginning") {
	TaskWatch watch;
	std::optional<TaskFault> last;
	for (int i = 0; i < 20; ++i) {
		watch.expect({ task_at({ 1.0 + i, 0.0, 0.0 }) });
		CHECK(reports(watch, Eigen::Vector3d::Zero(), { 0.0, 0.3, 0.0 }, 3.0, last) == 0);
	}
}
