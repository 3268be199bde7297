#pragma once

#include "tracking/frame.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace steadyhand {

/// Signs of wrong units, or of a clock that does not run. Each frame alone is valid, but no gesture can be
/// found.
enum class StreamFault : std::uint8_t {
	EQUAL_TIME_STAMPS, ///< a hand moves, but all frames have the same stamp
	TOO_RARE,          ///< seconds between frames: the unit may be milliseconds
	TOO_FAST           ///< faster than any hand: the unit may be millimetres, or the space itself moves
};

/// What is wrong, and what to do.
std::string_view explain(StreamFault fault);

/// Checks a stream of frames whose stamps do not decrease.
class StreamCheck {
public:
	/// Returns the fault of the newest frame, at each frame while it lasts.
	std::optional<StreamFault> push(const HandFrame &frame);

private:
	/// Number of frames in a row. A tracker's faults are shorter.
	static constexpr int FRAMES = 30, FAST_FRAMES = 10;
	static constexpr double FAST_S = 0.3;
	static constexpr double FASTEST_M_S = 10.0; ///< a punch
	static constexpr double RAREST_S = 1.0;

	std::optional<HandFrame> last_;
	int equal_stamps_ = 0; ///< steps in a row with equal stamps
	int rare_ = 0;
	int fast_ = 0;
	double fast_for_s_ = 0.0;
};

} // namespace steadyhand
