// Motion of `phase` mode when a hand returns from its endpoint or stays there.

#include "minimum_jerk_drag.h"
#include "monitored_estimator.h"
#include "recognition/gesture_recogniser.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace steadyhand;

namespace {

constexpr double PERIOD_S = 0.0125;

/// Six drags and returns with rests of half a second.
struct Round {
	static constexpr int DRAGS = 6;
	static constexpr double THERE_S = 0.8, BACK_S = 0.7, REST_S = 0.5;
	static constexpr double LENGTH_S = THERE_S + BACK_S + 2.0 * REST_S;
	static constexpr double ALL_S = DRAGS * LENGTH_S + REST_S;

	static double x(double t_s) {
		const double in_round_s = std::fmod(t_s, LENGTH_S);
		const test::Drag there{ .onset_s = REST_S, .duration_s = THERE_S, .amplitude_m = 1.0 };
		const test::Drag back{ .onset_s = 2.0 * REST_S + THERE_S, .duration_s = BACK_S, .amplitude_m = 1.0 };
		return there.x_m(in_round_s) - back.x_m(in_round_s);
	}
};

} // namespace

TEST_CASE("drags with dropouts and freezes end, with less error than the data") {
	constexpr double LATE_S = 0.04;
	const Task task;
	double missing = 0.0, missing_shown = 0.0; // sums of squares
	for (unsigned seed = 0; seed < 6; ++seed) {
		CAPTURE(seed);
		GestureRecogniser hmm({ test::shared_drag_model() }, task, MotionMode::PHASE);
		std::mt19937_64 random(seed);
		std::uniform_real_distribution<double> uniform;
		std::normal_distribution<double> noise(0.0, 1e-3);
		double lost_until_s = 0.0, shown = 0.0;
		bool freezes = false;
		int arrivals = 0;
		GestureSession::Stage stage = GestureSession::Stage::IDLE;
		for (int i = 0; i * PERIOD_S < Round::ALL_S; ++i) {
			const double t_s = i * PERIOD_S;
			if (t_s > lost_until_s && uniform(random) < 0.6 * PERIOD_S) {
				lost_until_s = t_s + 0.1 + 0.3 * uniform(random);
				freezes = !freezes;
			}
			const bool lost = t_s < lost_until_s;
			shown = lost ? shown : Round::x(std::max(t_s - LATE_S, 0.0)) + noise(random);
			if (!lost || freezes) {
				HandFrame frame;
				frame.t_s = t_s;
				frame.set(Joint::INDEX, { task.amplitude_m * shown, 0.0, 0.0 });
				hmm.push(frame);
			}
			hmm.advance(t_s);
			const double hand = Round::x(t_s);
			const double value = hmm.motion(MotionSource::SYNTHESISED).value_m / task.amplitude_m;
			missing += (value - hand) * (value - hand);
			missing_shown += (shown - hand) * (shown - hand);
			const GestureSession::Stage now =
					hmm.session() != nullptr ? hmm.session()->stage() : GestureSession::Stage::IDLE;
			arrivals += now != stage && now == GestureSession::Stage::ENDED ? 1 : 0;
			stage = now;
		}
		CHECK(arrivals == Round::DRAGS);
	}
	CHECK(missing < missing_shown);
}

TEST_CASE("after a return in a dropout the value is right within 0.1 s") {
	const test::Drag there{ .onset_s = 0.5, .duration_s = 0.5, .amplitude_m = 1.0 };
	const test::Drag back{ .onset_s = 1.3, .duration_s = 0.5, .amplitude_m = 1.0 };
	constexpr double LOST_S = 1.25, FOUND_S = 1.65, KNOWN_S = 0.1;
	for (const bool freezes : { false, true }) {
		for (const double faults : { 0.0, 0.3 }) { // length of an earlier dropout, s
			CAPTURE(freezes);
			CAPTURE(faults);
			test::MonitoredEstimator estimator(*test::shared_drag_model());
			std::mt19937_64 random(5);
			std::normal_distribution<double> noise(0.0, 1e-3);
			double seen = 0.0;
			for (int i = 0; i * PERIOD_S < FOUND_S + KNOWN_S; ++i) {
				const double t_s = i * PERIOD_S;
				const bool lost = (t_s > LOST_S && t_s < FOUND_S) || (t_s > 0.1 && t_s < 0.1 + faults);
				seen = lost ? seen : there.x_m(t_s) - back.x_m(t_s) + noise(random);
				if (!lost || freezes) {
					estimator.push(t_s, seen);
				}
			}
			const double hand = 1.0 - back.x_m(FOUND_S + KNOWN_S);
			CHECK(std::abs(estimator.at(FOUND_S + KNOWN_S).value - hand) < 0.03);
		}
	}
}

TEST_CASE("after a return a hand at rest stays at 0 despite rounding") {
	constexpr double RESTS_S = 4.0;
	for (const double rate_hz : { 60.0, 90.0 }) {
		for (const double rounded_to : { 0.0, 0.005 }) { // amplitudes
			CAPTURE(rate_hz);
			CAPTURE(rounded_to);
			const test::Drag there{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 1.0 };
			const test::Drag back{ .onset_s = 1.9, .duration_s = 0.4, .amplitude_m = -1.0 };
			const double rests_from_s = back.onset_s + back.duration_s;
			test::MonitoredEstimator estimator(test::drag_model());
			double furthest = 0.0;
			for (int i = 0; i < rate_hz * (rests_from_s + RESTS_S); ++i) {
				const double t_s = i / rate_hz, x = there.x_m(t_s) + back.x_m(t_s);
				estimator.wait(t_s);
				estimator.push(t_s, rounded_to > 0.0 ? rounded_to * std::round(x / rounded_to) : x);
				furthest = t_s > rests_from_s + 0.3 ? std::max(furthest, estimator.at(t_s).value) : 0.0;
			}
			CHECK(furthest < 0.05);
		}
	}
}

TEST_CASE("a return after a dwell is followed at any quality") {
	for (const Quality quality : { Quality::FAST, Quality::BALANCED, Quality::ACCURATE }) {
		for (const double rest_s : { 0.7, 1.4 }) {
			for (const double back_s : { 0.25, 0.4 }) {
				CAPTURE(static_cast<int>(quality));
				CAPTURE(rest_s);
				CAPTURE(back_s);
				const test::Drag there{ .onset_s = 1.0, .duration_s = 1.6, .amplitude_m = 0.28 };
				const test::Drag back{ .onset_s = 2.6 + rest_s, .duration_s = back_s, .amplitude_m = 0.28 };
				GestureRecogniser recogniser({ test::shared_drag_model() },
						Task{ Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.28 }, MotionMode::PHASE,
						estimator_effort(quality));
				for (int i = 0; i < static_cast<int>(60.0 * (back.onset_s + 1.5)); ++i) {
					HandFrame frame;
					frame.t_s = i / 60.0;
					frame.set(Joint::INDEX, { there.x_m(frame.t_s) - back.x_m(frame.t_s), 0.0, 0.0 });
					recogniser.push(frame);
				}
				CHECK(std::abs(recogniser.motion(MotionSource::SYNTHESISED).value_m) < 1e-3);
				CHECK(recogniser.gesture() == -1);
			}
		}
	}
}
