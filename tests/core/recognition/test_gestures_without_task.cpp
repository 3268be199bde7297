// Gestures without a task: events, values and confidence.

#include "gesture_events.h"
#include "near.h"
#include "signal/minimum_jerk.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Time at which twice DRAG has moved by a quarter: 10 s^3 - 15 s^4 + 6 s^5 = 0.25.
constexpr double TURNS_S = 0.6 + 0.36;

Eigen::Vector3d turns_at_right_angles(double t_s) {
	const double moved_m = 2.0 * DRAG.x_m(t_s);
	return { std::min(moved_m, 0.1), 0.0, std::max(moved_m - 0.1, 0.0) };
}

Eigen::Vector3d halts(double t_s) {
	return turns_at_right_angles(std::min(t_s, TURNS_S));
}

Eigen::Vector3d drifts_after_end(double t_s) {
	const Eigen::Vector3d oblique(std::cos(0.33), std::sin(0.33), 0.0);
	return DRAG.x_m(t_s) * oblique + 0.12 * std::clamp(t_s - 1.3, 0.0, 0.35) * Y;
}

GestureRecogniser least(double min_confidence, GestureRecogniser recogniser = without_task()) {
	recogniser.set_min_confidence(min_confidence);
	return recogniser;
}

/// Drags that end, of 40 hands that come from elsewhere and rest before.
int drags_after(double rest_s, const StartSettings &start = {}) {
	constexpr double COMES_S = 1.0, LONG_S = 0.5;
	int ended = 0;
	for (unsigned seed = 0; seed < 40; ++seed) {
		GestureRecogniser recogniser({ { models()[0], std::nullopt } });
		recogniser.set_start_condition(start);
		Tremor tremor(5e-4, seed);
		const double from_s = COMES_S + LONG_S + rest_s + 0.001 * seed;
		const TestPath path = [&](double t_s) {
			const double comes = 1.0 - minimum_jerk((t_s - COMES_S) / LONG_S).value;
			const double moved = minimum_jerk((t_s - from_s) / (0.5 + 0.01 * seed)).value;
			const Eigen::Vector3d sways(std::sin(2.0 * t_s + seed), std::sin(2.7 * t_s), 0.0);
			return Eigen::Vector3d(
					comes * Eigen::Vector3d(-0.1, -0.15, 0.1) + 0.2 * moved * X + 0.001 * sways + tremor());
		};
		const TestTracker tracker{ .rate_hz = 90.0, .noise_m = 0.0 };
		const Events events = watch(recogniser, path, from_s + 2.5, tracker);
		ended += events.last_ended_s > from_s ? 1 : 0;
	}
	return ended;
}

/// A drag of 0.2 m in 1 s, at this angle to the axis of "horizontal_drag".
TestPath oblique(double angle_rad) {
	return along({ std::cos(angle_rad), std::sin(angle_rad), 0.0 }, { DRAG });
}

} // namespace

TEST_CASE("without a task a drag ends after another movement and a rest of seconds") {
	for (const double rest_s : { 2.0, 3.0, 5.0, 20.0 }) {
		CAPTURE(rest_s);
		CHECK(drags_after(rest_s) >= 38);
	}
}

TEST_CASE("without a task a dwell before the drag is enough") {
	for (const double rest_s : { 2.0, 3.0 }) {
		CAPTURE(rest_s);
		CHECK(drags_after(rest_s, { .kind = StartKind::DWELL }) >= 38);
	}
}

