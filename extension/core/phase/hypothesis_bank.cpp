#include "phase/hypothesis_bank.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

/// Log weights against the best of the same kind, and of all.
constexpr double NEGLIGIBLE = -10.0;
constexpr double NEGLIGIBLE_TO_ALL = -40.0;
/// Those that are over hold the same of what is to come.
constexpr std::array<std::size_t, 6> MOST_SPENT{ 4, 3, 2, 3, HypothesisBank::MOST_STANDING,
	HypothesisBank::MOST_SHAKING };

} // namespace

HypothesisBank::Kind HypothesisBank::kind(std::size_t place) const {
	if (error(place) == TrackerError::SLIDING_BACK) {
		return SLIDING_BACK;
	}
	if (error(place) == TrackerError::SHAKING) {
		return SHAKING;
	}
	if (is_standing(place)) {
		return STANDING;
	}
	if (regime(place) == Regime::UNSOUND) {
		return ERRING;
	}
	return regime(place) == Regime::FREE && on_its_way(place) ? WANDERING : USUAL;
}

/// Of those that make the gesture: a hand at rest may be held several times, and one on no way makes none.
double HypothesisBank::total(std::span<const Place> places) const {
	double sum = 0.0;
	for (const Place i : places) {
		sum += on_its_way(i) ? weight(i) : 0.0;
	}
	return sum;
}

void HypothesisBank::start(const GestureHypothesis &at_rest) {
	count_ = 0;
	add(at_rest);
	weights_[0][AT_REST] = 1.0;
	least_.fill(NEGLIGIBLE_TO_ALL);
}

void HypothesisBank::set(std::size_t place, const GestureHypothesis &hypothesis) {
	groups_[place / LANES].set(place % LANES, hypothesis);
	log_weights_[place / LANES][place % LANES] = hypothesis.log_weight;
	weights_[place / LANES][place % LANES] = std::exp(hypothesis.log_weight);
}

GestureHypothesis HypothesisBank::hypothesis(std::size_t place) const {
	GestureHypothesis h = group(place).hypothesis(place % LANES);
	h.log_weight = log_weight(place);
	return h;
}

void HypothesisBank::swap(std::size_t a, std::size_t b) {
	const GestureHypothesis at_a = hypothesis(a);
	set(a, hypothesis(b));
	set(b, at_a);
}

void HypothesisBank::predict(const ElementCurve &curve, double t_s, const Passages &passages) {
	for (std::size_t g = 0; g < groups_in_use(); ++g) {
		groups_[g].predict(curve, t_s, passages);
	}
}

void HypothesisBank::absorb(
		const ElementCurve &curve, double t_s, double x, const HypothesisGroup::Trust &trust) {
	for (std::size_t g = 0; g < groups_in_use(); ++g) {
		groups_[g].absorb(curve, t_s, x, trust, log_weights_[g]);
	}
}

double HypothesisBank::greatest_log_weight() const {
	double greatest = -std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < count_; ++i) {
		greatest = std::max(greatest, log_weight(i));
	}
	return greatest;
}

/// The greatest weight becomes 1.
STEADYHAND_WIDE void HypothesisBank::scale() {
	const double best = greatest_log_weight();
	for (std::size_t g = 0; g < groups_in_use(); ++g) {
		const LaneVector scaled = load(log_weights_[g]) - best;
		store(log_weights_[g], scaled);
		store(weights_[g], exponential(scaled));
	}
	if (log_weight(AT_REST) < NEGLIGIBLE_TO_ALL) {
		log_weights_[0][AT_REST] = -std::numeric_limits<double>::infinity();
		weights_[0][AT_REST] = 0.0;
	}
}

