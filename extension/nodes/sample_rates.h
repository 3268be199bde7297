#pragma once

#include "node_label.h"

#include "haptics/vibration.h"

#include <godot_cpp/variant/string.hpp>

namespace godot {

// Sample rates of a Vibration, for properties and methods in whole Hz.

inline constexpr int LOWEST_RATE_HZ = static_cast<int>(steadyhand::Vibration::LOWEST_RATE_HZ);
inline constexpr int HIGHEST_RATE_HZ = static_cast<int>(steadyhand::Vibration::HIGHEST_RATE_HZ);

constexpr bool is_sample_rate(int p_rate_hz) {
	return p_rate_hz >= LOWEST_RATE_HZ && p_rate_hz <= HIGHEST_RATE_HZ;
}

/// Range of a property in the inspector.
inline String sample_rate_hint() {
	return itos(LOWEST_RATE_HZ) + String(",") + itos(HIGHEST_RATE_HZ) + String(",1,suffix:Hz");
}

/// Message if `p_where` refuses `p_rate_hz` for `p_what`.
inline String sample_rate_fault(const String &p_where, const char *p_what, int p_rate_hz) {
	return refusal(p_where,
			String(p_what) + String(" must be ") + itos(LOWEST_RATE_HZ) + String("..") +
					itos(HIGHEST_RATE_HZ) + String(" Hz"),
			p_rate_hz);
}

} // namespace godot
