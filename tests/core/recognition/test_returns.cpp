// Motion of `phase` mode when a hand returns from its endpoint or stays there.

#include "gesture_events.h"
#include "monitored_estimator.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double PERIOD_S = 0.0125;

} // namespace

TEST_CASE("drags with dropouts and freezes end, with less error than the data") {
	constexpr int DRAGS = 6;
	constexpr double LATE_S = 0.04;
	std::vector<Drag> rounds; // with rests of half a second
	for (int i = 0; i < DRAGS; ++i) {
		rounds.push_back({ 2.5 * i + 0.5, 0.8, 0.2 });
		rounds.push_back({ 2.5 * i + 1.8, 0.7, -0.2 });
	}
	double error = 0.0, raw_error = 0.0; // sums of squares
	for (unsigned seed = 0; seed < 6; ++seed) {
		CAPTURE(seed);
		GestureRecogniser recogniser({ { shared_drag_model(), Task{} } });
		std::mt19937_64 random(seed);
		std::uniform_real_distribution<double> uniform;
		Tremor tremor(2e-4, seed);
		double lost_until_s = 0.0, seen_m = 0.0;
		bool freezes = false;
		ShownChanges shown;
		int ended = 0;
		for (int i = 0; i * PERIOD_S < 2.5 * DRAGS + 0.5; ++i) {
			const double t_s = i * PERIOD_S;
			if (t_s > lost_until_s && uniform(random) < 0.6 * PERIOD_S) {
				lost_until_s = t_s + 0.1 + 0.3 * uniform(random);
				freezes = !freezes;
			}
			const bool is_lost = t_s < lost_until_s;
			seen_m = is_lost ? seen_m : x_m(rounds, t_s - LATE_S) + tremor().x();
			if (!is_lost || freezes) {
				HandFrame frame;
				frame.t_s = t_s;
				frame.set(Joint::INDEX, seen_m * X);
				recogniser.push(frame);
			}
			recogniser.advance(t_s);
			ended += shown.next(recogniser).ended ? 1 : 0;
			error += std::pow(recogniser.motion(MotionSource::SYNTHESISED).value_m - x_m(rounds, t_s), 2);
			raw_error += std::pow(seen_m - x_m(rounds, t_s), 2);
		}
		CHECK(ended == DRAGS);
	}
	CHECK(error < raw_error);
}

TEST_CASE("after a return in a dropout the value is right within 0.1 s") {
	const std::vector<Drag> there_and_back{ { 0.5, 0.5, 1.0 }, { 1.3, 0.5, -1.0 } };
	constexpr double LOST_S = 1.25, FOUND_S = 1.65, KNOWN_S = 0.1;
	for (const bool freezes : { false, true }) {
		for (const double faults : { 0.0, 0.3 }) { // length of an earlier dropout, s
			INFO("freezes ", freezes, ", faults ", faults);
			MonitoredEstimator estimator(drag_model());
			Tremor tremor(1e-3, 5);
			double seen = 0.0;
			for (int i = 0; i * PERIOD_S < FOUND_S + KNOWN_S; ++i) {
				const double t_s = i * PERIOD_S;
				const bool lost = (t_s > LOST_S && t_s < FOUND_S) || (t_s > 0.1 && t_s < 0.1 + faults);
				seen = lost ? seen : x_m(there_and_back, t_s) + tremor().x();
				if (!lost || freezes) {
					estimator.push(t_s, seen);
				}
			}
			const double hand = x_m(there_and_back, FOUND_S + KNOWN_S);
			CHECK(std::abs(estimator.at(FOUND_S + KNOWN_S).value - hand) < 0.03);
		}
	}
}

TEST_CASE("after a return a hand at rest stays at 0 despite rounding") {
	const std::vector<Drag> there_and_back{ { 0.6, 0.8, 1.0 }, { 1.9, 0.4, -1.0 } };
	for (const double rate_hz : { 60.0, 90.0 }) {
		for (const double rounded_to : { 0.0, 0.005 }) { // amplitudes
			INFO("rate ", rate_hz, ", rounded to ", rounded_to);
			MonitoredEstimator estimator(drag_model());
			double furthest = 0.0;
			for (int i = 0; i < rate_hz * 6.3; ++i) {
				const double t_s = i / rate_hz, x = x_m(there_and_back, t_s);
				estimator.wait(t_s);
				estimator.push(t_s, rounded_to > 0.0 ? rounded_to * std::round(x / rounded_to) : x);
				furthest = t_s > 2.6 ? std::max(furthest, estimator.at(t_s).value) : 0.0;
			}
			CHECK(furthest < 0.05);
		}
	}
}

TEST_CASE("a return after a dwell is followed at any quality") {
	for (const Quality quality : { Quality::FAST, Quality::BALANCED, Quality::ACCURATE }) {
		for (const double rest_s : { 0.7, 1.4 }) {
			for (const double back_s : { 0.25, 0.4 }) {
				INFO("quality ", static_cast<int>(quality), ", rest ", rest_s, ", back ", back_s);
				const std::vector<Drag> strokes{ { 1.0, 1.6, 0.28 }, { 2.6 + rest_s, back_s, -0.28 } };
				GestureRecogniser recogniser({ { shared_drag_model(), Task{ 0.0 * X, X, 0.28 } } },
						{ .hypotheses = hypotheses_of(quality) });
				const Events events = watch(
						recogniser, along(X, strokes), 4.1 + rest_s, { .rate_hz = 60.0, .noise_m = 0.0 });
				CHECK(std::abs(events.last_value_m) < 1e-3);
				CHECK(recogniser.gesture() == -1);
			}
		}
	}
}
