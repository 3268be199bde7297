#include "motion/gesture_filter.h"

#include "base/parameters.h"
#include "signal/critically_damped.h"
#include "signal/minimum_jerk.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// Of the lag, in a gesture of that duration.
double share_of_lag(double duration_s) {
	return duration_s / (duration_s + parameters::LAG_SETTLING_S);
}

} // namespace

DampedTransition::DampedTransition(double a, double dt_s) {
	const double fading = std::exp(-a * dt_s);
	xx = fading * (1.0 + a * dt_s);
	xv = fading * dt_s;
	vx = -fading * a * a * dt_s;
	vv = fading * (1.0 - a * dt_s);
	noise_xx = 1.0 - (xx * xx + xv * xv * a * a);
	noise_xv = -(xx * vx + xv * vv * a * a);
	noise_vv = a * a - (vx * vx + vv * vv * a * a);
}

double GestureFilter::deviation(TrackerMode tracker, double gone) {
	return tracker == TrackerMode::SOUND
			? parameters::DEVIATION
			: parameters::LAGGING_ERROR + parameters::LAGGING_ERROR_ON_WAY * std::clamp(gone, 0.0, 1.0);
}

double GestureFilter::deviation_rate_per_s(TrackerMode tracker) {
	return tracker == TrackerMode::SOUND ? parameters::DEVIATION_RATE_PER_S
										 : parameters::LAGGING_ERROR_RATE_PER_S;
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
	const double unit = 1.0 / deviation(tracker, 0.0);
	mean_(DEVIATION) = unit * from.x;
	mean_(DEVIATION_RATE) = unit * from.v;
	covariance_(DEVIATION, DEVIATION) = unit * unit * from.xx;
	covariance_(DEVIATION, DEVIATION_RATE) = covariance_(DEVIATION_RATE, DEVIATION) = unit * unit * from.xv;
	covariance_(DEVIATION_RATE, DEVIATION_RATE) = unit * unit * from.vv;
}

void GestureFilter::predict(const DampedTransition &by, double dt_s, double t_s) {
	kept_s_ = NAN;
	const double x = mean_(DEVIATION), v = mean_(DEVIATION_RATE);
	mean_(DEVIATION) = by.xx * x + by.xv * v;
	mean_(DEVIATION_RATE) = by.vx * x + by.vv * v;
	Vector column_x = by.xx * covariance_.col(DEVIATION) + by.xv * covariance_.col(DEVIATION_RATE);
	Vector column_v = by.vx * covariance_.col(DEVIATION) + by.vv * covariance_.col(DEVIATION_RATE);
	const double xx = by.xx * column_x(DEVIATION) + by.xv * column_x(DEVIATION_RATE) + by.noise_xx;
	const double xv = by.vx * column_x(DEVIATION) + by.vv * column_x(DEVIATION_RATE) + by.noise_xv;
	const double vv = by.vx * column_v(DEVIATION) + by.vv * column_v(DEVIATION_RATE) + by.noise_vv;
	column_x(DEVIATION) = xx;
	column_x(DEVIATION_RATE) = column_v(DEVIATION) = xv;
	column_v(DEVIATION_RATE) = vv;
	covariance_.col(DEVIATION) = column_x;
	covariance_.col(DEVIATION_RATE) = column_v;
	covariance_.row(DEVIATION) = column_x;
	covariance_.row(DEVIATION_RATE) = column_v;
	// As the log duration changes by e, the onset does by -(t - onset) e: the phase stays.
	const double shift = -std::max(t_s - mean_(ONSET), 0.0);
	const double walk = parameters::PACE_WALK * parameters::PACE_WALK * std::min(dt_s, 1.0);
	covariance_(ONSET, ONSET) += walk * shift * shift;
	covariance_(ONSET, LOG_DURATION) += walk * shift;
	covariance_(LOG_DURATION, ONSET) += walk * shift;
	covariance_(LOG_DURATION, LOG_DURATION) += walk;
}

