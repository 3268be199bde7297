// What a GestureRecogniser shows where gestures begin under a start condition only.

#include "gesture_events.h"
#include "minimum_jerk_drag.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

using Said = std::vector<std::string>;
const Said STARTS_AND_ENDS{ "started", "ended" };

/// What is said of a drag of 0.2 m within 1 s from rest_s on, whose thumb is so far from the index.
template <class Gap>
Said said(const StartSettings &settings, const std::optional<Task> &task, double rest_s, Gap gap_m) {
	GestureRecogniser recogniser({ models()[0] }, task, MotionMode::PHASE);
	recogniser.set_start_condition(settings);
	Tremor tremor(1e-4, 7);
	Said said;
	GestureShown shown;
	const Way way = along(X, { { .onset_s = rest_s, .duration_s = 1.0, .amplitude_m = 0.2 } });
	for (int ms = 0; ms < static_cast<int>(1000.0 * (rest_s + 2.5)); ++ms) {
		const double t_s = ms / 1000.0;
		if (ms % 9 == 0) {
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, way(t_s) + tremor());
			frame.set(Joint::THUMB, frame.position(Joint::INDEX) - gap_m(t_s) * Y);
			recogniser.push(frame);
		}
		recogniser.advance(t_s);
		const GestureShown before = std::exchange(shown, shown_by(recogniser));
		const GestureNews happened = news(before, shown);
		for (const auto &[is_said, what] : { std::pair{ happened.aborted, "aborted" },
					 { happened.started, "started" }, { happened.ended, "ended" } }) {
			if (is_said) {
				said.emplace_back(what);
			}
		}
	}
	return said;
}

const std::vector<std::optional<Task>> CONTEXTS{ Task{}, std::nullopt };
constexpr double OPEN_M = 0.08, CLOSED_M = 0.01;

} // namespace

TEST_CASE("a drag starts and ends with a pinch, and not without") {
	for (const std::optional<Task> &task : CONTEXTS) {
		CAPTURE(task.has_value());
		CHECK(said({ StartKind::PINCH }, task, 1.0, [](double) { return CLOSED_M; }) == STARTS_AND_ENDS);
		CHECK(said({ StartKind::PINCH }, task, 1.0, [](double) { return OPEN_M; }).empty());
		CHECK(said({ StartKind::NONE }, task, 1.0, [](double) { return OPEN_M; }) == STARTS_AND_ENDS);
	}
}

TEST_CASE("a pinch that opens half-way aborts the drag, which does not start again") {
	for (const std::optional<Task> &task : CONTEXTS) {
		CAPTURE(task.has_value());
		const auto opens = [](double t_s) { return t_s < 1.5 ? CLOSED_M : OPEN_M; };
		CHECK(said({ StartKind::PINCH }, task, 1.0, opens) == Said{ "started", "aborted" });
	}
}

TEST_CASE("a pinch that closes half-way starts nothing") {
	for (const std::optional<Task> &task : CONTEXTS) {
		CAPTURE(task.has_value());
		const auto closes = [](double t_s) { return t_s < 1.5 ? OPEN_M : CLOSED_M; };
		CHECK(said({ StartKind::PINCH }, task, 1.0, closes).empty());
	}
}

TEST_CASE("a drag starts after a dwell, and not after a shorter rest") {
	for (const std::optional<Task> &task : CONTEXTS) {
		CAPTURE(task.has_value());
		const auto open = [](double) { return OPEN_M; };
		CHECK(said({ StartKind::DWELL }, task, 1.0, open) == STARTS_AND_ENDS);
		CHECK(said({ .kind = StartKind::DWELL, .dwell_s = 2.0 }, task, 1.0, open).empty());
	}
}

TEST_CASE("without its joints a start condition lets nothing start") {
	CHECK(said({ StartKind::POINTING_POSE }, Task{}, 1.0, [](double) { return OPEN_M; }).empty());
}
