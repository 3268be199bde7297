#pragma once

#include "gesture/task.h"
#include "hand_path.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand::matrix {

/// A hand before one task.
struct Hand {
	std::string name;
	HandPath path;
	double from_s = 0.0; ///< the movement in the task begins
	double to_s = 0.0;   ///< it has come to rest, or reached the task's end
	int ends = 1;        ///< how many ended gestures are right
};

inline constexpr double REST_S = 0.6;  ///< before the first movement
inline constexpr double AFTER_S = 1.3; ///< recorded after to_s

/// Unit vector across the task's axis, for axes in the xy plane.
inline Eigen::Vector3d across(const Task &task) {
	return Eigen::Vector3d::UnitZ().cross(task.axis).normalized();
}

inline std::string named(const char *what, double number, const char *unit) {
	char text[64];
	std::snprintf(text, sizeof text, "%s %g %s", what, number, unit);
	return text;
}

inline Hand moved(
		std::string name, const Task &task, double duration_s, double share, Profile profile, int ends) {
	const Stroke stroke{ REST_S, duration_s, share * task.amplitude_m * task.axis, profile };
	return { std::move(name), { task.start_m, { stroke } }, stroke.onset_s, stroke.end_s(), ends };
}

inline Hand resting(const Task &task) {
	return { "rest", { task.start_m, {} }, REST_S, REST_S + 1.0, 0 };
}

inline Hand reaching(const Task &task, double duration_s) {
	return moved(named("reach", duration_s, "s"), task, duration_s, 1.0, Profile::MINIMUM_JERK, 1);
}

/// At constant speed to a share of the way, there without braking.
inline Hand stopping_dead(const Task &task, double duration_s, double share) {
	return moved(named("dead stop", 100.0 * share, "%"), task, duration_s, share, Profile::CONSTANT_SPEED, 0);
}

inline Hand stopping_short(const Task &task, double duration_s, double share) {
	return moved(named("smooth stop", 100.0 * share, "%"), task, duration_s, share, Profile::MINIMUM_JERK, 0);
}

/// Where a reach to the task's start comes from.
enum class Approach : std::uint8_t { ACROSS, ALONG, ASLANT };

inline constexpr std::array APPROACHES{ Approach::ACROSS, Approach::ALONG, Approach::ASLANT };

/// Reaches 30 cm to the task's start, dwells there, and makes the gesture.
inline Hand pressing_after_reach(
		const Task &task, Approach approach, double reach_s, double dwell_s, double duration_s) {
	const Eigen::Vector3d side = across(task);
	const Eigen::Vector3d way = approach == Approach::ACROSS ? side
			: approach == Approach::ALONG                    ? task.axis
															 : (side + task.axis).normalized();
	const Stroke reach{ REST_S, reach_s, 0.3 * way };
	const Stroke press{ reach.end_s() + dwell_s, duration_s, task.amplitude_m * task.axis };
	constexpr std::array NAMES{ "across", "along", "aslant" };
	const std::string name = std::string("reach ") + NAMES[static_cast<std::size_t>(approach)];
	return { named((name + ", press after").c_str(), dwell_s, "s"),
		{ task.start_m - reach.way_m, { reach, press } }, press.onset_s, press.end_s(), 1 };
}

inline Hand going_there_and_back(const Task &task, double duration_s, double pause_s) {
	Hand hand = reaching(task, duration_s);
	hand.name = named("there and back, pause", pause_s, "s");
	hand.path.strokes.push_back({ hand.to_s + pause_s, duration_s, -task.amplitude_m * task.axis });
	return hand;
}

/// Halts half-way and goes on.
inline Hand halting(const Task &task, double halt_s) {
	const Eigen::Vector3d half_m = 0.5 * task.amplitude_m * task.axis;
	const Stroke first{ REST_S, 0.5, half_m };
	const Stroke second{ first.end_s() + halt_s, 0.5, half_m };
	return { named("halt", halt_s, "s"), { task.start_m, { first, second } }, first.onset_s, second.end_s(),
		1 };
}

/// Does not stop at the task's end; `share` of the way is where it stops, > 1.
inline Hand passing_the_end(const Task &task, double duration_s, double share) {
	Hand hand = moved(
			named("past the end, to", 100.0 * share, "%"), task, duration_s, share, Profile::MINIMUM_JERK, 1);
	hand.to_s = hand.from_s + duration_s * minimum_jerk_share(1.0 / share);
	return hand;
}

} // namespace steadyhand::matrix
