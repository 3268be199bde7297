// What hypotheses together expect of the hand until the next frame, and while none comes.

#include "near.h"
#include "phase/motion_outlook.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

namespace {

constexpr double NOW_S = 1.0;
/// As MotionOutlook's: beyond it what is expected is no quintic.
constexpr double PIECE_S = 0.02;

GestureHypothesis begun(Regime regime, double onset_s, double duration_s, double log_weight) {
	GestureHypothesis h =
			GestureHypothesis::resting(0.0).begun(regime, onset_s, 0.01, std::log(duration_s), 0.1);
	h.log_weight = log_weight;
	return h;
}

/// Of each kind one: at rest, seen on its way and not yet seen, before a tracker that errs, a hand that has
/// turned to something else on its way, one that is on no way.
HypothesisBank mixed() {
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.02));
	bank.weigh(HypothesisBank::AT_REST, -1.0);
	bank.add(begun(Regime::SOUND, 0.6, 0.8, -0.5));
	bank.add(begun(Regime::SOUND, 0.98, 0.6, -0.7));
	bank.add(begun(Regime::UNSOUND, 0.5, 0.7, -0.2));
	bank.add(begun(Regime::FREE, 0.7, 0.9, -0.4));
	bank.add(GestureHypothesis::leaving(0.4, 1.5), -0.6);
	// Deviations that are not 0, of different rates.
	bank.predict(test::drag_curve(), NOW_S - 0.01, passages(0.01));
	bank.absorb(test::drag_curve(), NOW_S - 0.01, 0.3, { .outlier = 0.0, .jitter = 0.1 });
	bank.predict(test::drag_curve(), NOW_S, passages(0.01));
	bank.absorb(test::drag_curve(), NOW_S, 0.33, { .outlier = 0.0, .jitter = 0.1 });
	bank.prune(NOW_S, 0.0, 0.0);
	return bank;
}

/// What one hypothesis alone expects, last seen at NOW_S.
PhaseEstimate alone(const GestureHypothesis &hypothesis, double t_s) {
	HypothesisBank bank;
	bank.start(hypothesis);
	bank.prune(NOW_S, 0.0, 0.0);
	MotionOutlook outlook;
	outlook.look(bank, test::drag_curve(), NOW_S, 0.0, NOW_S);
	return outlook.at(test::drag_curve(), t_s);
}

} // namespace

TEST_CASE("velocity and acceleration are the derivatives of what is expected, and so they stay") {
	constexpr double STEP_S = 1e-5;
	const HypothesisBank bank = mixed();
	REQUIRE(bank.size() == 6);
	for (const double ahead_s : { 0.0, 0.013 }) {
		MotionOutlook outlook;
		outlook.look(bank, test::drag_curve(), NOW_S, ahead_s, NOW_S);
		const auto at = [&](double t_s) { return outlook.at(test::drag_curve(), t_s); };
		for (const double later_s : { 0.004, 0.01, 0.016, 0.03, 0.05, 0.1, 0.2, 0.5, 1.5 }) {
			CAPTURE(later_s);
			const double t_s = NOW_S + ahead_s + later_s;
			const PhaseEstimate before = at(t_s - STEP_S), now = at(t_s), after = at(t_s + STEP_S);
			CHECK(std::abs((after.value - before.value) / (2.0 * STEP_S) - now.velocity) < 1e-6);
			CHECK(std::abs((after.velocity - before.velocity) / (2.0 * STEP_S) - now.acceleration) < 1e-4);
		}
		// The quintic ends as what comes after it begins.
		for (const double end_s : { 0.0, PIECE_S }) {
			const PhaseEstimate before = at(NOW_S + ahead_s + end_s - 1e-9),
								after = at(NOW_S + ahead_s + end_s + 1e-9);
			CHECK(std::abs(after.value - before.value) < 1e-7);
			CHECK(std::abs(after.velocity - before.velocity) < 1e-5);
			CHECK(std::abs(after.phase - before.phase) < 1e-7);
		}
	}
}

