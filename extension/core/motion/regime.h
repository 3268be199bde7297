#pragma once

#include "signal/lanes.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// What a hypothesis holds of the hand and of the tracker.
enum class Regime : std::uint8_t {
	REST,    ///< the hand has not begun
	SOUND,   ///< the hand makes the gesture, the tracker is right
	UNSOUND, ///< the hand makes the gesture; the tracker errs and is late, the more the further the hand is
	FREE,    ///< the hand does something else, the tracker is right
};
inline constexpr std::size_t REGIMES = 4;
/// Its place, and its lane where each regime has one.
[[nodiscard]] constexpr std::size_t index_of(Regime regime) {
	return static_cast<std::size_t>(regime);
}

/// How far a deviation goes and how it comes back: critically damped noise. That of a FREE hand has the same
/// velocity, and comes back nowhere: see FREE_SLOWING_PER_S.
struct Deviation {
	double amplitudes; ///< standard deviation
	double rate_per_s;
};

/// A regime's numbers (docs/method.md says how they were set); values in amplitudes.
struct RegimeNumbers {
	Deviation hand;      ///< d: what the hand does that the gesture does not say
	Deviation error;     ///< b: the tracker's slow error, at the start of the way
	double error_on_way; ///< b: standard deviation added at the end of the way
	double lag_s;        ///< expected lag at the end of the way
	double lag_deviation_s;
	double gain_deviation; ///< g: how much further or less far than the task asks
};
inline constexpr std::array<RegimeNumbers, REGIMES> REGIME_NUMBERS = [] {
	constexpr Deviation SMALL_ERROR{ 0.0056, 2.7 };
	return std::array{
		RegimeNumbers{ { 0.025, 9.0 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
		RegimeNumbers{ { 0.06, 4.6 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.041 },
		RegimeNumbers{ { 0.016, 11.0 }, { 0.012, 5.9 }, 0.046, 0.12, 0.035, 0.025 },
		RegimeNumbers{ { 0.55, 4.0 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
	};
}();
[[nodiscard]] constexpr const RegimeNumbers &regime_numbers(Regime regime) {
	return REGIME_NUMBERS[index_of(regime)];
}

/// A free hand comes to rest wherever it is, x'' = -c x' + white (an integrated Ornstein-Uhlenbeck process).
inline constexpr double FREE_SLOWING_PER_S = 6.0;

/// Critically damped motion x'' = -2 a x' - a^2 x over a time, a regime each but FREE, which slows down: [x,
/// x'] is multiplied by [xx xv; vx vv].
struct Dampings {
	static_assert(REGIMES == LANES);
	Lanes xx, xv, vx, vv;
	/// As much noise as keeps the stationary variances, s of x and a^2 s of x' (of a free hand the latter):
	/// covariance that it adds, by s.
	Lanes noise_x, noise_xv, noise_v;
};

/// What a time does to the deviations: the same for all hypotheses in a regime.
struct Passages {
	Dampings hand, error;
};
[[nodiscard]] Passages passages(double dt_s);

} // namespace steadyhand
