#include "minimum_jerk_drag.h"
#include "motion/gesture_recogniser.h"
#include "motion/phase_estimator.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace steadyhand;

// What `phase` mode makes of a hand that has made its gesture: it stays at its end, or leaves it.

namespace {

constexpr double PERIOD_S = 0.0125;

const std::shared_ptr<const GestureModel> &drag_model() {
	static const auto model = std::make_shared<const GestureModel>(test::trained_drag_model());
	return model;
}

} // namespace

TEST_CASE("a hand that comes back unseen is where the tracker finds it") {
	const test::Drag there{ .onset_s = 0.5, .duration_s = 0.5, .amplitude_m = 1.0 };
	const test::Drag back{ .onset_s = 1.3, .duration_s = 0.5, .amplitude_m = 1.0 };
	constexpr double LOST_S = 1.25, FOUND_S = 1.65, KNOWN_S = 0.1;
	for (const bool freezes : { false, true }) {
		for (const double faults : { 0.0, 0.3 }) { // seconds in which the tracker had been lost before
			CAPTURE(freezes);
			CAPTURE(faults);
			PhaseEstimator estimator(*drag_model());
			std::mt19937_64 random(5);
			std::normal_distribution<double> noise(0.0, 1e-3);
			double seen = 0.0;
			for (double t_s = 0.0; t_s < FOUND_S + KNOWN_S; t_s += PERIOD_S) {
				const bool lost = (t_s > LOST_S && t_s < FOUND_S) || (t_s > 0.1 && t_s < 0.1 + faults);
				seen = lost ? seen : there.x_m(t_s) - back.x_m(t_s) + noise(random);
				if (!lost || freezes) {
					estimator.push(t_s, seen);
				}
			}
			const double hand = 1.0 - back.x_m(FOUND_S + KNOWN_S);
			CHECK(estimator.at(FOUND_S + KNOWN_S).value == doctest::Approx(hand).epsilon(0.1));
		}
	}
}

TEST_CASE("a tracker that wanders, and loses the hand, throws none about that stays at its end") {
	constexpr double DEVIATION = 0.06, SETTLING_S = 0.5; // amplitudes
	const double kept = std::exp(-PERIOD_S / SETTLING_S);
	const Task task;
	double furthest = 0.0, furthest_shown = 0.0;
	for (unsigned seed = 140; seed < 210; ++seed) {
		const test::Drag drag{ .onset_s = 0.7, .duration_s = 0.4, .amplitude_m = task.amplitude_m };
		GestureRecogniser hmm({ drag_model() }, task, MotionMode::PHASE);
		std::mt19937_64 random(seed);
		std::normal_distribution<double> normal;
		double error = 0.0;
		for (double t_s = 0.0; t_s < 3.0; t_s += PERIOD_S) {
			error = kept * error + DEVIATION * std::sqrt(1.0 - kept * kept) * normal(random);
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, { drag.x_m(t_s) + task.amplitude_m * error, 0.0, 0.0 });
			if (!(t_s > 0.2 && t_s < 0.4) && !(t_s > 0.55 && t_s < 0.75)) {
				hmm.push(frame);
			}
			if (t_s > 1.6) {
				const double value = hmm.motion(MotionSource::SYNTHESISED).value_m / task.amplitude_m;
				furthest = std::max(furthest, std::abs(value - 1.0));
				furthest_shown = std::max(furthest_shown, std::abs(error));
			}
		}
	}
	CHECK(furthest < furthest_shown + 0.02);
}
