#pragma once

#include "recognition/gesture_changes.h"

#include <utility>

namespace steadyhand::test {

/// Changes of the shown gesture since the last call.
class ShownChanges {
public:
	GestureChanges next(const GestureRecogniser &recogniser) {
		const ShownGesture now = shown_gesture(recogniser);
		// expect() may have changed the index of the session.
		const GestureSession *const before = std::exchange(session_, recogniser.session());
		shown_.gesture = before == session_ ? now.gesture : shown_.gesture;
		before_ = std::exchange(shown_, now);
		return changes_between(before_, now);
	}
	/// Index of the gesture before the last call; it is the gesture that was aborted, if one was.
	[[nodiscard]] int before() const { return before_.gesture; }

private:
	ShownGesture shown_, before_;
	const GestureSession *session_ = nullptr;
};

} // namespace steadyhand::test
