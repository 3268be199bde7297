#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

// `paper` mode with a task: when its motion starts, which is played to the end whatever the hand does, and
// when it is let go.

namespace {

constexpr double TASK_M = 0.2; ///< of Task{}
constexpr double ONSET_S = 0.5;

Events on_paper(const Way &way, double length_s) {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PAPER);
	return watch(recogniser, way, length_s);
}

/// To `far` of the task's way, quickly, where it stays.
Way twitch(double far) {
	return along(X, { Drag{ .onset_s = ONSET_S, .duration_s = 0.12, .amplitude_m = far * TASK_M } });
}

} // namespace

TEST_CASE("a hand that drifts away from its start begins nothing, one that sets out slowly does") {
	// To an eighth of the way at a constant speed. A drag of the model's duration would have 1 in the mean.
	const auto starts = [](double speed) {
		const double m_s = speed * TASK_M / drag_model().duration_mean_s;
		const Way way = [=](double t_s) {
			return Eigen::Vector3d(std::clamp(m_s * (t_s - ONSET_S), 0.0, 0.125 * TASK_M), 0.0, 0.0);
		};
		return !on_paper(way, 4.0).said.empty();
	};
	for (const double speed : { 0.03, 0.05, 0.06 }) {
		CAPTURE(speed);
		CHECK_FALSE(starts(speed));
	}
	for (const double speed : { 0.13, 0.2, 0.5, 1.0 }) {
		CAPTURE(speed);
		CHECK(starts(speed));
	}
}

TEST_CASE("a twitch of five millimetres begins nothing, one of a centimetre does") {
	CHECK(on_paper(twitch(0.024), 1.5).said.empty());
	CHECK(on_paper(twitch(0.05), 1.0).said == std::vector<std::string>{ "started sideways" });
}

TEST_CASE("a hand that stays at its start has half a second to go on, and is let go within a second or so") {
	// The first of the model's four states lasts a quarter of a second.
	const Way sets_out = twitch(0.05);
	CHECK(on_paper(sets_out, ONSET_S + 0.6).said == std::vector<std::string>{ "started sideways" });
	CHECK(on_paper(sets_out, ONSET_S + 1.2).said ==
			std::vector<std::string>{ "started sideways", "aborted sideways" });
	const Drag goes_on{ .onset_s = ONSET_S + 0.5, .duration_s = 0.8, .amplitude_m = 0.95 * TASK_M };
	const Way way = [&](double t_s) { return Eigen::Vector3d(sets_out(t_s) + goes_on.x_m(t_s) * X); };
	CHECK(on_paper(way, 3.0).said == times(1, "sideways"));
}

TEST_CASE("a hand that set out and is back at its start is let go, also from half-way") {
	for (const double far : { 0.1, 0.2, 0.3, 0.4, 0.5 }) {
		CAPTURE(far);
		const Drag out{ .onset_s = ONSET_S, .duration_s = 0.5, .amplitude_m = far * TASK_M };
		const Drag back{ .onset_s = ONSET_S + 0.6, .duration_s = 0.5, .amplitude_m = -far * TASK_M };
		const Events events = on_paper(along(X, { out, back }), 6.0);
		CHECK(std::abs(events.last_value_m) < 1e-9);
		CHECK(events.said == std::vector<std::string>{ "started sideways", "aborted sideways" });
	}
}

TEST_CASE("`paper` mode comes to the task's end, or waits at a state's, wherever the hand stops") {
	const double first_end = drag_model().elements.front().phase_end;
	for (const double far : { 0.6, 0.8, 1.2, 1.5 }) {
		CAPTURE(far);
		const Drag drag{ .onset_s = ONSET_S, .duration_s = 0.8, .amplitude_m = far * TASK_M };
		const Events events = on_paper(along(X, { drag }), 4.0);
		CHECK(events.said == times(1, "sideways"));
		CHECK(events.last_value_m == near(TASK_M).epsilon(1e-9));
	}
	// Three tenths of the way, slowly, are its first state.
	const Drag short_of_it{ .onset_s = ONSET_S, .duration_s = 0.8, .amplitude_m = 0.3 * TASK_M };
	const Events waits = on_paper(along(X, { short_of_it }), 4.0);
	CHECK(waits.said == std::vector<std::string>{ "started sideways" });
	CHECK(waits.last_value_m == near(TASK_M * evaluate(drag_model(), first_end).value).epsilon(1e-9));
}

TEST_CASE("`paper` mode with a task rejects nothing that comes as far along its way") {
	const Drag drag{ .onset_s = ONSET_S, .duration_s = 0.8, .amplitude_m = 2.0 * TASK_M };
	CHECK(on_paper(along((X + Y).normalized(), { drag }), 3.0).said == times(1, "sideways"));
	const Way winding = [](double t_s) {
		const Drag way{ .onset_s = ONSET_S, .duration_s = 0.8, .amplitude_m = TASK_M };
		return Eigen::Vector3d(way.x_m(t_s), 0.1 * std::sin(8.0 * t_s), 0.1 * std::cos(8.0 * t_s));
	};
	CHECK(on_paper(winding, 3.0).said == times(1, "sideways"));
}

TEST_CASE("`paper` mode ends early where a gesture is slower than its first states promised") {
	const auto late_s = [](double duration_s) {
		const Drag drag{ .onset_s = ONSET_S, .duration_s = duration_s, .amplitude_m = TASK_M };
		return on_paper(along(X, { drag }), duration_s + 2.0).last_ended_s - ONSET_S - duration_s;
	};
	CHECK(std::abs(late_s(1.0)) < 0.1);
	CHECK(late_s(4.0) < -1.0);
}

TEST_CASE("`paper` mode holds its end until the hand is back below 15 % of the way, and lets go in 0.1 s") {
	constexpr double TURNS_S = 2.0, BACK_S = 2.3;
	const auto shown_m = [](double left, double later_s) {
		const Drag there{ .onset_s = ONSET_S, .duration_s = 0.8, .amplitude_m = TASK_M };
		const Drag back{
			.onset_s = TURNS_S, .duration_s = BACK_S - TURNS_S, .amplitude_m = (left - 1.0) * TASK_M
		};
		return on_paper(along(X, { there, back }), BACK_S + later_s).last_value_m;
	};
	CHECK(shown_m(0.16, 1.0) == near(TASK_M).epsilon(1e-9));
	CHECK(shown_m(0.14, -0.04) == near(TASK_M).epsilon(1e-9));
	CHECK(shown_m(0.14, 0.1) < 0.05 * TASK_M);
	CHECK(shown_m(0.14, 0.02) > 0.05 * TASK_M);
}
