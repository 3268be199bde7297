#pragma once

#include "motion/element_curve.h"
#include "motion/hypothesis_bank.h"

#include <array>

namespace steadyhand {

/// What is believed of the motion at an instant; values in amplitudes, time in seconds.
struct PhaseEstimate {
	double value = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double phase = 0.0;  ///< 0..1, expected
	double moving = 0.0; ///< probability that the gesture has begun
};

/// The weighted mean of what hypotheses expect of the hand, in as few numbers as give it at any time until
/// they change: it is asked for each millisecond, they change with frames.
///
/// A gesture that was seen to begin goes on while nothing is seen. One that was not, and a hand that did
/// something else, wait: nothing moves on a mere chance.
class MotionOutlook {
public:
	/// filtered_s: the time that the hypotheses were predicted to; seen_s: when a frame last told where the
	/// hand is. To be called after HypothesisBank::prune.
	void look(const HypothesisBank &bank, double filtered_s, double seen_s);

	/// At t_s, not before filtered_s (or as it was then).
	[[nodiscard]] PhaseEstimate at(const ElementCurve &curve, double t_s) const;

private:
	/// Of one on its way; shares of the total weight.
	struct Course {
		double onset_s, rate_per_s;
		double elements; ///< of the motion elements' curve in the value
		double smooth;   ///< of the minimum jerk's
		double weight;
		double waits_from; ///< phase from which on it slows down until it is seen again
	};
	/// Of all in a regime: their deviations fade alike, so that the mean of them is one.
	struct Wandering {
		double x = 0.0, v = 0.0;
	};

	std::array<Course, HypothesisBank::MOST_AFTER_PRUNE> courses_{};
	std::size_t count_ = 0;
	std::array<Wandering, REGIMES> hand_{};
	double moving_ = 0.0;
	double filtered_s_ = 0.0;
};

} // namespace steadyhand
