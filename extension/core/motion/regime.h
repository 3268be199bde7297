#pragma once

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

/// How far a deviation goes and how it comes back: critically damped noise.
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
[[nodiscard]] const RegimeNumbers &regime_numbers(Regime regime);

/// Critically damped motion x'' = -2 a x' - a^2 x over a time: [x, x'] is multiplied by this.
struct Damping {
	double xx = 1.0, xv = 0.0, vx = 0.0, vv = 1.0;
	/// As much noise as keeps the stationary variances, s of x and a^2 s of x': covariance that it adds, by
	/// s.
	double noise_x = 0.0, noise_xv = 0.0, noise_v = 0.0;

	Damping() = default;
	/// fading: exp(-rate_per_s * dt_s)
	Damping(double rate_per_s, double dt_s, double fading);
};

/// What a time does to the deviations of a regime: the same for all hypotheses in it.
struct Passage {
	Damping hand, error;
};
using Passages = std::array<Passage, REGIMES>; ///< one of each
[[nodiscard]] Passages passages(double dt_s);

} // namespace steadyhand
