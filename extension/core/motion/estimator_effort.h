#pragma once

#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// Number of hypotheses in `phase` mode. More hypotheses cost more time and estimate better.
struct EstimatorEffort {
	static constexpr std::size_t MOST_HYPOTHESES = 48, MOST_DURATIONS = 7;

	std::size_t hypotheses = 24; ///< most GESTURE hypotheses at a time; 2..MOST_HYPOTHESES
	std::size_t durations = 7;   ///< different durations of new hypotheses; 3..MOST_DURATIONS
};

/// Compromises between cost and accuracy. docs/results.md has the measurements.
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
