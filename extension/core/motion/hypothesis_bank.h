#pragma once

#include "motion/gesture_hypothesis.h"

#include <array>
#include <cstddef>
#include <span>

namespace steadyhand {

/// The hypotheses that are weighed against each other; the first one is at rest and always stays. Allocates
/// nothing.
class HypothesisBank {
public:
	/// Between two calls of prune.
	static constexpr std::size_t MOST_ADDED = 32;

	/// Only the one at rest.
	void start(const GestureHypothesis &at_rest);
	GestureHypothesis &add(const GestureHypothesis &hypothesis);
	/// Drops the unlikely, and scales weights so that the greatest is 1. unsound_at_least, free_at_least:
	/// shares that the regimes UNSOUND and FREE keep against the others that are on their way, as long as
	/// there are any: a tracker may begin to err, a hand to do something else, at any time.
	void prune(double unsound_at_least, double free_at_least);

	[[nodiscard]] bool empty() const { return count_ == 0; }
	[[nodiscard]] GestureHypothesis &at_rest() { return hypotheses_[0]; }
	[[nodiscard]] std::span<GestureHypothesis> all() { return { hypotheses_.data(), count_ }; }
	[[nodiscard]] std::span<const GestureHypothesis> all() const { return { hypotheses_.data(), count_ }; }

private:
	enum Kind : std::size_t { USUAL, ERRING, WANDERING, KINDS };
	static constexpr std::array<std::size_t, KINDS> MOST_KEPT{ 20, 16, 4 };
	static constexpr std::size_t CAPACITY = 1 + 20 + 16 + 4 + MOST_ADDED;

	std::array<GestureHypothesis, CAPACITY> hypotheses_{};
	std::size_t count_ = 0;

	static Kind kind(const GestureHypothesis &hypothesis);
	static std::size_t keep_likely(
			std::span<GestureHypothesis> r_hypotheses, std::size_t most, double at_least);
};

} // namespace steadyhand
