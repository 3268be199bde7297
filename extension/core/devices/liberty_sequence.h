#pragma once

#include "base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// Settings of the tracker.
struct LibertySettings {
	int rate_hz = 240; ///< 240 or 120; 120 has slightly less noise
	/// The half space of the source frame (x forward, y right, z down) that holds all sensors, as a vector
	/// into it. The tracker cannot distinguish a position from its mirror image through the source. With all
	/// zeros the tracker follows each sensor into the other half space. The sensors must then start in the
	/// half space that was set before.
	Eigen::Vector3d hemisphere = Eigen::Vector3d::UnitX();
	/// False keeps the adaptive filters that are stored in the tracker, which add latency.
	bool filters_off = true;
	/// Corrects positions that jumped to their mirror image (HemisphereGuard).
	bool mirror_flips = true;
};

/// Why these settings are invalid; empty if they are valid.
[[nodiscard]] std::optional<Error> check(const LibertySettings &settings);

/// One step of a conversation with the tracker: write `bytes`, then read until `then` is met.
struct LibertyStep {
	enum class Then : std::uint8_t {
		DISCARD,     ///< drop all data until none has arrived for `quiet_s`
		CHECK,       ///< as DISCARD, but report a LibertyMessage::Kind::REFUSAL
		STATION_MAP, ///< until a station map arrives; write again after `quiet_s` without one
		STREAM       ///< until the first record arrives
	};
	std::string bytes;
	Then then = Then::CHECK;
	double quiet_s = 0.0;
	/// Time-out of the step. After it, DISCARD and CHECK continue with the next step; other steps fail.
	double timeout_s = 0.0;
	std::string_view aim; ///< completes "cannot ..." in an error message
};

/// The steps from any state of the tracker to a stream of records. `settings` must have passed check().
[[nodiscard]] std::vector<LibertyStep> liberty_start_steps(const LibertySettings &settings);

/// The steps that stop the stream.
[[nodiscard]] std::vector<LibertyStep> liberty_stop_steps();

} // namespace steadyhand
