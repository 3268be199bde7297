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
		return changes_between(std::exchange(shown_, now), now);
	}

private:
	ShownGesture shown_;
	const GestureSession *session_ = nullptr;
};

} // namespace steadyhand::test
