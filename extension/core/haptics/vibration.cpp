#include "haptics/vibration.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

float most_of(const EffectSet &effects) {
	return static_cast<float>(effects.most());
}

} // namespace

Vibration::Vibration(double sample_rate_hz, int channels) : channels_(channels > 1 ? 2 : 1) {
	set_sample_rate(sample_rate_hz);
}

void Vibration::set_sample_rate(double sample_rate_hz) {
	end_stretch();
	sample_rate_hz_ = std::isnan(sample_rate_hz)
			? 48000.0
			: std::clamp(sample_rate_hz, LOWEST_RATE_HZ, HIGHEST_RATE_HZ);
	run_s_ = static_cast<double>(RUN) / sample_rate_hz_;
	is_connected_ = false;
}

void Vibration::set_effects(const EffectSet &effects) {
	end_stretch();
	in_use_ = std::max(in_use_, effects.count);
	effects_ = effects;
	most_ = is_silent_ ? most_of(effects) : std::max(most_, most_of(effects));
	effects_follow_ = acceleration_follows_ = false;
	by_position_ = by_velocity_s_m_ = 0.0;
	for (std::size_t i = 0; i < effects.count; ++i) {
		const Effect &effect = effects.effects[i];
		effects_follow_ = effects_follow_ || effect.follows_motion();
		if (effect.is_cue()) {
			continue;
		}
		if (effect.follows_acceleration()) {
			acceleration_follows_ = true;
		} else if (effect.drive == Drive::POSITION) {
			by_position_ = std::max(by_position_, effect.gain / effect.full_scale);
		} else if (effect.drive == Drive::VELOCITY) {
			by_velocity_s_m_ = std::max(by_velocity_s_m_, effect.gain / effect.full_scale);
		}
	}
	is_connected_ = false;
}

void Vibration::set_motion(const MotionSnapshot &motion) {
	end_stretch();
	const bool is_sound = std::isfinite(motion.time_s) && motion.period_s > 0.0 && motion.count > 0 &&
			motion.count <= MotionSnapshot::MOST_KNOTS;
	static constexpr MotionSnapshot NONE{};
	motion_.set(is_sound ? motion : NONE);
	is_connected_ = false;
	if (unheard_s_ > 0.0) {
		patience_s_ = std::clamp(1.5 * std::min(unheard_s_, last_gap_s_), PATIENCE_S, MOST_PATIENCE_S);
		last_gap_s_ = unheard_s_;
		unheard_s_ = 0.0;
	}
}

void Vibration::seek(double time_s) {
	end_stretch();
	clock_.seek(std::isfinite(time_s) ? time_s : 0.0);
	is_connected_ = false;
	is_live_ = false;
}

void Vibration::follow(double time_s) {
	end_stretch();
	clock_.follow(time_s);
	is_connected_ = false;
	is_live_ = true;
}

void Vibration::render(std::span<float> frames) {
	const std::size_t total = frames.size() / channels_;
	for (std::size_t done = 0; done < total;) {
		if (handed_out_ < RUN) {
			const std::size_t count = std::min(RUN - handed_out_, total - done);
			std::copy_n(&rest_[channels_ * handed_out_], channels_ * count, &frames[channels_ * done]);
			handed_out_ += count;
			done += count;
			continue;
		}
		if (made_ == stretch_.runs) {
			begin_stretch();
		}
		const std::size_t runs = std::min((total - done) / RUN, stretch_.runs - made_);
		if (runs > 0) {
			make(&frames[channels_ * done], runs);
			done += runs * RUN;
		} else {
			make(rest_.data(), 1);
			handed_out_ = 0;
		}
	}
}

Mix &Vibration::mix_of(std::uint8_t channels) {
	if (channels_ == 1 || channels == (Effect::LEFT | Effect::RIGHT)) {
		return both_;
	}
	return channels == Effect::LEFT ? left_ : right_;
}

void Vibration::end_stretch() {
	if (stretch_.runs == 0) {
		return;
	}
	const double made_s = run_s_ * static_cast<double>(made_);
	clock_.advance(made_s);
	unheard_s_ += made_s;
	if (made_ < stretch_.runs) {
		const double share = static_cast<double>(made_) / static_cast<double>(stretch_.runs);
		for (std::size_t i = 0; i < in_use_; ++i) {
			sustained_[i].cut(share);
		}
		arrivals_.cut(share);
	}
	stretch_.first_run += made_;
	stretch_.runs = made_ = 0;
}

