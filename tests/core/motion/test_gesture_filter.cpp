#include "motion/gesture_filter.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace steadyhand;

// Positions in amplitudes. Oracles: finite differences, dense matrices and numerical integration.

namespace {

using Index = GestureFilter::Index;

constexpr double ONSET_S = 1.0, DURATION_S = 0.8;
constexpr double DEVIATION = 0.1;

const ReferenceTable &curve() {
	static const ReferenceTable table(test::drag_model());
	return table;
}

/// The filter with state i moved by almost `step`, by a correction with an artificial prediction.
GestureFilter moved(GestureFilter filter, int i, double step) {
	GestureFilter::Prediction prediction;
	prediction.variance = 0.5;
	prediction.covariance(i) = 1.0;
	filter.correct(prediction, { .x = step, .variance = 0.5 });
	return filter;
}

/// A filter with onset ONSET_S after two readings off its prediction. Its whole state differs from the prior.
GestureFilter gesture(TrackerMode tracker) {
	const HandState from{ .x = 0.02, .v = -0.1, .xx = 1e-4, .xv = 2e-5, .vv = 0.04 };
	GestureFilter filter(tracker,
			{ .t_s = ONSET_S,
					.deviation_s = 0.02,
					.log_duration = std::log(DURATION_S),
					.log_duration_deviation = 0.2,
					.gain_deviation = 0.05 },
			from);
	filter.weight = 0.3;
	double then_s = ONSET_S;
	for (const double t_s : { ONSET_S + 0.2, ONSET_S + 0.3 }) {
		const double dt_s = t_s - then_s;
		filter.predict({ DEVIATION, GestureFilter::deviation_rate_per_s(tracker), dt_s }, dt_s, t_s);
		const GestureFilter::Prediction p = filter.predict_measurement(curve(), t_s);
		filter.correct(p, { .t_s = t_s, .x = p.x + 0.05, .variance = 1e-4 });
		then_s = t_s;
	}
	return filter;
}

GestureFilter::Hand hand(const GestureFilter &filter, double from_s, double t_s) {
	const double since_s = t_s - from_s;
	return filter.hand(curve(), t_s, since_s,
			std::exp(-GestureFilter::deviation_rate_per_s(TrackerMode::SOUND) * since_s));
}

GestureFilter::Vector finite_differences(const GestureFilter &filter, double t_s) {
	constexpr double STEP = 1e-5;
	GestureFilter::Vector slope;
	for (int i = 0; i < GestureFilter::SIZE; ++i) {
		const GestureFilter less = moved(filter, i, -STEP), more = moved(filter, i, STEP);
		slope(i) = (more.predict_measurement(curve(), t_s).x - less.predict_measurement(curve(), t_s).x) /
				(more.mean()(i) - less.mean()(i));
	}
	return slope;
}

GestureFilter::Matrix dense_transition(const DampedTransition &by) {
	GestureFilter::Matrix f = GestureFilter::Matrix::Identity();
	f(Index::DEVIATION, Index::DEVIATION) = by.xx;
	f(Index::DEVIATION, Index::DEVIATION_VELOCITY) = by.xv;
	f(Index::DEVIATION_VELOCITY, Index::DEVIATION) = by.vx;
	f(Index::DEVIATION_VELOCITY, Index::DEVIATION_VELOCITY) = by.vv;
	return f;
}

Eigen::Matrix2d matrix(const DampedTransition &by) {
	return (Eigen::Matrix2d() << by.xx, by.xv, by.vx, by.vv).finished();
}

Eigen::Matrix2d noise(const DampedTransition &by) {
	return (Eigen::Matrix2d() << by.noise_xx, by.noise_xv, by.noise_xv, by.noise_vv).finished();
}

} // namespace

TEST_CASE("the slope of a prediction equals finite differences") {
	for (const TrackerMode tracker : { TrackerMode::SOUND, TrackerMode::LAGGING }) {
		const GestureFilter filter = gesture(tracker);
		for (const double phase : { -0.2, 0.1, 0.33, 0.5, 0.77, 0.95, 1.1, 1.3 }) {
			INFO("tracker ", static_cast<int>(tracker), ", phase ", phase);
			const double t_s = ONSET_S + phase * DURATION_S;
			const GestureFilter::Prediction p = filter.predict_measurement(curve(), t_s);
			CHECK((p.slope - finite_differences(filter, t_s)).norm() < 1e-5);
			CHECK((p.covariance - filter.covariance() * p.slope).norm() < 1e-15);
			CHECK(p.variance == doctest::Approx(p.slope.dot(filter.covariance() * p.slope)));
		}
	}
}

