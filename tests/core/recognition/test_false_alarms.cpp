// Movement that is no gesture: rest, wandering, waving, other directions, bent ways.

#include "gesture_events.h"

#include "simulation/oscillation.h"
#include "simulation/synthetic_trial.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr int PHASES = 10;

/// To and fro by 20 cm, from half-way between two turns. Each stroke is as straight and as long as a drag,
/// but the hand never rests.
Eigen::Vector3d waving(double rate_hz, double t_s) {
	return { 0.1 * std::sin(2.0 * std::numbers::pi * rate_hz * t_s), 0.01 * std::sin(2.1 * t_s), 0.0 };
}

} // namespace

TEST_CASE("a hand that never moves starts nothing") {
	const Way still = [](double) { return Eigen::Vector3d(0.02, -0.01, 0.03); };
	CHECK(in_the_open(still, 20.0).said.empty());
	CHECK(in_a_task(still, 20.0).said.empty());
}

TEST_CASE("noise of up to 5 mm hides no gesture, ends none") {
	for (const double rate_hz : { 30.0, 80.0, 240.0 }) {
		for (const double noise_m : { 1e-3, 5e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(noise_m);
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			const Events drag = watch(recogniser, along(X, { DRAG }), 2.5, 1e9, 1e9, rate_hz, noise_m);
			CHECK(count(drag, "ended sideways") == 1);
			CHECK(ends(drag) == 1);
			GestureRecogniser at_rest(models(), std::nullopt, MotionMode::PHASE);
			CHECK(none_ends(watch(at_rest, along(X, {}), 20.0, 1e9, 1e9, rate_hz, noise_m)));
		}
	}
}

TEST_CASE("without a task a shift of 3 cm starts nothing") {
	for (const double duration_s : { 0.2, 0.5, 1.0 }) {
		CAPTURE(duration_s);
		const Drag shift{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.15 * 0.2 };
		CHECK(in_the_open(along(X, { shift }), 3.0).said.empty());
	}
}

TEST_CASE("diagonal, bent, round and winding movement ends nothing") {
	const Way diagonal = along((X + Y).normalized(), { DRAG });
	const Way round = [](double t_s) {
		return Eigen::Vector3d(0.1 * std::cos(4.0 * t_s), 0.1 * std::sin(4.0 * t_s), 0.0);
	};
	for (const Way &way : { diagonal, round }) {
		CHECK(none_ends(in_the_open(way, 4.0)));
		CHECK(none_ends(in_a_task(way, 4.0)));
	}
	// With a task these two count: they lead from its start to its end.
	const Way arc = [](double t_s) {
		const double angle = std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
		return Eigen::Vector3d(0.1 - 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
	};
	// To either side in turn: the mean of the way lies on its chord.
	const Way wave = [](double t_s) {
		const double x_m = DRAG.x_m(t_s);
		return Eigen::Vector3d(x_m, 0.12 * std::sin(4.0 * std::numbers::pi * x_m / DRAG.amplitude_m), 0.0);
	};
	CHECK(none_ends(in_the_open(arc, 4.0)));
	CHECK(none_ends(in_the_open(wave, 3.0)));
}

TEST_CASE("two strokes without a rest between them end nothing") {
	// The two strokes of a 1: up obliquely, and at once straight down.
	const Eigen::Vector3d up(0.7, 0.7, 0.0);
	const Way one = [&](double t_s) {
		const Drag first{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.2 };
		const Drag second{ .onset_s = 1.05, .duration_s = 0.5, .amplitude_m = 0.2 };
		return Eigen::Vector3d(first.x_m(t_s) * up - second.x_m(t_s) * Y);
	};
	CHECK(none_ends(in_the_open(one, 3.0)));
}

TEST_CASE("random movement of synthetic people ends nothing and has low confidence") {
	double seconds = 0.0, greatest = 0.0, sum_of_greatest = 0.0; // confidences
	int begun = 0;
	for (std::uint32_t person = 0; person < 24; ++person) {
		const SyntheticTrial trial =
				make_synthetic_trial({ .name = "none",
											 .gesture = "none",
											 .subject = draw_subject(Population::TUNE, person),
											 .seed = person })
						.value();
		GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
		for (const HandFrame &frame : trial.measured.frames) {
			recogniser.push(frame);
			const double confidence = recogniser.confidence();
			REQUIRE((recogniser.gesture() < 0 ||
					recogniser.session()->stage() != GestureSession::Stage::ENDED));
			begun += confidence > 0.0 && greatest == 0.0 ? 1 : 0;
			sum_of_greatest += confidence == 0.0 ? greatest : 0.0;
			greatest = confidence == 0.0 ? 0.0 : std::max(greatest, confidence);
		}
		seconds += trial.measured.frames.back().t_s - trial.measured.frames.front().t_s;
	}
	CHECK(begun < seconds / 2.0);
	CHECK(sum_of_greatest <= 0.4 * begun);
}

TEST_CASE("a hand that wanders by 1 cm is mostly idle" * doctest::test_suite("figures")) {
	constexpr int HANDS = 16;
	constexpr double SECONDS = 20.0, WANDERS_M = 0.01;
	struct Pace {
		double slowest_hz, fastest_hz, share;
	};
	for (const Pace &pace : { Pace{ 0.1, 0.5, 0.25 }, { 0.5, 1.5, 0.4 } }) {
		CAPTURE(pace.fastest_hz);
		double shown_s = 0.0;
		for (int hand = 0; hand < HANDS; ++hand) {
			Random random(static_cast<std::uint64_t>(hand));
			const Oscillation wandering(pace.slowest_hz, pace.fastest_hz, WANDERS_M, random);
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			double last_s = 0.0;
			const Way way = [&](double t_s) -> Eigen::Vector3d {
				shown_s += recogniser.gesture() >= 0 ? t_s - last_s : 0.0;
				last_s = t_s;
				return wandering.at(t_s);
			};
			watch(recogniser, way, SECONDS);
		}
		CHECK(shown_s < pace.share * HANDS * SECONDS);
	}
}

TEST_CASE("slow wandering makes at most 0.2 false alarms per minute" * doctest::test_suite("figures")) {
	constexpr int HANDS = 24;
	constexpr double SECONDS = 30.0;
	for (const double deviation_m : { 0.05, 0.1 }) {
		CAPTURE(deviation_m);
		std::ptrdiff_t ended = 0;
		for (int hand = 0; hand < HANDS; ++hand) {
			Random random(static_cast<std::uint64_t>(hand));
			const Oscillation wandering(0.1, 0.3, deviation_m, random);
			const Way way = [&](double t_s) -> Eigen::Vector3d { return wandering.at(t_s); };
			ended += ends(in_the_open(way, SECONDS));
		}
		CHECK(static_cast<double>(ended) <= 0.2 * HANDS * SECONDS / 60.0);
	}
}

TEST_CASE("a hand that goes on waving starts nothing") {
	for (const double rate_hz : { 0.5, 0.7, 0.8, 1.0 }) {
		CAPTURE(rate_hz);
		CHECK(in_the_open([=](double t_s) { return waving(rate_hz, t_s); }, 8.0).said.empty());
	}
}

TEST_CASE("a hand that comes into view waving ends at most one gesture") {
	for (const double rate_hz : { 0.7, 1.0, 1.5 }) {
		for (int phase = 0; phase < PHASES; ++phase) {
			CAPTURE(rate_hz);
			CAPTURE(phase);
			const double into_s = phase / (PHASES * rate_hz);
			const Way way = [=](double t_s) { return waving(rate_hz, t_s + into_s); };
			CHECK(count(in_the_open(way, 6.0), "ended sideways") <= 1);
		}
	}
}

TEST_CASE("dropouts and freezes make a waving hand end hardly a gesture" * doctest::test_suite("figures")) {
	int runs = 0, alarms = 0;
	for (const double rate_hz : { 0.5, 0.7, 1.0 }) {
		for (const double loss_s : { 0.05, 0.15, 0.25, 0.35 }) {
			for (int phase = 0; phase < PHASES; ++phase) {
				const double from_s = 2.0 + phase / (PHASES * rate_hz), to_s = from_s + loss_s;
				const Way way = [=](double t_s) { return waving(rate_hz, t_s); };
				const Way frozen = [=](double t_s) { return way(t_s > from_s && t_s < to_s ? from_s : t_s); };
				GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
				alarms += none_ends(in_the_open(way, 6.0, from_s, to_s)) ? 0 : 1;
				alarms += none_ends(watch(recogniser, frozen, 6.0, 1e9, 1e9, 110.0, 0.0)) ? 0 : 1;
				runs += 2;
			}
		}
	}
	CHECK(alarms <= 0.1 * runs);
}
