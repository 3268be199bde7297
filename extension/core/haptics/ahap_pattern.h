#pragma once

#include "haptics/haptic_clip.h"

#include <vector>

namespace steadyhand {

/// A pattern of Core Haptics: events, and controls that change all of them.
struct AhapPattern {
	struct Event {
		double time_s = 0.0;
		double duration_s = 0.0; ///< of a continuous one
		bool is_transient = false;
		double intensity = 1.0, sharpness = 0.5;
		double attack_s = 0.0, decay_s = 0.0, release_s = 0.0;
		bool is_sustained = true;

		/// Until when it is felt.
		[[nodiscard]] double end_s() const;
		/// 0..1, its rise and fall, so long after its start.
		[[nodiscard]] double envelope(double since_s) const;
	};
	/// A parameter, or a curve of it, from its time on until the next one.
	struct Control {
		double time_s = 0.0;
		std::vector<Breakpoint> points; ///< times from the control's own on
	};

	std::vector<Event> events;
	std::vector<Control> intensity, sharpness; ///< a factor; a summand

	/// The pattern as a clip, its envelopes within 0.005 of the pattern's.
	[[nodiscard]] HapticClip clip() const;
};

} // namespace steadyhand
