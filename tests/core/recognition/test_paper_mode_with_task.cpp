// `paper` mode with a task: aborts, ends, and late states.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double TASK_M = 0.2; ///< amplitude of Task{}
constexpr double ONSET_S = 0.5;

Events watch_paper_mode(const TestPath &path, double length_s) {
	GestureRecogniser recogniser({ { models()[0], Task{} } }, { MotionMode::PAPER });
	return watch(recogniser, path, length_s);
}

Drag drag_to(double far, double duration_s = 0.8) {
	return { .onset_s = ONSET_S, .duration_s = duration_s, .amplitude_m = far * TASK_M };
}

} // namespace

TEST_CASE("paper mode aborts a stop near the start within 1.2 s") {
	const Drag begins = drag_to(0.05, 0.12);
	CHECK(watch_paper_mode(along(X, { begins }), ONSET_S + 0.6).names == STARTS);
	CHECK(watch_paper_mode(along(X, { begins }), ONSET_S + 1.2).names == ABORTS);
	const Drag continues{ .onset_s = ONSET_S + 0.5, .duration_s = 0.8, .amplitude_m = 0.95 * TASK_M };
	CHECK(watch_paper_mode(along(X, { begins, continues }), 3.0).names == ENDS);
}

TEST_CASE("paper mode aborts when the hand returns from half-way or before") {
	for (const double far : { 0.1, 0.5 }) {
		CAPTURE(far);
		const Drag back{ .onset_s = ONSET_S + 0.6, .duration_s = 0.5, .amplitude_m = -far * TASK_M };
		const Events events = watch_paper_mode(along(X, { drag_to(far, 0.5), back }), 6.0);
		CHECK(std::abs(events.last_value_m) < 1e-9);
		CHECK(events.names == ABORTS);
	}
}

TEST_CASE("paper mode ends at the task's amplitude wherever the hand stops") {
	for (const double far : { 0.6, 1.5 }) {
		CAPTURE(far);
		const Events events = watch_paper_mode(along(X, { drag_to(far) }), 4.0);
		CHECK(events.names == ENDS);
		CHECK(events.last_value_m == near(TASK_M).epsilon(1e-9));
	}
}

TEST_CASE("paper mode with a task accepts oblique and winding movement") {
	CHECK(watch_paper_mode(along((X + Y).normalized(), { drag_to(2.0) }), 3.0).names == ENDS);
	const TestPath winding = [](double t_s) {
		return Eigen::Vector3d(drag_to(1.0).x_m(t_s), 0.1 * std::sin(8.0 * t_s), 0.1 * std::cos(8.0 * t_s));
	};
	CHECK(watch_paper_mode(winding, 3.0).names == ENDS);
}

TEST_CASE("paper mode holds its end until the hand returns") {
	constexpr double TURNS_S = 2.0, BACK_S = 2.3;
	const auto shown_m = [](double left, double later_s) {
		const Drag back{ TURNS_S, BACK_S - TURNS_S, (left - 1.0) * TASK_M };
		return watch_paper_mode(along(X, { drag_to(1.0), back }), BACK_S + later_s).last_value_m;
	};
	CHECK(shown_m(0.16, 1.0) == near(TASK_M).epsilon(1e-9));
	CHECK(shown_m(0.14, -0.04) == near(TASK_M).epsilon(1e-9));
	CHECK(shown_m(0.14, 0.1) < 0.05 * TASK_M);
}

TEST_CASE("the element of a late decoded state ends in time") {
	const GestureModel &model = drag_model();
	constexpr double SLOWER = 1.2, LATE_S = 0.05;
	const PrimitiveMotionElement &first = model.elements[0], &second = model.elements[1];
	const double entered_s = SLOWER * first.duration_mean_s,
				 through_s = entered_s + SLOWER * second.duration_mean_s;
	PaperSynthesiser in_time(model), late(model);
	in_time.begin(0.0, 0.0);
	late.begin(0.0, 0.0);
	in_time.enter_state(1, entered_s, entered_s);
	const double phase_before = late.phase(entered_s + LATE_S);
	const double value_before = late.motion(entered_s + LATE_S, 1.0).value_m;
	late.enter_state(1, entered_s, entered_s + LATE_S);
	CHECK(late.phase(entered_s + LATE_S) == phase_before);
	CHECK(late.motion(entered_s + LATE_S, 1.0).value_m == near(value_before));
	for (const PaperSynthesiser *const synthesiser : { &in_time, &late }) {
		CHECK(synthesiser->phase(through_s - 1e-3) < second.phase_end - 1e-4);
		CHECK(synthesiser->phase(through_s + 1e-9) == near(second.phase_end).epsilon(1e-12));
	}
}

TEST_CASE("a gesture that begins late starts at its phase") {
	const GestureModel &model = drag_model();
	const PrimitiveMotionElement &first = model.elements[0], &second = model.elements[1];
	for (const double share : { 0.0, 0.9 }) {
		PaperSynthesiser synthesiser(model);
		synthesiser.begin(2.0, share * first.phase_end);
		const double through_s = 2.0 + (1.0 - share) * first.duration_mean_s;
		CHECK(synthesiser.phase(2.0) == near(share * first.phase_end));
		CHECK(synthesiser.phase(through_s - 1e-3) < first.phase_end);
		CHECK(synthesiser.phase(through_s + 1e-9) == near(first.phase_end).epsilon(1e-12));
		CHECK(synthesiser.phase(through_s + 1.0) == first.phase_end);
	}
	// A state decoded after its expected end is played within 1 ms, forwards.
	PaperSynthesiser late(model);
	late.begin(0.0, 0.0);
	const double known_s = first.duration_mean_s + 3.0 * second.duration_mean_s;
	late.enter_state(1, first.duration_mean_s, known_s);
	CHECK(late.phase(known_s) == near(first.phase_end));
	CHECK(late.phase(known_s + 0.5e-3) > first.phase_end);
	CHECK(late.phase(known_s + 1.1e-3) == near(second.phase_end));
}
