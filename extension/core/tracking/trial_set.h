#pragma once

#include "base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// Name for no gesture: in a trial without one, and in results if none is recognised.
inline constexpr std::string_view NO_GESTURE = "none";

/// Position of the hand relative to the sensor: STABLE where it tracks well, UNSTABLE where range and
/// self-occlusion cause faults.
enum class HandPosition : std::uint8_t { STABLE, UNSTABLE };

/// One row of a trial set's `trials.csv`. Its tracks are `TRIAL.measured.csv` and `TRIAL.reference.csv` in
/// the same folder, on one clock.
struct Trial {
	std::string trial; ///< unique in its set, valid as a file name
	/// `horizontal_drag`, `vertical_drag`, `tap`, `zoom`, `none`, or the name of a trained gesture.
	std::string gesture;
	HandPosition position = HandPosition::STABLE;
	std::string subject;
	double start_s = 0.0;
	double end_s =
			0.0; ///< not before start_s. `none` may leave both empty: they are 0, the whole track counts
	/// Start of the task, m. For zoom, x is the radius at the start. For `none`, zero.
	Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
	/// Unit vector of the task's motion; zero for zoom and `none`.
	Eigen::Vector3d axis = Eigen::Vector3d::Zero();
	double amplitude_m = 0.0; ///< length of the motion, or growth of zoom's radius; 0 for `none`

	[[nodiscard]] bool has_axis() const { return !axis.isZero(0.0); }
};

struct TrialTable {
	std::vector<Trial> trials;
	std::vector<std::string> faults; ///< errors of invalid rows, each "source:line: column: what"
};

/// Reads all valid rows. An axis whose length is within 5 % of 1 is normalised, because files have few
/// decimals. Error of a file without a valid header: "source:line: column: what".
[[nodiscard]] Result<TrialTable> parse_trials_csv(std::string_view text, std::string_view source_name);

/// Writes trials. They read back with equal bits.
[[nodiscard]] std::string format_trials_csv(const std::vector<Trial> &trials);

[[nodiscard]] std::string_view position_name(HandPosition position);

/// Why `name` is not valid as a file name on every system; empty if it is. Tracks of a trial, and the model
/// of a gesture, are files with their names.
[[nodiscard]] std::string_view file_name_fault(std::string_view name);

} // namespace steadyhand
