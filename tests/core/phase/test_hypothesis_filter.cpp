// Hypotheses against the same filter with dense matrices.

#include "dense_hypothesis.h"
#include "minimum_jerk_drag.h"
#include "near.h"
#include "phase/hypothesis_bank.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace steadyhand;

namespace {

using Dense = test::DenseHypothesis;

constexpr double STEP_S = 0.009;
const test::Drag DRAG{ .onset_s = 0.06, .duration_s = 0.5, .amplitude_m = 1.0 };

/// A hypothesis at a place of a bank, and what it should be.
struct Pair {
	HypothesisBank bank;
	Dense dense;

	Pair(const GestureHypothesis &hypothesis, Dense expected) : dense(std::move(expected)) {
		bank.start(hypothesis);
	}
	void see(double t_s, double x, const HypothesisGroup::Trust &trust) {
		bank.predict(test::drag_curve(), t_s, passages(STEP_S));
		bank.absorb(test::drag_curve(), t_s, x, trust);
		dense.predict(t_s, STEP_S);
		dense.absorb(t_s, x, trust);
	}
	void slide_back(double deviation) {
		turn(hypothesis().displaced_sliding_back(deviation));
		dense.error = TrackerError::SLIDING_BACK;
		dense.forget_error();
		dense.covariance(Dense::B, Dense::B) += deviation * deviation;
	}
	void turn(const GestureHypothesis &hypothesis) { bank.set(0, hypothesis); }
	[[nodiscard]] GestureHypothesis hypothesis() const { return bank.hypothesis(0); }

	void check(double tolerance = 1e-5) const {
		const auto near = [tolerance](double value, double expected) {
			return std::abs(value - expected) <= tolerance * std::max(1.0, std::abs(expected));
		};
		CHECK(near(bank.hand_deviation(0), dense.mean[Dense::D]));
		CHECK(near(bank.hand_deviation_rate(0), dense.mean[Dense::DV]));
		CHECK(near(bank.log_weight(0), dense.log_weight));
		if (dense.on_its_way) {
			const auto [onset_s, rate_per_s, gain, shape] = bank.course(0);
			CHECK(near(onset_s, dense.mean[Dense::ONSET]));
			CHECK(near(rate_per_s, std::exp(-dense.mean[Dense::LOG_DURATION])));
			CHECK(near(gain, 1.0 + dense.mean[Dense::GAIN]));
			CHECK(near(shape, dense.mean[Dense::SHAPE]));
		}
	}
};

Pair on_its_way(Regime regime, double onset_s, double log_duration) {
	const GestureHypothesis rest = GestureHypothesis::resting(0.01);
	Pair pair(rest.begun(regime, onset_s, 0.02, log_duration, 0.1), Dense::resting(test::drag_model(), 0.01));
	pair.dense.begin_way(regime, onset_s, 0.02, log_duration, 0.1);
	return pair;
}

/// A tracker that shows the drag, from the first frame on, with an error of its own.
double shown(int frame) {
	return DRAG.x_m(0.1 + frame * STEP_S) + 0.02 * std::sin(1.7 * frame);
}

void see(Pair &r_pair, int from, int to, const HypothesisGroup::Trust &trust) {
	for (int i = from; i < to; ++i) {
		r_pair.see(0.1 + i * STEP_S, shown(i), trust);
	}
}

} // namespace

TEST_CASE("hypotheses side by side are extended Kalman filters, each as with dense matrices") {
	constexpr std::array REGIMES_OF{ Regime::SOUND, Regime::UNSOUND, Regime::FREE, Regime::UNSOUND,
		Regime::SOUND, Regime::FREE, Regime::UNSOUND };
	constexpr std::size_t SLIDES_BACK = 6;
	constexpr HypothesisGroup::Trust TRUST{ .outlier = 0.0, .jitter = 0.003 };
	std::vector<Pair> alone;
	HypothesisBank bank;
	for (std::size_t k = 0; k < REGIMES_OF.size(); ++k) {
		Pair &pair = alone.emplace_back(on_its_way(
				REGIMES_OF[k], 0.015 * static_cast<double>(k), -0.9 + 0.1 * static_cast<double>(k)));
		if (k == SLIDES_BACK) {
			pair.slide_back(0.1);
		}
		k == 0 ? bank.start(pair.hypothesis()) : bank.add(pair.hypothesis());
	}
	for (int i = 0; i < 34; ++i) {
		const double t_s = 0.1 + i * STEP_S;
		bank.predict(test::drag_curve(), t_s, passages(STEP_S));
		bank.absorb(test::drag_curve(), t_s, DRAG.x_m(t_s), TRUST);
		for (Pair &pair : alone) {
			pair.see(t_s, DRAG.x_m(t_s), TRUST);
		}
	}
	for (std::size_t k = 0; k < alone.size(); ++k) {
		CAPTURE(k);
		alone[k].turn(bank.hypothesis(k));
		alone[k].check();
	}
}

