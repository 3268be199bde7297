#pragma once

#include "recognition/gesture_recogniser.h"

#include <cstdint>

namespace steadyhand {

/// What may be told of a recogniser at an instant.
struct GestureShown {
	int gesture = -1;        ///< index of the one under way or just finished; -1: none
	std::uint32_t begun = 0; ///< GestureSession::gestures_started
	int state = -1;          ///< of its HMM
	bool arrived = false;    ///< it has come to its end

	bool operator==(const GestureShown &) const = default;
};

[[nodiscard]] GestureShown shown_by(const GestureRecogniser &recogniser);

/// What happened from one instant to the next, in this order: the gesture shown before was given up, one
/// began, its state changed, it came to its end.
struct GestureNews {
	bool aborted = false;
	bool started = false;
	bool state_changed = false;
	bool ended = false;

	bool operator==(const GestureNews &) const = default;
};

/// A gesture that begins at once where the last one ended is another one, if it is of the same model too.
[[nodiscard]] GestureNews news(const GestureShown &before, const GestureShown &now);

} // namespace steadyhand
