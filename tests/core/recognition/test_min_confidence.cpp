// With nothing given: how sure a gesture has to be before it is shown.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

struct Shown {
	Events events;
	std::vector<double> values_m; ///< synthesised, at each look of the hand
	double least_at_start = 1e9;  ///< confidence in the frame after a gesture was first shown
	double most_while_none = 0.0; ///< size of the synthesised value while no gesture was under way, m
};

Shown shown(double min_confidence, const Way &way, double length_s, const std::optional<Task> &task = {}) {
	GestureRecogniser recogniser(task ? std::vector{ models()[0] } : models(), task, MotionMode::PHASE);
	recogniser.set_min_confidence(min_confidence);
	Shown shown;
	int last = -1;
	const Way watched = [&](double t_s) {
		const int gesture = recogniser.gesture();
		const double value_m = recogniser.motion(MotionSource::SYNTHESISED).value_m;
		shown.values_m.push_back(value_m);
		if (gesture >= 0 && gesture != last) {
			shown.least_at_start = std::min(shown.least_at_start, recogniser.confidence());
		} else if (gesture < 0) {
			shown.most_while_none = std::max(shown.most_while_none, std::abs(value_m));
		}
		last = gesture;
		return way(t_s);
	};
	shown.events = watch(recogniser, watched, length_s);
	return shown;
}

/// 0.2 m within 1 s, this far off the axis of "sideways".
Way oblique(double angle_rad) {
	return along(Eigen::Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0.0), { DRAG });
}

} // namespace

TEST_CASE("a reach that goes too far aside is shown for a while, but not where it has to be likely first") {
	const Shown any = shown(0.0, oblique(0.5), 2.5), likely = shown(0.3, oblique(0.5), 2.5);
	CHECK(any.events.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	CHECK(likely.events.said.empty());
	CHECK(likely.most_while_none == 0.0);
}

TEST_CASE("drags, taps and lifts after a rest are shown about as soon, and end on the same instant") {
	for (const Eigen::Vector3d &axis : { X, Y, Eigen::Vector3d(-X), Eigen::Vector3d(-Z) }) {
		CAPTURE(axis.transpose());
		const Shown any = shown(0.0, along(axis, { DRAG }), 2.5);
		const Shown sure = shown(0.9, along(axis, { DRAG }), 2.5);
		CHECK(sure.events.said == any.events.said);
		CHECK(sure.events.first_shown_s < any.events.first_shown_s + 0.1);
		CHECK(sure.events.last_ended_s == any.events.last_ended_s);
		CHECK(sure.events.last_value_m == near(any.events.last_value_m).epsilon(1e-6));
	}
}

TEST_CASE("what is shown later comes in without a step") {
	for (const double angle_rad : { 0.4, 0.42, 0.45 }) {
		CAPTURE(angle_rad);
		const Shown any = shown(0.0, oblique(angle_rad), 2.5), sure = shown(0.7, oblique(angle_rad), 2.5);
		REQUIRE(sure.events.said == any.events.said);
		REQUIRE(sure.events.first_shown_s > any.events.first_shown_s);
		// Twice as fast as from one gesture's motion to another's, beside the hand's own way.
		CHECK(sure.events.largest_step < 2.0 * FASTEST_M_MS + 4e-4);
	}
}

TEST_CASE("no gesture is shown, or ends, below that confidence") {
	for (const double angle_rad : { 0.0, 0.2, 0.3, 0.4, 0.5 }) {
		for (const double min_confidence : { 0.1, 0.5, 0.9 }) {
			CAPTURE(angle_rad);
			CAPTURE(min_confidence);
			const Shown sure = shown(min_confidence, oblique(angle_rad), 2.5);
			CHECK(sure.least_at_start >= min_confidence);
			CHECK((none_ends(sure.events) || sure.events.last_confidence >= min_confidence));
		}
	}
	const double confidence = shown(0.0, oblique(0.35), 2.5).events.last_confidence;
	REQUIRE(confidence > 0.1);
	REQUIRE(confidence < 0.999);
	CHECK(!none_ends(shown(confidence - 0.001, oblique(0.35), 2.5).events));
	CHECK(none_ends(shown(confidence + 0.001, oblique(0.35), 2.5).events));
}

TEST_CASE("at a task it changes nothing") {
	const Shown any = shown(0.0, along(X, { DRAG }), 2.5, Task{}),
				sure = shown(1.0, along(X, { DRAG }), 2.5, Task{});
	CHECK(sure.events.said == times(1, "sideways"));
	CHECK(sure.values_m == any.values_m);
}
