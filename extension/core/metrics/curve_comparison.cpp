#include "metrics/curve_comparison.h"

#include "gesture/task.h"
#include "metrics/spectral_arc_length.h"
#include "signal/sample_clock.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace steadyhand {

namespace {

constexpr double MARGIN_S = 0.25;
constexpr double LARGEST_LAG_S = 0.5;
/// The lag search takes a step a sample; no sensor or synthesiser is faster.
constexpr double LARGEST_RATE_HZ = 1e6;
/// Of the largest value, rms: a curve that varies less is constant but for rounding.
constexpr double ROUNDING = 1e-12;
/// Of a sample: instants this near are on the grid although start_s and 1 / rate are rounded.
constexpr double GRID_SLACK = 1e-6;

/// A curve on the grid without its unusable samples.
Eigen::ArrayXd repaired(std::span<const double> samples) {
	Eigen::ArrayXd curve(static_cast<Eigen::Index>(samples.size()));
	const auto first = std::find_if(samples.begin(), samples.end(), is_usable);
	double last = first == samples.end() ? 0.0 : *first;
	for (Eigen::Index i = 0; i < curve.size(); ++i) {
		const double sample = samples[static_cast<std::size_t>(i)];
		last = is_usable(sample) ? sample : last;
		curve[i] = last;
	}
	return curve;
}

/// Samples from first to last, both included; none if last < first.
struct Window {
	Eigen::Index first;
	Eigen::Index last;

