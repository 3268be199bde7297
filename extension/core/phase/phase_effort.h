#pragma once

#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// How much `phase` mode computes: its cost is that of its hypotheses, so many of each kind
/// (hypothesis_bank.h) beside the one at rest, and of how often and how densely new ones are begun.
struct PhaseEffort {
	static constexpr std::size_t MOST_USUAL = 20, MOST_ERRING = 16, MOST_WANDERING = 4, MOST_DURATIONS = 7;

	std::size_t usual = MOST_USUAL;         ///< hand and tracker as they should be; 1..MOST_USUAL
	std::size_t erring = MOST_ERRING;       ///< the tracker errs; 1..MOST_ERRING
	std::size_t wandering = MOST_WANDERING; ///< the hand does something else; 1..MOST_WANDERING
	std::size_t durations = MOST_DURATIONS; ///< of which new ones are begun; 2..MOST_DURATIONS
	double branch_period_s = 0.03;          ///< between one beginning and the next
};

/// Points of the measured front of cost against accuracy (docs/evidence.md).
enum class Quality : std::uint8_t { FAST, BALANCED, ACCURATE };
[[nodiscard]] constexpr PhaseEffort phase_effort(Quality quality) {
	switch (quality) {
		case Quality::FAST:
			return { 2, 1, 1, 3, 0.06 };
		case Quality::BALANCED:
			return { 5, 4, 1, 7, 0.03 };
		case Quality::ACCURATE:
			break;
	}
	return {};
}

} // namespace steadyhand
