// Movement that is no gesture: rest, wandering, waving, other directions, bent paths.

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

/// Oscillation of 20 cm that begins at its centre. Each stroke is as straight and as long as a drag, but the
/// hand never rests.
Eigen::Vector3d waving(double rate_hz, double t_s) {
	return { 0.1 * std::sin(2.0 * std::numbers::pi * rate_hz * t_s), 0.01 * std::sin(2.1 * t_s), 0.0 };
}

} // namespace

TEST_CASE("a hand that never moves starts nothing") {
	const TestPath still = [](double) { return Eigen::Vector3d(0.02, -0.01, 0.03); };
	CHECK(watch_without_task(still, 20.0).names.empty());
	CHECK(watch_with_task(still, 20.0).names.empty());
}

TEST_CASE("noise up to 5 mm hides no gesture and ends none") {
	for (const double rate_hz : { 30.0, 80.0, 240.0 }) {
		for (const double noise_m : { 1e-3, 5e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(noise_m);
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			const Events drag = watch(recogniser, along(X, { DRAG }), 2.5, 1e9, 1e9, rate_hz, noise_m);
			CHECK(count(drag, "ended sideways") == 1);
			CHECK(ends(drag) == 1);
			GestureRecogniser at_rest(models(), std::nullopt, MotionMode::PHASE);
			CHECK(has_no_end(watch(at_rest, along(X, {}), 20.0, 1e9, 1e9, rate_hz, noise_m)));
		}
	}
}

TEST_CASE("without a task a shift of 3 cm starts nothing") {
	for (const double duration_s : { 0.2, 0.5, 1.0 }) {
		CAPTURE(duration_s);
		const Drag shift{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.15 * 0.2 };
		CHECK(watch_without_task(along(X, { shift }), 3.0).names.empty());
	}
}

TEST_CASE("diagonal, bent, circular and winding movement ends nothing") {
	const TestPath diagonal = along((X + Y).normalized(), { DRAG });
	const TestPath round = [](double t_s) {
		return Eigen::Vector3d(0.1 * std::cos(4.0 * t_s), 0.1 * std::sin(4.0 * t_s), 0.0);
	};
	for (const TestPath &path : { diagonal, round }) {
		CHECK(has_no_end(watch_without_task(path, 4.0)));
		CHECK(has_no_end(watch_with_task(path, 4.0)));
	}
	// With a task these two are gestures: they lead from its start to its end.
	const TestPath arc = [](double t_s) {
		const double angle = std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
		return Eigen::Vector3d(0.1 - 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
	};
	// It deviates to both sides in turn: the mean of the path is on its chord.
	const TestPath wave = [](double t_s) {
		const double x_m = DRAG.x_m(t_s);
		return Eigen::Vector3d(x_m, 0.12 * std::sin(4.0 * std::numbers::pi * x_m / DRAG.amplitude_m), 0.0);
	};
	CHECK(has_no_end(watch_without_task(arc, 4.0)));
	CHECK(has_no_end(watch_without_task(wave, 3.0)));
}

TEST_CASE("two strokes without a rest between them end nothing") {
	// The two strokes of the digit 1: obliquely up, then straight down without a rest.
	const Eigen::Vector3d up(0.7, 0.7, 0.0);
	const TestPath one = [&](double t_s) {
		const Drag first{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = 0.2 };
		const Drag second{ .onset_s = 1.05, .duration_s = 0.5, .amplitude_m = 0.2 };
		return Eigen::Vector3d(first.x_m(t_s) * up - second.x_m(t_s) * Y);
	};
	CHECK(has_no_end(watch_without_task(one, 3.0)));
}

TEST_CASE("random movement of synthetic people ends nothing at low confidence") {
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
			const TestPath path = [&](double t_s) -> Eigen::Vector3d {
				shown_s += recogniser.gesture() >= 0 ? t_s - last_s : 0.0;
				last_s = t_s;
				return wandering.at(t_s);
			};
			watch(recogniser, path, SECONDS);
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
			const TestPath path = [&](double t_s) -> Eigen::Vector3d { return wandering.at(t_s); };
			ended += ends(watch_without_task(path, SECONDS));
		}
		CHECK(static_cast<double>(ended) <= 0.2 * HANDS * SECONDS / 60.0);
	}
}

TEST_CASE("a hand that waves continuously starts nothing") {
	for (const double rate_hz : { 0.5, 0.7, 0.8, 1.0 }) {
		CAPTURE(rate_hz);
		CHECK(watch_without_task([=](double t_s) { return waving(rate_hz, t_s); }, 8.0).names.empty());
	}
}

TEST_CASE("a track that begins with waving ends at most one gesture") {
	for (const double rate_hz : { 0.7, 1.0, 1.5 }) {
		for (int phase = 0; phase < PHASES; ++phase) {
			CAPTURE(rate_hz);
			CAPTURE(phase);
			const double into_s = phase / (PHASES * rate_hz);
			const TestPath path = [=](double t_s) { return waving(rate_hz, t_s + into_s); };
			CHECK(count(watch_without_task(path, 6.0), "ended sideways") <= 1);
		}
	}
}

TEST_CASE("a waving hand with dropouts and freezes hardly ends a gesture" * doctest::test_suite("figures")) {
	int runs = 0, alarms = 0;
	for (const double rate_hz : { 0.5, 0.7, 1.0 }) {
		for (const double loss_s : { 0.05, 0.15, 0.25, 0.35 }) {
			for (int phase = 0; phase < PHASES; ++phase) {
				const double from_s = 2.0 + phase / (PHASES * rate_hz), to_s = from_s + loss_s;
				const TestPath path = [=](double t_s) { return waving(rate_hz, t_s); };
				const TestPath frozen = [=](double t_s) {
					return path(t_s > from_s && t_s < to_s ? from_s : t_s);
				};
				GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
				alarms += has_no_end(watch_without_task(path, 6.0, from_s, to_s)) ? 0 : 1;
				alarms += has_no_end(watch(recogniser, frozen, 6.0, 1e9, 1e9, 110.0, 0.0)) ? 0 : 1;
				runs += 2;
			}
		}
	}
	CHECK(alarms <= 0.1 * runs);
}
