#pragma once

#include "tracking/frame.h"

#include <cstdint>
#include <optional>

namespace steadyhand {

/// What speaks for frames of wrong units, or of a clock that stands: no gesture is ever found in them, and
/// each frame by itself is sound.
enum class StreamDoubt : std::uint8_t {
	TIME_STANDS, ///< a hand moves, and all frames have one stamp
	TOO_RARE,    ///< seconds lie between frames, as if they were milliseconds
	TOO_FAST     ///< no hand moves like that, as if millimetres were metres, or the space moved
};

/// Looks at a stream of frames whose stamps do not decrease.
class StreamDoubts {
public:
	/// What the newest frame makes clear; the same again with each one that goes on so.
	std::optional<StreamDoubt> look(const HandFrame &frame);

private:
	/// In succession; a tracker's errors are over sooner.
	static constexpr int FRAMES = 30, FAST_FRAMES = 10;
	static constexpr double FAST_S = 0.3;
	static constexpr double FASTEST_M_S = 10.0; ///< a punch
	static constexpr double RAREST_S = 1.0;

	std::optional<HandFrame> last_;
	int standing_ = 0; ///< steps in succession
	int rare_ = 0;
	int fast_ = 0;
	double fast_for_s_ = 0.0;
};

} // namespace steadyhand
