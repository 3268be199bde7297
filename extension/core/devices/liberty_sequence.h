#pragma once

#include "base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// How the tracker is to measure.
struct LibertySettings {
	int rate_hz = 240; ///< 240 or 120; 120 has slightly less noise
	/// The half space of the source frame (x forward, y right, z down) that holds all sensors, as a vector
	/// into it. The tracker cannot tell a position from its mirror image through the source. All zeros let
	/// the tracker follow each sensor across; the sensors must then start in the half that was set before.
	Eigen::Vector3d hemisphere = Eigen::Vector3d::UnitX();
	/// False keeps the adaptive filters that are stored in the tracker, which add latency.
	bool filters_off = true;
	/// Mirrors back a position that jumped to its mirror image (HemisphereGuard).
	bool mirror_flips = true;
};

/// Why these settings cannot be used. Empty where they can.
[[nodiscard]] std::optional<Error> check(const LibertySettings &settings);

/// One step of a conversation with the tracker: write `bytes`, then read until `then` is met.
struct LibertyStep {
	enum class Then : std::uint8_t {
		DISCARD,     ///< throw away all that comes until the tracker was silent for `quiet_s`
		CHECK,       ///< as DISCARD, but report a LibertyMessage::Kind::REFUSAL
		STATION_MAP, ///< until a station map comes; write again after `quiet_s` without one
		STREAM       ///< until the first record comes
	};
	std::string bytes;
	Then then = Then::CHECK;
	double quiet_s = 0.0;
	/// Until then the step must be over. DISCARD and CHECK then go on with the next step, the others fail.
	double timeout_s = 0.0;
	std::string_view aim; ///< completes "cannot ..." in an error message
};

/// The steps from any state of the tracker to a stream of records. `settings` have passed check().
[[nodiscard]] std::vector<LibertyStep> liberty_start_steps(const LibertySettings &settings);

/// The steps that leave the tracker silent.
[[nodiscard]] std::vector<LibertyStep> liberty_stop_steps();

} // namespace steadyhand
