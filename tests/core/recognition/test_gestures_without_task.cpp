// Gestures without a task: events, values and confidence.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("without a task each gesture is found in each of its directions") {
	CHECK(watch_without_task(along(X, { DRAG }), 2.5).names == times(1, "sideways"));
	CHECK(watch_without_task(along(-X, { DRAG }), 2.5).names == times(1, "sideways"));
	CHECK(watch_without_task(along(Y, { DRAG }), 2.5).names == times(1, "upright"));
	CHECK(watch_without_task(along(-Y, { DRAG }), 2.5).names == times(1, "upright"));
	CHECK(watch_without_task(along(-Z, { DRAG }), 2.5).names == times(1, "push"));
	CHECK(watch_without_task(along(Z, { DRAG }), 2.5).names.empty());   // a push has one direction
	const Eigen::Vector3d oblique(std::cos(0.35), 0.0, std::sin(0.35)); // 20 degrees off
	CHECK(watch_without_task(along(oblique, { DRAG }), 2.5).names == times(1, "sideways"));
}

TEST_CASE("without a task gestures of 0.15 to 4 s are found") {
	for (const double duration_s : { 0.15, 0.3, 2.5, 4.0 }) {
		CAPTURE(duration_s);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
		CHECK(watch_without_task(along(X, { drag }), duration_s + 2.0).names == times(1, "sideways"));
	}
}

TEST_CASE("without a task the value is distance in the hand's direction") {
	for (const double angle : { 0.0, 0.35 }) {
		for (const double amplitude_m : { 0.15, 0.35 }) {
			for (const double sense : { 1.0, -1.0 }) {
				CAPTURE(angle);
				CAPTURE(amplitude_m);
				const Drag drag{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = amplitude_m };
				const Eigen::Vector3d axis(std::cos(angle), std::sin(angle), 0.0);
				const Events events = watch_without_task(along(sense * axis, { drag }), 2.2);
				CHECK(events.last_value_m == near(amplitude_m).epsilon(0.02));
				// After 0.4 s the hand is at a third of the amplitude.
				CHECK(events.first_shown_s < drag.onset_s + 0.4);
			}
		}
	}
}

TEST_CASE("without a task the value counts from the onset, before detection") {
	for (const double duration_s : { 0.3, 0.8 }) {
		CAPTURE(duration_s);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
		const double until_s = drag.onset_s + duration_s + 0.6;
		CHECK(watch_without_task(along(X, { drag }), until_s).last_value_m == near(0.2).epsilon(0.004));
	}
}

TEST_CASE("without a task a gesture of double amplitude ends at its endpoint") {
	const Drag far{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.4 };
	const Events events = watch_without_task(along(X, { far }), 2.5);
	CHECK(events.names == times(1, "sideways"));
	CHECK(far.x_m(events.last_ended_s) > 0.36);
}

