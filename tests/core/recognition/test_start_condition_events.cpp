// Events of gestures with a start condition.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Distance between thumb and index tip.
using Gap = double (*)(double t_s);

/// Events of a drag of 0.2 m from 1 to 2 s.
EventNames event_names(const StartSettings &settings, GestureRecogniser recogniser, Gap gap_m) {
	recogniser.set_start_condition(settings);
	Tremor tremor(1e-4, 7);
	EventNames names;
	ShownChanges shown;
	const Drag drag{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };
	for (int ms = 0; ms < 3500; ++ms) {
		const double t_s = ms / 1000.0;
		if (ms % 9 == 0) {
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, drag.x_m(t_s) * X + tremor());
			frame.set(Joint::THUMB, frame.position(Joint::INDEX) - gap_m(t_s) * Y);
			recogniser.push(frame);
		}
		recogniser.advance(t_s);
		const GestureChanges changes = shown.next(recogniser);
		for (const auto &[has_happened, what] : { std::pair{ changes.aborted, "aborted sideways" },
					 { changes.started, "started sideways" }, { changes.ended, "ended sideways" } }) {
			if (has_happened) {
				names.emplace_back(what);
			}
		}
	}
	return names;
}

constexpr double OPEN_M = 0.08, CLOSED_M = 0.01, HALF_WAY_S = 1.5;
constexpr Gap OPEN = [](double) { return OPEN_M; };
constexpr Gap CLOSED = [](double) { return CLOSED_M; };
constexpr Gap OPENS = [](double t_s) { return t_s < HALF_WAY_S ? CLOSED_M : OPEN_M; };
constexpr Gap CLOSES = [](double t_s) { return t_s < HALF_WAY_S ? OPEN_M : CLOSED_M; };

struct Row {
	std::string what;
	StartSettings settings;
	Gap gap_m;
	EventNames events;
};

} // namespace

TEST_CASE("a drag starts only while its start condition is met") {
	for (const auto &[what, settings, gap_m, events] : {
				 Row{ "no condition", {}, OPEN, ENDS },
				 { "pinch", { StartKind::PINCH }, CLOSED, ENDS },
				 { "open hand", { StartKind::PINCH }, OPEN, NOTHING },
				 { "pinch that opens half-way", { StartKind::PINCH }, OPENS, ABORTS },
				 { "pinch that closes half-way", { StartKind::PINCH }, CLOSES, NOTHING },
				 { "dwell", { StartKind::DWELL }, OPEN, ENDS },
				 { "rest shorter than the dwell", { .kind = StartKind::DWELL, .dwell_s = 2.0 }, OPEN,
						 NOTHING },
				 { "pose without its joints", { StartKind::POINTING_POSE }, OPEN, NOTHING },
		 }) {
		INFO(what);
		CHECK_MESSAGE(event_names(settings, with_task(), gap_m) == events, "with a task");
		CHECK_MESSAGE(event_names(settings, without_task(), gap_m) == events, "without a task");
	}
}
