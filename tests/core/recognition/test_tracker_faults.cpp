// Gestures with tracker faults: dropout, freeze, jump, rounding.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double RATE_HZ = 100.0;

/// Checks that the gesture is recognised in `phase` mode, with a task and without one.
void check_found(const TestPath &seen, double length_s, double lost_from_s = 1e9, double lost_to_s = 1e9) {
	GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
	GestureRecogniser task({ models()[0] }, Task{}, MotionMode::PHASE);
	for (GestureRecogniser *const recogniser : { &open, &task }) {
		CAPTURE(recogniser == &open);
		CHECK(watch(*recogniser, seen, length_s, lost_from_s, lost_to_s, RATE_HZ, 0.0).names ==
				times(1, "sideways"));
	}
}

} // namespace

TEST_CASE("a dropout of 0.3 s in mid-gesture does not abort") {
	for (const double lost_s : { 0.8, 1.0, 1.2 }) {
		CAPTURE(lost_s);
		CHECK(watch_without_task(along(X, { DRAG }), 3.0, lost_s, lost_s + 0.3).names ==
				times(1, "sideways"));
		CHECK(watch_with_task(along(X, { DRAG }), 3.0, lost_s, lost_s + 0.3).names == times(1, "sideways"));
	}
}

TEST_CASE("a dropout or a rounding tracker at the onset hides no gesture") {
	for (const double grid_m : { 0.0, 2e-3 }) {
		for (const double onset_s : { 0.6, 2.0 }) {
			for (const double duration_s : { 0.4, 0.8 }) {
				for (const double gap_s : { 0.1, 0.3 }) {
					CAPTURE(grid_m);
					CAPTURE(onset_s);
					CAPTURE(duration_s);
					CAPTURE(gap_s);
					const Drag drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = 0.2 };
					const TestPath seen = [=](double t_s) { // tremor below half of the grid
						const double tremor_m = 0.45 * grid_m * std::sin(2.0 * std::numbers::pi * 11.0 * t_s);
						return rounded(drag.x_m(t_s) * X + tremor_m * (X + Y), grid_m);
					};
					const double lost_s = onset_s - 0.05;
					check_found(seen, onset_s + duration_s + 0.6, lost_s, lost_s + gap_s);
					GestureRecogniser paper(models(), std::nullopt, MotionMode::PAPER);
					CHECK(watch(paper, seen, onset_s + duration_s + 0.6, lost_s, lost_s + gap_s, RATE_HZ, 0.0)
									.names == times(1, "sideways"));
				}
			}
		}
	}
}

// Without noise, a freeze is equal to a hand at rest.
TEST_CASE("a freeze of 0.3 s at the onset hides no gesture") {
	for (const double tremor_m : { 1e-4, 1e-3 }) {
		for (const double duration_s : { 0.4, 0.8 }) {
			for (const double freeze_s : { 0.1, 0.3 }) {
				for (const double share : { -0.2, 0.05, 0.2 }) {
					CAPTURE(tremor_m);
					CAPTURE(duration_s);
					CAPTURE(freeze_s);
					CAPTURE(share);
					const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
					const double from_s = drag.onset_s + share * duration_s;
					const TestPath seen = [=, tremor = Tremor(tremor_m, 1)](double t_s) mutable {
						return Eigen::Vector3d(drag.x_m(t_s) * X + tremor());
					};
					check_found(held(seen, from_s, from_s + freeze_s), 2.4);
				}
			}
		}
	}
}

TEST_CASE("a freeze in mid-gesture keeps the end value of a long gesture") {
	for (const double frozen_s : { 0.15, 0.25 }) {
		for (const double share : { 0.4, 0.6 }) {
			CAPTURE(frozen_s);
			CAPTURE(share);
			const Drag drag{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.28 };
			const double from_s = drag.onset_s + share * drag.duration_s;
			const Events events =
					watch_without_task(held(along(X, { drag }), from_s, from_s + frozen_s), 2.0);
			CHECK(events.names == times(1, "sideways"));
			CHECK(std::abs(events.last_value_m - 0.28) < 0.01);
		}
	}
}

