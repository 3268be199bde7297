#include "gesture/task_watch.h"

#include <algorithm>
#include <limits>

namespace steadyhand {

void TaskWatch::expect(const std::vector<Task> &tasks) {
	last_s_.reset();
	last_m_.reset();
	if (std::ranges::equal(tasks, tasks_, {}, {}, &Watched::task)) {
		for (Watched &one : tasks_) {
			one.is_at_start = false; // the hand may begin elsewhere
		}
		return;
	}
	tasks_.clear();
	for (const Task &task : tasks) {
		tasks_.push_back({ task, std::numeric_limits<double>::infinity() });
	}
	watched_s_ = 0.0;
	moved_m_ = 0.0;
}

bool TaskWatch::leaves_in_other_direction(Watched &r_task, const Eigen::Vector3d &tip_m) {
	const Eigen::Vector3d displacement_m = tip_m - r_task.task.start_m;
	const double distance_m = displacement_m.norm();
	if (distance_m < 0.25 * r_task.task.amplitude_m) {
		r_task.is_at_start = true;
	}
	if (!r_task.is_at_start || distance_m < LEFT_SHARE * r_task.task.amplitude_m) {
		return false;
	}
	r_task.is_at_start = false;
	const Eigen::Vector3d direction = displacement_m / distance_m;
	const bool is_other = direction.dot(r_task.task.axis) < SAME_DIRECTION;
	const bool agrees =
			r_task.departures == 0 || direction.dot(r_task.direction_sum.normalized()) > SAME_DEPARTURE;
	if (!is_other || !agrees) {
		r_task.departures = 0;
		r_task.direction_sum.setZero();
	}
	if (is_other) {
		++r_task.departures;
		r_task.direction_sum += direction;
	}
	return r_task.departures >= DEPARTURES;
}

std::optional<TaskFault> TaskWatch::push(const HandFrame &frame) {
	if (is_over_ || tasks_.empty() || !frame.has(Joint::INDEX)) {
		return std::nullopt;
	}
	const Eigen::Vector3d &tip_m = frame.position(Joint::INDEX);
	const double step_m = last_m_ ? (tip_m - *last_m_).norm() : 0.0;
	moved_m_ += step_m < LONGEST_STEP_M ? step_m : 0.0;
	last_m_ = tip_m;
	watched_s_ += frame.t_s - last_s_.value_or(frame.t_s);
	last_s_ = frame.t_s;
	for (std::size_t i = 0; i < tasks_.size(); ++i) {
		Watched &one = tasks_[i];
		one.nearest_m = std::min(one.nearest_m, (tip_m - one.task.start_m).norm());
		if (leaves_in_other_direction(one, tip_m)) {
			is_over_ = true;
			return TaskFault{ TaskFault::Kind::OTHER_DIRECTION, i, one.nearest_m,
				one.direction_sum.normalized() };
		}
	}
	if (watched_s_ < WATCHED_S || moved_m_ < MOVED_M) {
		return std::nullopt;
	}
	const auto nearest = std::min_element(tasks_.begin(), tasks_.end(),
			[](const Watched &one, const Watched &other) { return one.nearest_m < other.nearest_m; });
	if (nearest->nearest_m < NEAR_M) {
		return std::nullopt;
	}
	is_over_ = true;
	return TaskFault{ TaskFault::Kind::FAR, static_cast<std::size_t>(nearest - tasks_.begin()),
		nearest->nearest_m };
}

} // namespace steadyhand
