#pragma once

#include "gesture/hand_motion.h"
#include "tracking/track.h"

#include <optional>
#include <vector>

namespace steadyhand {

/// Observations of a hand since a possible onset, at the instants of the symbol clock. An instant without a
/// new frame has no observation.
struct MotionSequence {
	std::vector<std::optional<MotionObservation>> points;
	std::vector<int> states; ///< state of the HMM for each point
};

/// Position of a gesture in a track, as indices of instants.
struct MotionMarks {
	int begin = 0; ///< begin of the sequence
	int onset = 0; ///< instants before it are in the first state
	int end = 0;   ///< instants after it are in the END_STATES; the other states divide the time between
	int last = 0;  ///< end of the sequence
};

/// Motion of a recorded hand at the instants of the symbol clock.
class MotionInstants {
public:
	/// track: with at least one frame.
	explicit MotionInstants(const Track &track);

	[[nodiscard]] int size() const { return static_cast<int>(motions_.size()); }
	/// Index of the instant nearest to t_s.
	[[nodiscard]] int index(double t_s) const;
	/// Newest motion at or before an instant, at most 50 ms old.
	[[nodiscard]] std::optional<HandMotion> last_motion(int index) const;
	/// Sequence from the first tracked instant in marks.begin .. marks.onset on; nullopt if there is none.
	[[nodiscard]] std::optional<MotionSequence> sequence(const MotionMarks &marks, int states) const;

private:
	double first_s_ = 0.0;
	std::vector<std::optional<HandMotion>> motions_;
};

} // namespace steadyhand
