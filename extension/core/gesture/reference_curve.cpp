#include "gesture/reference_curve.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

constexpr double ONSET_SPEED = 0.05; ///< of the peak speed
constexpr double HALF_WINDOW_S = 0.02;

double r_squared(const Eigen::VectorXd &observed, const Eigen::VectorXd &model) {
	const double total = (observed.array() - observed.mean()).square().sum();
	return total > 0.0 ? 1.0 - (observed - model).squaredNorm() / total : 0.0;
}

/// Mean and standard deviation of the kept curves at each point.
void mean_of_kept(std::span<const Eigen::VectorXd> curves, ReferenceCurve &r_reference) {
	r_reference.mean = Eigen::VectorXd::Zero(CURVE_POINTS);
	r_reference.deviation = Eigen::VectorXd::Zero(CURVE_POINTS);
	double n = 0.0;
	for (std::size_t i = 0; i < curves.size(); ++i) {
		if (r_reference.kept[i]) {
			r_reference.mean += curves[i];
			n += 1.0;
		}
	}
	r_reference.mean /= n;
	for (std::size_t i = 0; i < curves.size(); ++i) {
		if (r_reference.kept[i]) {
			r_reference.deviation += (curves[i] - r_reference.mean).cwiseAbs2();
		}
	}
	r_reference.deviation = (r_reference.deviation / std::max(n - 1.0, 1.0)).cwiseSqrt();
}

} // namespace

double value_at(const RecordedCurve &curve, double t_s) {
	const auto next = std::upper_bound(curve.t_s.begin(), curve.t_s.end(), t_s);
	if (next == curve.t_s.begin()) {
		return curve.x_m.front();
	}
	if (next == curve.t_s.end()) {
		return curve.x_m.back();
	}
	const auto i = static_cast<std::size_t>(next - curve.t_s.begin());
	const double weight = (t_s - curve.t_s[i - 1]) / (curve.t_s[i] - curve.t_s[i - 1]);
	return curve.x_m[i - 1] + weight * (curve.x_m[i] - curve.x_m[i - 1]);
}

MovementSpan movement_span(const RecordedCurve &curve, double start_s, double end_s) {
	const MovementSpan whole{ start_s, end_s };
	constexpr double STEP_S = 0.005;
	const auto steps = static_cast<int>((end_s - start_s) / STEP_S);
	const double x_start = value_at(curve, start_s);
	const double travel = value_at(curve, end_s) - x_start;
	if (steps < 2 || travel == 0.0) {
		return whole;
	}
	const auto speed = [&](int i) {
		const double t_s = start_s + i * STEP_S;
		return (value_at(curve, t_s + HALF_WINDOW_S) - value_at(curve, t_s - HALF_WINDOW_S)) /
				(2.0 * HALF_WINDOW_S) * std::copysign(1.0, travel);
	};
	double peak = 0.0;
	int half_way = steps;
	for (int i = 0; i <= steps; ++i) {
		peak = std::max(peak, speed(i));
		if (half_way == steps && (value_at(curve, start_s + i * STEP_S) - x_start) / travel >= 0.5) {
			half_way = i;
		}
	}
	int onset = half_way;
	while (onset > 0 && speed(onset) > ONSET_SPEED * peak) {
		--onset;
	}
	const double onset_s = start_s + onset * STEP_S;
	return onset_s < end_s ? MovementSpan{ onset_s, end_s } : whole;
}

Eigen::VectorXd normalised_curve(const RecordedCurve &curve, const MovementSpan &span) {
	const double x_onset = value_at(curve, span.onset_s);
	const double travel = value_at(curve, span.end_s) - x_onset;
	Eigen::VectorXd normalised = Eigen::VectorXd::Zero(CURVE_POINTS);
	if (travel == 0.0) {
		return normalised;
	}
	for (Eigen::Index i = 0; i < CURVE_POINTS; ++i) {
		const double phase = static_cast<double>(i) / static_cast<double>(CURVE_POINTS - 1);
		normalised(i) =
				(value_at(curve, span.onset_s + phase * (span.end_s - span.onset_s)) - x_onset) / travel;
	}
	return normalised;
}

ReferenceCurve reference_curve(std::span<const Eigen::VectorXd> curves, double threshold) {
	ReferenceCurve reference;
	reference.kept.assign(curves.size(), true);
	mean_of_kept(curves, reference);
	for (const Eigen::VectorXd &curve : curves) {
		reference.r2.push_back(r_squared(curve, reference.mean));
	}
	const auto best = std::max_element(reference.r2.begin(), reference.r2.end());
	for (std::size_t i = 0; i < curves.size(); ++i) {
		reference.kept[i] = reference.r2[i] >= std::min(threshold, *best);
	}
	mean_of_kept(curves, reference);
	return reference;
}

} // namespace steadyhand