	[[nodiscard]] Eigen::Index length() const { return last - first + 1; }
};

Window window_of(double from_s, double to_s, const UniformGrid &grid, Eigen::Index samples) {
	const auto end = static_cast<double>(samples);
	const double first = std::ceil((from_s - grid.t0_s) * grid.rate_hz - GRID_SLACK);
	const double last = std::floor((to_s - grid.t0_s) * grid.rate_hz + GRID_SLACK);
	return { static_cast<Eigen::Index>(std::clamp(first, 0.0, end)),
		static_cast<Eigen::Index>(std::clamp(last, -1.0, end - 1.0)) };
}

/// 1 - residual / total for sums of squares, with `rounding` the sum that counts as none.
double coefficient_of_determination(double residual, double total, double rounding) {
	if (total > rounding) {
		return std::max(1.0 - residual / total, -LARGEST_USABLE);
	}
	return residual > rounding ? 0.0 : 1.0;
}

void compare_shape(const Eigen::ArrayXd &reference, const Eigen::ArrayXd &x, const UniformGrid &grid,
		const Window &window, CurveComparison &result) {
	const auto largest_lag = static_cast<Eigen::Index>(std::lround(LARGEST_LAG_S * grid.rate_hz));
	const auto length = window.length();
	const auto target = reference.segment(window.first, length);
	// held[i] is x at window.first - largest_lag + i.
	Eigen::ArrayXd held(length + 2 * largest_lag);
	for (Eigen::Index i = 0; i < held.size(); ++i) {
		held[i] = x[std::clamp<Eigen::Index>(window.first - largest_lag + i, 0, x.size() - 1)];
	}
	const auto residual_at = [&](Eigen::Index lag) {
		return (target - held.segment(largest_lag + lag, length)).square().sum();
	};

	const double residual_zero = residual_at(0);
	double smallest = residual_zero;
	Eigen::Index best_lag = 0;
	for (Eigen::Index distance = 1; distance <= largest_lag; ++distance) {
		for (const Eigen::Index lag : { distance, -distance }) {
			const double residual = residual_at(lag);
			if (residual < smallest) {
				smallest = residual;
				best_lag = lag;
			}
		}
	}
	const double total = (target - target.mean()).square().sum();
	const double rounding_rms = ROUNDING * target.abs().maxCoeff();
	const double rounding = rounding_rms * rounding_rms * static_cast<double>(length);
	result.r2 = coefficient_of_determination(smallest, total, rounding);
	result.r2_zero = coefficient_of_determination(residual_zero, total, rounding);
	result.lag_s = static_cast<double>(best_lag) / grid.rate_hz;
}

/// Value on straight lines between samples; `position` in samples, held at the ends.
double value_at(const Eigen::ArrayXd &curve, double position) {
	const double inside = std::clamp(position, 0.0, static_cast<double>(curve.size() - 1));
	const auto before = static_cast<Eigen::Index>(inside);
	const auto after = std::min(before + 1, curve.size() - 1);
	return curve[before] + (inside - static_cast<double>(before)) * (curve[after] - curve[before]);
}

/// First position (in samples) not before `from` at which the curve is at or above the level.
std::optional<double> first_reach(const Eigen::ArrayXd &curve, double from, double level) {
	const double start = std::clamp(from, 0.0, static_cast<double>(curve.size() - 1));
	if (value_at(curve, start) >= level) {
		return start;
	}
	for (auto i = static_cast<Eigen::Index>(start) + 1; i < curve.size(); ++i) {
		if (curve[i] >= level) {
			const double before = curve[i - 1];
			return static_cast<double>(i - 1) + (level - before) / (curve[i] - before);
		}
	}
	return std::nullopt;
}

void compare_ends(const Eigen::ArrayXd &reference, const Eigen::ArrayXd &x, const UniformGrid &grid,
		const GestureSpan &span, CurveComparison &result) {
	const double start = (span.start_s - grid.t0_s) * grid.rate_hz;
	const double end = (span.end_s - grid.t0_s) * grid.rate_hz;
	const double level = END_LEVEL * value_at(reference, end);
	const std::optional<double> reference_end =
			level > 0.0 ? first_reach(reference, start, level) : std::nullopt;
	const std::optional<double> x_end = reference_end ? first_reach(x, start, level) : std::nullopt;
	result.missed = !x_end;
	const auto record_end = static_cast<double>(x.size() - 1);
	result.t_diff_s = (reference_end.value_or(end) - x_end.value_or(record_end)) / grid.rate_hz;
}

/// |dx/dt| by central differences, one-sided where the record ends.
std::vector<double> speeds(const Eigen::ArrayXd &x, const Window &window, double rate_hz) {
	std::vector<double> result;
	result.reserve(static_cast<std::size_t>(window.length()));
	for (Eigen::Index i = window.first; i <= window.last; ++i) {
		const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0);
		const Eigen::Index after = std::min(i + 1, x.size() - 1);
		const auto steps = static_cast<double>(std::max<Eigen::Index>(after - before, 1));
		result.push_back(std::abs(x[after] - x[before]) * rate_hz / steps);
	}
	return result;
}

} // namespace

CurveComparison compare_curves(std::span<const double> reference, std::span<const double> x,
		const UniformGrid &grid, const GestureSpan &span) {
	CurveComparison result;
	result.missed = true;
	const std::size_t samples = std::min(reference.size(), x.size());
	const bool sound = is_usable(grid.t0_s) && is_usable(span.start_s) && is_usable(span.end_s) &&
			grid.rate_hz > 0.0 && grid.rate_hz <= LARGEST_RATE_HZ;
	if (samples == 0 || !sound) {
		return result;
	}
	const Eigen::ArrayXd reference_curve = repaired(reference.first(samples));
	const Eigen::ArrayXd x_curve = repaired(x.first(samples));
	const Window gesture = window_of(span.start_s, span.end_s, grid, x_curve.size());
	if (gesture.length() <= 0) {
		return result;
	}
	const Window window = window_of(span.start_s - MARGIN_S, span.end_s + MARGIN_S, grid, x_curve.size());
	compare_shape(reference_curve, x_curve, grid, window, result);
	compare_ends(reference_curve, x_curve, grid, span, result);
	result.sparc = spectral_arc_length(speeds(x_curve, gesture, grid.rate_hz), grid.rate_hz);
	return result;
}

} // namespace steadyhand
