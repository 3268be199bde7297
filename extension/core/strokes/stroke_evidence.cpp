#include "strokes/stroke_evidence.h"

#include "base/parameters.h"
#include "signal/minimum_jerk.h"
#include "strokes/direction_density.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

using namespace parameters::strokes;

constexpr double GAMMA_FIVE_QUARTERS = 0.9064024770554771; ///< gamma(5/4)
constexpr double IMPOSSIBLE = -1e3;
constexpr double LEAST_SHARE = 0.01; ///< of a duration: a stroke of no length has no pace

/// Of the density of a normal whose deviation differs below and above its mode, 0.
double log_two_piece_normal(double x, double below, double above) {
	const double z = x / (x < 0.0 ? below : above);
	return -0.5 * z * z - std::log(0.5 * (below + above) * std::sqrt(2.0 * std::numbers::pi));
}

/// off: distance on the unit sphere from the axis.
double direction_in_the_open(double off) {
	return log_direction_ratio(off, DIRECTION);
}

/// The same where the axis is known: a normal.
double direction_in_task(double off) {
	return std::log(2.0 / (TASK_DIRECTION * TASK_DIRECTION)) -
			0.5 * off * off / (TASK_DIRECTION * TASK_DIRECTION);
}

/// Ways are as likely bowed by anything within BOW, and hardly beyond: exp(-(bow / BOW)^4) against the
/// uniform.
double bow_evidence(double bow) {
	const double square = bow * bow / (BOW * BOW);
	return std::log(LARGEST_BOW / (BOW * GAMMA_FIVE_QUARTERS)) - square * square;
}

/// stroke: of length_m > 0.
double straightness(const Stroke &stroke, double length_m) {
	const FeaturePlace chord = stroke.to - stroke.from;
	const FeaturePlace off = stroke.middle - 0.5 * (stroke.from + stroke.to);
	return bow_evidence((off - chord * (off.dot(chord) / (length_m * length_m))).norm() / length_m);
}

/// stroke: of length_m > 0.
double detour(const Stroke &stroke, double length_m) {
	return std::max(stroke.way_m / length_m - 1.0, 0.0);
}

/// stroke: of length_m > 0.
double usual_detour(const Stroke &stroke, double length_m) {
	return DETOUR + (DETOUR_M + DETOUR_M_S * (stroke.now_s - stroke.onset_s)) / length_m;
}

/// By how much less likely any hand goes such a detour than none, in nats, less the same of one that goes
/// astray.
double astray_evidence(double detour, double mean) {
	return 3.0 * std::log1p(detour / OTHER_DETOUR) - detour / (LARGE_DETOUR * mean);
}

double detour_evidence(double detour, double mean) {
	// The slower of the two exponentials is taken out, so that no detour is too long for a logarithm.
	const double plain = (1.0 - LARGE_DETOUR_SHARE) * std::exp(-detour / mean * (1.0 - 1.0 / LARGE_DETOUR));
	return std::log((plain + LARGE_DETOUR_SHARE / LARGE_DETOUR) / mean * 0.5 * OTHER_DETOUR) +
			astray_evidence(detour, mean);
}

double rest_evidence(const Stroke &stroke, double amplitude_m) {
	const double unrest = stroke.unrest_m / amplitude_m, still = UNREST + UNREST_M / amplitude_m;
	const double other = std::hypot(still, OTHER_UNREST_PER_S * stroke.watched_s);
	const double ratio = std::exp(-0.5 * unrest * unrest * (1.0 / (still * still) - 1.0 / (other * other)));
	return std::log((1.0 - NO_REST_SHARE) * ratio * other / still + NO_REST_SHARE) -
			REST_UNSEEN * (1.0 - stroke.watched_s / REST_S);
}

double size_evidence(double log_length, double log_time) {
	const double usual = std::exp(log_two_piece_normal(log_time, LOG_DURATION, LOG_DURATION)) * LOG_DURATIONS;
	return log_two_piece_normal(log_length, LOG_SHORTER, LOG_LONGER) + std::log(LOG_LENGTHS) +
			std::log((1.0 - ANY_PACE_SHARE) * usual + ANY_PACE_SHARE);
}

/// Of the way of a minimum jerk, that which is covered by the time that its speed has fallen to this share, 0
/// to 1, of its peak: 16 s^2 (1 - s)^2 at the share s of its duration.
double covered(double speed_share) {
	return minimum_jerk(0.5 + 0.5 * std::sqrt(1.0 - std::sqrt(speed_share))).value;
}

/// By which a stroke may go off the way at its end, as it has gone so far.
double best_off(double off, double length_m, double amplitude_m) {
	const double to_go = std::max(1.0 - length_m / amplitude_m, 0.0);
	return std::max(off - LATER_TURN * to_go * to_go, 0.0);
}

/// m: from where the gesture may begin - the task's start or, of a hand that comes into view, the first part
/// of its way, beyond which it is infinite - to where it began: as the tracker showed it then, or would show
/// it now, whichever is less. The tracker may have been displaced then, or may be now.
FeaturePlace off_start(
		const Stroke &stroke, const FeaturePlace &start, const FeaturePlace &way, double amplitude_m) {
	const auto off = [&](const FeaturePlace &from) -> FeaturePlace {
		const double along_m = (from - start).dot(way);
		const double unseen_m = stroke.is_from_rest ? 0.0 : std::max(along_m, 0.0);
		if (unseen_m > UNSEEN_PART * amplitude_m) {
			return FeaturePlace::Constant(INFINITY);
		}
		// A radius has no place.
		return way(3) != 0.0 ? FeaturePlace((along_m - unseen_m) * way)
							 : FeaturePlace(from - start - unseen_m * way);
	};
	const FeaturePlace now = off(stroke.from + stroke.shown_to - stroke.to), then = off(stroke.shown_from);
	return now.squaredNorm() < then.squaredNorm() ? now : then;
}

