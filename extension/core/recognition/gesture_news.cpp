#include "recognition/gesture_news.h"

namespace steadyhand {

GestureShown shown_by(const GestureRecogniser &recogniser) {
	const GestureFollower *const follower = recogniser.follower();
	if (follower == nullptr) {
		return {};
	}
	return { recogniser.gesture(), follower->gestures_begun(), follower->state(),
		follower->stage() == GestureFollower::Stage::ARRIVED };
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
