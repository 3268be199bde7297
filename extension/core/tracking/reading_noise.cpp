#include "tracking/reading_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace steadyhand {
namespace {

using Axes = Eigen::Array4d; ///< x, y, z and 0, which fill two SIMD registers

struct Spread {
	Axes deviation = Axes::Constant(std::numeric_limits<double>::infinity());
	/// Differences change their sign as often as white noise. Those of motion do not.
	Eigen::Array<bool, 4, 1> alternates = Eigen::Array<bool, 4, 1>::Constant(false);
};

/// Sorts each axis separately by odd-even transposition. It has no branches, which noise would make
/// unpredictable.
template <std::size_t COUNT> void sort(std::array<Axes, COUNT> &r_items) {
	for (std::size_t round = 0; round < COUNT; ++round) {
		for (std::size_t i = round % 2; i + 1 < COUNT; i += 2) {
			const Axes lesser = r_items[i].min(r_items[i + 1]);
			r_items[i + 1] = r_items[i].max(r_items[i + 1]);
			r_items[i] = lesser;
		}
	}
}

/// Spread of normalised differences, at least one. Differences beyond three standard deviations (by the
/// median) do not count: they are jumps.
template <class Differences> Spread spread_of(const Differences &differences) {
	constexpr double NORMAL_QUARTILE = 0.6745; // half of a normal distribution is within this
	constexpr double MOST_DEVIATIONS = 3.0;
	const std::size_t count = differences.size();
	std::array<Axes, 16> sizes;
	sizes.fill(Axes::Constant(std::numeric_limits<double>::infinity()));
	Axes sign_changes = Axes::Zero(), last = Axes::Zero();
	for (std::size_t i = 0; i < count; ++i) {
		Axes difference = Axes::Zero();
		difference.head<3>() = differences[i];
		sizes[i] = difference.abs();
		sign_changes += (difference * last < 0.0).cast<double>();
		last = difference;
	}
	sort(sizes);
	const Axes most = MOST_DEVIATIONS / NORMAL_QUARTILE * sizes[count / 2];
	Axes squares = Axes::Zero(), kept = Axes::Zero();
	for (std::size_t i = 0; i < count; ++i) {
		const Axes is_kept = (sizes[i] <= most).cast<double>();
		squares += is_kept * sizes[i].square();
		kept += is_kept;
	}
	// Differences of order k of white noise change their sign in acos(-k / (k + 1)) / pi of the steps: 0.73
	// for order 2, 0.80 for order 4.
	return { (squares / kept).sqrt(), 2.0 * sign_changes > static_cast<double>(count - 1) };
}

/// Tolerance of multiples of a step, in steps: single precision at 1 m, with steps of a micrometre.
constexpr double ROUNDING_TOLERANCE = 0.05;

double distance_from_multiple(double length, double step) {
	return std::abs(length - step * std::floor(length / step + 0.5));
}

/// Longest step of which both lengths are multiples, by Euclid's algorithm. A fast hand makes no single
/// steps.
double common_measure(double one, double other) {
	double step = std::min(one, other), rest = std::max(one, other);
	rest = std::isfinite(rest) ? distance_from_multiple(rest, step) : 0.0;
	while (rest > ROUNDING_TOLERANCE * step) {
		const double last = std::exchange(step, rest);
		rest = distance_from_multiple(last, step);
	}
	return step;
}

} // namespace

void ReadingNoise::push(double t_s, const Eigen::Vector3d &position_m) {
	readings_.push({ t_s, position_m });
	difference<2>(second_);
	difference<4>(fourth_);
	measure();
	find_resolution();
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
			// Relative to the whole span, so that products do not overflow.
			const double span_s = readings_.newest().t_s - readings_[first].t_s;
			weight *= i == j ? 1.0 : span_s / (readings_[first + i].t_s - readings_[first + j].t_s);
		}
		sum += weight * (readings_[first + i].position_m - readings_[first].position_m);
		squares += weight * weight;
	}
	r_differences.push(sum / std::sqrt(squares));
}

void ReadingNoise::measure() {
	const Spread second = second_.size() >= LEAST_COUNT ? spread_of(second_) : Spread{};
	const Spread fourth = fourth_.size() >= LEAST_COUNT ? spread_of(fourth_) : Spread{};
	for (Eigen::Index axis = 0; axis < 3; ++axis) {
		const Spread &least = fourth.deviation[axis] < second.deviation[axis] ? fourth : second;
		if (least.alternates[axis]) {
			deviation_m_[axis] = least.deviation[axis];
			has_noise_[static_cast<std::size_t>(axis)] = true;
		} else {
			deviation_m_[axis] = std::min(deviation_m_[axis], least.deviation[axis]);
		}
	}
}

bool ReadingNoise::is_rounded_to(double step_m, std::size_t first) const {
	if (!(step_m > 0.0) || !std::isfinite(step_m)) {
		return false;
	}
	for (std::size_t i = first; i < readings_.size(); ++i) {
		for (const double length_m : readings_[i].position_m - readings_[i - 1].position_m) {
			if (distance_from_multiple(length_m, step_m) > ROUNDING_TOLERANCE * step_m) {
				return false;
			}
		}
	}
	return true;
}

void ReadingNoise::find_resolution() {
	if (readings_.size() < WINDOW / 2 || is_rounded_to(resolution_m_, readings_.size() - 1)) {
		return;
	}
	double common_m = std::numeric_limits<double>::infinity();
	for (std::size_t i = 1; i < readings_.size() && common_m >= FINEST_M; ++i) {
		for (const double length_m : readings_[i].position_m - readings_[i - 1].position_m) {
			common_m = length_m != 0.0 ? common_measure(common_m, std::abs(length_m)) : common_m;
		}
	}
	resolution_m_ = common_m >= FINEST_M && is_rounded_to(common_m, 1) ? common_m : 0.0;
}

Eigen::Vector3d ReadingNoise::deviation_m() const {
	return deviation_m_.cwiseMax(resolution_m_ / std::sqrt(12.0));
}

double ReadingNoise::repeat_probability() const {
	const double step_m = std::max(resolution_m_, FINEST_M);
	double probability = 1.0;
	for (std::size_t i = 0; i < has_noise_.size(); ++i) {
		const double deviation_m = deviation_m_[static_cast<Eigen::Index>(i)];
		// Two readings of a hand at rest are in the same cell with probability cell / (2 sqrt(pi) deviation),
		// if the noise is wider than a cell. Smaller noise is not distinguishable from rounding (uniform,
		// variance step^2 / 12), which repeats as long as the hand rests.
		probability *= has_noise_[i] && deviation_m > step_m
				? step_m / deviation_m * 0.5 * std::numbers::inv_sqrtpi
				: 1.0;
	}
	return probability;
}

} // namespace steadyhand