TEST_CASE("a persistent jump before the onset does not change the gesture") {
	const Events events = watch_without_task(jumped(along(X, { DRAG }), 0.3, 1e9, 0.04 * X), 2.2);
	CHECK(events.names == times(1, "sideways"));
	CHECK(events.last_value_m == near(0.2).epsilon(0.02));
	for (const double off_m : { 0.05, 0.15, -0.3 }) {
		CAPTURE(off_m);
		const TestPath aside = jumped(along(X, { { .onset_s = 2.0 } }), 0.0, 1.0, off_m * Y);
		CHECK(watch_with_task(aside, 4.0).names == times(1, "sideways"));
	}
}

TEST_CASE("a track that begins in motion does not hide the next gesture") {
	const TestPath arriving = [](double t_s) {
		const Drag come{ .onset_s = -0.15, .duration_s = 0.3, .amplitude_m = 0.3 };
		const Drag late{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };
		return Eigen::Vector3d(late.x_m(t_s), 0.0, come.x_m(t_s));
	};
	CHECK(watch_without_task(arriving, 3.0).names == times(1, "sideways"));
}

TEST_CASE("a single outlier before the onset does not shift the value") {
	for (const double before_s : { 0.0, 0.1 }) {
		for (const double by_m : { -0.05, -0.2, 0.2 }) {
			CAPTURE(before_s);
			CAPTURE(by_m);
			// The first frame at or after this time, at 110 Hz.
			const double outlier_s = std::ceil((DRAG.onset_s - before_s) * 110.0) / 110.0;
			const TestPath path =
					jumped(along(X, { DRAG }), outlier_s - 0.5 / 110.0, outlier_s + 0.5 / 110.0, by_m * X);
			const Events events = watch_without_task(path, 2.2);
			CHECK(events.names == times(1, "sideways"));
			CHECK(events.last_value_m == near(DRAG.amplitude_m).epsilon(0.02));
		}
	}
}

TEST_CASE("an undone jump at the onset or endpoint keeps the value") {
	for (const double back_m : { 0.03, 0.15 }) {
		for (const double shown_s : { 0.005, 0.1 }) {
			for (const double from_s : { 0.5, 0.6, 1.6, 1.8 }) {
				CAPTURE(back_m);
				CAPTURE(shown_s);
				CAPTURE(from_s);
				const double length_s = from_s < 1.0 ? 2.0 : from_s + shown_s + 0.3;
				const Events events = watch_without_task(
						jumped(along(X, { DRAG }), from_s, from_s + shown_s, -back_m * X), length_s);
				CHECK(events.names == times(1, "sideways"));
				CHECK(std::abs(events.last_value_m - 0.2) < 0.01);
			}
		}
	}
}

TEST_CASE("an undone jump in mid-gesture does not shorten the gesture") {
	for (const double duration_s : { 0.6, 1.0 }) {
		const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
		for (const Eigen::Vector3d &off_m :
				{ Eigen::Vector3d(-0.25, 0.03, 0.0), Eigen::Vector3d(0.25, 0.0, 0.1),
						Eigen::Vector3d(0.0, 0.2, 0.1), Eigen::Vector3d(0.05, 0.1, 0.0) }) {
			for (const double from_share : { 0.2, 0.5 }) {
				for (const double shown_share : { 0.08, 0.3 }) {
					CAPTURE(duration_s);
					CAPTURE(off_m.transpose());
					CAPTURE(from_share);
					CAPTURE(shown_share);
					const double from_s = drag.onset_s + from_share * duration_s,
								 to_s = from_s + shown_share * duration_s;
					// During the jump the tracked position is constant.
					const TestPath hand = along(X, { drag });
					const TestPath stands = [=](double t_s) {
						return hand(t_s >= from_s && t_s < to_s ? from_s : t_s);
					};
					const Events events = watch_without_task(
							jumped(stands, from_s, to_s, off_m), drag.onset_s + duration_s + 0.6);
					CHECK(events.names == times(1, "sideways"));
					CHECK(std::abs(events.last_value_m - drag.amplitude_m) < 0.02);
				}
			}
		}
	}
}
