#pragma once

#include "performance.h"
#include "recognition/gesture_recogniser.h"
#include "tracking/frame.h"

#include <cstddef>
#include <vector>

namespace steadyhand::bench {

/// As GestureHMM says it: started, ended, aborted. MOVES_AGAIN: an ended one is under way without a start.
enum class Happening { STARTED, ENDED, ABORTED, MOVES_AGAIN };

struct Said {
	Happening happening;
	int gesture; ///< index into Performance::gestures()
	double t_s;
};

/// What GestureHMM::publish makes of a recogniser's states.
class Announcer {
public:
	void listen(const GestureRecogniser &recogniser, double t_s) {
		const GestureFollower *const follower = recogniser.follower();
		const bool is_shown = follower != nullptr && follower->stage() != GestureFollower::Stage::RESTING;
		const bool has_arrived = is_shown && follower->stage() == GestureFollower::Stage::ARRIVED;
		const int now = is_shown ? recogniser.gesture() : NONE;
		const bool starts = is_shown && now != shown_;
		if (shown_ != NONE && !had_arrived_ && now != shown_) {
			said_.push_back({ Happening::ABORTED, shown_, t_s });
		}
		if (starts) {
			said_.push_back({ Happening::STARTED, now, t_s });
		}
		if (has_arrived && (starts || !had_arrived_)) {
			said_.push_back({ Happening::ENDED, now, t_s });
		}
		if (is_shown && !has_arrived && !starts && had_arrived_) {
			said_.push_back({ Happening::MOVES_AGAIN, now, t_s });
		}
		shown_ = now;
		had_arrived_ = has_arrived;
	}
	[[nodiscard]] const std::vector<Said> &said() const { return said_; }

private:
	static constexpr int NONE = -1;

	int shown_ = NONE;
	bool had_arrived_ = false;
	std::vector<Said> said_;
};

/// Looked at each millisecond, as scenes do. min_confidence: GestureRecogniser::set_min_confidence.
inline std::vector<Said> follow(const std::vector<ExpectedGesture> &gestures,
		const std::vector<HandFrame> &frames, double length_s, double min_confidence) {
	GestureRecogniser recogniser(
			gestures, MotionMode::PHASE, phase_effort(Quality::ACCURATE), USUAL_SENSOR_LATENCY_S);
	recogniser.set_min_confidence(min_confidence);
	Announcer announcer;
	std::size_t next = 0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * length_s); ++ms) {
		const double t_s = ms / 1000.0;
		while (next < frames.size() && frames[next].t_s <= t_s) {
			recogniser.push(frames[next++]);
		}
		recogniser.advance(t_s);
		announcer.listen(recogniser, t_s);
	}
	return announcer.said();
}

} // namespace steadyhand::bench
