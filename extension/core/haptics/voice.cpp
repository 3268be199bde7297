#include "haptics/voice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

constexpr double TWO_PI = 2.0 * std::numbers::pi;
constexpr auto LENGTH = static_cast<std::int64_t>(RUN);
/// A swelling over this many periods of the carrier changes no faster than the carrier itself.
constexpr double RAMP_PERIODS = 0.5;

double rad_per_s(double frequency_hz, double sample_rate_hz) {
	return TWO_PI * std::min(frequency_hz, 0.5 * sample_rate_hz);
}

} // namespace

void SustainedVoice::add_run(const Effect &effect, bool wanted, const RunContext &context, Mix &out) {
	// A voice that dies away keeps the frequency that it had.
	if ((wanted && effect.frequency_hz != frequency_hz_) || context.sample_rate_hz != sample_rate_hz_) {
		frequency_hz_ = wanted || frequency_hz_ == 0.0 ? effect.frequency_hz : frequency_hz_;
		sample_rate_hz_ = context.sample_rate_hz;
		carrier_.set_step(phase_step(frequency_hz_, sample_rate_hz_));
	}
	LevelPoint from, to;
	if (wanted) {
		const bool goes_on = context.is_connected && next_run_ == context.number;
		from = goes_on ? wanted_ : level_of(effect, context.from, context.amplitude_m);
		to = level_of(effect, context.to, context.amplitude_m);
	}
	wanted_ = to;
	const Level level = level_.follow(from, to, rad_per_s(frequency_hz_, sample_rate_hz_), context.run_s);
	// In silence the phase goes on.
	carrier_.advance(context.number - next_run_);
	next_run_ = context.number;
	if (!level.is_zero()) {
		add_sine(out, carrier_, level);
	}
	carrier_.advance(1);
	++next_run_;
}

void ArrivalVoice::start(const Effect &effect, std::uint64_t generation, const Arrival &arrival,
		std::int32_t first, const MotionPoint &motion, const RunContext &context) {
	effect_ = effect;
	generation_ = generation;
	const double rate = context.sample_rate_hz;
	peak_ = peak_of(effect, arrival, motion, context.amplitude_m);
	is_active_ = peak_ > 0.0;
	has_level_ = false;
	next_ = -first;
	length_ = std::llround(effect.length_s() * rate);
	const double ramp =
			std::min(RAMP_PERIODS * rate / effect.frequency_hz, 0.5 * static_cast<double>(length_));
	window_ = { static_cast<float>(std::max(ramp, 1.0)), static_cast<float>(length_) };
	const std::uint64_t step = phase_step(effect.frequency_hz, rate);
	carrier_.set_step(step);
	carrier_.set_phase(step * static_cast<std::uint64_t>(next_));
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

void ArrivalVoice::fill_from_table(const RunContext &context, Run &values) const {
	const bool is_curve = effect_.shape == Shape::CURVE;
	const double cells = static_cast<double>(effect_.table.count) - 1.0;
	const double each =
			is_curve ? cells / static_cast<double>(length_) : effect_.table_rate_hz / context.sample_rate_hz;
	const auto sine = static_cast<float>(carrier_.start().sine);
	const auto cosine = static_cast<float>(carrier_.start().cosine);
	for (std::size_t i = 0; i < RUN; ++i) {
		const double at = each * static_cast<double>(next_ + static_cast<std::int64_t>(i));
		const float carrier = is_curve ? carrier_.at(sine, cosine, i) : 1.0F;
		values[i] = static_cast<float>(peak_ * effect_.table.value(at)) * carrier;
	}
}

void ArrivalVoice::add_level(Mix &out, const Level &level) const {
	if (window_.is_full(static_cast<float>(next_), static_cast<float>(next_ + LENGTH - 1))) {
		add_sine(out, carrier_, level);
	} else {
		add_windowed_sine(out, carrier_, level, window_, static_cast<std::int32_t>(next_));
	}
}

void ArrivalVoice::add_run(const RunContext &context, Mix &out) {
	const auto at = static_cast<std::int32_t>(next_);
	switch (effect_.shape) {
		case Shape::DECAYING_SINE:
			add_decaying_sine(out, carrier_, decayed_, decay_, std::max(-at, 0));
			decayed_ *= decay_over_run_;
			break;
		case Shape::SINE:
			add_level(out, Level::hermite(peak_, 0.0, peak_, 0.0));
			break;
		case Shape::INERTIAL_VISCOUS: {
			const LevelPoint from = level_of(effect_, context.from, context.amplitude_m);
			const LevelPoint to = level_of(effect_, context.to, context.amplitude_m);
			if (!has_level_) {
				level_.start(from);
				has_level_ = true;
			}
			const double w = rad_per_s(effect_.frequency_hz, context.sample_rate_hz);
			add_level(out, level_.follow(from, to, w, context.run_s));
			break;
		}
		case Shape::CURVE:
		case Shape::SAMPLES: {
			Run values;
			fill_from_table(context, values);
			add_windowed(out, values, window_, at);
			break;
		}
	}
	carrier_.advance(1);
	next_ += LENGTH;
	is_active_ = next_ < length_;
}

} // namespace steadyhand
