#pragma once

#include "recognition/gesture_recogniser.h"

#include <cstdint>

namespace steadyhand {

/// The shown gesture of a recogniser at an instant.
struct ShownGesture {
	int gesture = -1;         ///< index of the active or ended gesture; -1: none
	std::uint32_t number = 0; ///< GestureSession::gestures_started
	int state = -1;           ///< of its HMM
	bool has_ended = false;   ///< the gesture has ended

	bool operator==(const ShownGesture &) const = default;
};

[[nodiscard]] inline ShownGesture shown_gesture(const GestureRecogniser &recogniser) {
	const GestureSession *const session = recogniser.session();
	if (session == nullptr) {
		return {};
	}
	return { recogniser.gesture(), session->gestures_started(), session->state(),
		session->stage() == GestureSession::Stage::ENDED };
}

/// Events from one instant to the next, in this order: the gesture shown before was aborted, another one
/// started, its state changed, it ended.
struct GestureChanges {
	bool aborted = false;
	bool started = false;
	bool state_changed = false;
	bool ended = false;

	bool operator==(const GestureChanges &) const = default;
};

/// A different ShownGesture::number is a different gesture, also with the same model.
[[nodiscard]] inline GestureChanges changes_between(const ShownGesture &before, const ShownGesture &now) {
	const bool is_other = now.gesture != before.gesture || now.number != before.number;
	const bool started = now.gesture >= 0 && is_other;
	return {
		.aborted = before.gesture >= 0 && !before.has_ended && is_other,
		.started = started,
		.state_changed = started || now.state != before.state,
		.ended = now.has_ended && (started || !before.has_ended),
	};
}

} // namespace steadyhand
