// What it says of hypotheses that the tracker loses the hand, or shows it where it was.

#include "near.h"
#include "phase/fault_evidence.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

// Values in amplitudes.

namespace {

constexpr double NOW_S = 1.0;
constexpr double STILL_PER_S = 0.3;

/// Of a minimum-jerk movement of that duration, so long after its onset (Flash & Hogan 1985).
double speed_per_s(double since_s, double duration_s) {
	const double s = since_s / duration_s;
	return 30.0 * s * s * (1.0 - s) * (1.0 - s) / duration_s;
}

GestureHypothesis begun(Regime regime, double since_s, double duration_s) {
	return GestureHypothesis::resting(0.0).begun(regime, NOW_S - since_s, 0.01, std::log(duration_s), 0.1);
}

} // namespace

TEST_CASE("a hand is lost in proportion to 0.3 amplitudes a second and its speed when it was last seen") {
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.0));
	bank.add(begun(Regime::SOUND, 0.1, 0.4));
	bank.add(begun(Regime::UNSOUND, 0.1, 2.0));
	bank.add(begun(Regime::SOUND, 0.5, 1.0));
	constexpr double LOST_S = NOW_S - 0.03;
	for (const double loss : { 0.25, 0.75 }) { // as much as one loss, in two parts
		count_loss(bank, NOW_S, LOST_S, loss);
	}
	const double quick = STILL_PER_S + speed_per_s(0.07, 0.4);
	CHECK(bank.log_weight(2) - bank.log_weight(1) ==
			test::near(std::log((STILL_PER_S + speed_per_s(0.07, 2.0)) / quick)));
	CHECK(bank.log_weight(3) - bank.log_weight(1) ==
			test::near(std::log((STILL_PER_S + speed_per_s(0.47, 1.0)) / quick)));
}

TEST_CASE("a hand at rest is lost half a nat less often than those on their way together") {
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.0));
	bank.add(begun(Regime::SOUND, 0.2, 0.5), -0.7);
	bank.add(begun(Regime::UNSOUND, 0.2, 3.0), -1.1);
	bank.add(GestureHypothesis::resting(0.3).in(Regime::FREE), -2.0);
	bank.add(begun(Regime::SOUND, 3.0, 1.0), -1.5); // over
	const auto on_their_way = [&] { return std::exp(bank.log_weight(1)) + std::exp(bank.log_weight(2)); };
	const double rest = bank.log_weight(0) - std::log(on_their_way());
	const double free = bank.log_weight(3) - std::log(on_their_way());
	const double over = bank.log_weight(4) - std::log(on_their_way());
	count_loss(bank, NOW_S, NOW_S, 1.0);
	CHECK(bank.log_weight(0) - std::log(on_their_way()) == test::near(rest - 0.5));
	CHECK(bank.log_weight(3) - std::log(on_their_way()) == test::near(free));
	CHECK(bank.log_weight(4) - std::log(on_their_way()) == test::near(over));
}

TEST_CASE("what speaks for a tracker that errs says nothing of whether the hand has begun, or has left the "
		  "end") {
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.0));
	bank.add(begun(Regime::SOUND, 0.2, 0.5), -0.7);
	bank.add(begun(Regime::UNSOUND, 0.2, 3.0), -1.1);
	bank.add(begun(Regime::FREE, 0.2, 0.5), -2.0);
	bank.add(GestureHypothesis::resting(0.3).in(Regime::FREE), -2.0);
	bank.add(begun(Regime::SOUND, 3.0, 1.0), -1.5); // over
	const auto weight = [&](std::size_t i) { return std::exp(bank.log_weight(i)); };
	const auto judged = [&] { return weight(1) + weight(2) + weight(3); };
	const double rest = weight(0) / judged(), left = weight(4) / judged(), over = weight(5) / judged();
	for (const double nats : { 1.3, -0.6 }) {
		const double right = weight(1) / weight(2), free = weight(3) / weight(2);
		count_erring(bank, NOW_S, nats);
		CHECK(weight(1) / weight(2) == test::near(right * std::exp(-nats)));
		CHECK(weight(3) / weight(2) == test::near(free * std::exp(-nats)));
		CHECK(weight(0) / judged() == test::near(rest));
		CHECK(weight(4) / judged() == test::near(left));
		CHECK(weight(5) / judged() == test::near(over));
	}
}

TEST_CASE("a hand that is shown where it was speaks against a tracker that errs by as much as the hand has "
		  "gone on") {
	HypothesisBank bank;
	bank.start(GestureHypothesis::resting(0.0));
	bank.add(begun(Regime::SOUND, 0.4, 0.8));
	bank.add(begun(Regime::UNSOUND, 0.4, 0.8));
	bank.add(begun(Regime::UNSOUND, 0.4, 3.0)); // slower than the tracker would have to be
	bank.add(begun(Regime::UNSOUND, 1.5, 0.8)); // long over
	constexpr double DT_S = 0.01, SINCE_S = NOW_S - 0.3;
	count_stay(bank, NOW_S, DT_S, SINCE_S);
	const auto at = [](double s) { return s * s * s * (10.0 + s * (6.0 * s - 15.0)); };
	const double gone = at(0.35 / 0.8) - at(0.1 / 0.8);
	REQUIRE(gone > 0.3);
	CHECK(bank.log_weight(2) == test::near(-300.0 * DT_S * (gone - 0.1)));
	for (const std::size_t other : { 0, 1, 3, 4 }) {
		CHECK(bank.log_weight(other) == 0.0);
	}
}

TEST_CASE("a gap or a freeze is one loss, in however many parts it is told, until the hand is seen again") {
	LossCount count;
	CHECK(count.new_of(0.4) == test::near(0.4));
	CHECK(count.new_of(-0.2) == 0.0);
	CHECK(count.new_of(0.5) == test::near(0.5));
	CHECK(count.new_of(0.5) == test::near(0.1));
	CHECK(count.new_of(0.5) == 0.0);
	count.end();
	CHECK(count.new_of(3.0) == test::near(1.0));
}