GestureFilter::Prediction GestureFilter::measured(const ReferenceTable &curve, double t_s) const {
	const bool is_lagging = tracker_ == TrackerMode::LAGGING;
	const double rate = 1.0 / duration_s_, phase = (t_s - mean_(ONSET)) * rate;
	const CurvePoint hand = curve.at(phase);
	const double gone = std::clamp(hand.value, 0.0, 1.0), gone_slope = hand.value == gone ? hand.slope : 0.0;
	const double late = is_lagging ? share_of_lag(duration_s_) * rate * gone : 0.0;
	const double shown_phase = phase - mean_(LAG) * late;
	const CurvePoint own = is_lagging ? curve.at(shown_phase) : hand;
	const Polynomial::Point jerk = minimum_jerk(shown_phase);
	const double way = 1.0 + mean_(GAIN), f = own.value + mean_(SHAPE) * (jerk.value - own.value);
	const double slope = way * (own.slope + mean_(SHAPE) * (jerk.first - own.slope));
	const double unit = deviation(tracker_, gone);
	Prediction p;
	p.x = way * f + unit * mean_(DEVIATION);
	p.velocity = rate * own.slope;
	// By the phase without the lag, in which the lag and the error's size follow it.
	double by_phase = slope;
	if (is_lagging) {
		by_phase *= gone > 0.0 ? 1.0 - mean_(LAG) * late / gone * gone_slope : 1.0;
		by_phase += parameters::LAGGING_ERROR_ON_WAY * gone_slope * mean_(DEVIATION);
	}
	p.slope(ONSET) = -by_phase * rate;
	p.slope(LOG_DURATION) = -by_phase * phase +
			slope * mean_(LAG) * late * duration_s_ / (duration_s_ + parameters::LAG_SETTLING_S);
	p.slope(GAIN) = f;
	p.slope(SHAPE) = way * (jerk.value - own.value);
	p.slope(LAG) = -slope * late;
	p.slope(DEVIATION) = unit;
	p.covariance.noalias() = covariance_.leftCols<DEVIATION_RATE>() * p.slope.head<DEVIATION_RATE>();
	p.variance = p.covariance.dot(p.slope);
	return p;
}

const GestureFilter::Prediction &GestureFilter::keep_measured(const ReferenceTable &curve, double t_s) {
	if (kept_s_ != t_s) {
		kept_ = measured(curve, t_s);
		kept_s_ = t_s;
	}
	return kept_;
}

void GestureFilter::correct(const Prediction &prediction, const ElementReading &reading) {
	const double error = reading.x - prediction.x, variance = prediction.variance + reading.variance;
	const ReadingLikelihood likelihood(error, variance);
	weight *= std::pow(likelihood.density, reading.power);
	const Vector gain = prediction.covariance / variance;
	mean_ += likelihood.share * error * gain;
	covariance_.noalias() -= likelihood.reduction(error, variance) * gain * gain.transpose();
	duration_s_ = std::exp(mean_(LOG_DURATION));
	kept_s_ = NAN;
}

void GestureFilter::forget_error(double deviation) {
	const double unit = deviation / GestureFilter::deviation(tracker_, 0.0);
	const double rate = deviation_rate_per_s(tracker_);
	covariance_(DEVIATION, DEVIATION) += unit * unit;
	covariance_(DEVIATION_RATE, DEVIATION_RATE) += rate * rate;
	kept_s_ = NAN;
}

GestureFilter::Hand GestureFilter::hand(
		const ReferenceTable &curve, double t_s, double since_s, double fading) const {
	const double rate = 1.0 / duration_s_, phase = (t_s - mean_(ONSET)) * rate;
	const CurvePoint own = curve.at(phase);
	const Polynomial::Point jerk = minimum_jerk(phase);
	const double shape = mean_(SHAPE), way = 1.0 + mean_(GAIN);
	Hand hand{ way * (own.value + shape * (jerk.value - own.value)),
		way * rate * (own.slope + shape * (jerk.first - own.slope)),
		way * rate * rate * (own.curvature + shape * (jerk.second - own.curvature)),
		std::clamp(phase, 0.0, 1.0) };
	if (tracker_ == TrackerMode::SOUND) {
		const double unit = deviation(tracker_, 0.0);
		const CriticallyDamped d = critically_damped(unit * mean_(DEVIATION), unit * mean_(DEVIATION_RATE),
				deviation_rate_per_s(tracker_), since_s, fading);
		hand.value += d.value;
		hand.velocity += d.velocity;
		hand.acceleration += d.acceleration;
	}
	return hand;
}

} // namespace steadyhand