double start_evidence(const Stroke &stroke, const FeaturePlace &off_start_m, double amplitude_m) {
	return (stroke.is_from_rest ? LOG_STARTS : LOG_UNSEEN_STARTS - REST_UNSEEN) -
			0.5 * off_start_m.squaredNorm() / (START * START * amplitude_m * amplitude_m);
}

/// The way to the task's end of a hand that began beside its start: hands aim at ends.
FeaturePlace aim(const FeaturePlace &off_start_m, const FeaturePlace &way, double amplitude_m) {
	const FeaturePlace beside_m = off_start_m - off_start_m.dot(way) * way;
	return (amplitude_m * way - beside_m).normalized();
}

bool leads_somewhere(double length_m) {
	return length_m > 0.0 && std::isfinite(length_m);
}

} // namespace

StrokeEvidence stroke_evidence(const Stroke &stroke, const FeaturePlace &way, const UsualStroke &usual) {
	const double amplitude_m = usual.amplitude_m;
	const FeaturePlace chord = stroke.to - stroke.from;
	const double length_m = chord.norm(), time_s = stroke.now_s - stroke.onset_s;
	if (!leads_somewhere(length_m) || !(time_s > 0.0)) {
		return { .path = IMPOSSIBLE };
	}
	const double off = (chord / length_m - way).norm();
	const double direction = direction_in_the_open(off);
	StrokeEvidence evidence;
	evidence.path = direction + straightness(stroke, length_m);
	evidence.detour = detour_evidence(detour(stroke, length_m), usual_detour(stroke, length_m)) -
			(stroke.is_joined ? SEVERAL_STROKES : 0.0);
	evidence.rest = rest_evidence(stroke, amplitude_m);
	evidence.size = size_evidence(std::log(length_m / amplitude_m), std::log(time_s / usual.duration_s));
	evidence.outlook =
			direction_in_the_open(best_off(off, length_m, amplitude_m)) - direction + size_evidence(0.0, 0.0);
	return evidence;
}

double strike_evidence(const Stroke &stroke, const UsualStroke &usual) {
	if (!usual.is_strike) {
		return 0.0;
	}
	// Of a stroke that goes on, the duration of a minimum jerk that has come as far in the same time.
	const double share = minimum_jerk_share((stroke.to - stroke.from).norm() / usual.amplitude_m);
	const double duration_s = (stroke.now_s - stroke.onset_s) / std::max(share, LEAST_SHARE);
	const double slower = std::max(std::log(duration_s / usual.duration_s), 0.0) / SLOWER_STRIKE;
	return -slower * slower * slower * slower;
}

double return_evidence(const UsualStroke &usual, bool comes_back) {
	return std::log(2.0 * (comes_back == usual.is_strike ? USUAL_ENDING : 1.0 - USUAL_ENDING));
}

double shortfall(const Stroke &stroke, double speed_m_s, double amplitude_m) {
	const double share = speed_m_s / stroke.peak_m_s;
	if (!(share < SLOWING_SHARE)) {
		return 0.0;
	}
	const double longest_m = FURTHER * (stroke.to - stroke.from).norm() / covered(share);
	const double z = std::min(std::log(longest_m / amplitude_m), 0.0) / LOG_SHORTER;
	return std::log((1.0 - GOES_ON_SHARE) * std::exp(-0.5 * z * z) + GOES_ON_SHARE);
}

double most_evidence(const Stroke &stroke, const FeaturePlace &way, double amplitude_m) {
	const double at_most = bow_evidence(0.0) + detour_evidence(0.0, DETOUR) +
			std::log((1.0 - NO_REST_SHARE) * std::hypot(1.0, OTHER_UNREST_PER_S * REST_S / UNREST) +
					NO_REST_SHARE) +
			size_evidence(0.0, 0.0);
	const FeaturePlace chord = stroke.to - stroke.from;
	const double length_m = chord.norm();
	if (!leads_somewhere(length_m)) {
		return IMPOSSIBLE;
	}
	const double off = (chord / length_m - way).norm();
	// Of a detour that is long beside the tracker's error the null model's density may be the smaller one.
	const double more = astray_evidence(detour(stroke, length_m), usual_detour(stroke, length_m));
	return direction_in_the_open(best_off(off, length_m, amplitude_m)) + std::max(more, 0.0) + at_most;
}

double task_evidence(
		const Stroke &stroke, const FeaturePlace &start, const FeaturePlace &way, double amplitude_m) {
	const FeaturePlace chord = stroke.to - stroke.from, off_m = off_start(stroke, start, way, amplitude_m);
	const double length_m = chord.norm();
	if (!leads_somewhere(length_m) || !off_m.allFinite()) {
		return IMPOSSIBLE;
	}
	return direction_in_task((chord / length_m - aim(off_m, way, amplitude_m)).norm()) +
			straightness(stroke, length_m) + start_evidence(stroke, off_m, amplitude_m);
}

double most_task_evidence(
		const Stroke &stroke, const FeaturePlace &start, const FeaturePlace &way, double amplitude_m) {
	return direction_in_task(0.0) + bow_evidence(0.0) +
			start_evidence(stroke, off_start(stroke, start, way, amplitude_m), amplitude_m);
}

} // namespace steadyhand
