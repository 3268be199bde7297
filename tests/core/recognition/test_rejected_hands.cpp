// Hands that made something else than their task's gesture.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE(
		"with the task known a hand counts that comes to its end from beside its start, or goes beside it") {
	// Off the task's way by an angle; beside the start by shares of the way, to the end or as far beside
	// that.
	const auto ends_of = [](double angle_rad, double beside, double beside_end) {
		int ended = 0;
		for (const double duration_s : { 0.3, 0.6, 1.2 }) {
			const Drag drag{ .onset_s = 1.2, .duration_s = duration_s, .amplitude_m = 1.0 };
			const Way way = [&](double t_s) {
				const double gone = drag.x_m(t_s), aside = beside + (beside_end - beside) * gone;
				return Eigen::Vector3d(0.2 * (gone * X + (aside + gone * std::tan(angle_rad)) * Y));
			};
			ended += static_cast<int>(ends(in_a_task(way, 1.2 + duration_s + 1.5)));
		}
		return ended;
	};
	CHECK(ends_of(0.43, 0.0, 0.0) == 3);
	CHECK(ends_of(0.61, 0.0, 0.0) == 0);
	CHECK(ends_of(0.0, 0.35, 0.35) == 3);
	CHECK(ends_of(0.0, 0.5, 0.5) == 0);
	CHECK(ends_of(0.0, 0.6, 0.0) == 3);
	CHECK(ends_of(0.0, 0.75, 0.0) == 0);
}

TEST_CASE("how sure a gesture is counts its own strokes only, from its first instant on") {
	// There in two strokes, all the way back, and then off the task's way.
	const std::vector<Drag> before{ { .onset_s = 1.0, .duration_s = 0.5, .amplitude_m = 0.1 },
		{ .onset_s = 2.7, .duration_s = 0.5, .amplitude_m = 0.1 },
		{ .onset_s = 4.5, .duration_s = 0.7, .amplitude_m = -0.2 } };
	const Drag aside{ .onset_s = 8.0, .duration_s = 0.6, .amplitude_m = 0.2 };
	const Eigen::Vector3d direction(0.6, 0.8, 0.0); // by 53 degrees
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	double greatest = 0.0;
	const Way way = [&](double t_s) {
		greatest = t_s > aside.onset_s ? std::max(greatest, recogniser.confidence()) : 0.0;
		return Eigen::Vector3d(x_m(before, t_s) * X + aside.x_m(t_s) * direction);
	};
	const Events events = watch(recogniser, way, 9.5);
	REQUIRE(events.first_shown_s < 3.0);
	CHECK(greatest > 0.0); // it began
	CHECK(greatest < 0.5);
}

TEST_CASE("what has given way to another gesture does not begin again in the same motion") {
	Task far;
	far.amplitude_m = 0.4;
	const auto near_model = model("near", X, false), far_model = model("far", X, false);
	for (const double duration_s : { 0.6, 1.0, 1.5 }) {
		CAPTURE(duration_s);
		GestureRecogniser recogniser({ ExpectedGesture{ near_model, std::nullopt }, { far_model, far } });
		const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
		const std::vector<std::string> said = watch(recogniser, along(X, { drag }), 5.0).said;
		REQUIRE(!said.empty());
		CHECK(std::ranges::count(said, "ended near") == 1);
		CHECK(said.back() == "ended near");
	}
}

TEST_CASE("what is done at its task ends there, and is not one like it that may be made anywhere") {
	for (const double amplitude_m : { 0.2, 0.15 }) {
		for (const double angle_rad : { 0.0, 0.2 }) {
			CAPTURE(amplitude_m);
			CAPTURE(angle_rad);
			Task task;
			task.axis = { std::cos(angle_rad), std::sin(angle_rad), 0.0 };
			task.amplitude_m = amplitude_m;
			const auto here = model("here", X, false), anywhere = model("anywhere", X, true);
			GestureRecogniser recogniser({ ExpectedGesture{ here, task }, { anywhere, std::nullopt } });
			const Drag drag{ .onset_s = 1.0, .duration_s = 0.8, .amplitude_m = amplitude_m };
			const std::vector<std::string> said = watch(recogniser, along(task.axis, { drag }), 3.5).said;
			CHECK(std::ranges::count(said, "ended here") == 1);
			CHECK(std::ranges::count(said, "ended anywhere") == 0);
		}
	}
}

TEST_CASE("a hand that was rejected and is gone for a second is forgotten, and what comes begins anew") {
	constexpr double LOST_S = 3.5, FOUND_S = 8.0;
	constexpr double STANDS_M = 0.035; // where it is found: further than what counts as the start
	const Drag aside{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.34 };
	const Drag drag{ .onset_s = 10.0, .duration_s = 0.8, .amplitude_m = 0.2 - STANDS_M };
	const Way way = [&](double t_s) {
		return t_s < LOST_S ? Eigen::Vector3d(aside.x_m(t_s) * Eigen::Vector3d(0.62, 0.73, 0.29))
							: Eigen::Vector3d((STANDS_M + drag.x_m(t_s)) * X);
	};
	const Events gone = in_a_task(way, FOUND_S - 0.5, LOST_S);
	CHECK(none_ends(gone));
	CHECK(std::abs(gone.last_value_m) < 1e-3);
	const Events events = in_a_task(way, 12.0, LOST_S, FOUND_S);
	CHECK(events.said.back() == "ended sideways");
	CHECK(std::ranges::count(events.said, "ended sideways") == 1);
}

TEST_CASE("a hand that goes a third of the way, rests, and comes back however slowly has given up") {
	for (const double part : { 0.25, 0.3, 0.35 }) {
		for (const double back_s : { 1.0, 3.0, 4.0, 5.0 }) {
			CAPTURE(part);
			CAPTURE(back_s);
			const Way way = along(X, { { 0.6, 1.0, 0.2 * part }, { 2.1, back_s, -0.2 * part } });
			const std::vector<std::string> given_up{ "started sideways", "aborted sideways" };
			CHECK(in_a_task(way, 2.1 + back_s + 2.0).said == given_up);
		}
	}
}
