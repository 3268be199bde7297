#pragma once

#include <span>

namespace steadyhand {

// Values that are not usable numbers are left out of both; 0 if none is left.

[[nodiscard]] double mean(std::span<const double> values);

/// Linear between order statistics, at rank (n - 1) percent / 100 counted from 0: type 7 of Hyndman and Fan
/// 1996 (DOI 10.1080/00031305.1996.10473566), NumPy's default. The median is the 50th.
[[nodiscard]] double percentile(std::span<const double> values, double percent);

} // namespace steadyhand
