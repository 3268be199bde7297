#pragma once

#include "haptics/level_follower.h"
#include "haptics/run.h"

namespace steadyhand {

/// What a voice needs to know of a run.
struct RunContext {
	double sample_rate_hz = 48000.0;
	double run_s = 0.0;
	std::uint64_t number = 0; ///< of the run
	MotionPoint from, to;     ///< the motion at its first sample, and at the one after its last
	bool is_connected =
			false; ///< effects and motion at its first sample are those that the last run ended with
	double amplitude_m = 0.0;
};

/// An effect that goes on: a sine whose amplitude follows the motion.
class SustainedVoice {
public:
	/// Adds the run to `out` of the voice's channels. wanted: false lets it fade out.
	void add_run(const Effect &effect, bool wanted, const RunContext &context, Mix &out);

	/// Whether it needs a run to be made for it.
	[[nodiscard]] bool sounds(bool wanted) const { return wanted || !level_.is_silent(); }
	/// A voice changes its channels in silence only.
	[[nodiscard]] bool may_be(std::uint8_t channels) const {
		return channels == channels_ || level_.is_silent();
	}
	void set_channels(std::uint8_t channels) { channels_ = channels; }
	[[nodiscard]] std::uint8_t channels() const { return channels_; }

private:
	Carrier carrier_;
	std::uint64_t next_run_ = 0; ///< whose first sample has the carrier's phase
	LevelFollower level_;
	LevelPoint wanted_; ///< at the end of the last run
	std::uint8_t channels_ = Effect::LEFT | Effect::RIGHT;
	double frequency_hz_ = 0.0;
	double sample_rate_hz_ = 0.0;
};

/// An effect that begins with an arrival, on its own sample, with the phase 0.
class ArrivalVoice {
public:
	/// first: the sample of the next run that it begins with.
	void start(const Effect &effect, std::uint64_t generation, const Arrival &arrival, std::int32_t first,
			const MotionPoint &motion, const RunContext &context);
	void add_run(const RunContext &context, Mix &out);

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
	LevelFollower level_;
	double peak_ = 0.0;
	std::int64_t next_ = 0; ///< number of the next run's first sample; negative before the first
	std::int64_t length_ = 0;
	Window window_;
	Run decay_{};
	double decayed_ = 1.0; ///< at the next run's first sample
	double decay_over_run_ = 1.0;

	void add_level(Mix &out, const Level &level) const;
	void fill_from_table(const RunContext &context, Run &values) const;
};

} // namespace steadyhand
