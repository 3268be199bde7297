#pragma once

#include "base/random.h"
#include "simulation/oscillation.h"
#include "simulation/subject.h"
#include "tracking/frame.h"

#include <functional>
#include <vector>

namespace steadyhand {

/// True motion of a hand from 0 to span_s, and the difficulty of tracking it.
struct TrueMotion {
	std::function<HandFrame(double t_s)> hand;  ///< all seven joints, at time t_s
	std::function<double(double t_s)> severity; ///< 0: easy to track, 1: hardest; see SensorProfile
	double start_s = 0.0;                       ///< onset of the gesture
	double end_s = 0.0;                         ///< the hand stays at the target, or touches it
	double span_s = 0.0;
};

/// Involuntary motion of a hand: tremor and sway of the whole hand, and sway of each joint.
class InvoluntaryMotion {
public:
	InvoluntaryMotion(const Subject &subject, Random &r_random);

	void apply(double t_s, HandFrame &r_frame) const;

private:
	Oscillation tremor_;
	Oscillation sway_;
	std::vector<Oscillation> joints_;
};

} // namespace steadyhand
