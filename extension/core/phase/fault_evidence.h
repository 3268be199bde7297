#pragma once

#include "phase/hypothesis_bank.h"

namespace steadyhand {

/// How far the faults that a tracker shows, and those that it does not, speak against hypotheses. Amplitudes;
/// t_s: the time of the hypotheses.

/// fault: TrackingSoundness', below 0 to take one back. It speaks against a tracker that is right, and says
/// nothing of whether the hand has begun, or of one that has left the gesture's end: those keep their share.
/// Where the gesture is over, only a jump says where the hand is.
void count_fault(HypothesisBank &r_bank, double t_s, double fault, bool is_jump);

/// A frame, dt_s after the last one, that shows the hand at x speaks against a tracker that errs by as much
/// of the way as goes without a fault; by far more where it shows the hand standing on its way.
void count_errorless(HypothesisBank &r_bank, double t_s, double dt_s, double x, bool is_standing);

} // namespace steadyhand
