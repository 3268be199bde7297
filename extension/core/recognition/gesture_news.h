#pragma once

#include "recognition/gesture_recogniser.h"

#include <cstdint>

namespace steadyhand {

/// The shown gesture of a recogniser at an instant.
struct GestureShown {
	int gesture = -1;        ///< index of the active or ended gesture; -1: none
	std::uint32_t begun = 0; ///< GestureSession::gestures_started
	int state = -1;          ///< of its HMM
	bool arrived = false;    ///< the gesture has ended

	bool operator==(const GestureShown &) const = default;
};

[[nodiscard]] GestureShown shown_by(const GestureRecogniser &recogniser);

/// Events from one instant to the next, in this order: the gesture shown before was aborted, another one
/// started, its state changed, it ended.
struct GestureNews {
	bool aborted = false;
	bool started = false;
	bool state_changed = false;
	bool ended = false;

	bool operator==(const GestureNews &) const = default;
};

/// A different GestureShown::begun is a different gesture, also with the same model.
[[nodiscard]] GestureNews news(const GestureShown &before, const GestureShown &now);

} // namespace steadyhand
