#pragma once

#include "phase/hypothesis_bank.h"

#include <algorithm>

namespace steadyhand {

/// How far the faults that a tracker shows, and those that it does not, speak against hypotheses. Amplitudes;
/// t_s: the time of the hypotheses.

/// fault: TrackingSoundness', below 0 to take one back. It speaks against a tracker that is right, and says
/// nothing of whether the hand has begun, or of one that has left the gesture's end: those keep their share.
/// Where the gesture is over, only a jump says where the hand is.
void count_fault(HypothesisBank &r_bank, double t_s, double fault, bool is_jump);

/// The same of what else a frame says of the tracker. log_ratio: TrackingSoundness' news, nats.
void count_erring(HypothesisBank &r_bank, double t_s, double log_ratio);

/// The frame is off the way of the ones before it (TrackingSoundness::leapt): as a tracker that shakes shows
/// one after the other, and any other seldom.
void count_leap(HypothesisBank &r_bank);

/// Of a gap or a freeze, however long, that the hand was lost is said once.
class LossCount {
public:
	/// Of further evidence of it what is new: in all as much as of one loss.
	double new_of(double loss) {
		const double part = std::clamp(loss, 0.0, 1.0 - counted_);
		counted_ += part;
		return part;
	}
	void end() { counted_ = 0.0; }

private:
	double counted_ = 0.0;
};

/// loss: LossCount's, of a hand that was last seen at lost_s. Trackers lose hands that move, the sooner the
/// faster they are. That is no more likely of those that have begun than of one that has left the gesture's
/// end, or does something else, but is of either than of one at rest.
void count_loss(HypothesisBank &r_bank, double t_s, double lost_s, double loss);

/// A frame, dt_s after the last one, that shows the hand at x speaks against a tracker that errs by as much
/// of the way as goes without a fault.
void count_errorless(HypothesisBank &r_bank, double dt_s, double x);

/// The same of a frame that shows the hand where it has been since since_s, on its way: by as much as the
/// hand has gone on since then.
void count_stay(HypothesisBank &r_bank, double t_s, double dt_s, double since_s);

} // namespace steadyhand
