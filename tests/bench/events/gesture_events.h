#pragma once

#include "performance.h"
#include "shown_changes.h"
#include "tracking/frame.h"

#include <cstddef>
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
	GestureRecogniser recogniser(gestures, { .mode = mode, .latency_s = USUAL_SENSOR_LATENCY_S });
	recogniser.set_min_confidence(min_confidence);
	std::vector<GestureEvent> events;
	test::ShownChanges shown;
	std::size_t next = 0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * length_s); ++ms) {
		const double t_s = ms / 1000.0;
		while (next < frames.size() && frames[next].t_s <= t_s) {
			recogniser.push(frames[next++]);
		}
		recogniser.advance(t_s);
		const GestureChanges changes = shown.next(recogniser);
		if (changes.aborted) {
			events.push_back({ EventKind::ABORTED, shown.before(), t_s });
		}
		if (changes.started) {
			events.push_back({ EventKind::STARTED, recogniser.gesture(), t_s });
		}
		if (changes.ended) {
			events.push_back({ EventKind::ENDED, recogniser.gesture(), t_s });
		}
	}
	return events;
}

} // namespace steadyhand::bench
