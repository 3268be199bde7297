#pragma once

#include "base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// Stands for no gesture: in a trial where none is made, and in results where none is recognised.
inline constexpr std::string_view NO_GESTURE = "none";

/// Where the hand is in front of the sensor: where it tracks well, or where range and self-occlusion spoil
/// it.
enum class HandPosition : std::uint8_t { STABLE, UNSTABLE };

/// One row of a trial set's `trials.csv`. Its tracks are `TRIAL.measured.csv` and `TRIAL.reference.csv`
/// beside it, on one clock.
struct Trial {
	std::string trial; ///< unique in its set, safe as a file name
	std::string
			gesture; ///< `horizontal_drag`, `vertical_drag`, `tap`, `zoom`, `none` or a trained one's name
	HandPosition position = HandPosition::STABLE;
	std::string subject;
	double start_s = 0.0;
	double end_s = 0.0; ///< not before start_s; both 0 where none leaves them empty: the whole track
	/// Where the task starts. For zoom x is the circle's starting radius (m), for none all is zero.
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
	/// Unit vector of the task's motion; zero for zoom and none.
	Eigen::Vector3d axis = Eigen::Vector3d::Zero();
	double amplitude_m = 0.0; ///< length of the motion, growth of zoom's radius; 0 for none

	[[nodiscard]] bool has_axis() const { return !axis.isZero(0.0); }
};

struct TrialTable {
	std::vector<Trial> trials;
	std::vector<std::string> faults; ///< of the rows left out, each "source:line: column: what"
};

/// All rows that are good. An axis whose length is within 5 % of 1, as of a few decimals, is made a unit
/// vector. The error, of a file without a header of these columns: "source:line: column: what".
[[nodiscard]] Result<TrialTable> parse_trials_csv(std::string_view text, std::string_view source_name);

/// Reads back as the same trials, to the last bit of every number.
[[nodiscard]] std::string format_trials_csv(const std::vector<Trial> &trials);

[[nodiscard]] std::string_view position_name(HandPosition position);

/// Why `name` cannot name a file on every system, empty where it can: a trial's tracks are files of its name,
/// a gesture's model is one.
[[nodiscard]] std::string_view file_name_fault(std::string_view name);

} // namespace steadyhand
