#pragma once

#include "gesture/task.h"
#include "tracking/frame.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace steadyhand {

/// Why no gesture starts at the tasks of a scene, though a hand is there and moves.
struct TaskDoubt {
	enum class Kind : std::uint8_t {
		FAR,      ///< the hand is never near the start of any task
		OTHER_WAY ///< the hand leaves a task's start again and again, and each time another way than the
				  ///< task's
	};
	Kind kind;
	std::size_t task;                              ///< the nearest one, or the one that is left
	double distance_m = 0.0;                       ///< FAR: the least distance to its start
	Eigen::Vector3d way = Eigen::Vector3d::Zero(); ///< OTHER_WAY: unit vector; the mean of what the hand did
};

/// Watches the index tip about tasks that are a straight way of it, until a first gesture starts: then the
/// scene is as it should be.
class TaskWatch {
public:
	/// Begins anew with these.
	void expect(const std::vector<Task> &tasks);
	void gesture_started() { is_over_ = true; }

	/// Says something once. Allocates nothing.
	std::optional<TaskDoubt> look(const HandFrame &frame);

private:
	/// A player looks around for so long, and has moved the hand so far.
	static constexpr double PATIENCE_S = 10.0, MOVED_M = 2.0;
	/// Further away than a hand aims beside a start that it sees.
	static constexpr double NEAR_M = 0.15;
	/// A way is told after this share of the amplitude, and is the task's within 60 degrees (cosine).
	static constexpr double LEFT_SHARE = 0.6, SAME_WAY = 0.5;
	/// So many departures in a row that agree with each other are meant.
	static constexpr int DEPARTURES = 3;
	static constexpr double AGREE = 0.8;
	/// Of a longer step between frames the hand's path says nothing.
	static constexpr double LONGEST_STEP_M = 0.2;

	struct Watched {
		Task task;
		double nearest_m;
		bool is_at_start = false;
		int departures = 0;
		Eigen::Vector3d way_sum = Eigen::Vector3d::Zero();
	};

	std::vector<Watched> tasks_;
	bool is_over_ = false;
	std::optional<double> first_s_;
	std::optional<Eigen::Vector3d> last_m_;
	double moved_m_ = 0.0;

	/// Whether the hand has left the start of `r_task` a last time.
	static bool leaves_other_way(Watched &r_task, const Eigen::Vector3d &tip_m);
};

} // namespace steadyhand
