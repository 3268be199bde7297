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

/// How a tracker errs, beside its lag.
enum class TrackerError : std::uint8_t {
	SLIGHT,
	GREAT,        ///< the more the further the hand is
	SLIDING_BACK, ///< from where it has jumped to
	SHAKING,      ///< from frame to frame, about a hand at rest
};
inline constexpr std::size_t TRACKER_ERRORS = 4;
[[nodiscard]] constexpr std::size_t index_of(TrackerError error) {
	return static_cast<std::size_t>(error);
}

/// How far a deviation goes and how it comes back: critically damped noise. That of a FREE hand has the same
/// velocity, and comes back nowhere: see FREE_SLOWING_PER_S.
struct Deviation {
	double amplitudes; ///< standard deviation
	double rate_per_s;
};

/// A regime's numbers (docs/evidence.md says how they were set); values in amplitudes.
struct RegimeNumbers {
	Deviation hand;     ///< d: what the hand does that the gesture does not say
	TrackerError error; ///< unless the tracker's has been seen to be another
	double lag_s;       ///< of a gesture begun in it: expected lag at the end of the way
	double lag_deviation_s;
	double gain_deviation; ///< of a gesture begun in it; g: how much further or less far than the task asks
};
inline constexpr std::array<RegimeNumbers, REGIMES> REGIME_NUMBERS{
	RegimeNumbers{ { 0.025, 9.0 }, TrackerError::SLIGHT, 0.0, 0.0, 0.0 },
	RegimeNumbers{ { 0.06, 4.6 }, TrackerError::SLIGHT, 0.0, 0.0, 0.041 },
	RegimeNumbers{ { 0.016, 11.0 }, TrackerError::GREAT, 0.09, 0.035, 0.025 },
	RegimeNumbers{ { 0.55, 4.0 }, TrackerError::SLIGHT, 0.0, 0.0, 0.0 },
};
[[nodiscard]] constexpr const RegimeNumbers &regime_numbers(Regime regime) {
	return REGIME_NUMBERS[index_of(regime)];
}

struct ErrorNumbers {
	Deviation at_start; ///< b, where the hand starts
	double on_way;      ///< standard deviation added at the end of the way
	double noise;       ///< white, beside what any tracker has
};
inline constexpr std::array<ErrorNumbers, TRACKER_ERRORS> ERROR_NUMBERS{
	ErrorNumbers{ { 0.0056, 2.7 }, 0.0, 0.0 },
	ErrorNumbers{ { 0.012, 5.9 }, 0.046, 0.0 },
	ErrorNumbers{ { 0.012, 25.0 }, 0.046, 0.0 },
	ErrorNumbers{ { 0.0056, 2.7 }, 0.0, 0.05 },
};
[[nodiscard]] constexpr const ErrorNumbers &error_numbers(TrackerError error) {
	return ERROR_NUMBERS[index_of(error)];
}

/// A free hand comes to rest wherever it is, x'' = -c x' + white (an integrated Ornstein-Uhlenbeck process).
inline constexpr double FREE_SLOWING_PER_S = 6.0;

/// How freely a hand changes its pace on its way: a random walk of the log duration, standard deviation per
/// square root of s.
inline constexpr double PACE_WALK = 0.2;
/// What a longer time without frames adds no more.
inline constexpr double LONGEST_PACE_WALK_S = 1.0;

/// Critically damped motion x'' = -2 a x' - a^2 x over a time, of each regime's hand (FREE slows down) or of
/// each tracker error: [x, x'] is multiplied by [xx xv; vx vv].
struct Dampings {
	static_assert(REGIMES == LANES && TRACKER_ERRORS <= LANES);
	Lanes xx, xv, vx, vv;
	/// As much noise as keeps the stationary variances, s of x and a^2 s of x' (of a free hand the latter):
	/// covariance that it adds, by s.
	Lanes noise_x, noise_xv, noise_v;
};

/// What a time does to the deviations: the same for all hypotheses in a regime, and of an error.
struct Passages {
	Dampings hand, error;
	double pace_variance = 0.0; ///< added to that of log durations
};
[[nodiscard]] Passages passages(double dt_s);

} // namespace steadyhand
