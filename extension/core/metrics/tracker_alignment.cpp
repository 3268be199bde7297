#include "metrics/tracker_alignment.h"

#include "tracking/frame.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand {

namespace {

using Alignment = TrackerAlignment::Alignment;

/// Of the smoothed tracks. Hands move at up to about 4 Hz.
constexpr double GRID_HZ = 100.0;
constexpr int LARGEST_SHIFT = static_cast<int>(TrackerAlignment::LARGEST_LAG_S * GRID_HZ);
constexpr double LEAST_INSTANTS = TrackerAlignment::LEAST_OVERLAP_S * GRID_HZ;
/// Higher speeds are cut off at it: they come from jumps that last longer than the window.
constexpr double SPEED_QUANTILE = 0.9;
/// Peaks lower by less than this are compared by their residuals: steady waving has several peaks.
constexpr double RIVAL_PEAK = 0.2;
/// Around the peak of the correlation, which is good to some ms.
constexpr double REFINED_WITHIN_S = 0.02;
constexpr double LAG_TOLERANCE_S = 2e-5;
/// Residuals beyond this many medians are outliers: of normal noise 1 in 10000.
constexpr double OUTLIER_MEDIANS = 3.0;
/// No residual below it is an outlier: trackers are not that exact.
constexpr double NO_OUTLIER_M = 0.001;
/// Each fit finds the outliers that the next one leaves out. Jumps disturb the first two.
constexpr int FITS = 3;

/// Positions of both trackers at the same moments of the movement, one a column.
struct Pairs {
	Eigen::Matrix3Xd reference_m, other_m;

	[[nodiscard]] Eigen::Index size() const { return reference_m.cols(); }
};

class PairList {
public:
	explicit PairList(std::size_t most) :
			pairs_{ Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(most)),
				Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(most)) } {}

	void add(const Eigen::Vector3d &reference_m, const Eigen::Vector3d &other_m) {
		pairs_.reference_m.col(size_) = reference_m;
		pairs_.other_m.col(size_) = other_m;
		++size_;
	}
	[[nodiscard]] Pairs take() {
		pairs_.reference_m.conservativeResize(3, size_);
		pairs_.other_m.conservativeResize(3, size_);
		return std::move(pairs_);
	}

private:
	Pairs pairs_;
	Eigen::Index size_ = 0;
};

struct Fit {
	Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
	Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();

	[[nodiscard]] Eigen::VectorXd residuals_m(const Pairs &pairs) const {
		return ((rotation * pairs.other_m).colwise() + translation_m - pairs.reference_m)
				.colwise()
				.norm()
				.transpose();
	}
};

Fit fit(const Pairs &pairs) {
	const Eigen::Matrix4d transform = Eigen::umeyama(pairs.other_m, pairs.reference_m, false);
	return { transform.topLeftCorner<3, 3>(), transform.topRightCorner<3, 1>() };
}

double rms(const Eigen::VectorXd &values) {
	return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(values.size(), 1)));
}

/// Without the pairs that a fit of the rest leaves far apart.
Pairs without_outliers(const Pairs &all) {
	Pairs kept = all;
	for (int i = 0; i < FITS; ++i) {
		const Eigen::VectorXd residuals_m = fit(kept).residuals_m(all);
		std::vector<double> sorted_m(residuals_m.begin(), residuals_m.end());
		const auto middle = sorted_m.begin() + static_cast<std::ptrdiff_t>(sorted_m.size() / 2);
		std::nth_element(sorted_m.begin(), middle, sorted_m.end());
		const double limit_m = std::max(OUTLIER_MEDIANS * *middle, NO_OUTLIER_M);
		PairList list(static_cast<std::size_t>(all.size()));
		for (Eigen::Index column = 0; column < all.size(); ++column) {
			if (residuals_m[column] <= limit_m) {
				list.add(all.reference_m.col(column), all.other_m.col(column));
			}
		}
		kept = list.take();
	}
	return kept;
}

/// Both smoothed tracks on one grid.
struct SmoothedPair {
	SmoothedTrack reference, other;

	[[nodiscard]] std::size_t size() const { return reference.known.size(); }

	/// At lag_s, at most LARGEST_LAG_S.
	[[nodiscard]] Pairs pairs(double lag_s) const {
		const double shift = lag_s * GRID_HZ;
		const double whole = std::floor(shift);
		const double share = shift - whole;
		PairList list(size());
		for (std::size_t i = 0; i < size(); ++i) {
			const auto before = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) +
					static_cast<std::ptrdiff_t>(whole)); // wraps around below 0, which is not known
			if (reference.is_known(i) && other.is_known(before) && other.is_known(before + 1)) {
				list.add(reference.positions_m[i],
						(1.0 - share) * other.positions_m[before] + share * other.positions_m[before + 1]);
			}
		}
		return list.take();
	}
};

