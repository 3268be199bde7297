#include "haptics/pulse_train.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

namespace {

/// The envelope is looked at so often.
constexpr double LOOK_S = 0.002;
/// What is further apart is a leap: what lies between is not caught up with.
constexpr double LEAP_S = 0.1;

} // namespace

void PulseTrain::listen(
		const EffectSet &effects, const MotionSnapshot &motion, const Arrival &arrival, double t_s) {
	const Strength strength = strength_of(
			effects, t_s, motion.at(t_s), motion.is_moving(t_s), motion.amplitude_m, arrival, motion.onset);
	if (strength.amplitude > greatest_.amplitude) {
		greatest_ = strength;
	}
}

std::optional<Pulse> PulseTrain::next(const EffectSet &effects, const LiveMotion &live) {
	const MotionSnapshot &motion = live.snapshot;
	const double until_s = live.heard_s;
	if (!std::isfinite(until_s)) {
		return std::nullopt;
	}
	const bool leaps = !is_set_ || until_s < now_s_ || until_s > now_s_ + LEAP_S;
	if (leaps) {
		now_s_ = until_s;
		told_s_ = until_s - PERIOD_S;
		greatest_ = {};
	}
	is_set_ = true;
	const bool comes = motion.expected.number != 0 && motion.expected.time_s <= until_s;
	const Arrival &arrival = comes ? motion.expected : motion.arrival;
	const double late_s = until_s - arrival.time_s;
	const bool arrives = arrival.number > arrived_ && late_s >= 0.0 && late_s <= Vibration::LATEST_S;
	if (arrives) {
		listen(effects, motion, arrival, arrival.time_s);
	}
	const double begun_s = until_s - motion.onset.time_s;
	const bool begins =
			motion.onset.number > begun_ && begun_s >= 0.0 && begun_s <= Vibration::LATEST_START_S;
	if (begins) {
		listen(effects, motion, arrival, motion.onset.time_s);
		begun_ = motion.onset.number;
	}
	arrived_ = std::max(arrived_, motion.arrival.number);
	arrived_ = arrives ? arrival.number : arrived_;
	const int looks = std::max(1, static_cast<int>((until_s - now_s_) / LOOK_S));
	for (int i = 1; i <= looks; ++i) {
		listen(effects, motion, arrival, now_s_ + (until_s - now_s_) * i / looks);
	}
	now_s_ = until_s;
	if (!arrives && !begins && until_s < told_s_ + PERIOD_S) {
		return std::nullopt;
	}
	const Pulse pulse{ greatest_.amplitude, greatest_.low, greatest_.frequency_hz, DURATION_S };
	told_s_ = until_s;
	greatest_ = {};
	const bool sounded = sounds_;
	sounds_ = pulse.amplitude > 0.0;
	return sounds_ || sounded ? std::optional(pulse) : std::nullopt;
}

bool PulseTrain::restart() {
	const bool sounded = sounds_;
	const std::uint32_t arrived = arrived_, begun = begun_;
	*this = {};
	arrived_ = arrived;
	begun_ = begun;
	return sounded;
}

} // namespace steadyhand
