// What the phase estimator counts once, remembers, and forgets.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "phase/phase_estimator.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace steadyhand;

// Values in amplitudes, as the estimator has them.

namespace {

constexpr double PERIOD_S = 0.009;
constexpr test::Drag DRAG{ .onset_s = 0.5, .duration_s = 0.8, .amplitude_m = 1.0 };

bool same(const PhaseEstimate &a, const PhaseEstimate &b) {
	return a.value == b.value && a.velocity == b.velocity && a.acceleration == b.acceleration &&
			a.phase == b.phase && a.moving == b.moving && a.correction == b.correction;
}

/// Frames of a drag before a sensor that trembles, as `error` shifts them.
void show(
		PhaseEstimator &r_estimator, double from_s, double to_s,
		const std::function<double(double t_s)> &error = [](double) { return 0.0; }) {
	for (int i = static_cast<int>(std::ceil(from_s / PERIOD_S)); i * PERIOD_S < to_s; ++i) {
		const double t_s = i * PERIOD_S;
		r_estimator.push(t_s, DRAG.x_m(t_s) + error(t_s) + 1e-3 * std::sin(7.0 * i * i));
	}
}

} // namespace

TEST_CASE("a gap that is waited through is one fault, in however many steps it was noticed") {
	for (const double gap_s : { 0.045, 0.06, 0.09 }) {
		for (const double lost_s : { 0.75, 0.85, 0.95 }) {
			CAPTURE(gap_s);
			CAPTURE(lost_s);
			PhaseEstimator unaware(test::drag_model()), once(test::drag_model()), often(test::drag_model());
			for (PhaseEstimator *const estimator : { &unaware, &once, &often }) {
				show(*estimator, 0.0, lost_s);
			}
			once.wait(lost_s + gap_s - PERIOD_S);
			for (int ms = 0; 0.001 * ms < gap_s - PERIOD_S; ++ms) {
				often.wait(lost_s + 0.001 * ms);
			}
			often.wait(lost_s + gap_s - PERIOD_S);
			const double still_s = lost_s + gap_s + 0.1; // what is blended in has not gone yet
			CHECK(often.at(still_s).phase == test::near(once.at(still_s).phase).epsilon(1e-4));
			for (PhaseEstimator *const estimator : { &unaware, &once, &often }) {
				show(*estimator, lost_s + gap_s, lost_s + gap_s + 2.5 * PERIOD_S);
			}
			CHECK(once.at(still_s).phase == test::near(unaware.at(still_s).phase).epsilon(2e-4));
			CHECK(often.at(still_s).phase == test::near(unaware.at(still_s).phase).epsilon(2e-4));
		}
	}
}

TEST_CASE("what was reset is as made, whatever it had seen, and whenever it begins again") {
	const auto jump = [](double t_s) { return t_s > 0.9 ? -0.3 : 0.0; };
	const auto freeze = [](double t_s) { return t_s > 0.9 ? DRAG.x_m(0.9) - DRAG.x_m(t_s) : 0.0; };
	for (const auto &error : { std::function<double(double)>(jump), std::function<double(double)>(freeze) }) {
		for (const double from_s : { 0.0, 1.2 }) {
			CAPTURE(from_s);
			PhaseEstimator used(test::drag_model()), made(test::drag_model());
			show(used, 0.0, 1.0, error);
			used.wait(1.15);
			used.reset();
			CHECK(same(used.at(1.15), PhaseEstimate{}));
			for (PhaseEstimator *const estimator : { &used, &made }) {
				estimator->push(from_s, 0.2);
			}
			CHECK(same(used.at(from_s), made.at(from_s)));
			for (PhaseEstimator *const estimator : { &used, &made }) {
				estimator->wait(from_s + 0.06);
			}
			for (int i = 0; i < 100; ++i) {
				const double t_s = from_s + 0.07 + i * PERIOD_S;
				for (PhaseEstimator *const estimator : { &used, &made }) {
					estimator->push(t_s, DRAG.x_m(i * PERIOD_S + 0.2));
				}
				REQUIRE(same(used.at(t_s + 0.004), made.at(t_s + 0.004)));
			}
		}
	}
}

