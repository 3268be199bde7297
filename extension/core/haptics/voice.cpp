#include "haptics/voice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

constexpr double TWO_PI = 2.0 * std::numbers::pi;
constexpr auto RUN_LENGTH = static_cast<std::int64_t>(RUN);
/// A swelling over this many periods of the carrier changes no faster than the carrier itself.
constexpr double RAMP_PERIODS = 0.5;

double rad_per_s(double frequency_hz, double sample_rate_hz) {
	return TWO_PI * std::min(frequency_hz, 0.5 * sample_rate_hz);
}

float largest(const Run &values) {
	float largest = 0.0F;
	for (const float value : values) {
		largest = std::max(largest, std::abs(value));
	}
	return largest;
}

/// The amplitude that the motion asks for, its slope by the samples' clock.
LevelPoint wanted_of(const Effect &effect, const MotionPoint &motion, const Stretch &stretch) {
	LevelPoint level = level_of(effect, motion, stretch.amplitude_m);
	level.slope *= stretch.pace;
	return level;
}

} // namespace

bool SustainedVoice::look_at(const Effect &effect, bool wanted, const Stretch &stretch) {
	// A voice that dies away keeps the frequency that it had.
	const double frequency_hz = wanted || frequency_hz_ == 0.0
			? frequency_of(effect, stretch.from, stretch.amplitude_m)
			: frequency_hz_;
	if (frequency_hz != frequency_hz_ || stretch.sample_rate_hz != sample_rate_hz_) {
		turn_to(stretch.first_run);
		frequency_hz_ = frequency_hz;
		sample_rate_hz_ = stretch.sample_rate_hz;
		carrier_.set_step(phase_step(frequency_hz_, sample_rate_hz_));
	}
	is_on_ = true;
	LevelPoint from, to;
	if (wanted) {
		const bool goes_on = stretch.is_connected && followed_to_ == stretch.first_run;
		from = goes_on ? followed_ : wanted_of(effect, stretch.from, stretch);
		to = wanted_of(effect, stretch.to, stretch);
	}
	from_ = from;
	to_ = to;
	return stretch.runs == 1 ||
			((!wanted || is_smooth(effect, stretch.from, stretch.to, from.value, to.value)) &&
					level_.can_follow_stretch(from, to, effect.most,
							rad_per_s(frequency_hz_, sample_rate_hz_), stretch.length_s));
}

void SustainedVoice::begin(const Stretch &stretch) {
	course_ = level_.follow(
			from_, to_, rad_per_s(frequency_hz_, sample_rate_hz_), stretch.length_s, stretch.runs);
	followed_ = to_;
	followed_to_ = stretch.first_run + stretch.runs;
	if (is_heard()) {
		turn_to(stretch.first_run);
	}
}

/// In silence the phase goes on.
void SustainedVoice::turn_to(std::uint64_t run) {
	carrier_.advance(run - carrier_run_);
	carrier_run_ = run;
}

void SustainedVoice::cut(double share) {
	if (is_on_) {
		level_.cut(share);
	}
}

void ArrivalVoice::start(const Effect &effect, std::uint64_t generation, const Arrival &arrival,
		std::int32_t first, const MotionPoint &motion, const Stretch &stretch) {
	effect_ = effect;
	generation_ = generation;
	const double rate = stretch.sample_rate_hz;
	peak_ = peak_of(effect, arrival, motion, stretch.amplitude_m);
	course_ = { static_cast<float>(peak_) };
	is_active_ = peak_ > 0.0;
	has_level_ = false;
	next_ = -first;
	length_ = std::llround(effect.length_s() * rate);
	const double ramp = effect.fades
			? std::min(RAMP_PERIODS * rate / effect.frequency_hz, 0.5 * static_cast<double>(length_))
			: 0.0;
	window_ = { static_cast<float>(std::max(ramp, 1.0)), static_cast<float>(length_) };
	const std::uint64_t step = phase_step(effect.frequency_hz, rate);
	carrier_.set_step(step);
	carrier_.set_phase(step * static_cast<std::uint64_t>(next_));
	carrier_run_ = stretch.first_run;
	if (effect.shape == Shape::DECAYING_SINE) {
		const double each = std::exp(-effect.decay_per_s / rate);
		double decayed = 1.0;
		for (float &share : decay_) {
			share = static_cast<float>(decayed);
			decayed *= each;
		}
		decay_over_run_ = decayed;
		decayed_ = peak_ * std::exp(effect.decay_per_s / rate * static_cast<double>(first));
	}
}

void ArrivalVoice::fill_from_table(const Stretch &stretch, std::size_t run, Run &values) const {
	const bool is_curve = effect_.shape == Shape::CURVE;
	const double cells = static_cast<double>(effect_.table.count) - 1.0;
	const double each =
			is_curve ? cells / static_cast<double>(length_) : effect_.table_rate_hz / stretch.sample_rate_hz;
	for (std::size_t i = 0; i < RUN; ++i) {
		const double at = each * static_cast<double>(next_ + static_cast<std::int64_t>(i));
		const float carrier = is_curve ? carrier_.at(carrier_.start(run), i) : 1.0F;
		values[i] = static_cast<float>(peak_ * effect_.table.value(at)) * carrier;
	}
}

void ArrivalVoice::add_level(Mix &out, std::size_t run) const {
	if (window_.is_full(static_cast<float>(next_), static_cast<float>(next_ + RUN_LENGTH - 1))) {
		add_sine(out, carrier_, course_, run);
	} else {
		add_windowed_sine(out, carrier_, course_, window_, static_cast<std::int32_t>(next_), run);
	}
	out.level += std::abs(course_.after_run(run)) * window_after_run();
}

bool ArrivalVoice::look_at(const Stretch &stretch) {
	if (!effect_.follows_motion()) {
		return true;
	}
	from_ = wanted_of(effect_, stretch.from, stretch);
	to_ = wanted_of(effect_, stretch.to, stretch);
	if (!has_level_) {
		level_.start(from_);
		has_level_ = true;
	}
	return stretch.runs == 1 ||
			(is_smooth(effect_, stretch.from, stretch.to, from_.value, to_.value) &&
					level_.can_follow_stretch(from_, to_, effect_.most,
							rad_per_s(effect_.frequency_hz, stretch.sample_rate_hz), stretch.length_s));
}

void ArrivalVoice::begin(const Stretch &stretch) {
	carrier_.advance(stretch.first_run - carrier_run_);
	carrier_run_ = stretch.first_run;
	if (effect_.follows_motion()) {
		course_ = level_.follow(from_, to_, rad_per_s(effect_.frequency_hz, stretch.sample_rate_hz),
				stretch.length_s, stretch.runs);
	}
}

void ArrivalVoice::add_run(const Stretch &stretch, std::size_t run, Mix &out) {
	const auto at = static_cast<std::int32_t>(next_);
	switch (effect_.shape) {
		case Shape::DECAYING_SINE:
			add_decaying_sine(out, carrier_, decayed_, decay_, std::max(-at, 0), run);
			decayed_ *= decay_over_run_;
			out.level += static_cast<float>(decayed_);
			break;
		case Shape::SINE:
		case Shape::INERTIAL_VISCOUS:
			add_level(out, run);
			break;
		case Shape::CURVE:
		case Shape::SAMPLES: {
			Run values;
			fill_from_table(stretch, run, values);
			add_windowed(out, values, window_, at);
			out.level += largest(values) * window_after_run();
			break;
		}
	}
	next_ += RUN_LENGTH;
	is_active_ = next_ < length_;
}

} // namespace steadyhand
