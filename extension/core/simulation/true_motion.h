#pragma once

#include "base/random.h"
#include "simulation/oscillation.h"
#include "simulation/subject.h"
#include "tracking/frame.h"

#include <functional>
#include <vector>

namespace steadyhand {

/// What a hand really does, at any instant from 0 to `span_s`, and how hard that is to track.
struct TrueMotion {
	std::function<HandFrame(double t_s)> hand;  ///< all seven joints, stamped `t_s`
	std::function<double(double t_s)> severity; ///< 0: as easy as the posture gets .. 1: at its hardest
	double start_s = 0.0;                       ///< onset of the gesture
	double end_s = 0.0;                         ///< in the target for good, or contact
	double span_s = 0.0;
};

/// What no hand can help: tremor and sway of the whole hand, each joint's own restlessness.
class Unrest {
public:
	Unrest(const Subject &subject, Random &r_random);

	void apply(double t_s, HandFrame &r_frame) const;

private:
	Oscillation tremor_;
	Oscillation sway_;
	std::vector<Oscillation> joints_;
};

} // namespace steadyhand
