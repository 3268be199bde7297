#pragma once

#include "metrics/curve_comparison.h"

#include <cstddef>
#include <span>

namespace steadyhand {

// Values that are not usable numbers are left out of both; 0 if none is left.

[[nodiscard]] double mean(std::span<const double> values);

/// Linear between order statistics, at rank (n - 1) percent / 100 counted from 0: type 7 of Hyndman and Fan
/// 1996 (DOI 10.1080/00031305.1996.10473566), NumPy's default. The median is the 50th.
[[nodiscard]] double percentile(std::span<const double> values, double percent);

/// One condition over many trials. Missed ones take part with the bound that CurveComparison gives them.
struct ConditionSummary {
	std::size_t trials = 0;
	std::size_t missed = 0;
	double mean_r2 = 0.0;
	double worst_r2 = 0.0; ///< 5th percentile
	double mean_r2_zero = 0.0;
	double median_lag_s = 0.0;
	double median_t_diff_s = 0.0;
	double low_t_diff_s = 0.0;  ///< 2.5th percentile
	double high_t_diff_s = 0.0; ///< 97.5th percentile
	double mean_sparc = 0.0;
};

[[nodiscard]] ConditionSummary summarise(std::span<const CurveComparison> trials);

} // namespace steadyhand