TEST_CASE("a frame that may be an outlier leaves mean and covariance of both densities, and its share of "
		  "the weight") {
	for (const HypothesisGroup::Trust trust :
			{ HypothesisGroup::Trust{ .outlier = 0.3, .jitter = 0.01, .weight = 0.4 },
					HypothesisGroup::Trust{ .outlier = 0.02, .jitter = 0.0, .weight = 1.0 } }) {
		CAPTURE(trust.outlier);
		for (const Regime regime : { Regime::SOUND, Regime::UNSOUND, Regime::FREE }) {
			CAPTURE(index_of(regime));
			Pair pair = on_its_way(regime, 0.03, -0.8);
			see(pair, 0, 20, trust);
			pair.check();
			// Half a deviation of the broad density away, and so far that only the least likelihood counts.
			pair.see(0.1 + 20 * STEP_S, shown(20) + 0.1, trust);
			pair.check();
			pair.see(0.1 + 21 * STEP_S, shown(21) + 3.0, trust);
			see(pair, 22, 30, trust);
			pair.check();
		}
	}
}

TEST_CASE("a tracker that shakes about a hand at rest has that much more white noise, and no more") {
	const GestureHypothesis rest = GestureHypothesis::resting(0.01);
	for (const TrackerError error : { TrackerError::SLIGHT, TrackerError::SHAKING }) {
		CAPTURE(index_of(error));
		Pair pair(rest.before(error), Dense::resting(test::drag_model(), 0.01));
		pair.dense.error = error;
		for (int i = 0; i < 30; ++i) {
			pair.see(0.1 + i * STEP_S, 0.05 * std::sin(2.1 * i), { .outlier = 0.01, .jitter = 0.002 });
		}
		pair.check();
	}
}

TEST_CASE("what a prune or a swap moves to another place is filtered as it was") {
	constexpr double NOW_S = 0.3;
	for (const bool is_swapped : { false, true }) {
		CAPTURE(is_swapped);
		HypothesisBank bank;
		bank.start(GestureHypothesis::resting(0.0));
		std::vector<Pair> alone;
		for (int k = 0; k < 6; ++k) {
			alone.push_back(on_its_way(Regime::UNSOUND, 0.02 * k, -0.9 + 0.1 * k));
			// The first ones are dropped for good.
			bank.add(alone.back().hypothesis(), k < 4 ? -100.0 : 0.0);
		}
		bank.predict(test::drag_curve(), NOW_S, passages(STEP_S));
		bank.prune(NOW_S, 0.0, 0.0);
		REQUIRE(bank.size() == 3);
		if (is_swapped) {
			bank.swap(1, 2);
		}
		std::array<double, 3> rates{};
		for (const std::size_t place : { 1U, 2U }) {
			rates.at(place) = bank.course(place).rate_per_s;
		}
		bank.absorb(test::drag_curve(), NOW_S, 0.2, { .outlier = 0.0 });
		for (const std::size_t place : { 1U, 2U }) {
			Pair &pair = rates.at(place) == alone[4].bank.course(0).rate_per_s ? alone[4] : alone[5];
			REQUIRE(rates.at(place) == pair.bank.course(0).rate_per_s);
			pair.see(NOW_S, 0.2, { .outlier = 0.0 });
			pair.turn(bank.hypothesis(place));
			pair.dense.log_weight = bank.log_weight(place); // a prune scales weights
			pair.check();
		}
	}
}

TEST_CASE("no hypothesis comes to a duration that hands do not take") {
	for (const double log_duration : { std::log(0.13), std::log(7.8) }) {
		Pair pair = on_its_way(Regime::SOUND, 0.08, log_duration);
		double shortest = 1e9, longest = 0.0;
		for (int i = 0; i < 200; ++i) {
			// One that is done at once, or hardly moves.
			pair.see(0.1 + i * STEP_S, log_duration < 0.0 ? 1.0 : 0.0, { .outlier = 0.0 });
			shortest = std::min(shortest, 1.0 / pair.bank.course(0).rate_per_s);
			longest = std::max(longest, 1.0 / pair.bank.course(0).rate_per_s);
		}
		CHECK((log_duration < 0.0 ? shortest : longest) ==
				test::near(log_duration < 0.0 ? 0.12 : 8.0).epsilon(1e-12));
	}
}