TEST_CASE("without a task each hand makes its events") {
	const Eigen::Vector3d oblique(std::cos(0.35), 0.0, std::sin(0.35)); // 20 degrees off
	for (const auto &[hand, path, length_s, events] : {
				 HandRow{ "to the right", along(X, { DRAG }), 2.5, ENDS },
				 { "to the left", along(-X, { DRAG }), 2.5, ENDS },
				 { "obliquely", along(oblique, { DRAG }), 2.5, ENDS },
				 { "up", along(Y, { DRAG }), 2.5, times(1, "vertical_drag") },
				 { "down", along(-Y, { DRAG }), 2.5, times(1, "vertical_drag") },
				 { "away", along(-Z, { DRAG }), 2.5, times(1, "tap") },
				 { "to the user: a push has one direction", along(Z, { DRAG }), 2.5, NOTHING },
				 { "in 0.15 s", along(X, { { 0.6, 0.15, 0.2 } }), 2.15, ENDS },
				 { "in 4 s", along(X, { { 0.6, 4.0, 0.2 } }), 6.0, ENDS },
				 { "overshoots", along(X, { { 0.6, 0.9, 0.23 }, { 1.5, 0.3, -0.03 } }), 3.0, ENDS },
				 { "drifts 4 cm after its end", drifts_after_end, 3.0, ENDS },
				 { "stops half-way", along(X, { { 0.6, 0.8, 0.1 } }), 4.0, ABORTS },
				 { "turns at right angles", turns_at_right_angles, TURNS_S + 0.4, ABORTS },
				 { "halts: it may go on", halts, TURNS_S + 0.4, STARTS },
		 }) {
		INFO(hand);
		CHECK(watch_without_task(path, length_s).names == events);
	}
	CHECK(watch_without_task(along(X, { { 0.6, 0.8, 0.1 } }), 4.0).largest_step < 0.003);
	const Events returned = watch_without_task(along(X, { { 0.6, 0.8, 0.1 }, { 3.0, 0.8, -0.1 } }), 5.0);
	CHECK(has_no_end(returned));
	CHECK(std::abs(returned.last_value_m) < 0.005);
}

TEST_CASE("without a task the value is the distance since the onset") {
	struct Row {
		double angle_rad, amplitude_m, duration_s, tolerance;
	};
	for (const auto &[angle_rad, amplitude_m, duration_s, tolerance] : { Row{ 0.0, 0.2, 0.3, 0.004 },
				 { 0.0, 0.2, 0.8, 0.004 }, { 0.0, 0.15, 1.0, 0.02 }, { 0.35, 0.15, 1.0, 0.02 },
				 { 0.35, -0.15, 1.0, 0.02 }, { 0.0, -0.35, 1.0, 0.02 }, { 0.35, 0.35, 1.0, 0.02 } }) {
		INFO("angle ", angle_rad, ", amplitude ", amplitude_m, ", duration ", duration_s);
		const Drag drag{ 0.6, duration_s, amplitude_m };
		const Eigen::Vector3d axis(std::cos(angle_rad), std::sin(angle_rad), 0.0);
		const Events events = watch_without_task(along(axis, { drag }), 1.2 + duration_s);
		CHECK(events.names == ENDS);
		CHECK(events.last_value_m == near(std::abs(amplitude_m)).epsilon(tolerance));
		// After 0.4 s the slower hands are at a third of the amplitude.
		CHECK(events.first_shown_s < drag.onset_s + 0.4);
		CHECK(drag.x_m(events.last_ended_s) / amplitude_m > 0.9);
	}
}

TEST_CASE("the value of every gesture begins and returns without a step") {
	const Drag back{ .onset_s = 2.1, .duration_s = 1.0, .amplitude_m = -0.2 };
	for (const Eigen::Vector3d &axis : { X, Y, Eigen::Vector3d(-Z) }) {
		CAPTURE(axis);
		const Events events = watch_without_task(along(axis, { DRAG, back }), 4.0);
		CHECK(events.names.size() == 2);
		CHECK(events.largest_step < 1.5 * FASTEST_M_MS);
		CHECK(events.last_value_m == near(0.0).epsilon(1e-6));
	}
}

TEST_CASE("an ended gesture keeps its value until the next one begins") {
	const Drag next{ .onset_s = 1.9, .duration_s = 0.5, .amplitude_m = 0.1 };
	for (const double angle : { 0.0, 1.2 }) { // from vertical_drag
		CAPTURE(angle);
		const Eigen::Vector3d direction(0.0, std::cos(angle), std::sin(angle));
		const TestPath path = [&](double t_s) {
			return Eigen::Vector3d(DRAG.x_m(t_s) * X + next.x_m(t_s) * direction);
		};
		const Events events = watch_without_task(path, 2.4);
		CHECK(events.names.back() == (angle == 0.0 ? "started vertical_drag" : "ended horizontal_drag"));
		CHECK(events.last_value_m == near(angle == 0.0 ? 0.1 : 0.2).epsilon(angle == 0.0 ? 0.05 : 0.02));
		CHECK(events.largest_step < 1.2 * FASTEST_M_MS);
	}
}