TEST_CASE("a gesture filter predicts as dense Kalman matrices do") {
	constexpr double DT_S = 0.017, T_S = ONSET_S + 0.3, PACE_STEP = 1e-6;
	for (const TrackerMode tracker : { TrackerMode::SOUND, TrackerMode::LAGGING }) {
		const GestureFilter before = gesture(tracker);
		GestureFilter after = before;
		const DampedTransition by(DEVIATION, GestureFilter::deviation_rate_per_s(tracker), DT_S);
		after.predict(by, DT_S, T_S);
		const GestureFilter::Matrix f = dense_transition(by);
		CHECK((after.mean() - f * before.mean()).norm() < 1e-12);

		GestureFilter::Matrix added = after.covariance() - f * before.covariance() * f.transpose();
		added(Index::DEVIATION, Index::DEVIATION) -= by.noise_xx;
		added(Index::DEVIATION, Index::DEVIATION_VELOCITY) -= by.noise_xv;
		added(Index::DEVIATION_VELOCITY, Index::DEVIATION) -= by.noise_xv;
		added(Index::DEVIATION_VELOCITY, Index::DEVIATION_VELOCITY) -= by.noise_vv;
		// The rest is the random walk of the pace. It has rank 1, and does not change the phase at T_S.
		const double pace = added(Index::LOG_DURATION, Index::LOG_DURATION);
		CHECK(pace > 0.0);
		GestureFilter::Vector along = GestureFilter::Vector::Zero();
		along(Index::ONSET) = -(T_S - before.onset_s());
		along(Index::LOG_DURATION) = 1.0;
		CHECK((added - pace * along * along.transpose()).norm() < 1e-12);
		const GestureFilter::Vector step = PACE_STEP * along;
		const double phase = (T_S - before.onset_s() - step(Index::ONSET)) /
				(before.duration_s() * std::exp(step(Index::LOG_DURATION)));
		CHECK(phase == doctest::Approx((T_S - before.onset_s()) / before.duration_s()).epsilon(1e-11));
	}
}

TEST_CASE("a gesture filter corrects as dense Kalman matrices do") {
	for (const TrackerMode tracker : { TrackerMode::SOUND, TrackerMode::LAGGING }) {
		for (const double error : { 0.0, 0.01, -0.1, 0.6 }) {
			CAPTURE(error);
			const GestureFilter before = gesture(tracker);
			GestureFilter after = before;
			const GestureFilter::Prediction p = before.predict_measurement(curve(), ONSET_S + 0.4);
			const ElementReading reading{ .t_s = ONSET_S + 0.4, .x = p.x + error, .variance = 4e-4 };
			after.correct(p, reading);

			// Moments of a mixture: no change if the reading is an outlier, otherwise a Kalman step in
			// Joseph's form.
			const double s = p.slope.dot(before.covariance() * p.slope) + reading.variance;
			const double share = ReadingLikelihood(error, s).inlier_probability;
			const GestureFilter::Vector k = before.covariance() * p.slope / s;
			const GestureFilter::Matrix keep = GestureFilter::Matrix::Identity() - k * p.slope.transpose();
			const GestureFilter::Matrix taken =
					keep * before.covariance() * keep.transpose() + reading.variance * k * k.transpose();
			const GestureFilter::Vector mean = before.mean() + share * error * k;
			const GestureFilter::Vector off_taken = before.mean() + error * k - mean;
			const GestureFilter::Vector off_outlier = before.mean() - mean;
			const GestureFilter::Matrix covariance = share * (taken + off_taken * off_taken.transpose()) +
					(1.0 - share) * (before.covariance() + off_outlier * off_outlier.transpose());
			CHECK((after.mean() - mean).norm() < 1e-12);
			CHECK((after.covariance() - covariance).norm() < 1e-12);
			CHECK(after.weight ==
					doctest::Approx(before.weight * ReadingLikelihood(error, s).density).epsilon(1e-9));
		}
	}
}

TEST_CASE("a reading with power 0.5 weighs as the likelihood's square root") {
	const GestureFilter before = gesture(TrackerMode::SOUND);
	const GestureFilter::Prediction p = before.predict_measurement(curve(), ONSET_S + 0.4);
	GestureFilter whole = before, half = before;
	whole.correct(p, { .x = p.x + 0.02, .variance = 1e-4, .power = 1.0 });
	half.correct(p, { .x = p.x + 0.02, .variance = 1e-4, .power = 0.5 });
	CHECK(half.weight / before.weight == doctest::Approx(std::sqrt(whole.weight / before.weight)));
}

