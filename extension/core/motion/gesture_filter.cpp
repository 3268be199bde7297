#include "motion/gesture_filter.h"

#include "base/parameters.h"
#include "signal/critically_damped.h"
#include "signal/minimum_jerk.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// Share of the lag that builds up in a gesture, divided by its duration, 1/s.
double lag_build_up_per_s(double duration_s) {
	return 1.0 / (duration_s + parameters::LAG_SETTLING_S);
}

} // namespace

DampedTransition::DampedTransition(double deviation, double a, double dt_s) {
	const double fading = std::exp(-a * dt_s), variance = deviation * deviation;
	xx = fading * (1.0 + a * dt_s);
	xv = fading * dt_s;
	vx = -fading * a * a * dt_s;
	vv = fading * (1.0 - a * dt_s);
	noise_xx = variance * (1.0 - (xx * xx + xv * xv * a * a));
	noise_xv = -variance * (xx * vx + xv * vv * a * a);
	noise_vv = variance * (a * a - (vx * vx + vv * vv * a * a));
}

GestureFilter::GestureFilter(TrackerMode tracker, const Onset &onset, const HandState &from) :
		tracker_(tracker) {
	const auto set = [&](Index i, double mean, double deviation) {
		mean_(i) = mean;
		covariance_(i, i) = deviation * deviation;
	};
	set(ONSET, onset.t_s, onset.deviation_s);
	set(LOG_DURATION, onset.log_duration, onset.log_duration_deviation);
	set(GAIN, 0.0, onset.gain_deviation);
	set(SHAPE, parameters::SHAPE_MEAN, parameters::SHAPE_SPREAD);
	duration_s_ = std::exp(onset.log_duration);
	if (tracker == TrackerMode::LAGGING) {
		set(LAG, parameters::LAG_S, parameters::LAG_SPREAD_S);
	}
	mean_(DEVIATION) = from.x;
	mean_(DEVIATION_VELOCITY) = from.v;
	covariance_(DEVIATION, DEVIATION) = from.xx;
	covariance_(DEVIATION, DEVIATION_VELOCITY) = covariance_(DEVIATION_VELOCITY, DEVIATION) = from.xv;
	covariance_(DEVIATION_VELOCITY, DEVIATION_VELOCITY) = from.vv;
}

void GestureFilter::predict(const DampedTransition &by, double dt_s, double t_s) {
	cached_s_ = NAN;
	const double x = mean_(DEVIATION), v = mean_(DEVIATION_VELOCITY);
	mean_(DEVIATION) = by.xx * x + by.xv * v;
	mean_(DEVIATION_VELOCITY) = by.vx * x + by.vv * v;
	Vector column_x = by.xx * covariance_.col(DEVIATION) + by.xv * covariance_.col(DEVIATION_VELOCITY);
	Vector column_v = by.vx * covariance_.col(DEVIATION) + by.vv * covariance_.col(DEVIATION_VELOCITY);
	const double xx = by.xx * column_x(DEVIATION) + by.xv * column_x(DEVIATION_VELOCITY) + by.noise_xx;
	const double xv = by.vx * column_x(DEVIATION) + by.vv * column_x(DEVIATION_VELOCITY) + by.noise_xv;
	const double vv = by.vx * column_v(DEVIATION) + by.vv * column_v(DEVIATION_VELOCITY) + by.noise_vv;
	column_x(DEVIATION) = xx;
	column_x(DEVIATION_VELOCITY) = column_v(DEVIATION) = xv;
	column_v(DEVIATION_VELOCITY) = vv;
	covariance_.col(DEVIATION) = column_x;
	covariance_.col(DEVIATION_VELOCITY) = column_v;
	covariance_.row(DEVIATION) = column_x;
	covariance_.row(DEVIATION_VELOCITY) = column_v;
	// A change e of the log duration changes the onset by -(t - onset) e. The phase at t stays the same.
	const double shift = -std::max(t_s - mean_(ONSET), 0.0);
	const double walk = parameters::PACE_WALK * parameters::PACE_WALK * std::min(dt_s, 1.0);
	covariance_(ONSET, ONSET) += walk * shift * shift;
	covariance_(ONSET, LOG_DURATION) += walk * shift;
	covariance_(LOG_DURATION, ONSET) += walk * shift;
	covariance_(LOG_DURATION, LOG_DURATION) += walk;
}

