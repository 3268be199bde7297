#pragma once

#include "performance.h"
#include "recognition/gesture_changes.h"
#include "tracking/frame.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace steadyhand::bench {

enum class EventKind { STARTED, ENDED, ABORTED };

/// An event of the recogniser.
struct GestureEvent {
	EventKind kind;
	int gesture; ///< index into Performance::gestures()
	double t_s;
};

/// Events of the recogniser for these frames, checked each millisecond, as in GestureHMM. min_confidence:
/// GestureRecogniser::set_min_confidence.
inline std::vector<GestureEvent> follow(const std::vector<ExpectedGesture> &gestures,
		const std::vector<HandFrame> &frames, double length_s, double min_confidence,
		MotionMode mode = MotionMode::PHASE) {
	GestureRecogniser recogniser(gestures, mode, DEFAULT_HYPOTHESES, USUAL_SENSOR_LATENCY_S);
	recogniser.set_min_confidence(min_confidence);
	std::vector<GestureEvent> events;
	ShownGesture shown;
	std::size_t next = 0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * length_s); ++ms) {
		const double t_s = ms / 1000.0;
		while (next < frames.size() && frames[next].t_s <= t_s) {
			recogniser.push(frames[next++]);
		}
		recogniser.advance(t_s);
		const ShownGesture before = std::exchange(shown, shown_gesture(recogniser));
		const GestureChanges changes = changes_between(before, shown);
		if (changes.aborted) {
			events.push_back({ EventKind::ABORTED, before.gesture, t_s });
		}
		if (changes.started) {
			events.push_back({ EventKind::STARTED, shown.gesture, t_s });
		}
		if (changes.ended) {
			events.push_back({ EventKind::ENDED, shown.gesture, t_s });
		}
	}
	return events;
}

} // namespace steadyhand::bench
