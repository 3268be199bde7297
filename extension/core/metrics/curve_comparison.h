#pragma once

#include "signal/resample.h"

#include <span>

namespace steadyhand {

/// When the gesture is under way, on the curves' clock.
struct GestureSpan {
	double start_s = 0.0;
	double end_s = 0.0;
};

/// How a curve x follows the reference. Every field is finite, whatever the input.
struct CurveComparison {
	double r2 = 0.0; ///< 1 - sum (ref - x)^2 / sum (ref - mean ref)^2 at the lag that fits best; not clipped
	double r2_zero = 0.0;  ///< the same at zero lag
	double lag_s = 0.0;    ///< that lag; positive: x is late
	double t_diff_s = 0.0; ///< end(ref) - end(x); positive: x ends early
	double sparc = 0.0;    ///< of x's speed over the gesture's span, see spectral_arc_length()
	bool missed = false;   ///< x has no end; t_diff_s is then the bound end(ref) - last instant of the record
};

/// The definition of the project's metrics. Both curves are in units of the task's amplitude, 0 at the start
/// and 1 at the end, sampled at the grid's instants.
///
/// R2: over the gesture's span and 0.25 s on either side, as far as the record goes. Lags: -0.5 s to 0.5 s in
/// steps of one sample; outside the record x keeps its first and last value; of equals the lag nearest 0
/// wins, then the late one. A reference that is constant over the window has r2 = 1 if x equals it to
/// rounding, else 0.
///
/// End: the first instant from start_s on at which a curve is at or above 95 % of the reference's level at
/// end_s, on straight lines between samples. A reference that is not above 0 at end_s has no such level: it
/// ends at end_s, and x counts as missed.
///
/// A sample that is not a usable number is taken as the one before it. A record or span without samples gives
/// zeros and missed.
[[nodiscard]] CurveComparison compare_curves(std::span<const double> reference, std::span<const double> x,
		const UniformGrid &grid, const GestureSpan &span);

} // namespace steadyhand
