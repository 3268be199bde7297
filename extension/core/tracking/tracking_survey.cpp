#include "tracking/tracking_survey.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace steadyhand {

namespace {

constexpr double AWAY_S = 10.0;
/// Least time at a candidate, s: within POOL_M, and in its own cell.
constexpr double LEAST_POOLED_S = 2.0;
constexpr double LEAST_OWN_S = 0.3;
/// Added to the variance of the lost time, which may be 0: half a fault of 0.25 s (Jeffreys' prior of a
/// Poisson rate).
constexpr double UNSEEN_S2 = 0.5 * 0.25 * 0.25;

/// Hash table load of at most one half: searches are short and end at an empty slot.
constexpr std::size_t SLOTS_PER_CELL = 2;

/// Standard deviation of the difference in lost share between two places with equal fault rates: each second
/// adds the same variance at both.
double deviation_if_alike(const TrackingSurvey::Place &one, const TrackingSurvey::Place &other) {
	const double squares_s2 = one.lost_variance * one.seconds * one.seconds +
			other.lost_variance * other.seconds * other.seconds;
	return std::sqrt(squares_s2 / (one.seconds * other.seconds));
}

} // namespace

TrackingSurvey::TrackingSurvey() : cells_(MOST_CELLS), slots_(SLOTS_PER_CELL * MOST_CELLS) {}

void TrackingSurvey::push(double t_s, const Eigen::Vector3d &position_m) {
	const Measurement measurement = monitor_.push(t_s, position_m.cwiseMax(-FURTHEST_M).cwiseMin(FURTHEST_M));
	const double dt_s = t_s - newest_s_.value_or(t_s);
	const double watched_s = dt_s <= AWAY_S ? std::max(dt_s, 0.0) : 0.0;
	newest_s_ = t_s;
	duration_s_ += watched_s;
	// A fault counts in the cell of the last usable reading.
	if (last_ != NO_CELL) {
		Cell &cell = cells_[last_];
		cell.seconds += watched_s;
		if (measurement.gap_s > 0.0 && measurement.gap_s <= AWAY_S) {
			const double lost_s = std::max(measurement.gap_s - monitor_.period_s(), 0.0);
			cell.lost_s += lost_s;
			cell.squares_s2 += lost_s * lost_s;
		}
	}
	if (!measurement.is_usable()) {
		return;
	}
	last_ = cell_at(position_m);
	if (last_ != NO_CELL) {
		Cell &cell = cells_[last_];
		cell.readings += 1.0;
		cell.noise_sum_m += measurement.noise_m;
		cell.position_sum_m += position_m;
	}
}

std::size_t TrackingSurvey::cell_at(const Eigen::Vector3d &position_m) {
	if (position_m.cwiseAbs().maxCoeff() > FURTHEST_M) {
		return NO_CELL;
	}
	const Eigen::Vector3i number = (position_m / CELL_M).array().floor().cast<int>();
	if (last_ != NO_CELL && cells_[last_].number == number) {
		return last_;
	}
	std::uint64_t hash = 0;
	for (const int along : number) {
		hash = mix_bits(hash ^ static_cast<std::uint64_t>(along));
	}
	std::size_t slot = hash % slots_.size();
	while (slots_[slot] != 0) {
		const std::size_t index = slots_[slot] - std::size_t{ 1 };
		if (cells_[index].number == number) {
			return index;
		}
		slot = (slot + 1) % slots_.size();
	}
	if (visited_ == MOST_CELLS) {
		return NO_CELL;
	}
	cells_[visited_].number = number;
	slots_[slot] = static_cast<std::uint16_t>(visited_ + 1);
	return visited_++;
}

template <class Predicate> TrackingSurvey::Place TrackingSurvey::pooled(Predicate is_wanted) const {
	Cell sum;
	for (const Cell &cell : visited()) {
		if (is_wanted(Eigen::Vector3d(cell.position_sum_m / cell.readings))) {
			sum.position_sum_m += cell.position_sum_m;
			sum.seconds += cell.seconds;
			sum.noise_sum_m += cell.noise_sum_m;
			sum.lost_s += cell.lost_s;
			sum.squares_s2 += cell.squares_s2;
			sum.readings += cell.readings;
		}
	}
	Place place;
	place.position_m = sum.position_sum_m / sum.readings;
	place.noise_m = sum.noise_sum_m / sum.readings;
	place.seconds = sum.seconds;
	place.lost_share = sum.lost_s / place.seconds;
	// The variance of a sum with a Poisson number of terms is the sum of their squares.
	place.lost_variance = (sum.squares_s2 + UNSEEN_S2) / (place.seconds * place.seconds);
	return place;
}

std::vector<TrackingSurvey::Place> TrackingSurvey::candidates() const {
	std::vector<Place> found;
	for (const Cell &cell : visited()) {
		if (cell.seconds < LEAST_OWN_S) {
			continue;
		}
		const Eigen::Vector3d middle_m = cell.position_sum_m / cell.readings;
		Place place =
				pooled([&](const Eigen::Vector3d &other_m) { return (other_m - middle_m).norm() <= POOL_M; });
		place.position_m = middle_m;
		if (place.seconds >= LEAST_POOLED_S) {
			found.push_back(place);
		}
	}
	return found;
}

Result<TrackingSurvey::Proposal> TrackingSurvey::propose() const {
	if (duration_s_ < LEAST_S) {
		return Error{ "the practice run was too short: move the hand through the space for 20 s at least" };
	}
	const std::vector<Place> places = candidates();
	std::optional<Proposal> best;
	double best_difference = 0.0; // minus one standard deviation, against places with few readings
	for (const Place &stable : places) {
		for (const Place &unstable : places) {
			const double difference = unstable.error() - stable.error();
			const double deviation = std::sqrt(stable.lost_variance + unstable.lost_variance);
			if ((stable.position_m - unstable.position_m).norm() >= APART_M &&
					(!best || difference - deviation > best_difference)) {
				best = Proposal{ stable, unstable };
				best_difference = difference - deviation;
			}
		}
	}
	if (!best) {
		return Error{ "the hand stayed in one place: move it through all the space within its reach" };
	}
	const Eigen::Vector3d way_m = best->unstable.position_m - best->stable.position_m;
	const double halfway = way_m.dot(best->stable.position_m) + 0.5 * way_m.squaredNorm();
	const Place near = pooled([&](const Eigen::Vector3d &place_m) { return way_m.dot(place_m) < halfway; });
	const Place far = pooled([&](const Eigen::Vector3d &place_m) { return way_m.dot(place_m) >= halfway; });
	if (far.lost_share > 0.0) {
		best->contrast = (far.error() - near.error()) / deviation_if_alike(near, far);
	}
	return *best;
}

} // namespace steadyhand
