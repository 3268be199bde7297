#pragma once

#include "gesture/task.h"
#include "tracking/frame.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace steadyhand {

/// Why no gesture starts at the tasks of a scene, although a hand moves.
struct TaskFault {
	enum class Kind : std::uint8_t {
		FAR,            ///< the hand was never near the start of a task
		OTHER_DIRECTION ///< the hand leaves a task's start repeatedly, in a direction that is not the task's
	};
	Kind kind;
	std::size_t task;        ///< FAR: the nearest task; otherwise the task that is left
	double distance_m = 0.0; ///< least distance to its start
	Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< OTHER_DIRECTION: mean direction, unit vector
};

/// Monitors the index tip near tasks with a straight path, until the first gesture starts.
class TaskWatch {
public:
	/// Watches these tasks. If they are the same as before, the watch goes on: a recording that is played
	/// again and again must not end it.
	void expect(const std::vector<Task> &tasks);
	void gesture_started() { is_over_ = true; }

	/// Returns a fault at most once. Does not allocate.
	std::optional<TaskFault> push(const HandFrame &frame);

private:
	/// FAR needs this time and this length of the hand's path.
	static constexpr double WATCHED_S = 10.0, MOVED_M = 2.0;
	/// FAR needs a greater distance. A hand comes closer to a start that the player sees.
	static constexpr double NEAR_M = 0.15;
	/// A direction is measured at this share of the amplitude. It is the task's within 60 degrees (cosine).
	static constexpr double LEFT_SHARE = 0.6, SAME_DIRECTION = 0.5;
	/// OTHER_DIRECTION needs this many departures in a row, with this cosine between them.
	static constexpr int DEPARTURES = 3;
	static constexpr double SAME_DEPARTURE = 0.8;
	/// Longer steps between frames do not count for the hand's path.
	static constexpr double LONGEST_STEP_M = 0.2;

	struct Watched {
		Task task;
		double nearest_m;
		bool is_at_start = false;
		int departures = 0;
		Eigen::Vector3d direction_sum = Eigen::Vector3d::Zero();
	};

	std::vector<Watched> tasks_;
	bool is_over_ = false;
	double watched_s_ = 0.0;
	std::optional<double> last_s_; ///< of the newest frame since expect()
	std::optional<Eigen::Vector3d> last_m_;
	double moved_m_ = 0.0;

	/// True at the last of DEPARTURES from the start of `r_task` in another direction.
	static bool leaves_in_other_direction(Watched &r_task, const Eigen::Vector3d &tip_m);
};

} // namespace steadyhand
