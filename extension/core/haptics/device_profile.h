#pragma once

#include "haptics/effect.h"

#include <span>
#include <vector>

namespace steadyhand {

/// What an actuator makes of a drive signal, so that an effect can be driven to feel alike on each.
struct DeviceProfile {
	/// Response to a full drive at a frequency, relative to any reference.
	struct Point {
		double frequency_hz = 0.0, response = 0.0;
	};

	std::vector<Point> response; ///< by frequency, rising; none: the same everywhere
	double resonance_hz = 0.0;   ///< of a device that moves at its resonance only (LRA); 0: of a voice coil
	double most = 1.0;           ///< amplitude that it bears, 0..1
	double latency_s = 0.0;      ///< from a sample to the skin
};

/// The response at a frequency, in straight lines over the logarithm of the frequency, held beyond the ends;
/// 1 where there is none.
[[nodiscard]] double response_at(std::span<const DeviceProfile::Point> response, double frequency_hz);

/// The effect as the device has to be driven: its carrier at the resonance where the device has one only; the
/// gain raised where the response is weaker than at its best, by at most 4 (12 dB); the amplitude held to
/// what it bears.
[[nodiscard]] Effect adapted(const Effect &effect, const DeviceProfile &device);

} // namespace steadyhand
