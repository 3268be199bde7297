#include "motion/stroke_evidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

// Set on synthetic subjects of the tuning population.
constexpr double ANGLE = 0.14; ///< radians, each of two: aim and the tracker's error
constexpr double BOW = 0.05;   ///< mean distance from the chord, in its lengths; half-normal
constexpr double LARGEST_BOW = 0.5;
constexpr double LOG_SHORTER = 0.2; ///< of the logarithm of length / amplitude
constexpr double LOG_LONGER = 0.5;  ///< a hand that reaches further than it was asked is common
constexpr double LOG_LENGTHS = 3.7; ///< the null model's: 5 % to twice the amplitude
constexpr double LOG_DURATION = 0.7;
constexpr double LOG_DURATIONS = 3.9; ///< 0.1 to 5 s
constexpr double START = 0.12;        ///< amplitudes: how far from a task's start a hand begins
/// A normal of that deviation at its peak, against a ball of 1.5 amplitudes anywhere in which a hand may
/// begin: log((4/3) pi 1.5^3 / ((2 pi)^1.5 0.12^3)).
constexpr double LOG_STARTS = 6.25;
constexpr double IMPOSSIBLE = -1e3;

/// Of the density of a normal whose deviation differs below and above its mode, 0.
double log_two_piece_normal(double x, double below, double above) {
	const double z = x / (x < 0.0 ? below : above);
	return -0.5 * z * z - std::log(0.5 * (below + above) * std::sqrt(2.0 * std::numbers::pi));
}

double size_evidence(double log_length, double log_time) {
	return log_two_piece_normal(log_length, LOG_SHORTER, LOG_LONGER) + std::log(LOG_LENGTHS) +
			log_two_piece_normal(log_time, LOG_DURATION, LOG_DURATION) + std::log(LOG_DURATIONS);
}

} // namespace

StrokeEvidence stroke_evidence(
		const Stroke &stroke, const FeaturePlace &way, double amplitude_m, double duration_s) {
	const FeaturePlace chord = stroke.to - stroke.from;
	const double length_m = chord.norm(), time_s = stroke.now_s - stroke.onset_s;
	if (!(length_m > 0.0) || !(time_s > 0.0) || !std::isfinite(length_m)) {
		return { IMPOSSIBLE, 0.0 };
	}
	const double angle = std::acos(std::clamp(chord.dot(way) / length_m, -1.0, 1.0));
	// A wrapped normal on the sphere against the uniform 1 / (4 pi).
	const double direction = std::log(2.0 / (ANGLE * ANGLE)) - 0.5 * angle * angle / (ANGLE * ANGLE);
	const FeaturePlace off = stroke.middle - 0.5 * (stroke.from + stroke.to);
	const double bow = (off - chord * (off.dot(chord) / (length_m * length_m))).norm() / length_m;
	const double straightness = std::log(2.0) + log_two_piece_normal(bow, BOW, BOW) + std::log(LARGEST_BOW);
	const double log_length = std::log(length_m / amplitude_m);
	const double log_time = std::log(time_s / duration_s);
	return { direction + straightness, size_evidence(log_length, log_time) };
}

double largest_size_evidence() {
	return size_evidence(0.0, 0.0);
}

double task_evidence(
		const Stroke &stroke, const FeaturePlace &start, const FeaturePlace &way, double amplitude_m) {
	FeaturePlace off = (stroke.from - start) / amplitude_m;
	if (way(3) != 0.0) {
		off = way * off.dot(way); // a radius has no place
	}
	return stroke_evidence(stroke, way, amplitude_m, 1.0).path - 0.5 * off.squaredNorm() / (START * START) +
			LOG_STARTS;
}

} // namespace steadyhand
