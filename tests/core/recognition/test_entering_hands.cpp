// Hands that come into view on their way: nobody saw them at rest.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Nothing is seen of it before the drag has come to this share of its way.
Events drag_from(double share, double duration_s, bool has_task, const Eigen::Vector3d &axis = X,
		const Eigen::Vector3d &start_m = Eigen::Vector3d::Zero()) {
	const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
	double enters_s = drag.onset_s;
	while (drag.x_m(enters_s) < share * drag.amplitude_m) {
		enters_s += 1e-3;
	}
	GestureRecogniser recogniser(has_task ? std::vector{ models()[0] } : models(),
			has_task ? std::optional(Task{}) : std::nullopt, MotionMode::PHASE);
	return watch(
			recogniser, [&](double t_s) { return Eigen::Vector3d(start_m + drag.x_m(t_s) * axis); }, 4.0,
			-1.0, enters_s);
}

} // namespace

TEST_CASE("with the task known a hand that comes into view on the first part of its way makes the gesture") {
	for (const double duration_s : { 0.4, 0.7, 1.2, 2.0 }) {
		for (const double share : { 0.02, 0.05, 0.1, 0.2, 0.3, 0.4 }) {
			CAPTURE(duration_s);
			CAPTURE(share);
			if (share == 0.4 && duration_s == 0.4) {
				continue; // is seen on its way for less than 0.2 s
			}
			const Events events = drag_from(share, duration_s, true);
			CHECK(events.said == times(1, "sideways"));
			CHECK(events.last_value_m == near(0.2).epsilon(0.02));
		}
	}
}

TEST_CASE("one that comes into view later has not been seen to make it, nor one that goes elsewhere") {
	for (const double share : { 0.55, 0.7, 0.9 }) {
		CAPTURE(share);
		CHECK(drag_from(share, 0.7, true).said.empty());
	}
	for (const double share : { 0.05, 0.2, 0.4 }) {
		CAPTURE(share);
		CHECK_MESSAGE(none_ends(drag_from(share, 0.7, true, Y)), "upward");
		CHECK_MESSAGE(none_ends(drag_from(share, 0.7, true, -X)), "back");
		CHECK_MESSAGE(none_ends(drag_from(share, 0.7, true, X, 0.12 * Y)), "beside it");
		CHECK_MESSAGE(none_ends(drag_from(share, 0.7, true, X, { -0.2, 0.0, 0.0 })), "to its start");
	}
}

TEST_CASE("with nothing given only the very beginning may have been missed") {
	for (const double duration_s : { 0.4, 0.7, 1.2, 2.0 }) {
		CAPTURE(duration_s);
		CHECK(drag_from(0.01, duration_s, false).said == times(1, "sideways"));
		for (const double share : { 0.3, 0.5, 0.7 }) {
			CAPTURE(share);
			CHECK(drag_from(share, duration_s, false).said.empty());
		}
	}
}
