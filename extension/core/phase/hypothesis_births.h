#pragma once

#include "gesture/gesture_model.h"
#include "phase/hypothesis_bank.h"
#include "soundness/tracking_soundness.h"

#include <array>
#include <cstddef>

namespace steadyhand {

/// Which hypotheses come from which: how a hand begins, turns to something else, leaves the gesture's end and
/// comes to rest, and what of that it may have done while it was not seen.
class HypothesisBirths {
public:
	/// model must outlive this. gain_spread, knows_end: as PhaseEstimator's.
	HypothesisBirths(const GestureModel &model, const PhaseEffort &effort, double gain_spread = 1.0,
			bool knows_end = true);

	/// The tracker has come back or jumped, and shows x: it may have been astray until now, and the hand at
	/// rest. Where that had been given up for what the tracker showed, it counts again.
	static void rest_anew(HypothesisBank &r_bank, double x);
	/// The hand was seen, and may have changed what it does, in the branch period that ends at t_s.
	void branch(HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s) const;
	/// The same of one that is shown at x, at so many amplitudes a second since the last branching, and
	/// nowhere else for stays_s: it may stand there.
	void stand(HypothesisBank &r_bank, double t_s, double x, double per_s, double stays_s) const;
	/// The tracker has come back at t_s: a hand that had made the gesture may have left the end meanwhile.
	void leave_unseen(HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s) const;
	/// A hand at rest that is seen no nearer to the start than this had begun before.
	static constexpr double SEEDED_FROM = 0.08;
	/// At t_s the hand is seen at x: it may have begun since it was last seen.
	void seed(HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s, double x) const;

private:
	const GestureModel *model_;
	double period_s_;
	double gain_spread_;
	bool knows_end_;
	std::size_t durations_;
	std::array<double, PhaseEffort::MOST_DURATIONS> log_durations_{};
	std::array<double, PhaseEffort::MOST_DURATIONS> log_prior_{};
	double log_duration_deviation_ = 0.0; ///< of each

	void start(HypothesisBank &r_bank, const GestureHypothesis &at_rest, std::size_t duration, Regime regime,
			double onset_s, double onset_deviation_s, double log_probability) const;
	void begin(HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s) const;
	void come_to_rest(HypothesisBank &r_bank, double t_s) const;
	void come_to_end(HypothesisBank &r_bank, double t_s) const;
	void set_free(HypothesisBank &r_bank, double t_s) const;
};

} // namespace steadyhand
