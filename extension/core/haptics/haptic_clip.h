#pragma once

#include "haptics/breakpoints.h"
#include "haptics/effect.h"

#include <string>
#include <vector>

namespace steadyhand {

/// Which frequencies a clip's 0 and 1 stand for. The files do not say: each device has its own. The defaults
/// are those of Meta's renderer for Quest controllers (meta-haptics-sdk, resources/acf/MetaQuest.acf).
struct FrequencyRange {
	double lowest_hz = 55.0, highest_hz = 200.0;

	[[nodiscard]] double hz(double normalised) const {
		return lowest_hz + normalised * (highest_hz - lowest_hz);
	}
	/// Held to 0..1; 0.5 where the range is a single frequency.
	[[nodiscard]] double normalised(double frequency_hz) const;
};

/// A click at a time, beside the vibration that goes on.
struct Transient {
	double time_s = 0.0;
	double amplitude = 1.0; ///< 0..1
	double frequency = 0.5; ///< 0 dull, 1 sharp
};

/// How a gesture plays a clip; not a part of the formats, but kept in their metadata.
struct ClipPlayback {
	Trigger trigger = Trigger::ARRIVAL;
	Drive drive = Drive::CONSTANT;
	double gain = 1.0;
	double full_scale = 1.0;
	int channels = Effect::LEFT | Effect::RIGHT;
	FrequencyRange range;
};

/// A vibration that was designed or recorded: what a `.haptic` or `.ahap` file holds.
struct HapticClip {
	/// Longer ones are refused: their samples would take more than 12 MB.
	static constexpr double LONGEST_S = 60.0;

	std::vector<Breakpoint> amplitude; ///< 0..1; silence before the first and after the last
	std::vector<Breakpoint> frequency; ///< normalised, 0..1; 0.5 where there is none
	std::vector<Transient> transients; ///< in the order of their times
	ClipPlayback playback;
	std::string author, project, source, description;
	std::vector<std::string> tags;

	[[nodiscard]] double duration_s() const;
	[[nodiscard]] double amplitude_at(double time_s) const;
	/// Normalised.
	[[nodiscard]] double frequency_at(double time_s) const;
};

/// The length of a click: two periods of its frequency, 55 to 165 Hz (MetaQuest.acf: 36.4 to 12.1 ms).
[[nodiscard]] double transient_hz(const Transient &transient);
[[nodiscard]] double transient_s(const Transient &transient);

/// The clip as samples, -1..1, from a phase of 0 at its start to silence at its end. A click is a sine, which
/// makes no step, and halves what goes on while it lasts (MetaQuest.acf).
[[nodiscard]] std::vector<float> waveform_of(const HapticClip &clip, double sample_rate_hz);

/// Its frequency where most of it is: the mean, weighted by the amplitude; Hz.
[[nodiscard]] double main_frequency_hz(const HapticClip &clip);

} // namespace steadyhand
