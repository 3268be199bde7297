#include "metrics/tracker_alignment.h"

#include "metrics/lag_search.h"
#include "metrics/rigid_fit.h"
#include "tracking/frame.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand {

namespace {

using Alignment = TrackerAlignment::Alignment;

constexpr double LEAST_INSTANTS = TrackerAlignment::LEAST_OVERLAP_S * ALIGNMENT_GRID_HZ;

/// Each sample of the slower tracker, with the faster one's interpolated between two samples near in time.
Pairs measured_pairs(
		std::span<const TrackSample> reference, std::span<const TrackSample> other, double lag_s) {
	const bool is_reference_faster = reference.size() > other.size();
	const std::span<const TrackSample> slow = is_reference_faster ? other : reference;
	const std::span<const TrackSample> fast = is_reference_faster ? reference : other;
	const double fast_from_slow_s = is_reference_faster ? -lag_s : lag_s;
	PairList list(slow.size());
	std::size_t next = 1;
	for (const TrackSample &sample : slow) {
		const double t_s = sample.t_s + fast_from_slow_s;
		while (next < fast.size() && fast[next].t_s < t_s) {
			++next;
		}
		if (next >= fast.size() || fast[next - 1].t_s > t_s) {
			continue;
		}
		const TrackSample &before = fast[next - 1], &after = fast[next];
		const double gap_s = after.t_s - before.t_s;
		if (gap_s > LONGEST_SAMPLE_GAP_S) {
			continue;
		}
		const double share = (t_s - before.t_s) / gap_s;
		const Eigen::Vector3d between_m = (1.0 - share) * before.position_m + share * after.position_m;
		if (is_reference_faster) {
			list.add(between_m, sample.position_m);
		} else {
			list.add(sample.position_m, between_m);
		}
	}
	return list.take();
}

/// Of positions along their three main directions, the widest first: that of a uniform distribution with
/// the same deviation.
Eigen::Vector3d spread_m(const Eigen::Matrix3Xd &positions_m) {
	if (positions_m.cols() == 0) {
		return Eigen::Vector3d::Zero();
	}
	const Eigen::Vector3d mean_m = positions_m.rowwise().mean();
	const Eigen::Matrix3Xd centred_m = positions_m.colwise() - mean_m;
	const Eigen::Matrix3d covariance =
			centred_m * centred_m.transpose() / static_cast<double>(positions_m.cols());
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
	return (12.0 * solver.eigenvalues().cwiseMax(0.0)).cwiseSqrt().reverse();
}

std::string one_decimal(double value) {
	const std::string tenths = std::to_string(std::llround(10.0 * std::min(value, 1e9)));
	const std::string padded = tenths.size() < 2 ? "0" + tenths : tenths;
	return padded.substr(0, padded.size() - 1) + "." + padded.back();
}

/// Empty where the movement determines a rotation.
std::string movement_fault(const std::string &tracker, const Eigen::Matrix3Xd &positions_m) {
	const Eigen::Vector3d spread = spread_m(positions_m);
	if (spread[0] < TrackerAlignment::LEAST_SPREAD_M) {
		return "the hand moved over only " + one_decimal(100.0 * spread[0]) + " cm for " + tracker +
				"; move it over at least 10 cm, better 30 cm, in all directions";
	}
	if (spread[1] < TrackerAlignment::LEAST_FLATNESS * spread[0]) {
		return "the hand moved along one line only for " + tracker +
				", which leaves the rotation about that line open; move it in all directions";
	}
	return {};
}

Error overlap_error(double overlap_s) {
	return { "both trackers followed the hand together for only " + one_decimal(overlap_s) +
		" s; at least 5 s are needed, at 20 or more samples a second: keep the hand in view of both, and "
		"move "
		"it for 10 s" };
}

std::vector<TrackSample> samples_within(
		const Ring<TrackSample, TrackerAlignment::CAPACITY> &samples, double from_s, double to_s) {
	std::vector<TrackSample> within;
	for (std::size_t i = 0; i < samples.size(); ++i) {
		if (samples[i].t_s >= from_s && samples[i].t_s <= to_s) {
			within.push_back(samples[i]);
		}
	}
	return within;
}

} // namespace

TrackerAlignment::TrackerAlignment() : tracks_(std::make_unique<Tracks>()) {}

