#include "haptics/effect.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// Decaying sines end at exp(-this): with N = 200 /s after the paper's 40 ms.
constexpr double DECAYS = 8.0;
/// An instant's share of samples: the greatest within this time of it, a quarter of a period of 50 Hz.
constexpr double ENVELOPE_S = 0.005;

/// The drive in units of its full scale.
LevelPoint drive_of(const Effect &effect, const MotionPoint &motion, double amplitude_m) {
	const double sign_v = motion.velocity < 0.0 ? -1.0 : 1.0;
	const double sign_a = motion.own_acceleration() < 0.0 ? -1.0 : 1.0;
	const double share = 1.0 / effect.full_scale;
	const double metric = amplitude_m * share;
	switch (effect.drive) {
		case Drive::CONSTANT:
			break;
		case Drive::POSITION:
			return { motion.position * share, motion.velocity * share };
		case Drive::VELOCITY:
			return { sign_v * motion.velocity * metric, sign_v * motion.acceleration * metric };
		case Drive::ACCELERATION:
			return { sign_a * motion.own_acceleration() * metric, sign_a * motion.own_jerk() * metric };
	}
	return { 1.0, 0.0 };
}

LevelPoint held(const LevelPoint &level, double most) {
	if (!std::isfinite(level.value) || !std::isfinite(level.slope) || level.value <= 0.0) {
		return {};
	}
	return level.value < most ? level : LevelPoint{ most, 0.0 };
}

} // namespace

double Table::value(double at) const {
	if (count == 0) {
		return 0.0;
	}
	const double last = static_cast<double>(count - 1);
	const double place = at > 0.0 ? std::min(at, last) : 0.0;
	const auto low = std::min(static_cast<std::uint32_t>(place), count > 1 ? count - 2 : 0);
	const double from = static_cast<double>(values[low]);
	const double to = static_cast<double>(values[std::min(low + 1, count - 1)]);
	return from + (to - from) * (place - static_cast<double>(low));
}

double Table::slope(double at) const {
	if (count < 2 || !(at >= 0.0) || at >= static_cast<double>(count - 1)) {
		return 0.0;
	}
	const auto low = static_cast<std::uint32_t>(at);
	return static_cast<double>(values[low + 1]) - static_cast<double>(values[low]);
}

double Table::greatest(double from, double to) const {
	const double last = static_cast<double>(count) - 1.0;
	if (count == 0 || !(to >= 0.0) || !(from <= last)) {
		return 0.0;
	}
	const auto first = static_cast<std::uint32_t>(std::max(from, 0.0));
	const auto end = static_cast<std::uint32_t>(std::min(to, last)) + 1;
	float most = 0.0F;
	for (std::uint32_t i = first; i < end; ++i) {
		most = std::max(most, std::abs(values[i]));
	}
	return static_cast<double>(most);
}

double EffectSet::most() const {
	double greatest = count > 0 ? 0.0 : 1.0;
	for (std::size_t i = 0; i < count; ++i) {
		greatest = std::max(greatest, effects[i].most);
	}
	return greatest;
}

double Effect::length_s() const {
	switch (shape) {
		case Shape::DECAYING_SINE:
			return DECAYS / decay_per_s;
		case Shape::SAMPLES:
			return table.count > 1 ? static_cast<double>(table.count - 1) / table_rate_hz : 0.0;
		case Shape::SINE:
		case Shape::INERTIAL_VISCOUS:
		case Shape::CURVE:
			break;
	}
	return duration_s;
}

LevelPoint level_of(const Effect &effect, const MotionPoint &motion, double amplitude_m) {
	if (effect.shape == Shape::INERTIAL_VISCOUS) {
		const double inertia = effect.gain * effect.inertia_s2_m * amplitude_m;
		const double sign = motion.own_acceleration() < 0.0 ? -1.0 : 1.0;
		return held({ effect.gain * effect.viscous + sign * inertia * motion.own_acceleration(),
							sign * inertia * motion.own_jerk() },
				effect.most);
	}
	const LevelPoint drive = held(drive_of(effect, motion, amplitude_m), 1.0);
	if (effect.shape == Shape::CURVE && !effect.is_cue() && effect.table.count > 0) {
		const double cells = static_cast<double>(effect.table.count - 1);
		return held({ effect.gain * effect.table.value(cells * drive.value),
							effect.gain * effect.table.slope(cells * drive.value) * cells * drive.slope },
				effect.most);
	}
	return held({ effect.gain * drive.value, effect.gain * drive.slope }, effect.most);
}

double frequency_of(const Effect &effect, const MotionPoint &motion, double amplitude_m) {
	if (effect.frequency_table.count == 0) {
		return effect.frequency_hz;
	}
	const double cells = static_cast<double>(effect.frequency_table.count - 1);
	return effect.frequency_table.value(cells * held(drive_of(effect, motion, amplitude_m), 1.0).value);
}

