#pragma once

#include "gesture/task.h"
#include "tracking/frame.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace steadyhand {

/// Position of a hand for a feature, m, not relative to a start. One fingertip: x, y, z and 0. Three
/// fingertips: x and y of their mean, radius of their circle minus their size, and this radius.
using FeaturePlace = Eigen::Vector4d;

/// A motion element: one number in metres. It is 0 at the task's start and the amplitude at its end.
struct Feature {
	std::string_view name; ///< as written in model files
	std::uint8_t joints;   ///< required joints, as joint_bits()
	/// Value in a frame, m. nullopt if a required joint is not tracked, or if the joints do not determine it.
	std::optional<double> (*measure)(const HandFrame &frame, const Task &task);
	/// Position in a frame; nullopt if measure gives nullopt. A displacement along `direction` changes the
	/// motion element by the same amount; a displacement across it is evidence against the gesture. place
	/// and direction are null if the path is not straight.
	std::optional<FeaturePlace> (*place)(const HandFrame &frame);
	/// Unit vector in which the motion element grows.
	FeaturePlace (*direction)(const Task &task);
	/// Length of a closed path, m. measure gives values within half of it on either side of 0; MotionElement
	/// counts the rounds. Null if the path is not closed.
	double (*period_m)(const Task &task) = nullptr;
	/// Distance of the hand from the task's path, m, in a frame for which measure has a value. Null if the
	/// path is straight.
	double (*path_distance_m)(const HandFrame &frame, const Task &task) = nullptr;
	bool is_radius = false; ///< Task::start_m.x is a radius, not a position
	/// Factor of the standard deviation of the endpoint without a task.
	double no_task_gain_factor = 1.0;
	/// Weights of the coordinates of FeaturePlace in TaskEvidence.
	std::array<double, 4> coordinate_weights{ 1.0, 1.0, 1.0, 1.0 };
};

/// All features. A new one is a row of the table in feature.cpp.
std::span<const Feature> features();

/// Null if no feature has this name.
const Feature *find_feature(std::string_view name);

} // namespace steadyhand
