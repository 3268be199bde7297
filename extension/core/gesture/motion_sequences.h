#pragma once

#include "gesture/hand_motion.h"
#include "tracking/track.h"

#include <optional>
#include <vector>

namespace steadyhand {

/// Observations of a hand since a possible onset, at the symbol clock's instants; nothing where no frame was
/// new.
struct MotionSequence {
	std::vector<std::optional<MotionObservation>> points;
	std::vector<int> states; ///< as many: which state of an HMM each of them is taken to be in
};

/// Where a gesture lies in a track: instants, counted from the track's first.
struct MotionMarks {
	int begin = 0; ///< what the sequence begins with
	int onset = 0; ///< before it, the first state
	int end = 0;   ///< after it, the last state; the others share what is between
	int last = 0;
};

/// A recorded hand at the symbol clock's instants.
class MotionInstants {
public:
	/// track: with a frame at least.
	explicit MotionInstants(const Track &track);

	[[nodiscard]] int size() const { return static_cast<int>(motions_.size()); }
	/// Of the instant nearest to a time.
	[[nodiscard]] int index(double t_s) const;
	/// The hand as it was seen last, at most 50 ms before an instant.
	[[nodiscard]] std::optional<HandMotion> seen_by(int index) const;
	/// From the first instant from marks.begin to marks.onset at which the hand is seen; nothing where there
	/// is none.
	[[nodiscard]] std::optional<MotionSequence> sequence(const MotionMarks &marks, int states) const;

private:
	double first_s_ = 0.0;
	std::vector<std::optional<HandMotion>> motions_;
};

} // namespace steadyhand
