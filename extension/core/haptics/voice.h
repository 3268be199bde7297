#pragma once

#include "haptics/level_follower.h"
#include "haptics/run.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// What a voice needs to know of a stretch.
struct Stretch {
	double sample_rate_hz = 48000.0;
	std::size_t runs = 0;
	double length_s = 0.0;       ///< by the samples' clock
	double pace = 1.0;           ///< time of the motion's a second of samples
	std::uint64_t first_run = 0; ///< its number
	MotionPoint from, to;        ///< the motion at its first sample, and at the one after its last
	/// Effects and motion at its first sample are those that the last stretch ended with.
	bool is_connected = false;
	double amplitude_m = 0.0;
};

/// An effect that goes on: a sine whose amplitude follows the motion.
class SustainedVoice {
public:
	/// Looks at the coming stretch; wanted: false lets the voice fade out. False where that has to be made
	/// run by run, as seen from this voice.
	[[nodiscard]] bool look_at(const Effect &effect, bool wanted, const Stretch &stretch);
	/// Begins the stretch that was looked at last.
	void begin(const Stretch &stretch);
	/// It ends before its time, after this share.
	void cut(double share);
	/// The coming stretch is silent.
	void rest() { is_on_ = false; }

	/// Adds the run `run` of the stretch to `out` of the voice's channels.
	void add_run(std::size_t run, Mix &out) const {
		add_sine(out, carrier_, course_, run);
		out.level += std::abs(course_.after_run(run));
	}
	/// The same where nothing else is heard, of any number of runs.
	void write(float *frames, std::size_t channels, std::size_t run, std::size_t runs) const {
		write_sine(frames, channels, carrier_, course_, run, runs);
	}

	/// Whether it is to be made.
	[[nodiscard]] bool sounds(bool wanted) const { return wanted || !level_.is_silent(); }
	[[nodiscard]] bool is_on() const { return is_on_; }
	/// In the stretch.
	[[nodiscard]] bool is_heard() const { return is_on_ && !course_.is_zero(); }
	/// A voice changes its channels in silence only.
	[[nodiscard]] bool may_be(std::uint8_t channels) const {
		return channels == channels_ || level_.is_silent();
	}
	void set_channels(std::uint8_t channels) { channels_ = channels; }
	[[nodiscard]] std::uint8_t channels() const { return channels_; }

private:
	Carrier carrier_;
	std::uint64_t carrier_run_ = 0; ///< whose first sample has the carrier's phase
	LevelFollower level_;
	Level course_;                  ///< over the stretch
	LevelPoint from_, to_;          ///< wanted at the stretch's ends
	LevelPoint followed_;           ///< wanted at the end of the last one
	std::uint64_t followed_to_ = 0; ///< number of the run after it
	bool is_on_ = false;
	std::uint8_t channels_ = Effect::LEFT | Effect::RIGHT;
	double frequency_hz_ = 0.0;
	double sample_rate_hz_ = 0.0;

	void turn_to(std::uint64_t run);
};

/// An effect that begins with an arrival, on its own sample, with the phase 0.
class ArrivalVoice {
public:
	/// first: the sample of the next run that it begins with.
	void start(const Effect &effect, std::uint64_t generation, const Arrival &arrival, std::int32_t first,
			const MotionPoint &motion, const Stretch &stretch);
	/// As of SustainedVoice.
	[[nodiscard]] bool look_at(const Stretch &stretch);
	void begin(const Stretch &stretch);
	void cut(double share) {
		if (has_level_) {
			level_.cut(share);
		}
	}
	/// Adds the run `run` of the stretch; in turn, each once.
	void add_run(const Stretch &stretch, std::size_t run, Mix &out);

	[[nodiscard]] bool is_active() const { return is_active_; }
	[[nodiscard]] std::uint8_t channels() const { return effect_.channels; }
	/// Of the tables that it may read.
	[[nodiscard]] std::uint64_t generation() const { return generation_; }

private:
	bool is_active_ = false;
	bool has_level_ = false;
	Effect effect_;
	std::uint64_t generation_ = 0;
	Carrier carrier_;
	std::uint64_t carrier_run_ = 0; ///< whose first sample has the carrier's phase
	LevelFollower level_;
	LevelPoint from_, to_; ///< wanted at the stretch's ends
	Level course_;         ///< over the stretch
	double peak_ = 0.0;
	std::int64_t next_ = 0; ///< number of the next run's first sample; negative before the first
	std::int64_t length_ = 0;
	Window window_;
	Run decay_{};
	double decayed_ = 1.0; ///< at the next run's first sample
	double decay_over_run_ = 1.0;

	void add_level(Mix &out, std::size_t run) const;
	/// The most that it is at the end of the run and of the next one: what is to come is made room for.
	[[nodiscard]] float window_after_run() const {
		const auto end = static_cast<float>(next_ + static_cast<std::int64_t>(RUN));
		return std::max(window_.at(end), window_.at(end + static_cast<float>(RUN)));
	}
	void fill_from_table(const Stretch &stretch, std::size_t run, Run &values) const;
};

} // namespace steadyhand
