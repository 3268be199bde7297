// By how much hypotheses are weighed: what is seeded, what a jump and a tracker without a fault say, and what
// is held back for a tracker that may err.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "phase/fault_evidence.h"
#include "phase/hypothesis_births.h"
#include "phase/tracker_jump.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;

// Values in amplitudes.

namespace {

constexpr double LAG_SETTLING_S = 0.39; ///< docs/method.md: of a way of this duration half the lag is left

/// Where the model says a hand is.
double at_phase(double phase) {
	return std::clamp(evaluate_onwards(test::drag_model(), phase).value, 0.0, 1.0);
}

/// Where a tracker shows the likeliest course of that hypothesis.
double shown(const HypothesisBank &bank, std::size_t place, double t_s) {
	const HypothesisGroup::Course course = bank.course(place);
	const double duration_s = 1.0 / course.rate_per_s, now = (t_s - course.onset_s) * course.rate_per_s;
	const double lag_s =
			regime_numbers(bank.regime(place)).lag_s * duration_s / (duration_s + LAG_SETTLING_S);
	return at_phase(now - lag_s * at_phase(now) * course.rate_per_s);
}

double probability(const HypothesisBank &bank) {
	double sum = 0.0;
	for (std::size_t i = 0; i < bank.size(); ++i) {
		sum += std::exp(bank.log_weight(i));
	}
	return sum;
}

/// A hand at rest that is given up for the other one.
HypothesisBank bank_of(const GestureHypothesis &other) {
	constexpr double GIVEN_UP = -1e3;
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.0));
	bank.weigh(HypothesisBank::AT_REST, GIVEN_UP);
	bank.add(other);
	bank.prune(0.0, 0.0, 0.0);
	return bank;
}

} // namespace

TEST_CASE("a hand that may have begun unseen is taken to be where it is seen, whatever lag its tracker has") {
	constexpr double NOW_S = 1.0;
	TrackingSoundness soundness;
	for (int i = 0; i < 60; ++i) {
		soundness.push(0.01 * i, 1e-4 * (i % 3));
	}
	const HypothesisBirths births(test::drag_model(), PhaseEffort{});
	for (const double x : { 0.1, 0.3, 0.5, 0.9, 1.0 }) {
		HypothesisBank bank;
		bank.start(GestureHypothesis::resting(0.0));
		births.seed(bank, soundness, NOW_S, x);
		bool has_unsound = false;
		for (std::size_t i = 1; i < bank.size(); ++i) {
			CAPTURE(x);
			CAPTURE(1.0 / bank.course(i).rate_per_s);
			CHECK(std::abs(shown(bank, i, NOW_S) - x) < 0.03);
			has_unsound = has_unsound || bank.regime(i) == Regime::UNSOUND;
		}
		CHECK(has_unsound);
	}
}

TEST_CASE("a hand on its way turns to something else at 0.02 a second, however often that is asked") {
	for (const double period_s : { 0.03, 0.06 }) {
		CAPTURE(period_s);
		const HypothesisBirths births(test::drag_model(), PhaseEffort{ .branch_period_s = period_s });
		HypothesisBank bank =
				bank_of(GestureHypothesis::resting(0.0).begun(Regime::SOUND, -0.3, 0.01, 0.0, 0.1));
		births.branch(bank, TrackingSoundness{}, 0.0);
		double free = 0.0;
		for (std::size_t i = 0; i < bank.size(); ++i) {
			free += bank.regime(i) == Regime::FREE ? std::exp(bank.log_weight(i)) : 0.0;
		}
		CHECK(free / probability(bank) / (0.02 * period_s) == test::near(1.0).epsilon(0.05));
	}
}

TEST_CASE("at a jump the tracker led away, or back, or the hand was elsewhere: no probability is lost") {
	const GestureHypothesis free = GestureHypothesis::leaving(0.5, 0.1);
	const GestureHypothesis standing = GestureHypothesis::standing(0.5, -2.0);
	// A sound tracker, of which a few slide back, is not asked about here.
	const GestureHypothesis turned = GestureHypothesis::resting(0.0)
											 .begun(Regime::SOUND, -0.3, 0.01, std::log(0.8), 0.1)
											 .in(Regime::FREE);
	for (const GestureHypothesis &hypothesis : { free, standing, turned }) {
		for (const bool leads_onward : { false, true }) {
			HypothesisBank bank = bank_of(hypothesis);
			REQUIRE(probability(bank) == test::near(1.0));
			branch_at_jump(bank, leads_onward ? 0.3 : -0.3);
			CHECK(probability(bank) == test::near(1.0));
		}
	}
}

TEST_CASE("that a tracker shows no fault speaks against one that errs, and not against one that is right") {
	constexpr double LOG_DURATION = 0.0;
	constexpr int FRAMES = 100;
	constexpr double FRAME_S = 0.01, SHOWN = 0.6;
	const GestureHypothesis rest = GestureHypothesis::resting(0.0);
	HypothesisBank bank;
	bank.start(rest);
	bank.add(GestureHypothesis::standing(SHOWN, -2.0));
	bank.add(rest.begun(Regime::SOUND, -0.5, 0.01, LOG_DURATION, 0.1));
	bank.add(rest.begun(Regime::UNSOUND, -0.5, 0.01, LOG_DURATION, 0.1));
	for (int i = 0; i < FRAMES; ++i) {
		count_errorless(bank, FRAME_S, SHOWN);
	}
	CHECK(bank.log_weight(0) == 0.0);
	CHECK(bank.log_weight(1) == 0.0);
	CHECK(bank.log_weight(2) == 0.0);
	CHECK(bank.log_weight(3) < -0.1);
}

TEST_CASE("a hand at rest takes no share for a tracker that errs, however often it is held; one on its way "
		  "does") {
	constexpr double UNLIKELY = -6.5, SHARE = 0.03, FREE_SHARE = 0.005; // the shares are prune()'s least
	const GestureHypothesis rest = GestureHypothesis::resting(0.0);
	const GestureHypothesis erring = rest.begun(Regime::UNSOUND, -0.2, 0.1, 0.0, 0.2);
	HypothesisBank resting;
	resting.start(rest);
	resting.add(rest.displaced(0.15));
	resting.add(erring, UNLIKELY);
	resting.prune(0.0, SHARE, FREE_SHARE);
	CHECK(resting.weight(2) == test::near(std::exp(UNLIKELY)));

	HypothesisBank on_its_way;
	on_its_way.start(rest);
	on_its_way.add(rest.begun(Regime::SOUND, -0.2, 0.1, 0.0, 0.2));
	on_its_way.add(erring, UNLIKELY);
	on_its_way.prune(0.0, SHARE, FREE_SHARE);
	CHECK(on_its_way.weight(2) > 10.0 * std::exp(UNLIKELY));
}