TEST_CASE("phase and movement are the weighted means of those on their way") {
	const HypothesisBank bank = mixed();
	double total = 0.0, moving = 0.0, phase = 0.0;
	for (std::size_t i = 0; i < bank.size(); ++i) {
		total += bank.weight(i);
		if (bank.on_its_way(i)) {
			const HypothesisGroup::Course course = bank.course(i);
			moving += bank.weight(i);
			phase += bank.weight(i) * (NOW_S - course.onset_s) * course.rate_per_s;
		}
	}
	MotionOutlook outlook;
	outlook.look(bank, test::drag_curve(), NOW_S, 0.0, NOW_S);
	const PhaseEstimate now = outlook.at(test::drag_curve(), NOW_S);
	CHECK(now.moving == test::near(moving / total).epsilon(1e-12));
	CHECK(now.phase == test::near(phase / total).epsilon(1e-12));
	// Over the quintic the phase is a parabola, which is where the mean is at its end.
	const PhaseEstimate within = outlook.at(test::drag_curve(), NOW_S + 0.5 * PIECE_S),
						beyond = outlook.at(test::drag_curve(), NOW_S + PIECE_S + 1e-9);
	CHECK(std::abs(within.phase - 0.5 * (now.phase + beyond.phase)) < 1e-3);
	CHECK(within.moving == now.moving);
	// A time before that of the hypotheses is answered by theirs.
	CHECK(outlook.at(test::drag_curve(), NOW_S - 1.0).value == test::near(now.value).epsilon(1e-12));
}

TEST_CASE("what has come no further than the hand wandered goes on unseen for a quarter of a second") {
	const GestureHypothesis begins = begun(Regime::SOUND, 0.9, 1.0, 0.0); // seen to a hundredth of its way
	HypothesisBank bank;
	bank.start(begins);
	bank.prune(NOW_S, 0.0, 0.0);
	const auto expected = [&](double wander, double later_s) {
		MotionOutlook outlook;
		outlook.look(bank, test::drag_curve(), NOW_S, 0.0, NOW_S, 0.0, false, wander);
		return outlook.at(test::drag_curve(), NOW_S + later_s).value;
	};
	CHECK(expected(0.0, 2.0) == test::near(1.0));
	CHECK(expected(0.005, 2.0) == test::near(1.0));
	CHECK(expected(0.1, 0.25) == test::near(expected(0.0, 0.25)));
	CHECK(expected(0.1, 2.0) < expected(0.0, 0.31));
	CHECK(expected(0.1, 0.3) < expected(0.0, 0.3));
}

TEST_CASE("a look leaves nothing of the one before") {
	const HypothesisBank bank = mixed();
	HypothesisBank other;
	other.start(GestureHypothesis::leaving(-0.3, 0.8));
	other.add(begun(Regime::SOUND, 0.7, 1.0, -0.3));
	for (const double ahead_s : { 0.0, 0.02 }) {
		MotionOutlook used, fresh;
		used.look(bank, test::drag_curve(), NOW_S - 0.01, 0.005, NOW_S - 0.01);
		used.look(other, test::drag_curve(), NOW_S, ahead_s, NOW_S);
		fresh.look(other, test::drag_curve(), NOW_S, ahead_s, NOW_S);
		for (const double later_s : { 0.0, 0.01, 0.02, 0.5 }) {
			const PhaseEstimate a = used.at(test::drag_curve(), NOW_S + ahead_s + later_s),
								b = fresh.at(test::drag_curve(), NOW_S + ahead_s + later_s);
			CHECK(a.value == b.value);
			CHECK(a.velocity == b.velocity);
			CHECK(a.acceleration == b.acceleration);
			CHECK(a.phase == b.phase);
			CHECK(a.moving == b.moving);
		}
	}
}