/// Cut off at SPEED_QUANTILE.
std::vector<double> limited_speeds(const SmoothedTrack &track) {
	std::vector<double> known;
	for (std::size_t i = 0; i < track.known.size(); ++i) {
		if (track.is_known(i)) {
			known.push_back(track.speeds_m_s[i]);
		}
	}
	const auto place =
			known.begin() + static_cast<std::ptrdiff_t>(SPEED_QUANTILE * static_cast<double>(known.size()));
	std::nth_element(known.begin(), place, known.end());
	std::vector<double> limited = track.speeds_m_s;
	for (double &speed : limited) {
		speed = std::min(speed, *place);
	}
	return limited;
}

/// Pearson's correlation of both speeds for each shift of -LARGEST_SHIFT..LARGEST_SHIFT, where both are
/// known.
std::vector<double> correlations(const SmoothedPair &tracks) {
	const std::vector<double> reference = limited_speeds(tracks.reference);
	const std::vector<double> other = limited_speeds(tracks.other);
	const auto count = static_cast<std::ptrdiff_t>(tracks.size());
	std::vector<double> all;
	for (std::ptrdiff_t shift = -LARGEST_SHIFT; shift <= LARGEST_SHIFT; ++shift) {
		double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
		for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -shift);
				i < count - std::max<std::ptrdiff_t>(0, shift); ++i) {
			const auto at = static_cast<std::size_t>(i), shifted = static_cast<std::size_t>(i + shift);
			if (tracks.reference.is_known(at) && tracks.other.is_known(shifted)) {
				const double one = reference[at], two = other[shifted];
				n += 1.0;
				x += one;
				y += two;
				xx += one * one;
				yy += two * two;
				xy += one * two;
			}
		}
		const double spread = (n * xx - x * x) * (n * yy - y * y);
		const bool is_enough = n >= 0.5 * LEAST_INSTANTS && spread > 0.0;
		all.push_back(is_enough ? (n * xy - x * y) / std::sqrt(spread) : 0.0);
	}
	return all;
}

/// Of the smoothed tracks after the best transform, without outliers of their own.
double residual_at(const SmoothedPair &tracks, double lag_s) {
	const Pairs pairs = tracks.pairs(lag_s);
	if (pairs.size() < 3) {
		return std::numeric_limits<double>::infinity();
	}
	const Pairs kept = without_outliers(pairs);
	return rms(fit(kept).residuals_m(kept));
}

/// Of the peaks that rival the highest, the one whose tracks fit best; not a number where there is none.
double coarse_lag_s(const SmoothedPair &tracks) {
	const std::vector<double> all = correlations(tracks);
	const double highest = *std::max_element(all.begin(), all.end());
	double best_lag_s = std::numeric_limits<double>::quiet_NaN();
	double least_m = std::numeric_limits<double>::infinity();
	for (std::size_t i = 1; i + 1 < all.size(); ++i) {
		const double before = all[i - 1], here = all[i], after = all[i + 1];
		if (here < before || here <= after || here < highest - RIVAL_PEAK ||
				here < TrackerAlignment::LEAST_CORRELATION) {
			continue;
		}
		const double peak = 0.5 * (before - after) / (before - 2.0 * here + after); // of a parabola
		const double lag_s = (static_cast<double>(i) - LARGEST_SHIFT + peak) / GRID_HZ;
		const double residual_m = residual_at(tracks, lag_s);
		if (residual_m < least_m) {
			least_m = residual_m;
			best_lag_s = lag_s;
		}
	}
	return best_lag_s;
}

/// Golden section search of the least residual.
double refined_lag_s(const SmoothedPair &tracks, double coarse_s) {
	constexpr double SECTION = 1.0 / std::numbers::phi;
	double low = coarse_s - REFINED_WITHIN_S, high = coarse_s + REFINED_WITHIN_S;
	double left = high - SECTION * (high - low), right = low + SECTION * (high - low);
	double at_left = residual_at(tracks, left), at_right = residual_at(tracks, right);
	while (high - low > LAG_TOLERANCE_S) {
		if (at_left < at_right) {
			high = right;
			right = left;
			at_right = at_left;
			left = high - SECTION * (high - low);
			at_left = residual_at(tracks, left);
		} else {
			low = left;
			left = right;
			at_left = at_right;
			right = low + SECTION * (high - low);
			at_right = residual_at(tracks, right);
		}
	}
	return 0.5 * (low + high);
}

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
	const UniformGrid grid{ start_s, GRID_HZ };
	const auto count = static_cast<std::size_t>((end_s - start_s) * GRID_HZ) + 1;
	const SmoothedPair tracks{ smoothed(reference, grid, count), smoothed(other, grid, count) };

	const Pairs at_once = tracks.pairs(0.0);
	if (static_cast<double>(at_once.size()) < LEAST_INSTANTS) {
		return overlap_error(static_cast<double>(at_once.size()) / GRID_HZ);
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
	result.overlap_s = static_cast<double>(tracks.pairs(result.lag_s).size()) / GRID_HZ;
	const Pairs measured = measured_pairs(reference, other, result.lag_s);
	if (result.overlap_s < LEAST_OVERLAP_S || measured.size() == 0) {
		return overlap_error(result.overlap_s);
	}
	const Pairs pairs = without_outliers(measured);
	if (const std::string fault = movement_fault("the reference", pairs.reference_m); !fault.empty()) {
		return Error{ fault };
	}
	const Fit last = fit(pairs);
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
