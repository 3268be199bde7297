#pragma once

#include "phase/gesture_hypothesis.h"
#include "soundness/tracking_soundness.h"

#include <cmath>

namespace steadyhand {

/// Whether the hand has halted half-way, or rests behind the start, as it was last seen.
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

private:
	/// A hand stands that has been slow for so long, as a tracker sees it that has neither erred of late nor
	/// shakes; as another one sees it.
	static constexpr double HALTED_S = 0.02;
	static constexpr double HALTED_UNSURE_S = 0.1;
	/// However it wanders, one that stays within STAYS for so long.
	static constexpr double STAYS = 0.08;
	static constexpr double STAYS_S = 0.3;
	static constexpr double HALTED_FROM = 0.1; ///< one that is no further may not have begun,
	static constexpr double BEHIND = 0.08;     ///< one that rests further behind the start has not,
	static constexpr double STAYS_FROM = 0.2;  ///< nor one that stays here before a tracker that errs
	static constexpr double ERRED = 0.2;       ///< unsoundness from which on it has
	static constexpr double SHAKES = 0.003;    ///< jitter from which on it does

	struct Stay {
		double since_s = 0.0;
		double x = 0.0;
	};

	Stay stays_;
	bool is_halted_ = false;

	[[nodiscard]] bool has_halted(const TrackingSoundness &soundness, double t_s, double x) const {
		const bool is_sure = soundness.unsoundness() < ERRED && soundness.jitter() < SHAKES;
		const bool stays = t_s - stays_.since_s > STAYS_S;
		if (!is_on_way(x)) {
			return x < -BEHIND && stays && is_sure;
		}
		const bool is_slow = soundness.slow_for_s() > (is_sure ? HALTED_S : HALTED_UNSURE_S);
		return is_slow || (stays && x > STAYS_FROM);
	}
};

} // namespace steadyhand
