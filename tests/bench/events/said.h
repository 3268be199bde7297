#pragma once

#include "performance.h"
#include "recognition/gesture_news.h"
#include "tracking/frame.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace steadyhand::bench {

enum class Happening { STARTED, ENDED, ABORTED };

struct Said {
	Happening happening;
	int gesture; ///< index into Performance::gestures()
	double t_s;
};

/// Looked at each millisecond, as GestureHMM does. min_confidence: GestureRecogniser::set_min_confidence.
inline std::vector<Said> follow(const std::vector<ExpectedGesture> &gestures,
		const std::vector<HandFrame> &frames, double length_s, double min_confidence,
		MotionMode mode = MotionMode::PHASE) {
	GestureRecogniser recogniser(gestures, mode, estimator_effort(Quality::ACCURATE), USUAL_SENSOR_LATENCY_S);
	recogniser.set_min_confidence(min_confidence);
	std::vector<Said> said;
	GestureShown shown;
	std::size_t next = 0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * length_s); ++ms) {
		const double t_s = ms / 1000.0;
		while (next < frames.size() && frames[next].t_s <= t_s) {
			recogniser.push(frames[next++]);
		}
		recogniser.advance(t_s);
		const GestureShown before = std::exchange(shown, shown_by(recogniser));
		const GestureNews happened = news(before, shown);
		if (happened.aborted) {
			said.push_back({ Happening::ABORTED, before.gesture, t_s });
		}
		if (happened.started) {
			said.push_back({ Happening::STARTED, shown.gesture, t_s });
		}
		if (happened.ended) {
			said.push_back({ Happening::ENDED, shown.gesture, t_s });
		}
	}
	return said;
}

} // namespace steadyhand::bench