TEST_CASE("what a hypothesis turns into keeps what is known of hand and tracker, and no more") {
	constexpr HypothesisGroup::Trust TRUST{ .outlier = 0.01, .jitter = 0.002 };
	constexpr int SEEN = 25;
	constexpr double NOW_S = 0.1 + SEEN * STEP_S;
	const auto goes_on = [&](Pair &r_pair) {
		r_pair.check();
		see(r_pair, SEEN, SEEN + 10, TRUST);
		r_pair.check();
	};
	Pair way = on_its_way(Regime::SOUND, 0.05, -0.7);
	see(way, 0, SEEN, TRUST);

	SUBCASE("a free hand where the gesture ended") {
		way.turn(way.hypothesis().leaving_end());
		way.dense.leave_end();
		goes_on(way);
	}
	SUBCASE("the same hand, begun anew from the free one") {
		way.turn(way.hypothesis().leaving_end().begun(Regime::SOUND, NOW_S, 0.02, -0.5, 0.1));
		way.dense.leave_end();
		way.dense.begin_way(Regime::SOUND, NOW_S, 0.02, -0.5, 0.1);
		goes_on(way);
	}
	SUBCASE("a tracker that jumps") {
		way.turn(way.hypothesis().displaced(0.15));
		way.dense.covariance(Dense::B, Dense::B) += 0.15 * 0.15;
		goes_on(way);
	}
	SUBCASE("a tracker that jumps and slides back") {
		way.slide_back(0.15);
		goes_on(way);
	}
	SUBCASE("a tracker of which nothing is known any more") {
		GestureHypothesis hypothesis = way.hypothesis();
		hypothesis.forget_error();
		way.turn(hypothesis);
		way.dense.forget_error();
		goes_on(way);
	}
	SUBCASE("a tracker that errs from now on") {
		way.turn(way.hypothesis().in(Regime::UNSOUND));
		way.dense.be_in(Regime::UNSOUND);
		goes_on(way);
	}

	Pair free(GestureHypothesis::leaving(0.9, -0.6), Dense::resting(test::drag_model(), 0.9));
	free.dense.be_in(Regime::FREE);
	const Deviation &hand = regime_numbers(Regime::FREE).hand;
	free.dense.begin(Dense::DV, -0.6, hand.amplitudes * hand.rate_per_s);
	see(free, 0, SEEN, TRUST);

	SUBCASE("a free hand") {
		goes_on(free);
	}
	SUBCASE("a free hand that has made the gesture") {
		free.turn(free.hypothesis().at_end(-0.4, -0.7));
		free.dense.begin_way(Regime::SOUND, -0.4, 0.0, -0.7, 0.0);
		free.dense.begin(Dense::SHAPE, 1.0, 0.0);
		Dense::Matrix by = Dense::Matrix::Identity();
		by(Dense::D, Dense::GAIN) = -1.0;
		free.dense.carry_over(by, -Dense::Vector::Unit(Dense::D));
		goes_on(free);
	}
	SUBCASE("a free hand that was not seen for a while") {
		free.turn(free.hypothesis().free_for(0.3));
		free.dense.covariance.topLeftCorner<2, 2>() += Dense::free_noise(0.3);
		free.dense.forget_error();
		goes_on(free);
	}
	SUBCASE("a hand that had turned to something else on its way, and is elsewhere") {
		Pair turned = on_its_way(Regime::FREE, 0.05, -0.7);
		see(turned, 0, SEEN, TRUST);
		turned.turn(turned.hypothesis().found_elsewhere(0.5));
		turned.dense.begin(Dense::D, turned.dense.mean[Dense::D], 0.5);
		turned.dense.begin(Dense::DV, 0.0, hand.amplitudes * hand.rate_per_s);
		turned.dense.forget_error();
		goes_on(turned);
	}
	SUBCASE("a free hand that is elsewhere") {
		free.turn(free.hypothesis().found_elsewhere(0.5));
		free.dense.begin(Dense::D, free.dense.mean[Dense::D], 0.5);
		free.dense.begin(Dense::DV, 0.0, hand.amplitudes * hand.rate_per_s);
		free.dense.forget_error();
		goes_on(free);
	}
}
