#pragma once

#include "phase/hypothesis_bank.h"

namespace steadyhand {

/// The tracker has jumped at the time of the hypotheses. A jump is the tracker's, and leads away from where
/// the hand is, or back to it, or is the first of the steps by which one that had fallen behind catches up:
/// each likely hypothesis becomes two or more, of which the frames that follow choose. leap: in amplitudes,
/// onward where it is greater than 0.
void branch_at_jump(HypothesisBank &r_bank, double leap);

/// So long after its latest jump a tracker that slides back from it has arrived,
inline constexpr double SLIDES_FOR_S = 0.2;
/// and errs as any other from then on.
void arrive_from_jump(HypothesisBank &r_bank);

} // namespace steadyhand
