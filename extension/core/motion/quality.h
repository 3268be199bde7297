#pragma once

#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// Compromises between cost and accuracy of `phase` mode. docs/cost.md has the measurements.
enum class Quality : std::uint8_t { FAST, BALANCED, ACCURATE };

/// Most GESTURE hypotheses at a time, 2..MOST_HYPOTHESES. More cost more time and estimate better.
inline constexpr std::size_t MOST_HYPOTHESES = 48;
[[nodiscard]] constexpr std::size_t hypotheses_of(Quality quality) {
	switch (quality) {
		case Quality::FAST:
			return 4;
		case Quality::BALANCED:
			return 12;
		case Quality::ACCURATE:
			break;
	}
	return 24;
}

/// GestureHMM has the same default.
inline constexpr Quality DEFAULT_QUALITY = Quality::BALANCED;
inline constexpr std::size_t DEFAULT_HYPOTHESES = hypotheses_of(DEFAULT_QUALITY);

} // namespace steadyhand