TEST_CASE("a model that ends in motion ends before the hand stops") {
	// A contact at 0.8 of the amplitude, at 0.6734 of the duration: 10 s^3 - 15 s^4 + 6 s^5 = 0.8.
	constexpr double CONTACT = 0.6734;
	std::vector<TrainingRecording> recordings = drag_recordings();
	for (TrainingRecording &recording : recordings) {
		const double duration_s = recording.end_s - 0.5;
		recording.end_s = 0.5 + CONTACT * duration_s;
		recording.task.amplitude_m = 0.8 * 0.2;
	}
	const auto contact = std::make_shared<const GestureModel>(
			train("contact", "index_along_axis", recordings, {}).value());
	for (const double duration_s : { 0.8, 1.3 }) {
		CAPTURE(duration_s);
		GestureRecogniser recogniser({ contact }, std::nullopt, MotionMode::PHASE);
		const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
		const Events events = watch(recogniser, along(X, { drag }), 2.5);
		CHECK(events.names == times(1, "contact"));
		CHECK(std::abs(events.last_ended_s - (0.6 + CONTACT * duration_s)) < 0.05);
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
	const Drag next{ .onset_s = 2.0, .duration_s = 0.5, .amplitude_m = 0.1 };
	for (const double angle : { 0.0, 0.5, 0.7 }) { // from upright
		CAPTURE(angle);
		const Eigen::Vector3d direction(0.0, std::cos(angle), std::sin(angle));
		const TestPath path = [&](double t_s) {
			return Eigen::Vector3d(DRAG.x_m(t_s) * X + next.x_m(t_s) * direction);
		};
		const Events events = watch_without_task(path, 2.6);
		if (angle == 0.0) {
			CHECK(events.names.back() == "started upright");
			CHECK(events.last_value_m == near(0.1).epsilon(0.05));
		} else {
			CHECK(events.names == times(1, "sideways"));
			CHECK(events.last_value_m == near(0.2).epsilon(0.02));
		}
		CHECK(events.largest_step < 1.2 * FASTEST_M_MS);
	}
}

TEST_CASE("ten taps in a row each start and end once") {
	std::vector<Drag> strokes;
	for (int i = 0; i < 10; ++i) {
		strokes.push_back({ .onset_s = 0.6 + i, .duration_s = 0.45, .amplitude_m = 0.2 });
		strokes.push_back({ .onset_s = 1.02 + i, .duration_s = 0.4, .amplitude_m = -0.2 });
	}
	CHECK(watch_without_task(along(-Z, strokes), 11.0).names == times(10, "push"));
	CHECK(watch_with_task(along(X, strokes), 11.0).names == times(10, "sideways"));
}

TEST_CASE("without a task only a return after a long dwell is a gesture") {
	for (const double duration_s : { 1.0, 4.0 }) {
		for (const double far_m : { 0.2, 0.25 }) { // 0.25: beyond the model's amplitude
			CAPTURE(duration_s);
			CAPTURE(far_m);
			const auto names_after = [&](double dwell_s) {
				const Drag there{ .onset_s = 0.9, .duration_s = duration_s, .amplitude_m = far_m };
				const Drag back{ 0.9 + duration_s + dwell_s, 0.9, -far_m };
				return watch_without_task(along(X, { there, back }), 3.5 + duration_s + dwell_s).names;
			};
			CHECK(names_after(0.5) == times(1, "sideways"));
			CHECK(names_after(1.6) == times(2, "sideways"));
		}
	}
}

TEST_CASE("a drift of 4 cm after the endpoint does not abort") {
	const Eigen::Vector3d oblique(std::cos(0.33), std::sin(0.33), 0.0);
	const TestPath drifting = [&](double t_s) {
		return Eigen::Vector3d(DRAG.x_m(t_s) * oblique + 0.12 * std::clamp(t_s - 1.3, 0.0, 0.35) * Y);
	};
	CHECK(watch_without_task(drifting, 3.0).names == times(1, "sideways"));
}

TEST_CASE("without a task a right-angle turn half-way aborts within 0.4 s") {
	// A gesture that pauses there may still continue.
	constexpr double TURNS_S = 0.6 + 0.36; // a quarter of twice the amplitude: 10 s^3 - 15 s^4 + 6 s^5 = 0.25
	const TestPath path = [](double t_s) {
		const double moved_m = 2.0 * DRAG.x_m(t_s);
		return Eigen::Vector3d(std::min(moved_m, 0.1), 0.0, std::max(moved_m - 0.1, 0.0));
	};
	CHECK(watch_without_task(path, TURNS_S + 0.4).names == started_and_aborted("sideways"));
	const TestPath halts = [&](double t_s) { return path(std::min(t_s, TURNS_S)); };
	CHECK(watch_without_task(halts, TURNS_S + 0.4).names == std::vector<std::string>{ "started sideways" });
}

TEST_CASE("without a task a stop half-way aborts; its return ends nothing") {
	const Drag half{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.1 };
	const Drag back{ .onset_s = 3.0, .duration_s = 0.8, .amplitude_m = -0.1 };
	const Events open = watch_without_task(along(X, { half }), 4.0);
	CHECK(open.names == started_and_aborted("sideways"));
	CHECK(open.largest_step < 0.003);
	const Events events = watch_without_task(along(X, { half, back }), 5.0);
	CHECK(has_no_end(events));
	CHECK(std::abs(events.last_value_m) < 0.005);
}

TEST_CASE("an early return ends nothing and starts at most once") {
	for (const double far : { 0.17, 0.3, 0.4 }) {
		for (const double each_way_s : { 0.3, 0.6 }) {
			CAPTURE(far);
			CAPTURE(each_way_s);
			const Drag there{ .onset_s = 0.6, .duration_s = each_way_s, .amplitude_m = far * 0.2 };
			const Drag back{ 0.6 + each_way_s, each_way_s, -far * 0.2 };
			for (const Events &events : { watch_without_task(along(X, { there, back }), 6.0),
						 watch_with_task(along(X, { there, back }), 6.0) }) {
				CHECK(count(events, "started sideways") <= 1);
				CHECK(has_no_end(events));
			}
		}
	}
}

TEST_CASE("confidence is above 0.95 for a straight gesture, less for oblique ones") {
	const Events plain = watch_without_task(along(X, { DRAG }), 2.5);
	CHECK(plain.last_confidence > 0.95);
	CHECK(plain.last_confidence <= 1.0);
	const Eigen::Vector3d oblique(std::cos(0.4), 0.0, std::sin(0.4));
	CHECK(watch_without_task(along(oblique, { DRAG }), 2.5).last_confidence < plain.last_confidence);
	GestureRecogniser resting(models(), std::nullopt, MotionMode::PHASE);
	CHECK(resting.confidence() == 0.0);
}

TEST_CASE("frames with an impossible time stamp are ignored") {
	GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
	HandFrame frame;
	frame.set(Joint::INDEX, Eigen::Vector3d::Zero());
	recogniser.push(frame);
	frame.t_s = 1e300;
	recogniser.push(frame);
	recogniser.advance(1e300);
	CHECK(recogniser.time_s() == 0.0);
}