TEST_CASE("the moments of the outlier mixture equal numerical integration") {
	constexpr double PRIOR_VARIANCE = 0.02, NOISE_VARIANCE = 0.005, STEP = 1e-4;
	// The two parts of the likelihood, from its density: far away only the outliers' part is left.
	const double outliers = ReadingLikelihood(1e3, 1.0).density;
	const auto normal = [](double x, double variance) {
		return std::exp(-0.5 * x * x / variance) / std::sqrt(2.0 * std::numbers::pi * variance);
	};
	const double sound = (ReadingLikelihood(0.0, 1.0).density - outliers) / normal(0.0, 1.0);
	for (const double z : { 0.0, 0.05, -0.2, 0.45, 0.6, 3.0 }) {
		CAPTURE(z);
		double weight = 0.0, mean = 0.0, square = 0.0;
		for (double x = -2.0; x < 2.0; x += STEP) {
			const double posterior =
					normal(x, PRIOR_VARIANCE) * (sound * normal(z - x, NOISE_VARIANCE) + outliers) * STEP;
			weight += posterior;
			mean += posterior * x;
			square += posterior * x * x;
		}
		mean /= weight;
		const double variance = PRIOR_VARIANCE + NOISE_VARIANCE, gain = PRIOR_VARIANCE / variance;
		const ReadingLikelihood likelihood(z, variance);
		CHECK(likelihood.density == doctest::Approx(weight).epsilon(1e-6));
		CHECK(std::abs(likelihood.inlier_probability * z * gain - mean) < 1e-6);
		CHECK(PRIOR_VARIANCE - likelihood.reduction(z, variance) * gain * gain ==
				doctest::Approx(square / weight - mean * mean).epsilon(1e-5));
	}
}

TEST_CASE("the transition of damped noise equals the numerical integral") {
	// x'' = -2 a x' - a^2 x + white noise of density 4 a^3, which makes the variance of x 1.
	for (const double a : { 4.6, 8.0 }) {
		for (const double dt_s : { 1e-4, 0.01, 0.3, 2.0 }) {
			CAPTURE(dt_s);
			constexpr int PIECES = 2000; // of Runge-Kutta's and of Simpson's rule
			const Eigen::Matrix2d rate = (Eigen::Matrix2d() << 0.0, 1.0, -a * a, -2.0 * a).finished();
			const double h = dt_s / PIECES;
			const Eigen::Matrix2d one = h * rate, identity = Eigen::Matrix2d::Identity();
			const Eigen::Matrix2d small =
					identity + one * (identity + one / 2.0 * (identity + one / 3.0 * (identity + one / 4.0)));
			Eigen::Matrix2d transition = identity, integral = Eigen::Matrix2d::Zero();
			for (int i = 0; i <= PIECES; ++i) {
				const double share = i == 0 || i == PIECES ? 1.0 : i % 2 == 0 ? 2.0 : 4.0;
				const Eigen::Vector2d response = transition.col(1);
				integral += 4.0 * a * a * a * share * h / 3.0 * response * response.transpose();
				transition = i < PIECES ? Eigen::Matrix2d(small * transition) : transition;
			}
			const DampedTransition exact(1.0, a, dt_s);
			CHECK((matrix(exact) - transition).norm() < 1e-9 * transition.norm());
			CHECK((noise(exact) - integral).norm() < 1e-6 * integral.norm());
		}
	}
}

TEST_CASE("with a SOUND tracker the hand is at the predicted measurement") {
	constexpr double STEP_S = 1e-5;
	const GestureFilter filter = gesture(TrackerMode::SOUND);
	for (const double phase : { 0.15, 0.4, 0.6, 0.9 }) {
		CAPTURE(phase);
		const double from_s = ONSET_S + phase * DURATION_S, t_s = from_s + 0.01;
		CHECK(std::abs(hand(filter, from_s, from_s).value - filter.predict_measurement(curve(), from_s).x) <
				1e-4);
		const GestureFilter::Hand before = hand(filter, from_s, t_s - STEP_S),
								  now = hand(filter, from_s, t_s), after = hand(filter, from_s, t_s + STEP_S);
		CHECK(std::abs(now.velocity - (after.value - before.value) / (2.0 * STEP_S)) < 1e-4);
		CHECK(std::abs(now.acceleration - (after.velocity - before.velocity) / (2.0 * STEP_S)) < 0.01);
	}
}

TEST_CASE("a LAGGING tracker is behind a moving hand, not a resting one") {
	const GestureFilter filter(TrackerMode::LAGGING,
			{ .t_s = ONSET_S,
					.deviation_s = 0.02,
					.log_duration = std::log(DURATION_S),
					.log_duration_deviation = 0.2,
					.gain_deviation = 0.05 },
			{});
	const auto ahead = [&](double phase) {
		const double t_s = ONSET_S + phase * DURATION_S;
		return hand(filter, t_s, t_s).value - filter.predict_measurement(curve(), t_s).x;
	};
	CHECK(ahead(-0.1) == 0.0);
	CHECK(ahead(0.5) > 0.02);
	CHECK(std::abs(ahead(1.5)) < 1e-3);
}