void Vibration::begin_stretch() {
	end_stretch();
	const double from_s = clock_.now_s();
	const bool is_heard = !is_live_ || unheard_s_ <= patience_s_;
	follows_ = effects_follow_ || (follows_ && arrivals_.are_active());
	stretch_.sample_rate_hz = sample_rate_hz_;
	stretch_.pace = clock_.pace();
	stretch_.is_connected = is_connected_;
	stretch_.amplitude_m = motion_.snapshot().amplitude_m;
	if (follows_) {
		stretch_.from = is_connected_ ? stretch_.to : motion_.at(from_s);
	}
	is_connected_ = follows_;
	const bool is_moving = motion_.is_moving(from_s);
	set_length(longest_stretch(from_s), from_s);
	while (stretch_.runs > 1 && follows_ && !is_cubic(from_s)) {
		set_length(shorter_stretch(from_s), from_s);
	}
	if (is_heard) {
		begin_arrivals(from_s);
	}
	if (!look_at_voices(is_heard, is_moving)) {
		rough_until_ = stretch_.first_run + MOST_RUNS;
		set_length(1, from_s);
		static_cast<void>(look_at_voices(is_heard, is_moving));
	}
	begin_voices();
}

/// The runs up to what begins or ends next.
std::size_t Vibration::longest_stretch(double from_s) const {
	if (stretch_.first_run < rough_until_) {
		return 1;
	}
	if (is_live_ && unheard_s_ + MOST_RUNS * run_s_ > patience_s_) {
		return 1;
	}
	const double run_s = stretch_.pace * run_s_;
	std::size_t runs = MOST_RUNS;
	const auto end_before = [&](const Arrival &cause, std::uint32_t last) {
		const double left_s = cause.time_s - from_s;
		if (cause.number > last && left_s < static_cast<double>(runs) * run_s) {
			runs = left_s > run_s ? static_cast<std::size_t>(left_s / run_s) : 1;
		}
	};
	const MotionSnapshot &motion = motion_.snapshot();
	end_before(motion.arrival, arrived_);
	end_before(motion.expected, arrived_);
	end_before(motion.onset, begun_); // live it is past by now; in a file it may be still to come
	return runs;
}

/// One that goes on over fewer knots of the motion, or half of it.
std::size_t Vibration::shorter_stretch(double from_s) {
	const double smooth_s = motion_.smooth_s(from_s);
	for (const double reach_s : { smooth_s + motion_.snapshot().period_s, smooth_s }) {
		const double runs = reach_s / (stretch_.pace * run_s_);
		if (runs >= 1.0 && runs < static_cast<double>(stretch_.runs)) {
			return static_cast<std::size_t>(runs);
		}
	}
	return stretch_.runs / 2;
}

/// Whether the amplitudes that the motion makes over the stretch are cubics, nearer than a sample can tell.
bool Vibration::is_cubic(double from_s) {
	const double to_s = from_s + stretch_.pace * stretch_.length_s;
	const double position = motion_.from_cubic(from_s, stretch_.from, to_s, stretch_.to);
	double remainder = by_position_ * position;
	if (by_velocity_s_m_ > 0.0) {
		remainder += by_velocity_s_m_ * stretch_.amplitude_m * motion_.velocity_from_cubic(from_s, to_s);
	}
	// The acceleration of a quintic is a cubic, or its own a line.
	const bool needs_one_piece = acceleration_follows_ || arrivals_.are_active();
	return std::isfinite(position) && remainder <= MOST_REMAINDER &&
			(!needs_one_piece || motion_.smooth_s(from_s) >= to_s - from_s);
}

void Vibration::set_length(std::size_t runs, double from_s) {
	stretch_.runs = runs;
	stretch_.length_s = run_s_ * static_cast<double>(runs);
	if (follows_) {
		stretch_.to = motion_.at(from_s + stretch_.pace * stretch_.length_s);
	}
}

bool Vibration::look_at_voices(bool is_heard, bool is_moving) {
	// An expected arrival that has begun comes before the snapshot that will tell of it.
	const bool has_arrived =
			motion_.snapshot().expected.number != 0 && arrived_ >= motion_.snapshot().expected.number;
	bool is_smooth = true;
	for (std::size_t i = 0; i < in_use_; ++i) {
		SustainedVoice &voice = sustained_[i];
		const Effect &effect = effects_.effects[i];
		const bool is_due = effect.trigger == Trigger::ALWAYS ||
				(effect.trigger == Trigger::MOVING && !has_arrived && is_moving);
		const bool wanted = is_heard && i < effects_.count && motion_.snapshot().count > 0 && is_due &&
				voice.may_be(effect.channels);
		if (wanted) {
			voice.set_channels(effect.channels);
		}
		if (voice.sounds(wanted)) {
			is_smooth = voice.look_at(effect, wanted, stretch_) && is_smooth;
		} else {
			voice.rest();
		}
	}
	return arrivals_.look_at(stretch_) && is_smooth;
}