TEST_CASE("a restart moves nothing, and what the hand does it goes on doing") {
	for (const double restart_s : { 0.8, 0.9, 1.0 }) {
		CAPTURE(restart_s);
		PhaseEstimator estimator(test::drag_model());
		show(estimator, 0.0, restart_s);
		const PhaseEstimate before = estimator.at(restart_s);
		estimator.restart(restart_s);
		const PhaseEstimate after = estimator.at(restart_s);
		CHECK(after.value == test::near(before.value));
		CHECK(after.velocity == test::near(before.velocity));
		const double later_s = restart_s + 0.05;
		show(estimator, restart_s, later_s);
		CHECK(std::abs(estimator.at(later_s).value - DRAG.x_m(later_s)) < 0.02);
		CHECK(estimator.at(later_s).moving < 0.1); // nothing has begun
	}
}

TEST_CASE("a frame that is told again within an instant is the one it was") {
	PhaseEstimator once(test::drag_model()), twice(test::drag_model());
	for (int i = 0; i < 120; ++i) {
		const double t_s = i * PERIOD_S, x = DRAG.x_m(t_s) + 1e-3 * std::sin(7.0 * i * i);
		once.push(t_s, x);
		twice.push(t_s, x);
		twice.push(t_s + 1e-5, x);
		const double later_s = t_s + 0.5 * PERIOD_S;
		REQUIRE(twice.at(later_s).value == test::near(once.at(later_s).value).epsilon(1e-4));
		REQUIRE(twice.at(later_s).phase == test::near(once.at(later_s).phase).epsilon(1e-6));
	}
}

TEST_CASE("a frame that is passed over changes nothing, of what a hand that turns ever makes") {
	constexpr double FREE_FROM_S = 1.0, TO_AND_FRO_S = 1.2, LENGTH_S = 4.0;
	constexpr int USED_MS = 4; // frames in between come too soon
	std::mt19937_64 random(4);
	std::normal_distribution<double> trembling(0.0, 6e-5);
	PhaseEstimator sparse(test::drag_model()), dense(test::drag_model());
	double off = 0.0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * LENGTH_S); ++ms) {
		const double t_s = 0.001 * ms, turns = std::max(t_s - FREE_FROM_S, 0.0) / TO_AND_FRO_S;
		const double x = 0.4 * (1.0 - std::cos(2.0 * std::numbers::pi * turns)) + trembling(random);
		if (ms % USED_MS == 0) {
			sparse.push(t_s, x);
		}
		dense.push(t_s, x);
		off = std::max(off, std::abs(sparse.at(t_s).value - dense.at(t_s).value));
	}
	CHECK(off < 1e-4);
}

TEST_CASE("a frame that is told again within an instant is passed over, also after a restart") {
	for (const double shift : { 0.0, -0.5 }) {
		CAPTURE(shift);
		constexpr int RESTARTED_AT = 100;
		constexpr double RESTART_S = (RESTARTED_AT - 1) * PERIOD_S, LATER_S = (RESTARTED_AT + 11) * PERIOD_S;
		const test::Drag half{ .onset_s = 0.2, .duration_s = 0.4, .amplitude_m = 0.5 };
		PhaseEstimator once(test::drag_model()), twice(test::drag_model());
		for (PhaseEstimator *const estimator : { &once, &twice }) {
			for (int i = 0; i < RESTARTED_AT; ++i) {
				estimator->push(i * PERIOD_S, half.x_m(i * PERIOD_S));
			}
			estimator->restart(RESTART_S, shift);
			if (estimator == &twice) {
				estimator->push(RESTART_S, half.amplitude_m + shift + 0.01);
			}
			for (int i = RESTARTED_AT; i * PERIOD_S < LATER_S; ++i) {
				estimator->push(i * PERIOD_S, half.amplitude_m + shift);
			}
		}
		CHECK(std::abs(twice.at(LATER_S).value - once.at(LATER_S).value) < 1e-4);
	}
}
