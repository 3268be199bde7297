#pragma once

#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// How much `phase` mode computes.
struct EstimatorEffort {
	static constexpr std::size_t MOST_HYPOTHESES = 48, MOST_DURATIONS = 7;

	std::size_t hypotheses = 24; ///< of a gesture that has begun; 2..MOST_HYPOTHESES
	std::size_t durations = 7;   ///< of which new ones are begun; 3..MOST_DURATIONS
};

/// Points of the measured front of cost against accuracy (docs/results.md).
enum class Quality : std::uint8_t { FAST, BALANCED, ACCURATE };
[[nodiscard]] constexpr EstimatorEffort estimator_effort(Quality quality) {
	switch (quality) {
		case Quality::FAST:
			return { 4, 3 };
		case Quality::BALANCED:
			return { 10, 7 };
		case Quality::ACCURATE:
			break;
	}
	return {};
}

} // namespace steadyhand