bool TrackerAlignment::push(Track &track, double t_s, const Eigen::Vector3d &position_m) {
	// A time that is not a number is not within.
	if (!(std::abs(t_s) <= FARTHEST_S) || !is_place(position_m)) {
		return false;
	}
	if (!track.samples.empty()) {
		const double gap_s = t_s - track.samples.newest().t_s;
		if (!(gap_s > 0.0)) {
			return false;
		}
		track.followed_s += gap_s <= LONGEST_SAMPLE_GAP_S ? gap_s : 0.0;
	}
	track.samples.push({ t_s, position_m });
	return true;
}

bool TrackerAlignment::push_reference(double t_s, const Eigen::Vector3d &position_m) {
	return push(tracks_->reference, t_s, position_m);
}

bool TrackerAlignment::push_other(double t_s, const Eigen::Vector3d &position_m) {
	return push(tracks_->other, t_s, position_m);
}

void TrackerAlignment::clear() {
	for (Track *track : { &tracks_->reference, &tracks_->other }) {
		track->samples.clear();
		track->followed_s = 0.0;
	}
}

double TrackerAlignment::followed_s() const {
	return std::min(tracks_->reference.followed_s, tracks_->other.followed_s);
}

Result<Alignment> TrackerAlignment::align() const {
	const auto &all_reference = tracks_->reference.samples;
	const auto &all_other = tracks_->other.samples;
	if (all_reference.empty() || all_other.empty()) {
		return Error{ std::string("no samples of the ") +
			(all_reference.empty() ? "reference" : "other tracker") +
			"; check that it runs and sees the joint" };
	}
	const double end_s = std::min(all_reference.newest().t_s, all_other.newest().t_s) + LARGEST_LAG_S;
	const double start_s = std::max(
			{ all_reference[0].t_s - LARGEST_LAG_S, all_other[0].t_s - LARGEST_LAG_S, end_s - LONGEST_S });
	if (end_s - start_s < LEAST_OVERLAP_S) {
		return overlap_error(std::max(end_s - start_s - 2.0 * LARGEST_LAG_S, 0.0));
	}
	const std::vector<TrackSample> reference = without_jumps(samples_within(all_reference, start_s, end_s));
	const std::vector<TrackSample> other = without_jumps(samples_within(all_other, start_s, end_s));
	const UniformGrid grid{ start_s, ALIGNMENT_GRID_HZ };
	const auto count = static_cast<std::size_t>((end_s - start_s) * ALIGNMENT_GRID_HZ) + 1;
	const SmoothedPair tracks{ smoothed(reference, grid, count), smoothed(other, grid, count) };

	const Pairs at_once = tracks.pairs(0.0);
	if (static_cast<double>(at_once.size()) < LEAST_INSTANTS) {
		return overlap_error(static_cast<double>(at_once.size()) / ALIGNMENT_GRID_HZ);
	}
	for (const std::string &fault : { movement_fault("the reference", at_once.reference_m),
				 movement_fault("the other tracker", at_once.other_m) }) {
		if (!fault.empty()) {
			return Error{ fault };
		}
	}
	const double coarse_s = coarse_lag_s(tracks);
	if (std::isnan(coarse_s)) {
		return Error{ "no lag within 0.5 s at which both trackers show the same speeds; check that both "
					  "follow the same joint of the same hand, and move it faster and slower by turns" };
	}
	Alignment result;
	result.lag_s = refined_lag_s(tracks, coarse_s);
	result.overlap_s = static_cast<double>(tracks.pairs(result.lag_s).size()) / ALIGNMENT_GRID_HZ;
	const Pairs measured = measured_pairs(reference, other, result.lag_s);
	if (result.overlap_s < LEAST_OVERLAP_S || measured.size() == 0) {
		return overlap_error(result.overlap_s);
	}
	const Pairs pairs = without_outliers(measured);
	if (const std::string fault = movement_fault("the reference", pairs.reference_m); !fault.empty()) {
		return Error{ fault };
	}
	const RigidFit last = rigid_fit(pairs);
	const Eigen::VectorXd residuals_m = last.residuals_m(pairs);
	result.rotation = last.rotation;
	result.translation_m = last.translation_m;
	result.residual_rms_m = rms(residuals_m);
	result.residual_max_m = residuals_m.maxCoeff();
	result.samples = static_cast<std::size_t>(pairs.size());
	if (!(result.residual_rms_m < LARGEST_RESIDUAL * spread_m(pairs.reference_m)[0])) {
		return Error{ "the trackers still differ by " + one_decimal(100.0 * result.residual_rms_m) +
			" cm after the best alignment; check that both follow the same joint, in metres, with axes that "
			"are not mirrored" };
	}
	return result;
}

} // namespace steadyhand
