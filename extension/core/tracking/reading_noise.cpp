#include "tracking/reading_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace steadyhand {
namespace {

struct Spread {
	double deviation = 0.0;
	bool alternates = false; ///< as white noise does, and motion does not
};

/// Of `axis` of normalised differences, which are not empty. Those beyond three deviations, by the median,
/// are jumps and no noise.
template <class Differences> Spread spread_of(const Differences &differences, Eigen::Index axis) {
	constexpr double NORMAL_QUARTILE = 0.6745; // half of all are within that many deviations
	constexpr double MOST_DEVIATIONS = 3.0;
	const std::size_t count = differences.size();
	std::array<double, 16> sizes{};
	std::size_t turns = 0;
	for (std::size_t i = 0; i < count; ++i) {
		const double difference = differences[i][axis];
		sizes[i] = std::abs(difference);
		turns += i > 0 && difference * differences[i - 1][axis] < 0.0 ? 1 : 0;
	}
	const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(count / 2);
	std::nth_element(sizes.begin(), middle, sizes.begin() + static_cast<std::ptrdiff_t>(count));
	const double most = MOST_DEVIATIONS / NORMAL_QUARTILE * *middle;
	double squares = 0.0;
	std::size_t kept = 0;
	for (std::size_t i = 0; i < count; ++i) {
		squares += sizes[i] <= most ? sizes[i] * sizes[i] : 0.0;
		kept += sizes[i] <= most ? 1 : 0;
	}
	// White noise turns in acos(-k / (k + 1)) / pi of the steps: 0.73 and 0.80 for orders 2 and 4.
	return { std::sqrt(squares / static_cast<double>(kept)), 2 * turns > count - 1 };
}

} // namespace

void ReadingNoise::push(double t_s, const Eigen::Vector3d &position_m) {
	readings_.push({ t_s, position_m });
	difference<2>(second_);
	difference<4>(fourth_);
	for (Eigen::Index axis = 0; axis < 3; ++axis) {
		measure(axis);
	}
	look_for_resolution();
}

template <std::size_t ORDER> void ReadingNoise::difference(Differences &r_differences) const {
	if (readings_.size() <= ORDER) {
		return;
	}
	const std::size_t first = readings_.size() - 1 - ORDER;
	Eigen::Vector3d sum = Eigen::Vector3d::Zero();
	double squares = 0.0;
	for (std::size_t i = 0; i <= ORDER; ++i) {
		double weight = 1.0;
		for (std::size_t j = 0; j <= ORDER; ++j) {
			// In periods, so that the products stay near 1.
			const double span_s = readings_.newest().t_s - readings_[first].t_s;
			weight *= i == j ? 1.0 : span_s / (readings_[first + i].t_s - readings_[first + j].t_s);
		}
		sum += weight * (readings_[first + i].position_m - readings_[first].position_m);
		squares += weight * weight;
	}
	r_differences.push(sum / std::sqrt(squares));
}

void ReadingNoise::measure(Eigen::Index axis) {
	const std::size_t i = static_cast<std::size_t>(axis);
	Spread least{ std::numeric_limits<double>::infinity(), false };
	for (const Differences *differences : { &second_, &fourth_ }) {
		if (differences->size() >= FEWEST) {
			const Spread spread = spread_of(*differences, axis);
			least = spread.deviation < least.deviation ? spread : least;
		}
	}
	if (least.alternates) {
		deviation_m_[axis] = least.deviation;
		is_seen_[i] = true;
	} else {
		deviation_m_[axis] = std::min(deviation_m_[axis], least.deviation);
	}
}

bool ReadingNoise::is_rounded_to(double step_m, std::size_t first) const {
	constexpr double TOLERANCE = 0.05; // of a step: single precision at 1 m and steps of a micrometre
	if (!(step_m > 0.0) || !std::isfinite(step_m)) {
		return false;
	}
	for (std::size_t i = first; i < readings_.size(); ++i) {
		for (const double way_m : readings_[i].position_m - readings_[i - 1].position_m) {
			const double steps = std::abs(way_m) / step_m;
			if (std::abs(steps - std::floor(steps + 0.5)) > TOLERANCE) {
				return false;
			}
		}
	}
	return true;
}

void ReadingNoise::look_for_resolution() {
	if (readings_.size() < WINDOW / 2 || is_rounded_to(resolution_m_, readings_.size() - 1)) {
		return;
	}
	double least_m = std::numeric_limits<double>::infinity();
	for (std::size_t i = 1; i < readings_.size(); ++i) {
		for (const double step : readings_[i].position_m - readings_[i - 1].position_m) {
			least_m = std::abs(step) > 0.0 ? std::min(least_m, std::abs(step)) : least_m;
		}
	}
	resolution_m_ = least_m >= FINEST_M && is_rounded_to(least_m, 1) ? least_m : 0.0;
}

Eigen::Vector3d ReadingNoise::deviation_m() const {
	return deviation_m_.cwiseMax(resolution_m_ / std::sqrt(12.0));
}

double ReadingNoise::repeat_probability() const {
	const double step_m = std::max(resolution_m_, FINEST_M);
	double probability = 1.0;
	for (std::size_t i = 0; i < is_seen_.size(); ++i) {
		const double deviation_m = deviation_m_[static_cast<Eigen::Index>(i)];
		// Two draws of a normal distribution fall into one cell with cell / (2 sqrt(pi) deviation). Noise
		// below a step may be rounding's own, which says nothing of a hand at rest.
		probability *= is_seen_[i] && deviation_m > step_m
				? step_m / deviation_m * 0.5 * std::numbers::inv_sqrtpi
				: 1.0;
	}
	return probability;
}

} // namespace steadyhand
