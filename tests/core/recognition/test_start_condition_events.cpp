// Events of gestures with a start condition.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using EventNames = std::vector<std::string>;
const EventNames STARTS_AND_ENDS{ "started", "ended" };

/// Events of a drag of 0.2 m from 1 to 2 s. gap_m(t_s): distance between thumb and index tip.
template <class Gap>
EventNames event_names(const StartSettings &settings, const std::optional<Task> &task, Gap gap_m) {
	GestureRecogniser recogniser({ models()[0] }, task, MotionMode::PHASE);
	recogniser.set_start_condition(settings);
	Tremor tremor(1e-4, 7);
	EventNames names;
	ShownGesture shown;
	const TestPath path = along(X, { { .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 } });
	for (int ms = 0; ms < 3500; ++ms) {
		const double t_s = ms / 1000.0;
		if (ms % 9 == 0) {
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, path(t_s) + tremor());
			frame.set(Joint::THUMB, frame.position(Joint::INDEX) - gap_m(t_s) * Y);
			recogniser.push(frame);
		}
		recogniser.advance(t_s);
		const ShownGesture before = std::exchange(shown, shown_gesture(recogniser));
		const GestureChanges changes = changes_between(before, shown);
		for (const auto &[has_happened, what] : { std::pair{ changes.aborted, "aborted" },
					 { changes.started, "started" }, { changes.ended, "ended" } }) {
			if (has_happened) {
				names.emplace_back(what);
			}
		}
	}
	return names;
}

/// Checks the events with a task and without one.
template <class Gap> void check_events(const StartSettings &settings, Gap gap_m, const EventNames &expected) {
	CHECK(event_names(settings, Task{}, gap_m) == expected);
	CHECK(event_names(settings, std::nullopt, gap_m) == expected);
}

constexpr double OPEN_M = 0.08, CLOSED_M = 0.01, HALF_WAY_S = 1.5;
constexpr auto OPEN = [](double) { return OPEN_M; };
constexpr auto CLOSED = [](double) { return CLOSED_M; };
constexpr auto OPENS = [](double t_s) { return t_s < HALF_WAY_S ? CLOSED_M : OPEN_M; };
constexpr auto CLOSES = [](double t_s) { return t_s < HALF_WAY_S ? OPEN_M : CLOSED_M; };

} // namespace

TEST_CASE("under a pinch condition a drag starts only with a pinch") {
	check_events({ StartKind::PINCH }, CLOSED, STARTS_AND_ENDS);
	check_events({ StartKind::PINCH }, OPEN, {});
	check_events({ StartKind::NONE }, OPEN, STARTS_AND_ENDS);
}

TEST_CASE("opening a pinch half-way aborts; closing it half-way starts nothing") {
	check_events({ StartKind::PINCH }, OPENS, { "started", "aborted" });
	check_events({ StartKind::PINCH }, CLOSES, {});
}

TEST_CASE("a drag starts after a dwell, not after a shorter rest") {
	check_events({ StartKind::DWELL }, OPEN, STARTS_AND_ENDS);
	check_events({ .kind = StartKind::DWELL, .dwell_s = 2.0 }, OPEN, {});
}

TEST_CASE("a start condition without its joints starts nothing") {
	check_events({ StartKind::POINTING_POSE }, OPEN, {});
}
