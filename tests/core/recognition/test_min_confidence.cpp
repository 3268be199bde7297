// Without a task: the least confidence of a shown gesture.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

GestureRecogniser least(double min_confidence, GestureRecogniser recogniser = without_task()) {
	recogniser.set_min_confidence(min_confidence);
	return recogniser;
}

/// A drag of 0.2 m in 1 s, at this angle to the axis of "sideways".
TestPath oblique(double angle_rad) {
	return along({ std::cos(angle_rad), std::sin(angle_rad), 0.0 }, { DRAG });
}

} // namespace

TEST_CASE("a minimum confidence of 0.9 delays the start, not the end") {
	for (const TestPath &path : { along(X, { DRAG }), along(-Z, { DRAG }) }) {
		const Events any = watch(least(0.0), path, 2.5), sure = watch(least(0.9), path, 2.5);
		CHECK(sure.names == any.names);
		CHECK(sure.first_shown_s < any.first_shown_s + 0.1);
		CHECK(sure.last_ended_s == any.last_ended_s);
		CHECK(sure.last_value_m == near(any.last_value_m).epsilon(1e-6));
	}
}

TEST_CASE("a gesture shown later starts without a step") {
	for (const double angle_rad : { 0.4, 0.45 }) {
		CAPTURE(angle_rad);
		const Events any = watch(least(0.0), oblique(angle_rad), 2.5),
					 sure = watch(least(0.7), oblique(angle_rad), 2.5);
		REQUIRE(sure.names == any.names);
		REQUIRE(sure.first_shown_s > any.first_shown_s);
		// Twice the rate of the blend between two gestures, plus the hand's own motion.
		CHECK(sure.largest_step < 2.0 * FASTEST_M_MS + 4e-4);
	}
}

TEST_CASE("no gesture starts or ends below the minimum confidence") {
	for (const double angle_rad : { 0.0, 0.3, 0.5 }) {
		for (const double min_confidence : { 0.1, 0.9 }) {
			INFO("angle ", angle_rad, ", min confidence ", min_confidence);
			GestureRecogniser recogniser = least(min_confidence);
			bool was_shown = false;
			const TestPath watched = [&](double t_s) {
				const bool is_shown = recogniser.gesture() >= 0;
				CHECK((!is_shown || was_shown || recogniser.confidence() >= min_confidence));
				was_shown = is_shown;
				return oblique(angle_rad)(t_s);
			};
			const Events events = watch(recogniser, watched, 2.5);
			CHECK((!events.names.empty() || events.last_value_m == 0.0));
			CHECK((has_no_end(events) || events.last_confidence >= min_confidence));
		}
	}
	const double confidence = watch(least(0.0), oblique(0.35), 2.5).last_confidence;
	REQUIRE(confidence > 0.1);
	REQUIRE(confidence < 0.999);
	CHECK(!has_no_end(watch(least(confidence - 0.001), oblique(0.35), 2.5)));
	CHECK(has_no_end(watch(least(confidence + 0.001), oblique(0.35), 2.5)));
}

TEST_CASE("with a task the minimum confidence changes nothing") {
	const Events any = watch_with_task(along(X, { DRAG }), 2.5);
	const Events sure = watch(least(1.0, with_task()), along(X, { DRAG }), 2.5);
	CHECK(sure.names == ENDS);
	CHECK(sure.last_ended_s == any.last_ended_s);
	CHECK(sure.last_value_m == any.last_value_m);
}
