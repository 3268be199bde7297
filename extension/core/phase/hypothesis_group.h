#pragma once

#include "phase/element_curve.h"
#include "phase/gesture_hypothesis.h"
#include "signal/lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace steadyhand {

/// Hypotheses side by side, filtered at once: number for number, so that a processor computes them together.
/// All are computed, used or not.
class HypothesisGroup {
public:
	/// A frame's place in the evidence.
	struct Trust {
		double outlier = 0.01; ///< probability that the frame says little of the hand
		double jitter = 0.0;   ///< standard deviation that its noise has beside the least that any has
		double weight = 1.0; ///< part of its likelihood that counts, since errors of frames nearby are alike
	};

	/// Of a hand that makes the gesture: (1 + g) f((t - onset_s) * rate_per_s)
	struct Course {
		double onset_s, rate_per_s, gain, shape; ///< gain: 1 + g

		[[nodiscard]] double phase(double t_s) const { return (t_s - onset_s) * rate_per_s; }
	};

	void set(std::size_t lane, const GestureHypothesis &hypothesis);
	/// With no weight.
	[[nodiscard]] GestureHypothesis hypothesis(std::size_t lane) const;
	/// As set(lane, from.hypothesis(from_lane)).
	void copy(std::size_t lane, const HypothesisGroup &from, std::size_t from_lane);

	/// passages: over the time from the one predicted to before.
	void predict(const ElementCurve &curve, double t_s, const Passages &passages);
	/// Takes in that x was seen at t_s, the time predicted to, and adds to the log weights how likely that
	/// was (probabilistic data association: a frame is good, or an outlier).
	void absorb(const ElementCurve &curve, double t_s, double x, const Trust &trust, Lanes &r_log_weights);

	[[nodiscard]] Regime regime(std::size_t lane) const { return static_cast<Regime>(regime_[lane]); }
	[[nodiscard]] TrackerError error(std::size_t lane) const {
		return static_cast<TrackerError>(error_[lane]);
	}
	[[nodiscard]] bool on_its_way(std::size_t lane) const { return on_its_way_[lane] > 0.0; }
	/// Only of one on its way.
	[[nodiscard]] Course course(std::size_t lane) const {
		return { mean_[GestureHypothesis::ONSET][lane], rate_per_s_[lane],
			1.0 + mean_[GestureHypothesis::GAIN][lane], mean_[GestureHypothesis::SHAPE][lane] };
	}
	/// Of each whether it is on its way and beyond that phase.
	void mark_beyond(double t_s, double phase, std::span<bool, LANES> r_marks) const;
	/// d: what the hand does beside the gesture, and d'.
	[[nodiscard]] double hand_deviation(std::size_t lane) const {
		return mean_[GestureHypothesis::HAND][lane];
	}
	[[nodiscard]] double hand_deviation_rate(std::size_t lane) const {
		return mean_[GestureHypothesis::HAND_RATE][lane];
	}

	/// The computation itself, for processors of a kind (hypothesis_group.cpp).
	struct Filter;

private:
	friend struct Filter;

	std::array<Lanes, GestureHypothesis::STATES> mean_{};
	std::array<Lanes, GestureHypothesis::ENTRIES> covariance_{};
	Lanes rate_per_s_{ 1.0, 1.0, 1.0, 1.0 };
	std::array<std::uint8_t, LANES> regime_{}, error_{}; ///< index_of each
	Lanes on_its_way_{};                                 ///< 1 of those on their way, 0 of the others
	Lanes way_{};                                        ///< f(phase), 0..1, at the time predicted to
	bool is_way_known_ = false;                          ///< way_ is of all lanes as they are
};

} // namespace steadyhand
