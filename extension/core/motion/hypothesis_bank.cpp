#include "motion/hypothesis_bank.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace steadyhand {
namespace {

/// Log weights against the best of the same kind, and of all.
constexpr double NEGLIGIBLE = -10.0;
constexpr double NEGLIGIBLE_TO_ALL = -40.0;

} // namespace

HypothesisBank::Kind HypothesisBank::kind(const GestureHypothesis &hypothesis) {
	if (hypothesis.regime() == Regime::UNSOUND) {
		return ERRING;
	}
	return hypothesis.regime() == Regime::FREE && hypothesis.on_its_way() ? WANDERING : USUAL;
}

double HypothesisBank::greatest(std::span<const Place> places) const {
	double best = -std::numeric_limits<double>::infinity();
	for (const Place i : places) {
		best = std::max(best, hypotheses_[i].log_weight);
	}
	return best;
}

double HypothesisBank::total(std::span<const Place> places) const {
	double sum = 0.0;
	for (const Place i : places) {
		sum += hypotheses_[i].weight;
	}
	return sum;
}

void HypothesisBank::start(const GestureHypothesis &at_rest) {
	std::iota(order_.begin(), order_.end(), Place{ 0 });
	hypotheses_[0] = at_rest;
	count_ = 1;
	least_.fill(NEGLIGIBLE_TO_ALL);
}

GestureHypothesis &HypothesisBank::add(const GestureHypothesis &hypothesis) {
	GestureHypothesis &added = hypotheses_[order_[count_++]];
	added = hypothesis;
	return added;
}

void HypothesisBank::prune(double unsound_at_least, double free_at_least) {
	const double best = greatest(places());
	for (GestureHypothesis &h : all()) {
		h.log_weight -= best;
		h.weight = std::exp(h.log_weight);
	}
	if (at_rest().log_weight < NEGLIGIBLE_TO_ALL) {
		at_rest().log_weight = -std::numeric_limits<double>::infinity();
	}
	const auto begin = order_.begin() + 1;
	const auto end = order_.begin() + static_cast<std::ptrdiff_t>(count_);
	const auto is = [this](Kind wanted) {
		return [this, wanted](Place i) { return kind(hypotheses_[i]) == wanted; };
	};
	const auto erring = std::partition(begin, end, is(USUAL));
	const auto wandering = std::partition(erring, end, is(ERRING));
	const std::array bounds{ begin, erring, wandering, end };

	const std::array<double, KINDS> share{ 0.0, unsound_at_least, free_at_least };
	double usual = 0.0;
	auto kept = begin;
	for (const Kind k : { USUAL, ERRING, WANDERING }) {
		const auto count = keep_likely({ bounds[k], bounds[k + 1] }, k, share[k] * usual);
		kept = std::rotate(kept, bounds[k], bounds[k] + static_cast<std::ptrdiff_t>(count));
		usual = k == USUAL ? total({ begin, kept }) : usual;
	}
	count_ = static_cast<std::size_t>(kept - order_.begin());
}

/// Brings those that stay to the front; returns how many they are.
std::size_t HypothesisBank::keep_likely(std::span<Place> r_places, Kind kind, double at_least) {
	const double bound = std::max(greatest(r_places) + NEGLIGIBLE, NEGLIGIBLE_TO_ALL);
	least_[kind] = bound;
	const auto likely_end = std::partition(r_places.begin(), r_places.end(),
			[this, bound](Place i) { return hypotheses_[i].log_weight > bound; });
	auto count = static_cast<std::size_t>(likely_end - r_places.begin());
	if (count > most_kept_[kind]) {
		count = most_kept_[kind];
		std::nth_element(r_places.begin(), r_places.begin() + static_cast<std::ptrdiff_t>(count), likely_end,
				[this](Place a, Place b) { return hypotheses_[a].log_weight > hypotheses_[b].log_weight; });
	}
	const double sum = total(r_places.first(count));
	if (sum > 0.0 && sum < at_least) {
		const double factor = at_least / sum;
		for (const Place i : r_places.first(count)) {
			hypotheses_[i].log_weight += std::log(factor);
			hypotheses_[i].weight *= factor;
		}
	}
	return count;
}

} // namespace steadyhand
