// Without a task: the least confidence of a shown gesture.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

struct Shown {
	Events events;
	std::vector<double> values_m; ///< synthesised value at each frame
	double least_at_start = 1e9;  ///< least confidence in the frame after a gesture starts
	double most_while_none = 0.0; ///< greatest |synthesised value| while no gesture is active, m
};

Shown shown(GestureRecogniser recogniser, double min_confidence, const TestPath &path) {
	recogniser.set_min_confidence(min_confidence);
	Shown shown;
	int last = -1;
	const TestPath watched = [&](double t_s) {
		const int gesture = recogniser.gesture();
		const double value_m = recogniser.motion(MotionSource::SYNTHESISED).value_m;
		shown.values_m.push_back(value_m);
		if (gesture >= 0 && gesture != last) {
			shown.least_at_start = std::min(shown.least_at_start, recogniser.confidence());
		} else if (gesture < 0) {
			shown.most_while_none = std::max(shown.most_while_none, std::abs(value_m));
		}
		last = gesture;
		return path(t_s);
	};
	shown.events = watch(recogniser, watched, 2.5);
	return shown;
}

Shown shown(double min_confidence, const TestPath &path) {
	return shown({ models(), std::nullopt, MotionMode::PHASE }, min_confidence, path);
}

/// A drag of 0.2 m in 1 s, at this angle to the axis of "sideways".
TestPath oblique(double angle_rad) {
	return along({ std::cos(angle_rad), std::sin(angle_rad), 0.0 }, { DRAG });
}

} // namespace

TEST_CASE("a minimum confidence of 0.9 delays the start, not the end") {
	for (const Eigen::Vector3d &axis : { X, Eigen::Vector3d(-Z) }) {
		CAPTURE(axis.transpose());
		const Shown any = shown(0.0, along(axis, { DRAG })), sure = shown(0.9, along(axis, { DRAG }));
		CHECK(sure.events.names == any.events.names);
		CHECK(sure.events.first_shown_s < any.events.first_shown_s + 0.1);
		CHECK(sure.events.last_ended_s == any.events.last_ended_s);
		CHECK(sure.events.last_value_m == near(any.events.last_value_m).epsilon(1e-6));
	}
}

TEST_CASE("a gesture shown later starts without a step") {
	for (const double angle_rad : { 0.4, 0.45 }) {
		CAPTURE(angle_rad);
		const Shown any = shown(0.0, oblique(angle_rad)), sure = shown(0.7, oblique(angle_rad));
		REQUIRE(sure.events.names == any.events.names);
		REQUIRE(sure.events.first_shown_s > any.events.first_shown_s);
		// Twice the rate of the blend between two gestures, plus the hand's own motion.
		CHECK(sure.events.largest_step < 2.0 * FASTEST_M_MS + 4e-4);
	}
}

TEST_CASE("no gesture starts or ends below the minimum confidence") {
	for (const double angle_rad : { 0.0, 0.3, 0.5 }) {
		for (const double min_confidence : { 0.1, 0.9 }) {
			INFO("angle ", angle_rad, ", min confidence ", min_confidence);
			const Shown sure = shown(min_confidence, oblique(angle_rad));
			CHECK(sure.least_at_start >= min_confidence);
			CHECK((!sure.events.names.empty() || sure.most_while_none == 0.0));
			CHECK((has_no_end(sure.events) || sure.events.last_confidence >= min_confidence));
		}
	}
	const double confidence = shown(0.0, oblique(0.35)).events.last_confidence;
	REQUIRE(confidence > 0.1);
	REQUIRE(confidence < 0.999);
	CHECK(!has_no_end(shown(confidence - 0.001, oblique(0.35)).events));
	CHECK(has_no_end(shown(confidence + 0.001, oblique(0.35)).events));
}

TEST_CASE("with a task the minimum confidence changes nothing") {
	const auto at_task = [](double min_confidence) {
		return shown({ { models()[0] }, Task{}, MotionMode::PHASE }, min_confidence, along(X, { DRAG }));
	};
	const Shown any = at_task(0.0), sure = at_task(1.0);
	CHECK(sure.events.names == times(1, "sideways"));
	CHECK(sure.values_m == any.values_m);
}
