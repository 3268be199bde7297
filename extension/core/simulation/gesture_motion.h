#pragma once

#include "simulation/progress.h"
#include "simulation/subject.h"
#include "simulation/true_motion.h"
#include "tracking/trial_set.h"

#include <Eigen/Core>

#include <array>
#include <span>
#include <string_view>

namespace steadyhand {

/// A task, with the columns of trials.csv.
struct GestureTask {
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero(); ///< of the index tip; for zoom the circle's centre
	Eigen::Vector3d axis = Eigen::Vector3d::Zero();
	double amplitude_m = 0.0;
	double radius_m = 0.0; ///< of zoom's circle at the start; of a circular path
};

/// Path of one hand in a task.
struct HandPath {
	GestureTask task;
	Eigen::Vector3d start_error_m =
			Eigen::Vector3d::Zero(); ///< across the axis, see Subject::aim_deviation_m
	Eigen::Vector3d end_error_m = Eigen::Vector3d::Zero();
	Eigen::Vector3d bow_m = Eigen::Vector3d::Zero(); ///< offset at the middle of the path
	double hand_scale = 1.0;
};

/// The hand at a progress from 0 (start) to 1 (end of the task) or beyond.
using PlaceHand = HandFrame (*)(const HandPath &path, double progress);

/// A simulated gesture. A new one is a row of the table in gesture_motion.cpp.
struct SimulatedGesture {
	std::string_view name;
	/// Unit vectors of the tasks, each of half of them. 0: there is no axis, or no other axis.
	std::array<double, 3> axis, other_axis;
	double amplitude_m;
	double radius_m;
	double duration_mean_s; ///< onset to end, over all people and trials
	double duration_deviation_s;
	/// The hand passes the task's end by this distance and turns back; 0: it stops at the end.
	double through_min_m, through_max_m;
	PlaceHand place;
	/// The worked example of a new gesture (docs/new_gesture.md). It is made only on request by name.
	bool is_example = false;
};

[[nodiscard]] std::span<const SimulatedGesture> simulated_gestures();
/// Null if no gesture has this name.
[[nodiscard]] const SimulatedGesture *find_simulated_gesture(std::string_view name);

/// A random task of a gesture at a stable or unstable position. The sensor is at the origin and looks along
/// -z.
[[nodiscard]] GestureTask draw_task(const SimulatedGesture &gesture, HandPosition position, Random &r_random);

/// The pace (Subject::pace) of a gesture along `axis` for the requested `pace`. It is at most 1 for a strike
/// down: a slow strike down is a drag.
[[nodiscard]] double possible_pace(std::string_view gesture, const Eigen::Vector3d &axis, double pace);

/// Shortest and longest duration of a gesture.
inline constexpr double GESTURE_MIN_S = 0.15;
inline constexpr double GESTURE_MAX_S = 4.0;

/// One execution of a gesture. duration_s: onset to end, clamped to the limits above; 0: the person's own.
[[nodiscard]] TrueMotion make_gesture_motion(const SimulatedGesture &gesture, const GestureTask &task,
		HandPosition position, const Subject &subject, double duration_s, Random &r_random);

/// Progress of one execution that reaches the task's end after duration_s.
[[nodiscard]] Progress make_progress(
		const SimulatedGesture &gesture, const Subject &subject, double duration_s, Random &r_random);

/// Time of the task's end: the progress stays within 2 % of its final value or, for a gesture that passes the
/// end, reaches 1.
[[nodiscard]] double task_end_s(const SimulatedGesture &gesture, const Progress &progress);

/// Mean position of the hand in front of the sensor.
[[nodiscard]] Eigen::Vector3d hand_place_m(HandPosition position);

} // namespace steadyhand
