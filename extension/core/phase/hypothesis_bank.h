#pragma once

#include "phase/hypothesis_group.h"
#include "phase/phase_effort.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace steadyhand {

/// The hypotheses that are weighed against each other, by their places 0..size() - 1, which a prune changes.
/// The first one is at rest and always stays, with weight 0 once it is given up. Allocates nothing.
class HypothesisBank {
public:
	/// Between two calls of prune.
	static constexpr std::size_t MOST_ADDED = 80;
	/// Whose tracker slides back: of a hand at rest, and of one on its way, sound or unsound; or up to the
	/// hand, of the latter two.
	static constexpr std::size_t MOST_SLIDING_BACK = 5;
	/// Whose hand stands.
	static constexpr std::size_t MOST_STANDING = 2;
	/// Whose tracker shakes about a hand at rest.
	static constexpr std::size_t MOST_SHAKING = 2;
	static constexpr std::size_t MOST_AFTER_PRUNE = 1 + PhaseEffort::MOST_USUAL + PhaseEffort::MOST_ERRING +
			PhaseEffort::MOST_WANDERING + MOST_SLIDING_BACK + MOST_STANDING + MOST_SHAKING;
	static constexpr std::size_t AT_REST = 0; ///< its place
	static constexpr std::size_t GROUPS = (MOST_AFTER_PRUNE + MOST_ADDED + LANES - 1) / LANES;
	static constexpr std::size_t CAPACITY = GROUPS * LANES;

	explicit HypothesisBank(const PhaseEffort &effort = {}) :
			most_kept_{ effort.usual, effort.erring, effort.wandering, MOST_SLIDING_BACK, MOST_STANDING,
				MOST_SHAKING } {}

	void clear() { count_ = 0; }
	/// Only the one at rest.
	void start(const GestureHypothesis &at_rest);
	/// log_probability: that it came about so, given the one that it is made from.
	void add(GestureHypothesis hypothesis, double log_probability = 0.0) {
		hypothesis.log_weight += log_probability;
		set(count_++, hypothesis);
	}
	void set(std::size_t place, const GestureHypothesis &hypothesis);
	[[nodiscard]] GestureHypothesis hypothesis(std::size_t place) const;
	void swap(std::size_t a, std::size_t b);

	/// As HypothesisGroup's, all of them.
	void predict(const ElementCurve &curve, double t_s, const Passages &passages);
	void absorb(const ElementCurve &curve, double t_s, double x, const HypothesisGroup::Trust &trust);

	/// Drops the unlikely, and scales weights so that the greatest is 1. A tracker may begin to err, a hand
	/// to do something else, at any time: as long as there are any that are not over, the regime UNSOUND
	/// keeps at least a share of the weight of those that are neither at rest nor in it or FREE on their way,
	/// FREE of these and of UNSOUND. t_s: of the hypotheses.
	void prune(double t_s, double unsound_at_least, double free_at_least);
	/// One that the hand began or turned to, of this log weight, would be dropped by the next prune, if it
	/// were now.
	[[nodiscard]] bool is_hopeless(Regime regime, double log_weight) const {
		return log_weight <= least_[regime == Regime::UNSOUND ? ERRING : USUAL];
	}

	[[nodiscard]] bool empty() const { return count_ == 0; }
	[[nodiscard]] std::size_t size() const { return count_; }
	[[nodiscard]] double log_weight(std::size_t place) const {
		return log_weights_[place / LANES][place % LANES];
	}
	[[nodiscard]] double greatest_log_weight() const;
	void weigh(std::size_t place, double log_factor) {
		log_weights_[place / LANES][place % LANES] += log_factor;
	}
	/// exp(log_weight) when it was set, or at the last prune.
	[[nodiscard]] double weight(std::size_t place) const { return weights_[place / LANES][place % LANES]; }
	[[nodiscard]] Regime regime(std::size_t place) const { return group(place).regime(place % LANES); }
	[[nodiscard]] TrackerError error(std::size_t place) const { return group(place).error(place % LANES); }
	[[nodiscard]] bool on_its_way(std::size_t place) const { return group(place).on_its_way(place % LANES); }
	/// The gesture has come to its end a while ago.
	[[nodiscard]] bool is_over(std::size_t place, double t_s) const {
		return on_its_way(place) && course(place).phase(t_s) > SPENT_PHASE;
	}
	/// GestureHypothesis::standing
	[[nodiscard]] bool is_standing(std::size_t place) const {
		return regime(place) == Regime::UNSOUND && error(place) == TrackerError::SLIGHT;
	}
	[[nodiscard]] HypothesisGroup::Course course(std::size_t place) const {
		return group(place).course(place % LANES);
	}
	[[nodiscard]] double hand_deviation(std::size_t place) const {
		return group(place).hand_deviation(place % LANES);
	}
	[[nodiscard]] double hand_deviation_rate(std::size_t place) const {
		return group(place).hand_deviation_rate(place % LANES);
	}

private:
	enum Kind : std::size_t { USUAL, ERRING, WANDERING, SLIDING_BACK, STANDING, SHAKING, KINDS };
	static constexpr double SPENT_PHASE = 1.3;
	using Place = std::uint8_t;
	using Marks = std::array<bool, CAPACITY>;

	std::array<std::size_t, KINDS> most_kept_;
	std::array<HypothesisGroup, GROUPS> groups_{};
	std::array<Lanes, GROUPS> log_weights_{}, weights_{};
	std::size_t count_ = 0;
	std::array<double, KINDS> least_{}; ///< log weight that the next prune will drop

	[[nodiscard]] const HypothesisGroup &group(std::size_t place) const { return groups_[place / LANES]; }
	[[nodiscard]] std::size_t groups_in_use() const { return (count_ + LANES - 1) / LANES; }
	[[nodiscard]] Kind kind(std::size_t place) const;
	void scale();
	[[nodiscard]] double total(std::span<const Place> places) const;
	[[nodiscard]] std::size_t likeliest(std::span<Place> r_places, std::size_t most) const;
	std::size_t drop_spent(std::span<Place> r_places, const Marks &over, std::size_t most) const;
	std::size_t keep_likely(std::span<Place> r_places, Kind kind, const Marks &over);
	void raise(std::span<const Place> places, double at_least);
	void keep_only(std::span<const Place> places);
};

} // namespace steadyhand
