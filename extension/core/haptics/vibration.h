#pragma once

#include "haptics/arrival_voices.h"
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
	/// A start is never predicted: it is known a frame of the game after it was recognised, and is felt after
	/// the latency of the output.
	static constexpr double LATEST_START_S = 0.2;
	/// Live motion that is not heard of for so long, by the samples made, is over: it fades out. Where
	/// samples are made for longer than that at a time, so that nothing can be heard of in between, for half
	/// as long again as twice in a row, up to the limit, which holds until it has been heard of twice.
	static constexpr double PATIENCE_S = 0.1, MOST_PATIENCE_S = 1.0;
	/// An amplitude is made of cubics; they differ from it by no more than this, wherever a cubic over a
	/// single run is as near.
	static constexpr double MOST_REMAINDER = 2.5e-7;

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
	[[nodiscard]] double time_s() const {
		return clock_.now_s() + stretch_.pace * run_s_ * static_cast<double>(made_);
	}
	/// Samples made and not yet handed out.
	[[nodiscard]] std::size_t ahead() const { return RUN - handed_out_; }
	[[nodiscard]] std::uint64_t oldest_generation() const {
		return arrivals_.oldest_generation(effects_.generation);
	}

private:
	double sample_rate_hz_ = 48000.0;
	double run_s_ = 0.0;
	std::size_t channels_;
	EffectSet effects_;
	bool effects_follow_ = false;
	bool acceleration_follows_ = false; ///< an effect that goes on does
	/// The greatest amplitude of an effect by position and by velocity, for each unit and m/s.
	double by_position_ = 0.0, by_velocity_s_m_ = 0.0;
	MotionCurve motion_;
	MotionClock clock_; ///< at the stretch's begin
	bool is_live_ = false;
	double unheard_s_ = 0.0;              ///< from the last snapshot to the stretch's begin
	double last_gap_s_ = MOST_PATIENCE_S; ///< so long was unheard of before the last one
	double patience_s_ = MOST_PATIENCE_S;
	std::uint32_t arrived_ = 0; ///< number of the last one that was felt, or let pass
	std::uint32_t begun_ = 0;   ///< the same of starts
	std::size_t in_use_ = 0;    ///< of the sustained voices: those that may sound
	std::array<SustainedVoice, EffectSet::MOST> sustained_;
	ArrivalVoices arrivals_;

	Stretch stretch_;
	std::size_t made_ = 0;          ///< runs of the stretch
	std::uint64_t rough_until_ = 0; ///< run up to which a longer stretch is not tried again
	bool is_silent_ = true;
	bool is_only_voice_ = false; ///< nothing else is heard, and it alike on all channels
	std::size_t only_voice_ = 0;
	bool is_connected_ = false; ///< at the stretch's end effects and motion go on as they are
	bool follows_ = false;      ///< a voice follows the motion, or may

	/// What effects together are held to: the greatest amplitude that one of them may have; until silence
	/// also of those before them, which may still fade.
	float most_ = 1.0F;

	float left_gain_ = 1.0F, right_gain_ = 1.0F; ///< at the end of the last run; of a single channel the left
	/// The sides with all that is heard there, where one has sounds of its own; otherwise both_ alone.
	Mix both_, left_, right_;
	std::array<float, 2 * RUN> rest_{}; ///< a run that is handed out in parts
	std::size_t handed_out_ = RUN;      ///< of it

	void begin_stretch();
	void end_stretch();
	[[nodiscard]] std::size_t longest_stretch(double from_s) const;
	[[nodiscard]] std::size_t shorter_stretch(double from_s);
	[[nodiscard]] bool is_cubic(double from_s);
	void set_length(std::size_t runs, double from_s);
	[[nodiscard]] bool look_at_voices(bool is_heard, bool is_moving);
	void begin_voices();
	void begin_arrivals(double from_s);
	void begin_cues(Trigger trigger, const Arrival &arrival, double from_s, double length_s);
	void make(float *frames, std::size_t runs);
	void make_run(float *frames);
	[[nodiscard]] Ramp next_gain(float &r_gain, float level) const;
	Mix &mix_of(std::uint8_t channels);
};

} // namespace steadyhand
