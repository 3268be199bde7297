#include "metrics/smoothed_track.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

namespace {

/// On either side of an instant. Three samples of a tracker at 20 Hz lie within, and a hand's movements, up
/// to about 4 Hz, are not smoothed away.
constexpr double HALF_WINDOW_S = 0.08;
constexpr std::size_t LEAST_SAMPLES = 3;

/// A sample jumps if it is further from the median of its window than FAR times the median distance, plus
/// the noise of a bad tracker. At turning points of a movement the factor is about 1.
constexpr double FAR = 4.0;
constexpr double NOISE_M = 0.003;

double median(std::vector<double> &values) {
	const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
	std::nth_element(values.begin(), middle, values.end());
	return *middle;
}

/// Follows the samples within HALF_WINDOW_S of instants that do not decrease.
class SampleWindow {
public:
	explicit SampleWindow(std::span<const TrackSample> samples) : samples_(samples) {}

	std::span<const TrackSample> around(double t_s) {
		while (end_ < samples_.size() && samples_[end_].t_s <= t_s + HALF_WINDOW_S) {
			++end_;
		}
		while (begin_ < end_ && samples_[begin_].t_s < t_s - HALF_WINDOW_S) {
			++begin_;
		}
		return samples_.subspan(begin_, end_ - begin_);
	}

private:
	std::span<const TrackSample> samples_;
	std::size_t begin_ = 0, end_ = 0;
};

/// Whether there are samples close before and close after the instant.
bool is_covered(std::span<const TrackSample> window, double t_s) {
	const auto after = std::ranges::lower_bound(window, t_s, {}, &TrackSample::t_s);
	return window.size() >= LEAST_SAMPLES && after != window.begin() && after != window.end() &&
			after->t_s - std::prev(after)->t_s <= LONGEST_SAMPLE_GAP_S;
}

} // namespace

std::vector<TrackSample> without_jumps(std::span<const TrackSample> samples) {
	std::vector<TrackSample> kept;
	kept.reserve(samples.size());
	std::vector<double> values;
	SampleWindow window(samples);
	for (const TrackSample &sample : samples) {
		const std::span<const TrackSample> near = window.around(sample.t_s);
		Eigen::Vector3d middle_m;
		for (Eigen::Index axis = 0; axis < 3; ++axis) {
			values.clear();
			for (const TrackSample &other : near) {
				values.push_back(other.position_m[axis]);
			}
			middle_m[axis] = median(values);
		}
		values.clear();
		for (const TrackSample &other : near) {
			values.push_back((other.position_m - middle_m).norm());
		}
		if ((sample.position_m - middle_m).norm() <= FAR * median(values) + NOISE_M) {
			kept.push_back(sample);
		}
	}
	return kept;
}

SmoothedTrack smoothed(std::span<const TrackSample> samples, const UniformGrid &grid, std::size_t count) {
	SmoothedTrack track{ std::vector<Eigen::Vector3d>(count, Eigen::Vector3d::Zero()),
		std::vector<double>(count), std::vector<std::uint8_t>(count) };
	SampleWindow window(samples);
	for (std::size_t i = 0; i < count; ++i) {
		const double t_s = grid.time_s(i);
		const std::span<const TrackSample> near = window.around(t_s);
		if (!is_covered(near, t_s)) {
			continue;
		}
		// Relative to one sample, since the origin may be far away. Epanechnikov weights: a sample that
		// enters or leaves the window weighs nothing.
		const Eigen::Vector3d origin_m = near.front().position_m;
		double w = 0.0, wt = 0.0, wtt = 0.0;
		Eigen::Vector3d wx = Eigen::Vector3d::Zero(), wtx = Eigen::Vector3d::Zero();
		for (const TrackSample &sample : near) {
			const double dt_s = sample.t_s - t_s;
			const double share = dt_s / HALF_WINDOW_S;
			const double weight = std::max(1.0 - share * share, 0.0);
			const Eigen::Vector3d from_origin_m = sample.position_m - origin_m;
			w += weight;
			wt += weight * dt_s;
			wtt += weight * dt_s * dt_s;
			wx += weight * from_origin_m;
			wtx += weight * dt_s * from_origin_m;
		}
		const double determinant = w * wtt - wt * wt;
		if (!(determinant > 0.0)) {
			continue;
		}
		track.positions_m[i] = origin_m + (wtt * wx - wt * wtx) / determinant;
		track.speeds_m_s[i] = ((w * wtx - wt * wx) / determinant).norm();
		track.known[i] = 1;
	}
	return track;
}

} // namespace steadyhand