TEST_CASE("without a task only a return after a long dwell is a gesture") {
	for (const double duration_s : { 1.0, 2.0 }) {
		for (const double far_m : { 0.2, 0.25 }) { // 0.25: beyond the model's amplitude
			for (const double dwell_s : { 0.5, 1.6 }) {
				INFO("duration ", duration_s, ", far ", far_m, ", dwell ", dwell_s);
				const Drag there{ 0.9, duration_s, far_m }, back{ 0.9 + duration_s + dwell_s, 0.9, -far_m };
				CHECK(watch_without_task(along(X, { there, back }), 3.5 + duration_s + dwell_s).names ==
						times(dwell_s < 1.0 ? 1 : 2, "horizontal_drag"));
			}
		}
	}
}

TEST_CASE("without a task a soon repeated gesture needs no rest") {
	const auto ends_with_return_at = [](double back_s, const Eigen::Vector3d &axis) {
		const Drag back{ back_s, 0.6, -0.2 }, again{ back_s + 0.7, 0.6, 0.2 };
		return ends(watch_without_task(along(axis, { DRAG, back, again }), back_s + 2.5));
	};
	for (const Eigen::Vector3d &axis : { X, Y, Eigen::Vector3d(-Z) }) {
		CAPTURE(axis);
		CHECK(ends_with_return_at(1.7, axis) == 2);
	}
	CHECK(ends_with_return_at(4.5, -Z) == 1);
}

TEST_CASE("without a task a hand found elsewhere makes no gesture") {
	for (const double lost_s : { 1.5, 20.0 }) {
		const TestPath path = [](double t_s) -> Eigen::Vector3d { return (t_s < 2.0 ? 0.0 : 0.2) * X; };
		CHECK(watch_without_task(path, lost_s + 4.0, { 1.5, 1.5 + lost_s }).names.empty());
	}
}

TEST_CASE("without a task a drag down and a drag up 1.5 s later end") {
	for (const double rate_hz : { 60.0, 90.0, 110.0, 120.0 }) {
		for (const double noise_m : { 1e-4, 2e-4, 3e-4 }) {
			INFO("rate ", rate_hz, ", noise ", noise_m);
			const TestPath path = along(-Y, { DRAG, { 3.1, 0.8, -0.2 } });
			const Events events = watch_without_task(path, 9.0, { .rate_hz = rate_hz, .noise_m = noise_m });
			CHECK(events.names == times(2, "vertical_drag"));
			CHECK(events.last_value_m == near(0.2).epsilon(0.02)); // the hand stays at the end
		}
	}
}

TEST_CASE("confidence is above 0.95 for a straight gesture, less for oblique ones") {
	const Events plain = watch_without_task(along(X, { DRAG }), 2.5);
	CHECK(plain.last_confidence > 0.95);
	CHECK(plain.last_confidence <= 1.0);
	const Eigen::Vector3d oblique(std::cos(0.4), 0.0, std::sin(0.4));
	CHECK(watch_without_task(along(oblique, { DRAG }), 2.5).last_confidence < plain.last_confidence);
	CHECK(without_task().confidence() == 0.0);
}

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
					 sure = watch(least(0.98), oblique(angle_rad), 2.5);
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
	REQUIRE(confidence < 1.0 - 1e-5);
	CHECK(!has_no_end(watch(least(confidence - 1e-5), oblique(0.35), 2.5)));
	CHECK(has_no_end(watch(least(confidence + 1e-5), oblique(0.35), 2.5)));
}

TEST_CASE("with a task the minimum confidence changes nothing") {
	const Events any = watch_with_task(along(X, { DRAG }), 2.5);
	const Events sure = watch(least(1.0, with_task()), along(X, { DRAG }), 2.5);
	CHECK(sure.names == ENDS);
	CHECK(sure.last_ended_s == any.last_ended_s);
	CHECK(sure.last_value_m == any.last_value_m);
}
