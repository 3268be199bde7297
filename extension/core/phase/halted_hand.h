#pragma once

#include "phase/gesture_hypothesis.h"
#include "soundness/tracking_soundness.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Whether the hand has halted half-way, as it was last seen, and which faults speak of it then: that a
/// tracker errs from now on says nothing of whether the hand has gone on; that it jumps to the end does, or
/// that it soon finds a hand which moves.
class HaltedHand {
public:
	/// A hand that is first seen, at x.
	void start(double t_s, double x) { stays_ = { t_s, x }; }
	/// x: what the newest frame shows, in amplitudes.
	void look(const TrackingSoundness &soundness, double t_s, double x) {
		if (!soundness.told()) {
			return;
		}
		if (std::abs(x - stays_.x) > STAYS) {
			stays_ = { t_s, x };
		}
		is_halted_ = soundness.fault() == 0.0 ? has_halted(soundness, t_s, x) : is_halted_;
	}
	/// It stays where it was seen, whatever is not seen.
	[[nodiscard]] bool is_halted() const { return is_halted_; }
	/// At x it is between the ends.
	[[nodiscard]] static bool is_on_way(double x) { return x > HALTED_FROM && x < 1.0 - AT_END; }
	/// It has been seen nowhere else since then.
	[[nodiscard]] double stays_since_s() const { return stays_.since_s; }

	/// What counts by now of a frame's fault and of those that did not count before.
	double counted(double t_s, double fault, bool is_jump_to_end) {
		if (is_halted_ && !is_jump_to_end) {
			withheld_ = std::max(withheld_ + fault, 0.0);
			withheld_s_ = fault > 0.0 ? t_s : withheld_s_;
			return 0.0;
		}
		const double withheld = t_s - withheld_s_ < MOVES_S ? withheld_ : 0.0;
		withheld_ = 0.0;
		return fault + withheld;
	}

private:
	/// A hand stands that has been slow for so long, as a tracker sees it that has neither erred of late nor
	/// shakes; as another one sees it.
	static constexpr double HALTED_S = 0.02;
	static constexpr double HALTED_UNSURE_S = 0.1;
	/// However it wanders, one that stays within STAYS for so long.
	static constexpr double STAYS = 0.08;
	static constexpr double STAYS_S = 0.3;
	static constexpr double HALTED_FROM = 0.1; ///< one that is no further may not have begun,
	static constexpr double STAYS_FROM = 0.2;  ///< nor one that stays here before a tracker that errs
	static constexpr double ERRED = 0.2;       ///< unsoundness from which on it has
	static constexpr double SHAKES = 0.003;    ///< jitter from which on it does
	static constexpr double MOVES_S = 0.05; ///< a hand that moves so soon after a fault moved all the while

	struct Stay {
		double since_s = 0.0;
		double x = 0.0;
	};

	Stay stays_;
	bool is_halted_ = false;
	double withheld_ = 0.0;   ///< faults since it halted that have not been counted
	double withheld_s_ = 0.0; ///< the last of them

	[[nodiscard]] bool has_halted(const TrackingSoundness &soundness, double t_s, double x) const {
		const bool is_sure = soundness.unsoundness() < ERRED && soundness.jitter() < SHAKES;
		const bool is_slow = soundness.slow_for_s() > (is_sure ? HALTED_S : HALTED_UNSURE_S);
		return is_on_way(x) && (is_slow || (t_s - stays_.since_s > STAYS_S && x > STAYS_FROM));
	}
};

} // namespace steadyhand
