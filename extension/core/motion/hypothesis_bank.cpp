#include "motion/hypothesis_bank.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

/// Log weights against the best of the same kind, and of all.
constexpr double NEGLIGIBLE = -10.0;
constexpr double NEGLIGIBLE_TO_ALL = -40.0;

bool likelier(const GestureHypothesis &a, const GestureHypothesis &b) {
	return a.log_weight > b.log_weight;
}

double greatest(std::span<const GestureHypothesis> hypotheses) {
	double best = -std::numeric_limits<double>::infinity();
	for (const GestureHypothesis &h : hypotheses) {
		best = std::max(best, h.log_weight);
	}
	return best;
}

double total(std::span<const GestureHypothesis> hypotheses) {
	double sum = 0.0;
	for (const GestureHypothesis &h : hypotheses) {
		sum += std::exp(h.log_weight);
	}
	return sum;
}

} // namespace

HypothesisBank::Kind HypothesisBank::kind(const GestureHypothesis &hypothesis) {
	if (hypothesis.regime() == Regime::UNSOUND) {
		return ERRING;
	}
	return hypothesis.regime() == Regime::FREE && hypothesis.on_its_way() ? WANDERING : USUAL;
}

void HypothesisBank::start(const GestureHypothesis &at_rest) {
	hypotheses_[0] = at_rest;
	count_ = 1;
}

GestureHypothesis &HypothesisBank::add(const GestureHypothesis &hypothesis) {
	GestureHypothesis &added = hypotheses_[count_++];
	added = hypothesis;
	return added;
}

void HypothesisBank::prune(double unsound_at_least, double free_at_least) {
	const double best = greatest(all());
	for (GestureHypothesis &h : all()) {
		h.log_weight -= best;
	}
	const auto begin = hypotheses_.begin() + 1;
	const auto end = hypotheses_.begin() + static_cast<std::ptrdiff_t>(count_);
	const auto erring = std::partition(begin, end, [](const auto &h) { return kind(h) == USUAL; });
	const auto wandering = std::partition(erring, end, [](const auto &h) { return kind(h) == ERRING; });
	const std::array bounds{ begin, erring, wandering, end };

	const std::array<double, KINDS> share{ 0.0, unsound_at_least, free_at_least };
	double usual = 0.0;
	auto kept = begin;
	for (std::size_t k = 0; k < KINDS; ++k) {
		const auto moved = std::move(bounds[k], bounds[k + 1], kept);
		kept += static_cast<std::ptrdiff_t>(keep_likely({ kept, moved }, MOST_KEPT[k], share[k] * usual));
		usual = k == USUAL ? total({ begin, kept }) : usual;
	}
	count_ = static_cast<std::size_t>(kept - hypotheses_.begin());
}

/// Brings those that stay to the front; returns how many they are.
std::size_t HypothesisBank::keep_likely(
		std::span<GestureHypothesis> r_hypotheses, std::size_t most, double at_least) {
	const double bound = std::max(greatest(r_hypotheses) + NEGLIGIBLE, NEGLIGIBLE_TO_ALL);
	const auto likely_end = std::partition(r_hypotheses.begin(), r_hypotheses.end(),
			[bound](const GestureHypothesis &h) { return h.log_weight > bound; });
	auto count = static_cast<std::size_t>(likely_end - r_hypotheses.begin());
	if (count > most) {
		std::nth_element(r_hypotheses.begin(), r_hypotheses.begin() + static_cast<std::ptrdiff_t>(most),
				likely_end, likelier);
		count = most;
	}
	const double sum = total(r_hypotheses.first(count));
	if (sum > 0.0 && sum < at_least) {
		for (GestureHypothesis &h : r_hypotheses.first(count)) {
			h.log_weight += std::log(at_least / sum);
		}
	}
	return count;
}

} // namespace steadyhand
