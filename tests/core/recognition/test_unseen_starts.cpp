// Gestures of a hand whose tracker showed it at rest where it was, to the last bit: begun while nothing is
// seen, or while the tracker shows it elsewhere.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

struct Rest {
	double grid_m; ///< to which the tracker rounds; 0: not at all
	double tremor_m;
};

double trembling_m(const Rest &rest, double t_s) {
	return rest.tremor_m * std::sin(2.0 * std::numbers::pi * 11.0 * t_s);
}

Way seen(const Rest &rest, const Drag &drag) {
	return [=](double t_s) {
		return rounded(drag.x_m(t_s) * X + trembling_m(rest, t_s) * (X + Y), rest.grid_m);
	};
}

/// The tracker trembles also while it holds the pose of from_s, until to_s.
Way held_trembling(const Drag &drag, double tremor_m, double from_s, double to_s) {
	return [=, tremor = Tremor(tremor_m, 1)](double t_s) mutable {
		const bool is_held = t_s >= from_s && t_s < to_s;
		return Eigen::Vector3d(drag.x_m(is_held ? from_s : t_s) * X + tremor());
	};
}

} // namespace

TEST_CASE("a gesture that begins unseen is one, however still the hand was before") {
	for (const Rest &rest : { Rest{ 0.0, 0.0 }, { 1e-3, 0.4e-3 }, { 1e-3, 0.6e-3 }, { 2e-3, 0.9e-3 } }) {
		for (const double onset_s : { 0.6, 0.95, 2.0 }) {
			for (const double duration_s : { 0.4, 0.8 }) {
				for (const double gap_s : { 0.1, 0.2, 0.3 }) {
					for (const double before_s : { 0.08, 0.02 }) {
						CAPTURE(rest.grid_m);
						CAPTURE(rest.tremor_m);
						CAPTURE(onset_s);
						CAPTURE(duration_s);
						CAPTURE(gap_s);
						CAPTURE(before_s);
						const Drag drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = 0.2 };
						const double lost_s = onset_s - before_s;
						for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
							CAPTURE(mode == MotionMode::PHASE);
							GestureRecogniser open(models(), std::nullopt, mode);
							GestureRecogniser task({ models()[0] }, Task{}, mode);
							for (GestureRecogniser *recogniser : { &open, &task }) {
								CAPTURE(recogniser == &open);
								CHECK(watch(*recogniser, seen(rest, drag), onset_s + duration_s + 0.6, lost_s,
											  lost_s + gap_s, 100.0, 0.0)
												.said == times(1, "sideways"));
							}
						}
					}
				}
			}
		}
	}
}

// Without any noise a freeze is the same as a hand that rests.
TEST_CASE("a gesture that begins in a freeze is one, before a tracker that trembles") {
	for (const double tremor_m : { 1e-4, 1e-3 }) {
		for (const double duration_s : { 0.4, 0.8 }) {
			for (const double freeze_s : { 0.1, 0.2, 0.3 }) {
				for (const double share : { -0.2, -0.05, 0.05, 0.1, 0.2 }) {
					CAPTURE(tremor_m);
					CAPTURE(duration_s);
					CAPTURE(freeze_s);
					CAPTURE(share);
					const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
					const double from_s = drag.onset_s + share * duration_s;
					Tremor tremor(tremor_m, 1);
					const Way seen = [&](double t_s) {
						return Eigen::Vector3d(drag.x_m(t_s) * X + tremor());
					};
					const Way way = held(seen, from_s, from_s + freeze_s);
					GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
					GestureRecogniser task({ models()[0] }, Task{}, MotionMode::PHASE);
					for (GestureRecogniser *recogniser : { &open, &task }) {
						CAPTURE(recogniser == &open);
						CHECK(watch(*recogniser, way, 2.4, 1e9, 1e9, 100.0, 0.0).said ==
								times(1, "sideways"));
					}
				}
			}
		}
	}
}

TEST_CASE("a tracker that trembles also where it holds its pose hides no gesture's beginning") {
	for (const double tremor_m : { 1e-4, 3e-4 }) {
		for (const double freeze_s : { 0.1, 0.2, 0.3 }) {
			for (const double ends_at : { 0.45, 0.5, 0.55, 0.6 }) {
				for (const double duration_s : { 0.4, 0.6 }) {
					CAPTURE(tremor_m);
					CAPTURE(freeze_s);
					CAPTURE(ends_at);
					CAPTURE(duration_s);
					const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
					const double to_s = drag.onset_s + ends_at * duration_s;
					if (to_s - freeze_s > drag.onset_s + 0.1 * duration_s) {
						continue; // it has begun to be seen
					}
					const Way way = held_trembling(drag, tremor_m, to_s - freeze_s, to_s);
					GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
					CHECK(watch(open, way, 2.4, 1e9, 1e9, 100.0, 0.0).said == times(1, "sideways"));
				}
			}
		}
	}
}

TEST_CASE("a tracker that trembles where it lost a hand on its way, and catches up, hides no gesture") {
	for (const double tremor_m : { 1e-4, 3e-4 }) {
		for (const double freeze_s : { 0.1, 0.2, 0.3 }) {
			for (const double share : { 0.3, 0.4, 0.5, 0.6, 0.7 }) {
				for (const double duration_s : { 0.4, 0.8, 1.5 }) {
					CAPTURE(tremor_m);
					CAPTURE(freeze_s);
					CAPTURE(share);
					CAPTURE(duration_s);
					const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
					const double from_s = drag.onset_s + share * duration_s;
					const Way way = held_trembling(drag, tremor_m, from_s, from_s + freeze_s);
					GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
					const Events events = watch(open, way, 3.5, 1e9, 1e9, 100.0, 0.0);
					CHECK(events.said.back() == "ended sideways");
				}
			}
		}
	}
}

TEST_CASE("a tracker that shows a still hand elsewhere for a while as it sets out makes no other gesture of "
		  "it") {
	for (const Rest &rest : { Rest{ 0.0, 0.0 }, { 2e-3, 0.3e-3 } }) {
		for (const double shown_s : { 0.005, 0.05, 0.1, 0.2 }) {
			for (const double before_s : { 0.5, 0.1, 0.05, 0.0 }) {
				CAPTURE(rest.grid_m);
				CAPTURE(shown_s);
				CAPTURE(before_s);
				const Drag drag{ .onset_s = 1.3, .duration_s = 0.8, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s - before_s;
				const Way hand = seen(rest, drag);
				const Way way = [&](double t_s) {
					const bool is_paused = t_s >= from_s && t_s < from_s + shown_s;
					return Eigen::Vector3d(hand(t_s) + (is_paused ? 0.06 : 0.0) * Y);
				};
				GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
				const Events events = watch(recogniser, way, 2.6, 1e9, 1e9, 100.0, 0.0);
				CHECK(ends(events) == 1);
				CHECK(events.said.back() == "ended sideways");
			}
		}
	}
}
