#pragma once

#include "haptics/effect.h"
#include "haptics/motion_clock.h"
#include "haptics/motion_snapshot.h"
#include "haptics/voice.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace steadyhand {

/// Makes a motion's vibration sample by sample. The amplitude is the motion's own at each of them; an arrival
/// is felt from its own sample on, as soon as a snapshot tells of it, and may be taken back until it has
/// begun. Whatever changes (motion, effects, frequency, sample rate), no step from a sample to the next
/// exceeds by more than 2 % what the effects' own waveforms make.
///
/// Samples are made in runs of RUN samples from the first one on and handed out in whatever blocks are asked
/// for, which therefore changes none of them. What is set takes effect with the next run.
///
/// For the audio thread: nothing is allocated, locked or asked of the system.
class Vibration {
public:
	static constexpr double LOWEST_RATE_HZ = 8000.0, HIGHEST_RATE_HZ = 192000.0;
	/// An arrival that is noticed later than this is let pass: up to here hardly anyone feels that a cue is
	/// late (Di Luca & Mahnan 2019, World Haptics Conference).
	static constexpr double LATEST_S = 0.05;
	/// Live motion that is not heard of for so long is over: it fades out.
	static constexpr double PATIENCE_S = 0.1;

	/// Of one channel that has all effects, or of two. A rate beyond the limits is held to them, no number
	/// taken for 48 kHz.
	Vibration(double sample_rate_hz, int channels);

	void set_sample_rate(double sample_rate_hz);
	/// The effects' tables must outlive the last run of oldest_generation() <= effects.generation.
	void set_effects(const EffectSet &effects);
	/// A snapshot whose times are no numbers counts as one without motion.
	void set_motion(const MotionSnapshot &motion);

	/// From the next run on at this time of the motion's, then on the samples' own clock.
	void seek(double time_s);
	/// The motion is live and by now at this time: see MotionClock.
	void follow(double time_s);

	/// The next samples, -1..1, the channels interleaved.
	void render(std::span<float> frames);

	[[nodiscard]] double sample_rate_hz() const { return sample_rate_hz_; }
	/// Of the motion, at the next run.
	[[nodiscard]] double time_s() const { return clock_.now_s(); }
	/// Samples made and not yet handed out.
	[[nodiscard]] std::size_t ahead() const { return RUN - handed_out_; }
	[[nodiscard]] std::uint64_t oldest_generation() const;

private:
	double sample_rate_hz_ = 48000.0;
	double run_s_ = 0.0;
	std::size_t channels_;
	EffectSet effects_;
	MotionCurve motion_;
	MotionClock clock_;
	bool is_live_ = false;
	double unheard_s_ = 0.0;    ///< since the last live snapshot
	std::uint32_t arrived_ = 0; ///< number of the last one that was felt, or let pass
	std::uint64_t run_ = 0;     ///< number of the next one
	std::size_t in_use_ = 0;    ///< of the sustained voices: those that may sound
	std::size_t active_ = 0;    ///< of the arrivals' voices
	std::array<SustainedVoice, EffectSet::MOST> sustained_;
	std::array<ArrivalVoice, EffectSet::MOST> arrivals_;
	/// The sides with all that is heard there, where one has sounds of its own; otherwise both_ alone.
	Mix both_, left_, right_;
	std::size_t handed_out_ = RUN; ///< of the run
	bool effects_follow_ = false;
	bool follows_ = false;      ///< a voice follows the motion, or may
	bool is_connected_ = false; ///< end_ is the motion at the next run's start, and effects are the same
	MotionPoint end_;

	void make_run();
	void add_sustained(const RunContext &context, double from_s, bool is_heard);
	void begin_arrivals(const RunContext &context, double from_s, double to_s);
	void arrive(const Arrival &arrival, const RunContext &context, double from_s, double to_s);
	Mix &mix_of(std::uint8_t channels);
};

} // namespace steadyhand
