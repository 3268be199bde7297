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

Eigen::Vector3d circling(double t_s) {
	return { 0.1 * std::cos(4.0 * t_s), 0.1 * std::sin(4.0 * t_s), 0.0 };
}

Eigen::Vector3d in_an_arc(double t_s) {
	const double angle = std::numbers::pi * DRAG.x_m(t_s) / DRAG.amplitude_m;
	return { 0.1 - 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0 };
}

/// Deviates to both sides in turn: the mean of the path is on its chord.
Eigen::Vector3d in_a_wave(double t_s) {
	const double x_m = DRAG.x_m(t_s);
	return { x_m, 0.12 * std::sin(4.0 * std::numbers::pi * x_m / DRAG.amplitude_m), 0.0 };
}

/// The two strokes of the digit 1: obliquely up, then straight down without a rest.
Eigen::Vector3d digit_one(double t_s) {
	const Drag up{ 0.6, 0.5, 0.2 }, down{ 1.05, 0.5, 0.2 };
	return up.x_m(t_s) * Eigen::Vector3d(0.7, 0.7, 0.0) - down.x_m(t_s) * Y;
}

} // namespace

TEST_CASE("diagonal, bent, circular and winding movement ends nothing") {
	const TestPath diagonal = along((X + Y).normalized(), { DRAG });
	for (const TestPath &path : { diagonal, TestPath(circling) }) {
		CHECK(has_no_end(watch_without_task(path, 4.0)));
		CHECK(has_no_end(watch_with_task(path, 4.0)));
	}
	// With a task these are gestures: they lead from its start to its end.
	CHECK(has_no_end(watch_without_task(in_an_arc, 4.0)));
	CHECK(has_no_end(watch_without_task(in_a_wave, 3.0)));
	CHECK(has_no_end(watch_without_task(digit_one, 3.0)));
}

TEST_CASE("a still hand starts nothing; shifted and waving hands end nothing") {
	const TestPath still = [](double) { return Eigen::Vector3d(0.02, -0.01, 0.03); };
	CHECK(watch_without_task(still, 20.0).names.empty());
	CHECK(watch_with_task(still, 20.0).names.empty());
	for (const double duration_s : { 0.2, 0.5, 1.0 }) {
		CAPTURE(duration_s);
		CHECK(has_no_end(watch_without_task(along(X, { { 0.6, duration_s, 0.03 } }), 3.0)));
	}
	for (const double rate_hz : { 0.5, 0.7, 0.8, 1.0 }) {
		CAPTURE(rate_hz);
		CHECK(has_no_end(watch_without_task([=](double t_s) { return waving(rate_hz, t_s); }, 8.0)));
	}
}

TEST_CASE("an early return ends nothing and starts at most once") {
	for (const double far_m : { 0.034, 0.06, 0.08 }) {
		for (const double each_way_s : { 0.3, 0.6 }) {
			INFO("far ", far_m, ", each way ", each_way_s);
			const TestPath path =
					along(X, { { 0.6, each_way_s, far_m }, { 0.6 + each_way_s, each_way_s, -far_m } });
			for (const Events &events : { watch_without_task(path, 6.0), watch_with_task(path, 6.0) }) {
				CHECK(count(events, "started horizontal_drag") <= 1);
				CHECK(has_no_end(events));
			}
		}
	}
}

TEST_CASE("noise up to 5 mm hides no gesture and ends none") {
	for (const double rate_hz : { 30.0, 80.0, 240.0 }) {
		for (const double noise_m : { 1e-3, 5e-3 }) {
			INFO("rate ", rate_hz, ", noise ", noise_m);
			const TestTracker tracker{ .rate_hz = rate_hz, .noise_m = noise_m };
			const Events drag = watch_without_task(along(X, { DRAG }), 2.5, tracker);
			CHECK(count(drag, "ended horizontal_drag") == 1);
			CHECK(ends(drag) == 1);
			CHECK(has_no_end(watch_without_task(along(X, {}), 20.0, tracker)));
		}
	}
}

TEST_CASE("random movement of synthetic people ends nothing") {
	double seconds = 0.0;
	int begun = 0;
	for (std::uint32_t person = 0; person < 24; ++person) {
		const Subject subject = draw_subject(Population::TUNE, person);
		const SyntheticTrial trial = make_synthetic_trial(
				{ .name = "none", .gesture = "none", .subject = subject, .seed = person })
											 .value();
		GestureRecogniser recogniser = without_task();
		ShownChanges shown;
		for (const HandFrame &frame : trial.measured.frames) {
			recogniser.push(frame);
			begun += shown.next(recogniser).started ? 1 : 0;
			REQUIRE(stage(recogniser) != GestureSession::Stage::ENDED);
		}
		seconds += trial.measured.frames.back().t_s - trial.measured.frames.front().t_s;
	}
	CHECK(begun < seconds / 2.0);
}

TEST_CASE("slow wandering makes less than 1 false alarm per minute" * doctest::test_suite("figures")) {
	constexpr int HANDS = 24;
	constexpr double SECONDS = 30.0;
	for (const double deviation_m : { 0.05, 0.1 }) {
		CAPTURE(deviation_m);
		std::ptrdiff_t ended = 0;
		for (std::uint64_t hand = 0; hand < HANDS; ++hand) {
			Random random(hand);
			const Oscillation wandering(0.1, 0.3, deviation_m, random);
			const TestPath path = [&](double t_s) -> Eigen::Vector3d { return wandering.at(t_s); };
			ended += ends(watch_without_task(path, SECONDS));
		}
		CHECK(static_cast<double>(ended) < HANDS * SECONDS / 60.0);
	}
}

TEST_CASE("a waving hand with dropouts and freezes hardly ends a gesture" * doctest::test_suite("figures")) {
	int runs = 0, alarms = 0;
	for (const double rate_hz : { 0.5, 0.7, 1.0 }) {
		for (const double loss_s : { 0.05, 0.15, 0.25, 0.35 }) {
			for (int phase = 0; phase < PHASES; ++phase, runs += 2) {
				const double from_s = 2.0 + phase / (PHASES * rate_hz), to_s = from_s + loss_s;
				const TestPath path = [=](double t_s) { return waving(rate_hz, t_s); };
				const TestPath frozen = [=](double t_s) {
					return path(t_s > from_s && t_s < to_s ? from_s : t_s);
				};
				alarms += has_no_end(watch_without_task(path, 6.0, { from_s, to_s })) ? 0 : 1;
				alarms += has_no_end(watch_without_task(frozen, 6.0, { .noise_m = 0.0 })) ? 0 : 1;
			}
		}
	}
	CHECK(alarms <= 0.1 * runs);
}
