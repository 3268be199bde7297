#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

// With the task given a gesture begins once, and is begun anew only after it was given up for good; what is
// under way never seems to go back while the hand goes on.

namespace {

constexpr double TASK_M = 0.2; ///< of Task{}
constexpr double NEVER_S = 1e9;
constexpr double RATE_HZ = 90.0;
constexpr double FINE_M = 1e-4, TREMBLES_BY_M = 1e-3; ///< noise of trackers

/// watch()'s noise is always the same: of each repetition the hand does everything a little later.
constexpr double later_s(int repetition) {
	return 0.003 * repetition;
}

Drag going(double far, double onset_s, double duration_s) {
	return { .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = far * TASK_M };
}

Events in_the_task(const Way &way, double length_s, double noise_m) {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	return watch(recogniser, way, length_s, NEVER_S, NEVER_S, RATE_HZ, noise_m);
}

/// What progress a hand with a task seems to have made that goes half-way, halts, and goes on to the end.
struct Progress {
	double fell_by = 0.0; ///< the most below an earlier one, while it goes on
	double when_ended = 0.0;
	double at_last = 0.0; ///< when it has been at the end for half a second
};

Progress progress_of_one_that_halts(double halt_s, int repetition) {
	constexpr double AT_END_S = 0.5;
	const double onset_s = 1.3 + later_s(repetition);
	const Drag first = going(0.5, onset_s, 0.5), second = going(0.5, onset_s + 0.5 + halt_s, 0.5);
	const double end_s = second.onset_s + second.duration_s;
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	Progress progress;
	double most = 0.0;
	bool had_ended = false;
	const Way way = [&](double t_s) {
		const double now = recogniser.motion(MotionSource::SYNTHESISED).progress;
		if (t_s > second.onset_s && t_s < end_s) {
			most = std::max(most, now);
			progress.fell_by = std::max(progress.fell_by, most - now);
		}
		const GestureSession *const session = recogniser.session();
		const bool has_ended = session != nullptr && session->stage() == GestureSession::Stage::ENDED;
		progress.when_ended = has_ended && !had_ended ? now : progress.when_ended;
		had_ended = has_ended;
		progress.at_last = now;
		return Eigen::Vector3d(x_m({ first, second }, t_s) * X);
	};
	CHECK(watch(recogniser, way, end_s + AT_END_S, NEVER_S, NEVER_S, RATE_HZ, FINE_M).said ==
			times(1, "sideways"));
	return progress;
}

} // namespace

TEST_CASE("a drag before a tracker that trembles by a millimetre is begun once") {
	for (const double duration_s : { 0.8, 1.5, 4.0 }) {
		for (int repetition = 0; repetition < 24; ++repetition) {
			CAPTURE(duration_s);
			CAPTURE(repetition);
			const double onset_s = 1.2 + later_s(repetition);
			const Way way = along(X, { going(1.0, onset_s, duration_s) });
			CHECK(in_the_task(way, onset_s + duration_s + 0.6, TREMBLES_BY_M).said == times(1, "sideways"));
		}
	}
}

TEST_CASE("a hand that was elsewhere and rests at the start makes its gesture as any other, and no later") {
	constexpr double LEAVES_S = 1.3, STAYS_THERE_S = 0.4, RESTS_S = 3.0;
	constexpr double A_FRAME_S = 1.0 / RATE_HZ + 0.001; // what is seen differs by noise
	for (const Eigen::Vector3d &direction : { Eigen::Vector3d(-X), Y }) {
		for (const double way_s : { 0.4, 0.8 }) {
			for (const double noise_m : { FINE_M, TREMBLES_BY_M }) {
				CAPTURE(direction);
				CAPTURE(way_s);
				CAPTURE(noise_m);
				const Drag there = going(1.0, LEAVES_S, way_s);
				const Drag back = going(-1.0, LEAVES_S + way_s + STAYS_THERE_S, way_s);
				const Drag drag = going(1.0, back.onset_s + way_s + RESTS_S, 0.6);
				const Way way = [&](double t_s) {
					return Eigen::Vector3d(drag.x_m(t_s) * X + x_m({ there, back }, t_s) * direction);
				};
				const double length_s = drag.onset_s + drag.duration_s + 0.5;
				const Events events = in_the_task(way, length_s, noise_m);
				const Events plain = in_the_task(along(X, { drag }), length_s, noise_m);
				CHECK(events.said == times(1, "sideways"));
				CHECK(events.first_shown_s < plain.first_shown_s + A_FRAME_S);
				CHECK(events.last_ended_s < plain.last_ended_s + A_FRAME_S);
			}
		}
	}
}

