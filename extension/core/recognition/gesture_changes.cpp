#include "recognition/gesture_changes.h"

namespace steadyhand {

ShownGesture shown_gesture(const GestureRecogniser &recogniser) {
	const GestureSession *const session = recogniser.session();
	if (session == nullptr) {
		return {};
	}
	return { recogniser.gesture(), session->gestures_started(), session->state(),
		session->stage() == GestureSession::Stage::ENDED };
}

GestureChanges changes_between(const ShownGesture &before, const ShownGesture &now) {
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
