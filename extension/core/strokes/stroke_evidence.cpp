#include "strokes/stroke_evidence.h"

#include "base/parameters.h"
#include "signal/minimum_jerk.h"
#include "strokes/path_densities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

using namespace parameters::strokes;

constexpr double IMPOSSIBLE = -1e3;
constexpr double LEAST_SHARE = 0.01; ///< of a duration: a stroke without length has no pace

/// Log density of a normal whose standard deviation differs below and above its mode, 0.
double log_two_piece_normal(double x, double below, double above) {
	const double z = x / (x < 0.0 ? below : above);
	return -0.5 * z * z - std::log(0.5 * (below + above) * std::sqrt(2.0 * std::numbers::pi));
}

/// off: distance of the unit vectors of stroke and axis.
double direction_evidence(double off) {
	return log_direction_ratio(off, DIRECTION);
}

/// length_m: of the stroke's chord, > 0.
double straightness(const Stroke &stroke, double length_m) {
	const FeaturePlace chord = stroke.to - stroke.from;
	const FeaturePlace off = stroke.middle - 0.5 * (stroke.from + stroke.to);
	return log_bow_ratio((off - chord * (off.dot(chord) / (length_m * length_m))).norm() / length_m, BOW);
}

/// Log ratio of the gesture's density of detours, which is exponential, to that of the null model.
double detour_evidence(const Stroke &stroke, double length_m) {
	const double detour = std::max(stroke.path_m / length_m - 1.0, 0.0), mean = DETOUR_M / length_m;
	return std::log(0.5 * OTHER_DETOUR / mean) + 3.0 * std::log1p(detour / OTHER_DETOUR) - detour / mean;
}

double rest_evidence(const Stroke &stroke, double amplitude_m) {
	const double motion = stroke.motion_before_m / amplitude_m,
				 still = REST_MOTION + REST_MOTION_M / amplitude_m;
	const double other = std::hypot(still, OTHER_MOTION_PER_S * stroke.tracked_before_s);
	const double ratio = std::exp(-0.5 * motion * motion * (1.0 / (still * still) - 1.0 / (other * other)));
	return std::log((1.0 - NO_REST_SHARE) * ratio * other / still + NO_REST_SHARE) -
			REST_UNSEEN * (1.0 - stroke.tracked_before_s / REST_S);
}

double size_evidence(double log_length, double log_time) {
	const double usual = std::exp(log_two_piece_normal(log_time, LOG_DURATION, LOG_DURATION)) * LOG_DURATIONS;
	return log_two_piece_normal(log_length, LOG_SHORTER, LOG_LONGER) + std::log(LOG_LENGTHS) +
			std::log((1.0 - ANY_PACE_SHARE) * usual + ANY_PACE_SHARE);
}

/// Fraction of a minimum-jerk path that is covered when the speed has fallen to this fraction of its peak.
/// The speed is 16 s^2 (1 - s)^2 of the peak at the fraction s of the duration.
double path_fraction_at_speed(double speed_share) {
	return minimum_jerk(0.5 + 0.5 * std::sqrt(1.0 - std::sqrt(speed_share))).value;
}

/// Least distance from the axis that the direction of the stroke can have at its end. off: present distance.
double least_direction_error(double off, double length_m, double amplitude_m) {
	const double to_go = std::max(1.0 - length_m / amplitude_m, 0.0);
	return std::max(off - LATER_TURN * to_go * to_go, 0.0);
}

bool has_direction(double length_m) {
	return length_m > 0.0 && std::isfinite(length_m);
}

} // namespace

StrokeEvidence stroke_evidence(
		const Stroke &stroke, const FeaturePlace &direction, const UsualStroke &usual) {
	const double amplitude_m = usual.amplitude_m;
	const FeaturePlace chord = stroke.to - stroke.from;
	const double length_m = chord.norm(), time_s = stroke.now_s - stroke.onset_s;
	if (!has_direction(length_m) || !(time_s > 0.0)) {
		return { .path = IMPOSSIBLE };
	}
	const double off = (chord / length_m - direction).norm();
	const double now = direction_evidence(off);
	StrokeEvidence evidence;
	evidence.path = now + straightness(stroke, length_m);
	evidence.detour = detour_evidence(stroke, length_m);
	evidence.rest = rest_evidence(stroke, amplitude_m);
	evidence.size = size_evidence(std::log(length_m / amplitude_m), std::log(time_s / usual.duration_s));
	evidence.max_remaining = direction_evidence(least_direction_error(off, length_m, amplitude_m)) - now +
			size_evidence(0.0, 0.0);
	return evidence;
}

double strike_evidence(const Stroke &stroke, const UsualStroke &usual) {
	if (!usual.is_strike) {
		return 0.0;
	}
	// Duration of a minimum-jerk movement that has covered the same length in the same time.
	const double share = minimum_jerk_share((stroke.to - stroke.from).norm() / usual.amplitude_m);
	const double duration_s = (stroke.now_s - stroke.onset_s) / std::max(share, LEAST_SHARE);
	const double slower = std::max(std::log(duration_s / usual.duration_s), 0.0) / SLOWER_STRIKE;
	return -slower * slower * slower * slower;
}

double return_evidence(const UsualStroke &usual, bool comes_back) {
	return std::log(2.0 * (comes_back == usual.is_strike ? USUAL_ENDING : 1.0 - USUAL_ENDING));
}

double slowing_evidence(const Stroke &stroke, double speed_m_s, double amplitude_m) {
	const double share = speed_m_s / stroke.peak_m_s;
	if (!(share < SLOWING_SHARE)) {
		return 0.0;
	}
	const double longest_m = FURTHER * (stroke.to - stroke.from).norm() / path_fraction_at_speed(share);
	const double z = std::min(std::log(longest_m / amplitude_m), 0.0) / LOG_SHORTER;
	return std::log((1.0 - GOES_ON_SHARE) * std::exp(-0.5 * z * z) + GOES_ON_SHARE);
}

} // namespace steadyhand