bool is_smooth(const Effect &effect, const MotionPoint &from, const MotionPoint &to, double from_value,
		double to_value) {
	const auto rests = [](const MotionPoint &motion) {
		return motion.velocity == 0.0 && motion.acceleration == 0.0 && motion.jerk == 0.0 &&
				motion.correction == 0.0 && motion.correction_slope == 0.0;
	};
	const bool is_cue = effect.shape == Shape::INERTIAL_VISCOUS;
	if ((effect.drive == Drive::CONSTANT && !is_cue) || (rests(from) && rests(to))) {
		return true;
	}
	const double most = is_cue ? effect.most : std::min(effect.most, effect.gain);
	const auto is_free = [most](double value) { return value > 0.0 && value < most; };
	if (!is_free(from_value) || !is_free(to_value)) {
		return false;
	}
	if (effect.follows_acceleration()) {
		return (from.own_acceleration() < 0.0) == (to.own_acceleration() < 0.0);
	}
	return (effect.shape == Shape::SINE || effect.shape == Shape::DECAYING_SINE) &&
			(effect.drive == Drive::POSITION || (from.velocity < 0.0) == (to.velocity < 0.0));
}

double peak_of(const Effect &effect, const Arrival &arrival, const MotionPoint &motion, double amplitude_m) {
	if (effect.drive == Drive::VELOCITY && effect.shape != Shape::INERTIAL_VISCOUS) {
		return held({ effect.gain * std::min(arrival.speed_m_s / effect.full_scale, 1.0), 0.0 }, effect.most)
				.value;
	}
	return level_of(effect, motion, amplitude_m).value;
}

Effect spring_effect() {
	return {};
}

Effect impulse_effect() {
	Effect effect;
	effect.shape = Shape::DECAYING_SINE;
	effect.drive = Drive::VELOCITY;
	effect.trigger = Trigger::ARRIVAL;
	effect.frequency_hz = 300.0;
	return effect;
}

Effect inertial_viscous_effect() {
	Effect effect;
	effect.shape = Shape::INERTIAL_VISCOUS;
	effect.drive = Drive::ACCELERATION;
	effect.trigger = Trigger::ARRIVAL;
	return effect;
}

EffectSet effects_of_gesture(std::string_view gesture) {
	EffectSet set;
	set.add(gesture == "tap" ? impulse_effect() : spring_effect());
	if (gesture == "horizontal_drag" || gesture == "vertical_drag") {
		set.add(inertial_viscous_effect());
	}
	return set;
}

Strength strength_of(const EffectSet &effects, double t_s, const MotionPoint &motion, bool is_moving,
		double amplitude_m, const Arrival &arrival, const Arrival &onset) {
	Strength strength;
	double strongest = 0.0;
	for (std::size_t i = 0; i < effects.count; ++i) {
		const Effect &effect = effects.effects[i];
		double amplitude = 0.0, frequency_hz = effect.frequency_hz;
		if (effect.is_cue()) {
			const Arrival &cause = effect.trigger == Trigger::START ? onset : arrival;
			const double since_s = t_s - cause.time_s;
			if (cause.number == 0 || !(since_s >= 0.0) || since_s >= effect.length_s()) {
				continue;
			}
			amplitude = peak_of(effect, cause, motion, amplitude_m);
			if (effect.shape == Shape::DECAYING_SINE) {
				amplitude *= std::exp(-effect.decay_per_s * since_s);
			} else if (effect.shape == Shape::CURVE) {
				amplitude *= effect.table.value(
						static_cast<double>(effect.table.count - 1) * since_s / effect.duration_s);
			} else if (effect.shape == Shape::SAMPLES) {
				amplitude *= effect.table.greatest((since_s - ENVELOPE_S) * effect.table_rate_hz,
						(since_s + ENVELOPE_S) * effect.table_rate_hz);
			}
		} else if (effect.trigger == Trigger::ALWAYS || is_moving) {
			amplitude = level_of(effect, motion, amplitude_m).value;
			frequency_hz = frequency_of(effect, motion, amplitude_m);
		}
		strength.amplitude += amplitude;
		if (frequency_hz < Strength::LOW_BELOW_HZ) {
			strength.low += amplitude;
		}
		if (amplitude > strongest) {
			strongest = amplitude;
			strength.frequency_hz = frequency_hz;
		}
	}
	const double most = std::min(effects.most(), 1.0);
	if (strength.amplitude > most) {
		strength.low = std::min(strength.low * (most / strength.amplitude), most); // rounding gains none
		strength.amplitude = most;
	}
	return strength;
}

} // namespace steadyhand
