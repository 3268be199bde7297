#pragma once

#include "haptics/motion_snapshot.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace steadyhand {

/// What of the motion an effect's amplitude follows.
enum class Drive : std::uint8_t { CONSTANT, POSITION, VELOCITY, ACCELERATION };

/// When an effect is felt: as long as motion comes; while a gesture is active and has not arrived; or once,
/// from the instant on at which it arrives, or at which its start is recognised.
enum class Trigger : std::uint8_t { ALWAYS, MOVING, ARRIVAL, START };

enum class Shape : std::uint8_t {
	SINE,             ///< M sin(2 pi f t)
	DECAYING_SINE,    ///< M exp(-N t) sin(2 pi f t), at an arrival
	INERTIAL_VISCOUS, ///< a sine of the amplitude viscous + inertia |a|, at an arrival
	CURVE,            ///< a sine; the table is the amplitude over the drive, at an arrival over its duration
	SAMPLES,          ///< M times the table, at an arrival
};

/// Numbers owned by another, who keeps them as long as they are in use.
struct Table {
	const float *values = nullptr;
	std::uint32_t count = 0;

	/// Between its numbers in straight lines; `at` from 0 to count - 1.
	[[nodiscard]] double value(double at) const;
	/// d value / d at
	[[nodiscard]] double slope(double at) const;
	/// The greatest size of its numbers between two places, and 0 of none.
	[[nodiscard]] double greatest(double from, double to) const;
};

/// One effect, in numbers. The defaults are the paper's spring, equation (2).
struct Effect {
	static constexpr unsigned LEFT = 1, RIGHT = 2;

	Shape shape = Shape::SINE;
	Drive drive = Drive::POSITION;
	Trigger trigger = Trigger::MOVING;
	std::uint8_t channels = LEFT | RIGHT;
	double frequency_hz = 180.0;
	double gain = 1.0;           ///< amplitude where the drive is at its full scale; 0..1 of full output
	double full_scale = 1.0;     ///< of the drive: amplitudes, m/s or m/s^2
	double most = 1.0;           ///< the amplitude is held to this
	double decay_per_s = 200.0;  ///< N of a decaying sine; it ends where it has come down to exp(-8)
	double duration_s = 0.06;    ///< of a sine, a curve or an inertial-viscous cue at an arrival
	double viscous = 0.5;        ///< amplitude by the constant speed: viscosity x speed
	double inertia_s2_m = 0.25;  ///< amplitude by the acceleration, for each m/s^2
	Table table;                 ///< of a curve or samples
	double table_rate_hz = 48e3; ///< of samples
	bool fades = true;           ///< samples swell and die away; otherwise they begin and end at 0 themselves
	Table frequency_table;       ///< of a curve that follows the drive: its carrier over the drive, Hz

	/// It is felt once, from an arrival or a start on.
	[[nodiscard]] bool is_cue() const { return trigger == Trigger::ARRIVAL || trigger == Trigger::START; }
	/// How long a cue goes on.
	[[nodiscard]] double length_s() const;
	/// Whether its amplitude changes with the motion while it lasts.
	[[nodiscard]] bool follows_motion() const { return !is_cue() || shape == Shape::INERTIAL_VISCOUS; }
	[[nodiscard]] bool follows_acceleration() const {
		return shape == Shape::INERTIAL_VISCOUS || drive == Drive::ACCELERATION;
	}
};

/// The effects of a synth, small enough to be handed over as a whole.
struct EffectSet {
	static constexpr std::size_t MOST = 8;

	std::array<Effect, MOST> effects{};
	std::size_t count = 0;
	std::uint64_t generation = 0; ///< of the tables

	/// What they are held to together: the greatest amplitude that one of them may have, 1 without any.
	[[nodiscard]] double most() const;
	void add(const Effect &effect) {
		if (count < MOST) {
			effects[count++] = effect;
		}
	}
};

/// An amplitude and how it changes, per s.
struct LevelPoint {
	double value = 0.0, slope = 0.0;
};

/// The amplitude that the motion gives a sustained effect, or an inertial-viscous cue while it lasts. 0 where
/// the motion is no number.
[[nodiscard]] LevelPoint level_of(const Effect &effect, const MotionPoint &motion, double amplitude_m);
/// The frequency of a sustained effect's carrier at a motion, Hz.
[[nodiscard]] double frequency_of(const Effect &effect, const MotionPoint &motion, double amplitude_m);
/// Whether that amplitude has no corner between two motions that one polynomial joins, given its values there
/// and that a cubic by them stays within 0..most: it has where it is held to a limit, where what it follows
/// changes its sign, and along a curve.
[[nodiscard]] bool is_smooth(const Effect &effect, const MotionPoint &from, const MotionPoint &to,
		double from_value, double to_value);
/// M of an effect that begins with an arrival.
[[nodiscard]] double peak_of(
		const Effect &effect, const Arrival &arrival, const MotionPoint &motion, double amplitude_m);

// The paper's, "Subjective evaluation experiment".
[[nodiscard]] Effect spring_effect();
/// Equation (3); M is the speed at the contact, full at 1 m/s.
[[nodiscard]] Effect impulse_effect();
/// The cue at a drag's end: 60 ms, by a constant speed and the actual acceleration. The paper names neither
/// factor nor frequency.
[[nodiscard]] Effect inertial_viscous_effect();
/// What the paper gives with a gesture: drags spring and cue, a tap the impulse, any other the spring.
[[nodiscard]] EffectSet effects_of_gesture(std::string_view gesture);

/// What is felt at an instant without its carrier, for outputs that take a strength only.
struct Strength {
	/// A gamepad's motors: the light one turns faster than this, the heavy one more slowly.
	static constexpr double LOW_BELOW_HZ = 100.0;

	double amplitude = 0.0;    ///< 0..EffectSet::most()
	double low = 0.0;          ///< of that, what effects below LOW_BELOW_HZ make
	double frequency_hz = 0.0; ///< of the strongest effect
};

/// arrival, onset: the last ones.
[[nodiscard]] Strength strength_of(const EffectSet &effects, double t_s, const MotionPoint &motion,
		bool is_moving, double amplitude_m, const Arrival &arrival, const Arrival &onset = {});

} // namespace steadyhand
