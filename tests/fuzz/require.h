#pragma once

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace steadyhand::fuzz {

/// Ends the process where a property does not hold: libFuzzer keeps the input.
inline void require(bool holds, std::string_view property) {
	if (!holds) {
		std::fprintf(stderr, "PROPERTY FAILS: %.*s\n", static_cast<int>(property.size()), property.data());
		std::abort();
	}
}

} // namespace steadyhand::fuzz