void HypothesisBank::prune(double t_s, double unsound_at_least, double free_at_least) {
	scale();
	Marks over;
	for (std::size_t g = 0; g < groups_in_use(); ++g) {
		groups_[g].mark_beyond(t_s, SPENT_PHASE, std::span<bool, LANES>(over.data() + g * LANES, LANES));
	}
	std::array<std::array<Place, CAPACITY>, KINDS> places;
	std::array<std::size_t, KINDS> counts{};
	for (std::size_t i = AT_REST + 1; i < count_; ++i) {
		const Kind k = kind(i);
		places[k][counts[k]++] = static_cast<Place>(i);
	}
	std::array<double, KINDS> share{};
	share[ERRING] = unsound_at_least;
	share[WANDERING] = free_at_least;
	double others = 0.0;
	std::array<Place, CAPACITY> kept;
	std::size_t kept_count = 0;
	for (const Kind k : { USUAL, ERRING, WANDERING, SLIDING_BACK, STANDING, SHAKING }) {
		const std::span of_kind(places[k].data(), counts[k]);
		const auto likely = of_kind.first(keep_likely(of_kind, k, over));
		const auto spent = std::partition(likely.begin(), likely.end(), [&](Place i) { return !over[i]; });
		raise({ likely.begin(), spent }, share[k] * others);
		if (likely.size() == most_kept_[k]) { // one more drops the unlikeliest
			least_[k] = INFINITY;
			for (const Place i : likely) {
				least_[k] = std::min(least_[k], log_weight(i));
			}
		}
		others += k == USUAL || k == ERRING ? total(likely) : 0.0;
		std::copy(likely.begin(), likely.end(), kept.begin() + static_cast<std::ptrdiff_t>(kept_count));
		kept_count += likely.size();
	}
	keep_only({ kept.data(), kept_count });
}

/// Brings them to the front; returns how many there are, at most as many as are asked for.
std::size_t HypothesisBank::likeliest(std::span<Place> r_places, std::size_t most) const {
	if (r_places.size() > most) {
		std::nth_element(r_places.begin(), r_places.begin() + static_cast<std::ptrdiff_t>(most),
				r_places.end(), [this](Place a, Place b) { return log_weight(a) > log_weight(b); });
	}
	return std::min(r_places.size(), most);
}

/// Brings the others, and the likeliest of those that are over, to the front; returns how many they are.
std::size_t HypothesisBank::drop_spent(std::span<Place> r_places, const Marks &over, std::size_t most) const {
	if (r_places.size() <= most) {
		return r_places.size();
	}
	const auto spent = std::partition(r_places.begin(), r_places.end(), [&](Place i) { return !over[i]; });
	const auto others = static_cast<std::size_t>(spent - r_places.begin());
	return others + likeliest(r_places.subspan(others), most);
}

/// Brings those that stay to the front; returns how many they are.
std::size_t HypothesisBank::keep_likely(std::span<Place> r_places, Kind kind, const Marks &over) {
	double greatest = -std::numeric_limits<double>::infinity();
	for (const Place i : r_places) {
		greatest = std::max(greatest, log_weight(i));
	}
	const double bound = std::max(greatest + NEGLIGIBLE, NEGLIGIBLE_TO_ALL);
	least_[kind] = bound;
	const auto likely_end = std::partition(
			r_places.begin(), r_places.end(), [this, bound](Place i) { return log_weight(i) > bound; });
	const auto likely = r_places.first(static_cast<std::size_t>(likely_end - r_places.begin()));
	return likeliest(likely.first(drop_spent(likely, over, MOST_SPENT[kind])), most_kept_[kind]);
}

/// To that weight together, where there are any and they have less.
void HypothesisBank::raise(std::span<const Place> places, double at_least) {
	const double sum = total(places);
	if (sum > 0.0 && sum < at_least) {
		const double factor = at_least / sum, log_factor = std::log(factor);
		for (const Place i : places) {
			log_weights_[i / LANES][i % LANES] += log_factor;
			weights_[i / LANES][i % LANES] *= factor;
		}
	}
}

/// And the one at rest; the last ones move to where others were dropped.
void HypothesisBank::keep_only(std::span<const Place> places) {
	const std::size_t left = 1 + places.size();
	if (left == count_) {
		return;
	}
	std::array<bool, CAPACITY> is_kept{};
	for (const Place i : places) {
		is_kept[i] = true;
	}
	std::size_t hole = AT_REST + 1;
	for (std::size_t i = left; i < count_; ++i) {
		if (is_kept[i]) {
			while (is_kept[hole]) {
				++hole;
			}
			groups_[hole / LANES].copy(hole % LANES, group(i), i % LANES);
			log_weights_[hole / LANES][hole % LANES] = log_weight(i);
			weights_[hole / LANES][hole % LANES] = weight(i);
			++hole;
		}
	}
	count_ = left;
}

} // namespace steadyhand
