#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace steadyhand {

/// Number of points of a normalised curve, evenly spaced over phase 0..1, both ends included.
inline constexpr Eigen::Index CURVE_POINTS = 101;

/// Motion element of a recording over time, not normalised.
struct RecordedCurve {
	std::vector<double> t_s; ///< strictly increasing
	std::vector<double> x_m; ///< of equal size
};

/// Time of the movement, within start_s .. end_s of the trial.
struct MovementSpan {
	double onset_s = 0.0;
	double end_s = 0.0;
};

/// Value at t_s, m: linear between samples, constant beyond them. The curve must have samples.
double value_at(const RecordedCurve &curve, double t_s);

/// Onset at 5 % of the peak speed, searched backwards from the first crossing of half the travel. The speed
/// is the central difference over +-20 ms. The end is end_s. onset_s < end_s always. Without motion it
/// returns start_s .. end_s.
MovementSpan movement_span(const RecordedCurve &curve, double start_s, double end_s);

/// The curve over `span`, resampled at CURVE_POINTS phases and scaled from 0 to 1 (paper, "normalized in both
/// time and amplitude"). All zeros if begin and end are equal.
Eigen::VectorXd normalised_curve(const RecordedCurve &curve, const MovementSpan &span);

/// Reference curve of a gesture (paper, "Results: Reference motion elements").
struct ReferenceCurve {
	Eigen::VectorXd mean;      ///< CURVE_POINTS: mean of the kept curves
	Eigen::VectorXd deviation; ///< CURVE_POINTS: standard deviation of the kept curves
	std::vector<double> r2;    ///< for each curve: R^2 against the mean of all curves
	std::vector<bool> kept;    ///< for each curve: r2 >= threshold, or the best r2
};

/// Drops curves whose R^2 against the mean of all is below the threshold T_h. The reference is the mean of
/// the others. If none reaches the threshold, the best curve is kept. curves: at least one, normalised.
ReferenceCurve reference_curve(std::span<const Eigen::VectorXd> curves, double threshold);

} // namespace steadyhand