TEST_CASE("after another task's gesture at the same place, and a rest, a task's own begins once") {
	Task to_the_left;
	to_the_left.axis = -X;
	const auto right = model("right", X, false), left = model("left", -X, false);
	for (const double rests_s : { 1.0, 1.5, 3.0 }) {
		for (int repetition = 0; repetition < 3; ++repetition) {
			CAPTURE(rests_s);
			CAPTURE(repetition);
			const Drag there = going(1.0, 1.3 + later_s(repetition), 0.8);
			const Drag back = going(-1.0, there.onset_s + 1.2, 0.8);
			const Drag on = going(-1.0, back.onset_s + 0.8 + rests_s, 0.8);
			GestureRecogniser recogniser({ ExpectedGesture{ right, Task{} }, { left, to_the_left } });
			const Events events = watch(recogniser, along(X, { there, back, on }), on.onset_s + 1.3, NEVER_S,
					NEVER_S, RATE_HZ, FINE_M);
			CHECK(events.said ==
					std::vector<std::string>{ "started right", "ended right", "started left", "ended left" });
		}
	}
}

TEST_CASE("a twitch that is none of the gesture is given up within a second, and the gesture begins once") {
	struct Twitch {
		double far;      ///< less than from where on a hand has left the start
		bool comes_back; ///< at once, or stays there
	};
	for (const Twitch twitch : { Twitch{ 0.1, false }, { 0.1, true }, { 0.12, true } }) {
		for (const double duration_s : { 0.2, 0.3 }) {
			CAPTURE(twitch.far);
			CAPTURE(twitch.comes_back);
			CAPTURE(duration_s);
			const double left = twitch.comes_back ? 0.0 : twitch.far;
			const Drag out = going(twitch.far, 1.3, duration_s);
			const Drag back = going(left - twitch.far, out.onset_s + duration_s, duration_s);
			const Drag drag = going(1.0 - left, 4.0, 0.8);
			const std::vector<std::string> given_up{ "started sideways", "aborted sideways" };
			CHECK(in_the_task(along(X, { out, back }), out.onset_s + 1.0, FINE_M).said == given_up);
			std::vector<std::string> all = given_up;
			all.insert(all.end(), { "started sideways", "ended sideways" });
			CHECK(in_the_task(along(X, { out, back, drag }), 5.5, FINE_M).said == all);
		}
	}
}

TEST_CASE("a turn back before a third of the way is aborted within 0.3 s of the return") {
	struct Turn {
		double far, duration_s; ///< of either way
	};
	for (const Turn turn : { Turn{ 0.1, 0.2 }, { 0.14, 0.3 }, { 0.2, 0.5 }, { 0.3, 0.5 } }) {
		for (int repetition = 0; repetition < 3; ++repetition) {
			CAPTURE(turn.far);
			CAPTURE(turn.duration_s);
			CAPTURE(repetition);
			const Drag out = going(turn.far, 1.3 + later_s(repetition), turn.duration_s);
			const Drag back = going(-turn.far, out.onset_s + turn.duration_s, turn.duration_s);
			const double back_s = back.onset_s + back.duration_s;
			CHECK(in_the_task(along(X, { out, back }), back_s + 0.3, FINE_M).said ==
					std::vector<std::string>{ "started sideways", "aborted sideways" });
		}
	}
}

TEST_CASE("a hand that halts half-way and goes on makes progress, and none of it is taken back") {
	for (const double halt_s : { 0.3, 1.0, 5.0 }) {
		for (int repetition = 0; repetition < 3; ++repetition) {
			CAPTURE(halt_s);
			CAPTURE(repetition);
			const Progress progress = progress_of_one_that_halts(halt_s, repetition);
			CHECK(progress.fell_by < 0.05);
			CHECK(progress.when_ended > 0.7);
			CHECK(progress.at_last > 0.9);
		}
	}
}

TEST_CASE("what begins too far from a task's start to be its gesture is none from the first instant on") {
	for (const Eigen::Vector3d &off_m : { Eigen::Vector3d(0.15 * Y), Eigen::Vector3d(-1.0 * Z) }) {
		const Way beside = [&](double t_s) {
			return Eigen::Vector3d(off_m + going(1.0, 1.3, 0.8).x_m(t_s) * X);
		};
		CHECK(in_the_task(beside, 3.0, FINE_M).said.empty());
	}
	const Way near = [&](double t_s) {
		return Eigen::Vector3d(0.04 * Y + going(1.0, 1.3, 0.8).x_m(t_s) * X);
	};
	CHECK(in_the_task(near, 3.0, FINE_M).said == times(1, "sideways"));
}
