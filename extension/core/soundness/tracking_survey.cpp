#include "soundness/tracking_survey.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace steadyhand {

namespace {

constexpr double ONE_FAULT_S = 0.25;
constexpr double AWAY_S = 10.0;
/// Of a candidate: near it, and in its own cell.
constexpr double LEAST_POOLED_S = 2.0;
constexpr double LEAST_OWN_S = 0.3;
/// In the variance of a count that may be 0 (Jeffreys' prior of a Poisson rate).
constexpr double UNSEEN_FAULTS = 0.5;

/// So that a search ends after few steps, and at an empty one.
constexpr std::size_t SLOTS_PER_CELL = 2;

/// Of the difference of two places' unsoundness, as that of two Poisson rates.
double deviation_of_difference(const TrackingSurvey::Place &one, const TrackingSurvey::Place &other) {
	double variance = 0.0;
	for (const TrackingSurvey::Place *place : { &one, &other }) {
		variance +=
				(place->faults_per_s * place->seconds + UNSEEN_FAULTS) / (place->seconds * place->seconds);
	}
	return std::sqrt(variance);
}

} // namespace

TrackingSurvey::TrackingSurvey() : cells_(MOST_CELLS), slots_(SLOTS_PER_CELL * MOST_CELLS) {}

void TrackingSurvey::push(double t_s, const Eigen::Vector3d &position_m) {
	bool fault = false;
	bool frozen = false;
	double jitter = 0.0;
	for (Eigen::Index axis = 0; axis < 3; ++axis) {
		TrackingSoundness &soundness = axes_[static_cast<std::size_t>(axis)];
		soundness.push(t_s, std::clamp(position_m[axis], -FURTHEST_M, FURTHEST_M) / AMPLITUDE_M);
		fault = fault || soundness.fault() > 0.0 || soundness.jumped();
		frozen = frozen || soundness.frozen();
		jitter = std::max(jitter, soundness.jitter());
	}
	double dt_s = begun_ ? std::max(t_s - t_s_, 0.0) : 0.0;
	dt_s = dt_s > AWAY_S ? 0.0 : dt_s;
	duration_s_ += dt_s;
	begun_ = true;
	t_s_ = t_s;
	const double count = faults(dt_s, frozen, fault);
	// What goes wrong does so where the hand was last seen.
	if (last_ != NO_CELL) {
		cells_[last_].seconds += dt_s;
		cells_[last_].faults += count;
	}
	last_ = cell_at(position_m);
	if (last_ != NO_CELL) {
		cells_[last_].frames += 1.0;
		cells_[last_].jitter_m += jitter * AMPLITUDE_M;
		cells_[last_].position_m += position_m;
	}
}

double TrackingSurvey::faults(double dt_s, bool frozen, bool fault) {
	const bool is_new = fault && t_s_ - fault_s_ > ONE_FAULT_S;
	fault_s_ = fault ? t_s_ : fault_s_;
	if (!frozen && dt_s <= ONE_FAULT_S) {
		lost_s_ = 0.0;
		return is_new ? 1.0 : 0.0;
	}
	lost_s_ += dt_s;
	const double more = std::floor(lost_s_ / ONE_FAULT_S);
	lost_s_ -= more * ONE_FAULT_S;
	return std::max(more, is_new ? 1.0 : 0.0);
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

template <class Wanted> TrackingSurvey::Place TrackingSurvey::gathered(Wanted wanted) const {
	Place place;
	double faults = 0.0;
	double frames = 0.0;
	for (const Cell &cell : visited()) {
		if (wanted(Eigen::Vector3d(cell.position_m / cell.frames))) {
			place.position_m += cell.position_m;
			place.seconds += cell.seconds;
			place.jitter_m += cell.jitter_m;
			faults += cell.faults;
			frames += cell.frames;
		}
	}
	place.position_m /= frames;
	place.jitter_m /= frames;
	place.faults_per_s = place.seconds > 0.0 ? faults / place.seconds : 0.0;
	return place;
}

std::vector<TrackingSurvey::Place> TrackingSurvey::candidates() const {
	std::vector<Place> found;
	for (const Cell &cell : visited()) {
		if (cell.seconds < LEAST_OWN_S) {
			continue;
		}
		const Eigen::Vector3d middle_m = cell.position_m / cell.frames;
		Place place = gathered(
				[&](const Eigen::Vector3d &other_m) { return (other_m - middle_m).norm() <= POOL_M; });
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
	double best_difference = 0.0; // one deviation less than seen: a place that was hardly visited is no find
	for (const Place &stable : places) {
		for (const Place &unstable : places) {
			const double difference = unstable.unsoundness() - stable.unsoundness();
			const double deviation = deviation_of_difference(stable, unstable);
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
	const Place near = gathered([&](const Eigen::Vector3d &place_m) { return way_m.dot(place_m) < halfway; });
	const Place far = gathered([&](const Eigen::Vector3d &place_m) { return way_m.dot(place_m) >= halfway; });
	const bool has_faults = far.faults_per_s > 0.0;
	best->contrast =
			has_faults ? (far.unsoundness() - near.unsoundness()) / deviation_of_difference(near, far) : 0.0;
	return *best;
}

} // namespace steadyhand