GestureFilter::Prediction GestureFilter::predict_measurement(const ReferenceTable &curve, double t_s) const {
	const bool is_lagging = tracker_ == TrackerMode::LAGGING;
	const double rate = 1.0 / duration_s_, phase = (t_s - mean_(ONSET)) * rate;
	const CurvePoint hand = curve.at(phase);
	const double progress = std::clamp(hand.value, 0.0, 1.0),
				 progress_slope = hand.value == progress ? hand.slope : 0.0;
	const double lag_rate = is_lagging ? lag_build_up_per_s(duration_s_) : 0.0;
	const double lag_slope = lag_rate * progress; // phase by which the tracker is behind, per second of lag
	const double shown_phase = phase - mean_(LAG) * lag_slope;
	const CurvePoint own = is_lagging ? curve.at(shown_phase) : hand;
	const Polynomial::Point jerk = minimum_jerk(shown_phase);
	const double amplitude = 1.0 + mean_(GAIN), f = own.value + mean_(SHAPE) * (jerk.value - own.value);
	const double slope = amplitude * (own.slope + mean_(SHAPE) * (jerk.first - own.slope));
	Prediction p;
	p.x = amplitude * f + mean_(DEVIATION);
	p.velocity = rate * own.slope;
	// d x / d phase. The lag depends on the phase too.
	const double by_phase = slope * (1.0 - mean_(LAG) * lag_rate * progress_slope);
	p.slope(ONSET) = -by_phase * rate;
	p.slope(LOG_DURATION) = -by_phase * phase + slope * mean_(LAG) * lag_slope * lag_rate * duration_s_;
	p.slope(GAIN) = f;
	p.slope(SHAPE) = amplitude * (jerk.value - own.value);
	p.slope(LAG) = -slope * lag_slope;
	p.slope(DEVIATION) = 1.0;
	p.covariance.noalias() = covariance_.leftCols<DEVIATION_VELOCITY>() * p.slope.head<DEVIATION_VELOCITY>();
	p.variance = p.covariance.dot(p.slope);
	return p;
}

const GestureFilter::Prediction &GestureFilter::cached_prediction(const ReferenceTable &curve, double t_s) {
	if (cached_s_ != t_s) {
		cached_ = predict_measurement(curve, t_s);
		cached_s_ = t_s;
	}
	return cached_;
}

void GestureFilter::correct(const Prediction &prediction, const ElementReading &reading) {
	const double error = reading.x - prediction.x, variance = prediction.variance + reading.variance;
	const ReadingLikelihood likelihood(error, variance);
	weight *= std::pow(likelihood.density, reading.power);
	const Vector gain = prediction.covariance / variance;
	mean_ += likelihood.inlier_probability * error * gain;
	covariance_.noalias() -= likelihood.reduction(error, variance) * gain * gain.transpose();
	duration_s_ = std::exp(mean_(LOG_DURATION));
	cached_s_ = NAN;
}

void GestureFilter::widen_error() {
	const double error = deviation(tracker_), velocity = deviation_rate_per_s(tracker_) * error;
	covariance_(DEVIATION, DEVIATION) += error * error;
	covariance_(DEVIATION_VELOCITY, DEVIATION_VELOCITY) += velocity * velocity;
	cached_s_ = NAN;
}

GestureFilter::Hand GestureFilter::hand(
		const ReferenceTable &curve, double t_s, double since_s, double fading) const {
	const double rate = 1.0 / duration_s_, phase = (t_s - mean_(ONSET)) * rate;
	const CurvePoint own = curve.at(phase);
	const Polynomial::Point jerk = minimum_jerk(phase);
	const double shape = mean_(SHAPE), amplitude = 1.0 + mean_(GAIN);
	Hand hand{ amplitude * (own.value + shape * (jerk.value - own.value)),
		amplitude * rate * (own.slope + shape * (jerk.first - own.slope)),
		amplitude * rate * rate * (own.curvature + shape * (jerk.second - own.curvature)),
		std::clamp(phase, 0.0, 1.0) };
	if (tracker_ == TrackerMode::SOUND) {
		const CriticallyDamped d = critically_damped(
				mean_(DEVIATION), mean_(DEVIATION_VELOCITY), deviation_rate_per_s(tracker_), since_s, fading);
		hand.value += d.value;
		hand.velocity += d.velocity;
		hand.acceleration += d.acceleration;
	}
	return hand;
}

} // namespace steadyhand
