#pragma once

#include "gesture/task.h"
#include "tracking/frame.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace steadyhand {

/// Where a hand is for a feature, m, the start left out of account. Of a fingertip: x, y, z and 0; of three:
/// x, y, how far their circle is from being their own size, and its radius.
using FeaturePlace = Eigen::Vector4d;

/// A motion element: one number in metres, 0 where the task starts and the task's amplitude where it ends.
struct Feature {
	std::string_view name; ///< as written in model files
	std::uint8_t joints;   ///< that it needs: joint_bits()
	/// Nothing where a joint it needs is not tracked in the frame, or where the joints do not determine it.
	std::optional<double> (*measure)(const HandFrame &frame, const Task &task);
	/// Nothing where measure gives nothing. Differences of places along `direction` are differences of the
	/// motion element; across it they speak against the gesture. Null, as `direction` is
	/// then, where the way is not straight.
	std::optional<FeaturePlace> (*place)(const HandFrame &frame);
	/// Unit vector; the motion element's growth.
	FeaturePlace (*direction)(const Task &task);
	/// The way after which the hand is where it was, m: measure tells values apart within half of it on
	/// either side of 0, and MotionElement counts the rounds. Null where there is no such way.
	double (*period_m)(const Task &task) = nullptr;
	/// How far the hand is from the task's way, m; of a frame that measure takes. Null where places tell.
	double (*off_way_m)(const HandFrame &frame, const Task &task) = nullptr;
	bool is_radius = false; ///< Task::start_m.x is a radius, and no place
	/// How many times as freely as with a task lengths differ from the model's where no task says them.
	double open_gain_spread = 1.0;
	/// What a metre of each coordinate of places counts in strokes.
	std::array<double, 4> place_shares{ 1.0, 1.0, 1.0, 1.0 };
};

/// Every feature there is. A new one is a row of the table in feature.cpp.
std::span<const Feature> features();

/// Null where there is none of that name.
const Feature *find_feature(std::string_view name);

} // namespace steadyhand
