#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace steadyhand {

/// Points of a normalised curve, evenly spaced over phase 0..1, both ends included.
inline constexpr Eigen::Index CURVE_POINTS = 101;

/// A recording's motion element, still in its own time.
struct RecordedCurve {
	std::vector<double> t_s; ///< strictly increasing
	std::vector<double> x_m; ///< as many
};

/// When the hand moved, within the span that the trial names.
struct MovementSpan {
	double onset_s = 0.0;
	double end_s = 0.0;
};

/// m; linear between samples, the first and last one held beyond them. The curve must have some.
double value_at(const RecordedCurve &curve, double t_s);

/// Movement onset by the usual 5 % of the peak speed, searched back from the first crossing of half the way
/// (speed: the central difference over +-20 ms); the end is the trial's own. onset_s < end_s always; where
/// nothing moves, the trial's span is returned as it is.
MovementSpan movement_span(const RecordedCurve &curve, double start_s, double end_s);

/// The recording over `span`, resampled to CURVE_POINTS of phase and scaled to run from 0 to 1 (paper,
/// "normalized in both time and amplitude"). All zeros where it ends where it began.
Eigen::VectorXd normalised_curve(const RecordedCurve &curve, const MovementSpan &span);

/// The reference curve of a gesture and how it came about (paper, "Results: Reference motion elements").
struct ReferenceCurve {
	Eigen::VectorXd mean;      ///< CURVE_POINTS: mean of the kept curves
	Eigen::VectorXd deviation; ///< CURVE_POINTS: their standard deviation, point by point
	std::vector<double> r2;    ///< per curve: R^2 against the mean of all of them
	std::vector<bool> kept;    ///< per curve: r2 >= threshold
};

/// Mean of all curves; R^2 of each against it; those under the threshold T_h dropped; mean and deviation of
/// the rest. curves: one normalised curve each, at least one. Where none reaches the threshold, the best one
/// alone is kept.
ReferenceCurve reference_curve(std::span<const Eigen::VectorXd> curves, double threshold);

} // namespace steadyhand
