#pragma once

#include "motion/gesture_hypothesis.h"
#include "motion/phase_effort.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>

namespace steadyhand {

/// The hypotheses that are weighed against each other; the first one is at rest and always stays, with weight
/// 0 once it is given up. Allocates nothing, and moves none of them: what is sorted are their places.
class HypothesisBank {
public:
	/// Between two calls of prune.
	static constexpr std::size_t MOST_ADDED = 64;
	static constexpr std::size_t MOST_AFTER_PRUNE =
			1 + PhaseEffort::MOST_USUAL + PhaseEffort::MOST_ERRING + PhaseEffort::MOST_WANDERING;

	explicit HypothesisBank(const PhaseEffort &effort = {}) :
			most_kept_{ effort.usual, effort.erring, effort.wandering } {}

	/// Only the one at rest.
	void start(const GestureHypothesis &at_rest);
	GestureHypothesis &add(const GestureHypothesis &hypothesis);
	/// Drops the unlikely, and scales weights so that the greatest is 1. unsound_at_least, free_at_least:
	/// shares that the regimes UNSOUND and FREE keep against the others that are on their way, as long as
	/// there are any: a tracker may begin to err, a hand to do something else, at any time.
	void prune(double unsound_at_least, double free_at_least);
	/// One that the hand began or turned to, of this log weight, would be dropped by the next prune, if it
	/// were now.
	[[nodiscard]] bool is_hopeless(Regime regime, double log_weight) const {
		return log_weight <= least_[regime == Regime::UNSOUND ? ERRING : USUAL];
	}

	[[nodiscard]] bool empty() const { return count_ == 0; }
	[[nodiscard]] GestureHypothesis &at_rest() { return hypotheses_[0]; }
	[[nodiscard]] auto all() {
		return places() |
				std::views::transform([this](Place i) -> GestureHypothesis & { return hypotheses_[i]; });
	}
	[[nodiscard]] auto all() const {
		return places() | std::views::transform([this](Place i) -> const GestureHypothesis & {
			return hypotheses_[i];
		});
	}
	/// Those that may still be right.
	[[nodiscard]] auto weighed() { return all() | std::views::drop(at_rest().weight > 0.0 ? 0 : 1); }
	/// All but the one at rest.
	[[nodiscard]] auto others() { return all() | std::views::drop(1); }
	[[nodiscard]] auto others() const { return all() | std::views::drop(1); }

private:
	enum Kind : std::size_t { USUAL, ERRING, WANDERING, KINDS };
	static constexpr std::size_t CAPACITY = MOST_AFTER_PRUNE + MOST_ADDED;
	using Place = std::uint8_t;

	std::array<std::size_t, KINDS> most_kept_;
	std::array<GestureHypothesis, CAPACITY> hypotheses_{};
	std::array<Place, CAPACITY> order_{}; ///< the first count_ are in use
	std::size_t count_ = 0;
	std::array<double, KINDS> least_{}; ///< log weight below which the last prune dropped

	[[nodiscard]] std::span<const Place> places() const { return { order_.data(), count_ }; }
	static Kind kind(const GestureHypothesis &hypothesis);
	[[nodiscard]] double greatest(std::span<const Place> places) const;
	[[nodiscard]] double total(std::span<const Place> places) const;
	std::size_t keep_likely(std::span<Place> r_places, Kind kind, double at_least);
};

} // namespace steadyhand