void Vibration::begin_voices() {
	std::size_t heard = 0;
	for (std::size_t i = 0; i < in_use_; ++i) {
		if (sustained_[i].is_on()) {
			sustained_[i].begin(stretch_);
			if (sustained_[i].is_heard()) {
				++heard;
				only_voice_ = i;
			}
		}
	}
	while (in_use_ > effects_.count && !sustained_[in_use_ - 1].is_on()) {
		--in_use_;
	}
	arrivals_.begin(stretch_);
	is_silent_ = !arrivals_.are_active() && heard == 0;
	is_only_voice_ =
			!arrivals_.are_active() && heard == 1 && &mix_of(sustained_[only_voice_].channels()) == &both_;
}

void Vibration::begin_arrivals(double from_s) {
	const double length_s = stretch_.pace * stretch_.length_s;
	for (const Arrival *const arrival : { &motion_.snapshot().arrival, &motion_.snapshot().expected }) {
		if (arrival->number > arrived_ && arrival->time_s < from_s + length_s) {
			arrived_ = arrival->number;
			begin_cues(Trigger::ARRIVAL, *arrival, from_s, length_s);
		}
	}
	const Arrival &onset = motion_.snapshot().onset;
	if (onset.number > begun_ && onset.time_s < from_s + length_s) {
		begun_ = onset.number;
		begin_cues(Trigger::START, onset, from_s, length_s);
	}
}

void Vibration::begin_cues(Trigger trigger, const Arrival &arrival, double from_s, double length_s) {
	if (from_s - arrival.time_s > (trigger == Trigger::START ? LATEST_START_S : LATEST_S)) {
		return;
	}
	const double share = std::max(arrival.time_s - from_s, 0.0) / length_s;
	// The first sample at or after it; what rounding lost of a time on the samples' grid does not count.
	constexpr double GRAIN = 1e-6;
	const auto first = static_cast<std::int32_t>(
			std::ceil(std::max(share * static_cast<double>(stretch_.runs * RUN) - GRAIN, 0.0)));
	const MotionPoint motion = motion_.at(std::max(arrival.time_s, from_s));
	arrivals_.start(effects_, trigger, arrival, first, motion, stretch_);
}

void Vibration::make(float *frames, std::size_t runs) {
	const std::size_t a_run = channels_ * RUN;
	if (is_silent_) {
		most_ = most_of(effects_);
		std::fill_n(frames, runs * a_run, 0.0F);
		made_ += runs;
	} else if (is_only_voice_) {
		sustained_[only_voice_].write(frames, channels_, made_, runs);
		made_ += runs;
	} else {
		for (std::size_t i = 0; i < runs; ++i) {
			make_run(frames + i * a_run);
			++made_;
		}
	}
}

void Vibration::make_run(float *frames) {
	for (Mix *const mix : { &both_, &left_, &right_ }) {
		if (!mix->is_silent) {
			clear(*mix);
		}
	}
	for (std::size_t i = 0; i < in_use_; ++i) {
		if (sustained_[i].is_heard()) {
			sustained_[i].add_run(made_, mix_of(sustained_[i].channels()));
		}
	}
	arrivals_.add_run(stretch_, made_, [this](std::uint8_t channels) -> Mix & { return mix_of(channels); });
	const bool has_sides = !left_.is_silent || !right_.is_silent;
	if (has_sides) {
		add(left_, both_);
		add(right_, both_);
	}
	const Mix &left = has_sides ? left_ : both_, &right = has_sides ? right_ : both_;
	const Ramp left_gain = next_gain(left_gain_, left.level);
	if (channels_ == 1) {
		write_held(frames, both_, left_gain, most_);
	} else {
		write_held(frames, left, left_gain, right, next_gain(right_gain_, right.level), most_);
	}
}

/// Sounds that together would exceed full scale are turned down to it, and not cut flat: as an effect fades
/// and the next one swells.
Ramp Vibration::next_gain(float &r_gain, float level) const {
	const float from = r_gain;
	r_gain = level > most_ ? most_ / level : 1.0F;
	return { from, r_gain };
}

} // namespace steadyhand
