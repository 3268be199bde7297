#include "recognition/gesture_news.h"

namespace steadyhand {

GestureShown shown_by(const GestureRecogniser &recogniser) {
	const GestureSession *const session = recogniser.session();
	if (session == nullptr) {
		return {};
	}
	return { recogniser.gesture(), session->gestures_started(), session->state(),
		session->stage() == GestureSession::Stage::ENDED };
}

GestureNews news(const GestureShown &before, const GestureShown &now) {
	const bool is_other = now.gesture != before.gesture || now.begun != before.begun;
	const bool started = now.gesture >= 0 && is_other;
	return {
		.aborted = before.gesture >= 0 && !before.arrived && is_other,
		.started = started,
		.state_changed = started || now.state != before.state,
		.ended = now.arrived && (started || !before.arrived),
	};
}

} // namespace steadyhand
