#include "haptics/vibration.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

Vibration::Vibration(double sample_rate_hz, int channels) : channels_(channels > 1 ? 2 : 1) {
	set_sample_rate(sample_rate_hz);
}

void Vibration::set_sample_rate(double sample_rate_hz) {
	sample_rate_hz_ = std::isnan(sample_rate_hz)
			? 48000.0
			: std::clamp(sample_rate_hz, LOWEST_RATE_HZ, HIGHEST_RATE_HZ);
	run_s_ = static_cast<double>(RUN) / sample_rate_hz_;
	is_connected_ = false;
}

void Vibration::set_effects(const EffectSet &effects) {
	in_use_ = std::max(in_use_, effects.count);
	effects_ = effects;
	effects_follow_ = std::any_of(effects.effects.begin(), effects.effects.begin() + effects.count,
			[](const Effect &effect) { return effect.follows_motion(); });
	is_connected_ = false;
}

void Vibration::set_motion(const MotionSnapshot &motion) {
	const bool is_sound = std::isfinite(motion.time_s) && motion.period_s > 0.0 && motion.count > 0 &&
			motion.count <= MotionSnapshot::MOST_KNOTS;
	static constexpr MotionSnapshot NONE{};
	motion_.set(is_sound ? motion : NONE);
	is_connected_ = false;
	unheard_s_ = 0.0;
}

void Vibration::seek(double time_s) {
	clock_.seek(std::isfinite(time_s) ? time_s : 0.0);
	is_connected_ = false;
	is_live_ = false;
}

void Vibration::follow(double time_s) {
	clock_.follow(time_s);
	is_connected_ = false;
	is_live_ = true;
}

void Vibration::render(std::span<float> frames) {
	const std::size_t total = frames.size() / channels_;
	for (std::size_t done = 0; done < total;) {
		if (handed_out_ == RUN) {
			make_run();
			handed_out_ = 0;
		}
		const std::size_t count = std::min(RUN - handed_out_, total - done);
		if (channels_ == 1) {
			write_held(&frames[done], both_, handed_out_, count);
		} else {
			const bool has_sides = !left_.is_silent || !right_.is_silent;
			write_held(&frames[2 * done], has_sides ? left_ : both_, has_sides ? right_ : both_, handed_out_,
					count);
		}
		handed_out_ += count;
		done += count;
	}
}

Mix &Vibration::mix_of(std::uint8_t channels) {
	if (channels_ == 1 || channels == (Effect::LEFT | Effect::RIGHT)) {
		return both_;
	}
	return channels == Effect::LEFT ? left_ : right_;
}

void Vibration::make_run() {
	const double from_s = clock_.now_s();
	clock_.advance(run_s_);
	const double to_s = clock_.now_s();
	const bool is_heard = !is_live_ || unheard_s_ <= PATIENCE_S;
	unheard_s_ += run_s_;
	follows_ = effects_follow_ || (follows_ && active_ > 0);
	RunContext context{ sample_rate_hz_, run_s_, run_++, {}, {}, is_connected_,
		motion_.snapshot().amplitude_m };
	if (follows_) {
		context.from = is_connected_ ? end_ : motion_.at(from_s);
		context.to = end_ = motion_.at(to_s);
	}
	is_connected_ = follows_;
	for (Mix *const mix : { &both_, &left_, &right_ }) {
		if (!mix->is_silent) {
			clear(*mix);
		}
	}
	if (is_heard) {
		begin_arrivals(context, from_s, to_s);
	}
	add_sustained(context, from_s, is_heard);
	if (active_ > 0) {
		for (ArrivalVoice &voice : arrivals_) {
			if (voice.is_active()) {
				voice.add_run(context, mix_of(voice.channels()));
				active_ -= voice.is_active() ? 0 : 1;
			}
		}
	}
	if (!left_.is_silent || !right_.is_silent) {
		add(left_, both_);
		add(right_, both_);
	}
}

void Vibration::add_sustained(const RunContext &context, double from_s, bool is_heard) {
	// An expected arrival that has begun comes before the snapshot that will tell of it.
	const bool has_arrived =
			motion_.snapshot().expected.number != 0 && arrived_ >= motion_.snapshot().expected.number;
	for (std::size_t i = 0; i < in_use_; ++i) {
		SustainedVoice &voice = sustained_[i];
		const Effect &effect = effects_.effects[i];
		const bool is_due = effect.trigger == Trigger::ALWAYS ||
				(effect.trigger == Trigger::MOVING && !has_arrived && motion_.is_moving(from_s));
		const bool wanted = is_heard && i < effects_.count && motion_.snapshot().count > 0 && is_due &&
				voice.may_be(effect.channels);
		if (wanted) {
			voice.set_channels(effect.channels);
		}
		if (voice.sounds(wanted)) {
			voice.add_run(effect, wanted, context, mix_of(voice.channels()));
		}
	}
	while (in_use_ > effects_.count && !sustained_[in_use_ - 1].sounds(false)) {
		--in_use_;
	}
}

void Vibration::begin_arrivals(const RunContext &context, double from_s, double to_s) {
	for (const Arrival *const arrival : { &motion_.snapshot().arrival, &motion_.snapshot().expected }) {
		if (arrival->number > arrived_ && arrival->time_s < to_s) {
			arrive(*arrival, context, from_s, to_s);
		}
	}
}

void Vibration::arrive(const Arrival &arrival, const RunContext &context, double from_s, double to_s) {
	arrived_ = arrival.number;
	if (from_s - arrival.time_s > LATEST_S) {
		return;
	}
	const double share = std::max(arrival.time_s - from_s, 0.0) / (to_s - from_s);
	// The first sample at or after it; what rounding lost of a time on the samples' grid does not count.
	constexpr double GRAIN = 1e-6;
	const auto first =
			static_cast<std::int32_t>(std::ceil(std::max(share * static_cast<double>(RUN) - GRAIN, 0.0)));
	const MotionPoint motion = motion_.at(std::max(arrival.time_s, from_s));
	for (std::size_t i = 0; i < effects_.count; ++i) {
		if (effects_.effects[i].trigger != Trigger::ARRIVAL) {
			continue;
		}
		const auto free = std::find_if(arrivals_.begin(), arrivals_.end(),
				[](const ArrivalVoice &voice) { return !voice.is_active(); });
		if (free != arrivals_.end()) {
			free->start(effects_.effects[i], effects_.generation, arrival, first, motion, context);
			active_ += free->is_active() ? 1 : 0;
		}
	}
}

std::uint64_t Vibration::oldest_generation() const {
	std::uint64_t oldest = effects_.generation;
	for (const ArrivalVoice &voice : arrivals_) {
		if (voice.is_active()) {
			oldest = std::min(oldest, voice.generation());
		}
	}
	return oldest;
}

} // namespace steadyhand
