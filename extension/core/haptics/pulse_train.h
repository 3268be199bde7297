#pragma once

#include "haptics/effect.h"
#include "haptics/live_vibration.h"

#include <cstdint>
#include <optional>

namespace steadyhand {

/// What a motor is told: so strong, for so long, unless it is told otherwise before.
struct Pulse {
	double amplitude = 0.0;    ///< 0..1
	double low = 0.0;          ///< of that, as Strength has it
	double frequency_hz = 0.0; ///< of the strongest effect
	double duration_s = 0.0;
};

/// The vibration of a live motion for outputs that take a strength now and then: a controller's haptics, a
/// joypad's motors. A pulse has the greatest amplitude since the one before, so that a short impulse is not
/// lost between two of them.
class PulseTrain {
public:
	/// Between two pulses at least. Each of them replaces the last one, and goes over a radio link as a
	/// packet of its own; motors take longer than that to follow (docs/haptics.md).
	static constexpr double PERIOD_S = 0.02;
	/// A motor of which the game tells no more (it stands still, or has crashed) stops by itself.
	static constexpr double DURATION_S = 0.1;

	/// Once a frame; the pulse that is due, if one is. An arrival or a start does not wait for its turn.
	/// Silence is told once: by an amplitude of 0.
	[[nodiscard]] std::optional<Pulse> next(const EffectSet &effects, const LiveMotion &motion);
	/// Time starts anew. Whether a pulse is under way that should be stopped.
	bool restart();

private:
	bool is_set_ = false;
	bool sounds_ = false;
	double now_s_ = 0.0;  ///< known up to here
	double told_s_ = 0.0; ///< time of the last pulse
	Strength greatest_;   ///< since then
	std::uint32_t arrived_ = 0, begun_ = 0;

	void listen(const EffectSet &effects, const MotionSnapshot &motion, const Arrival &arrival, double t_s);
};

} // namespace steadyhand