TEST_CASE(
		"unseen, a gesture that was seen to begin goes on to its end; one that was not, and a hand that has "
		"turned to something else, wait") {
	const double much_later_s = NOW_S + 10.0;
	const auto phase = [&](const GestureHypothesis &h) { return alone(h, much_later_s).phase; };
	CHECK(phase(begun(Regime::SOUND, 0.6, 0.8, 0.0)) == 1.0);
	CHECK(phase(begun(Regime::UNSOUND, 0.6, 0.8, 0.0)) == 1.0);
	CHECK(alone(begun(Regime::SOUND, -1.0, 0.8, 0.0), NOW_S + 0.01).phase == 1.0);
	// 6 % of its way, and no more than 5 % on.
	CHECK(phase(begun(Regime::SOUND, NOW_S - 0.061, 1.0, 0.0)) == 1.0);
	CHECK(phase(begun(Regime::SOUND, NOW_S - 0.059, 1.0, 0.0)) == test::near(0.109));
	CHECK(phase(begun(Regime::SOUND, NOW_S, 1.0, 0.0)) == test::near(0.05));
	CHECK(phase(begun(Regime::SOUND, NOW_S + 0.3, 1.0, 0.0)) == test::near(0.05));
	CHECK(phase(begun(Regime::FREE, 0.5, 1.0, 0.0)) == test::near(0.55));
	for (const Regime regime : { Regime::SOUND, Regime::UNSOUND, Regime::FREE }) {
		const PhaseEstimate last = alone(begun(regime, 0.5, 1.0, 0.0), much_later_s);
		CHECK(std::abs(last.velocity) < 1e-12);
		CHECK(std::abs(last.acceleration) < 1e-12);
	}
	// A free hand that is on no way comes to rest where its velocity takes it.
	const PhaseEstimate hand = alone(GestureHypothesis::leaving(0.4, 1.5), much_later_s);
	CHECK(hand.value == test::near(0.4 + 1.5 / FREE_SLOWING_PER_S).epsilon(1e-12));
	CHECK(hand.moving == 0.0);
	// By half an amplitude at most: three tips that come into line make any speed of their radius.
	for (const double velocity : { 3.5, 20.0, -20.0 }) {
		const PhaseEstimate fast = alone(GestureHypothesis::leaving(0.4, velocity), much_later_s);
		CHECK(fast.value == test::near(0.4 + std::copysign(0.5, velocity)).epsilon(1e-12));
		const PhaseEstimate soon = alone(GestureHypothesis::leaving(0.4, velocity), NOW_S + 0.05);
		const PhaseEstimate sooner = alone(GestureHypothesis::leaving(0.4, velocity), NOW_S + 0.05 - 1e-5);
		CHECK((soon.value - sooner.value) / 1e-5 == test::near(soon.velocity).epsilon(1e-3));
		CHECK((soon.velocity - sooner.velocity) / 1e-5 == test::near(soon.acceleration).epsilon(1e-3));
	}
}

TEST_CASE("a free hand at the end, before a tracker that has erred, is there in six cases of ten") {
	const auto expected = [](const GestureHypothesis &hypothesis, double erred, bool is_halted = false) {
		HypothesisBank bank;
		bank.start(hypothesis);
		bank.prune(NOW_S, 0.0, 0.0);
		MotionOutlook outlook;
		outlook.look(bank, test::drag_curve(), NOW_S, 0.0, NOW_S, erred, is_halted);
		return outlook.at(test::drag_curve(), NOW_S);
	};
	for (const double hand : { 0.92, 1.3, 1.7 }) {
		const PhaseEstimate shown = expected(GestureHypothesis::leaving(hand, 2.0), 0.5);
		CHECK(shown.value == test::near(hand + 0.3 * (1.0 - hand)));
		CHECK(shown.velocity == test::near(0.7 * 2.0));
		CHECK(expected(GestureHypothesis::leaving(hand, 2.0), 0.5, true).value == shown.value);
	}
	const GestureHypothesis beyond = begun(Regime::FREE, NOW_S - 0.79, 0.8, 0.0);
	CHECK(expected(beyond, 1.0).value ==
			test::near(1.0 + 0.4 * (expected(beyond, 0.0).value - 1.0)).epsilon(1e-6));
	for (const double hand : { -0.3, 0.4, 0.69 }) {
		CHECK(expected(GestureHypothesis::leaving(hand, 2.0), 1.0).value == test::near(hand));
	}
	CHECK(expected(begun(Regime::SOUND, NOW_S - 0.7, 0.8, 0.0), 1.0).value ==
			expected(begun(Regime::SOUND, NOW_S - 0.7, 0.8, 0.0), 0.0).value);
}
