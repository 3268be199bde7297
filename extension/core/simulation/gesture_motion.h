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

/// What a scene asks the hand to do, in the terms of trials.csv.
struct GestureTask {
	Eigen::Vector3d start_m =
			Eigen::Vector3d::Zero(); ///< of the index tip; the circle's centre where there is one
	Eigen::Vector3d axis = Eigen::Vector3d::Zero();
	double amplitude_m = 0.0;
	double radius_m = 0.0; ///< of zoom's circle at the start; of the circle that the hand goes along
};

/// The way one hand takes through a task.
struct HandPath {
	GestureTask task;
	Eigen::Vector3d start_error_m = Eigen::Vector3d::Zero(); ///< sideways, see Subject::aim_deviation_m
	Eigen::Vector3d end_error_m = Eigen::Vector3d::Zero();
	Eigen::Vector3d bow_m = Eigen::Vector3d::Zero(); ///< offset at half way
	double hand_scale = 1.0;
};

/// The hand at a progress of 0 (start) .. 1 (end of the task) or beyond.
using PlaceHand = HandFrame (*)(const HandPath &path, double progress);

/// The simulation's knowledge of one gesture. A new one is a new row.
struct SimulatedGesture {
	std::string_view name;
	/// Unit vectors of the tasks, half of them each. All 0: the task has no axis, or one only.
	std::array<double, 3> axis, other_axis;
	double amplitude_m;
	double radius_m;
	double duration_mean_s; ///< onset to end over all people and trials
	double duration_deviation_s;
	/// The hand goes through the end of the task by this much and turns back; 0: it stops there.
	double through_min_m, through_max_m;
	PlaceHand place;
	/// The worked example of a new gesture (docs/new_gesture.md): made where it is asked for by name.
	bool is_example = false;
};

[[nodiscard]] std::span<const SimulatedGesture> simulated_gestures();
/// Null where there is none of that name.
[[nodiscard]] const SimulatedGesture *find_simulated_gesture(std::string_view name);

/// A task of that gesture where the sensor sees the hand well or badly. The sensor is at the origin and looks
/// along -z.
[[nodiscard]] GestureTask draw_task(const SimulatedGesture &gesture, HandPosition position, Random &r_random);

/// The pace (Subject::pace) at which a gesture is made along `axis` if this one is asked for. A slow strike
/// down is a drag, so that people strike down at their own pace at least.
[[nodiscard]] double possible_pace(std::string_view gesture, const Eigen::Vector3d &axis, double pace);

/// Shortest and longest gesture that is made.
inline constexpr double GESTURE_MIN_S = 0.15;
inline constexpr double GESTURE_MAX_S = 4.0;

/// One execution. `duration_s`: from onset to end, clamped to the limits above; 0 leaves it to the person.
[[nodiscard]] TrueMotion make_gesture_motion(const SimulatedGesture &gesture, const GestureTask &task,
		HandPosition position, const Subject &subject, double duration_s, Random &r_random);

/// The progress of one execution that takes `duration_s` from 0 to the task's end.
[[nodiscard]] Progress make_progress(
		const SimulatedGesture &gesture, const Subject &subject, double duration_s, Random &r_random);

/// When the task is over: progress stays within 2 % of where it ends, or passes 1 where the hand goes
/// through.
[[nodiscard]] double task_end_s(const SimulatedGesture &gesture, const Progress &progress);

/// Centre of the hand's place in front of the sensor.
[[nodiscard]] Eigen::Vector3d hand_place_m(HandPosition position);

} // namespace steadyhand
