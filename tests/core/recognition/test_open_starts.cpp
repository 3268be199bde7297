// With nothing given: from where the motion counts where the tracker shows the hand elsewhere for a frame,
// and what begins and is none.

#include "gesture_events.h"
#include "near.h"

#include "simulation/oscillation.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double RATE_HZ = 110.0; ///< watch()'s

/// A drag that is shown elsewhere in the one frame at or after that time.
Events shown_elsewhere(double t_s, const Eigen::Vector3d &by_m) {
	const double outlier = std::ceil(t_s * RATE_HZ);
	const Way way = [=](double frame_s) {
		const bool is_outlier = std::abs(frame_s * RATE_HZ - outlier) < 0.5;
		return Eigen::Vector3d(DRAG.x_m(frame_s) * X + (is_outlier ? by_m : Eigen::Vector3d::Zero()));
	};
	return in_the_open(way, 2.2);
}

} // namespace

TEST_CASE("with nothing given a single frame elsewhere right before a gesture does not move its start") {
	for (const double before_s : { 0.0, 0.02, 0.05, 0.1 }) {
		for (const double by_m : { -0.05, -0.2, 0.2 }) {
			CAPTURE(before_s);
			CAPTURE(by_m);
			const Events events = shown_elsewhere(DRAG.onset_s - before_s, by_m * X);
			CHECK(events.said == times(1, "sideways"));
			CHECK(events.last_value_m == near(DRAG.amplitude_m).epsilon(0.02));
		}
	}
}

TEST_CASE("where the tracker jumps back for a moment while the hand sets out, the motion is not shifted") {
	for (const double back_m : { 0.03, 0.05, 0.1 }) {
		for (const double shown_s : { 0.03, 0.1 }) {
			for (const double before_s : { 0.1, 0.05, 0.0 }) {
				CAPTURE(back_m);
				CAPTURE(shown_s);
				CAPTURE(before_s);
				const double from_s = DRAG.onset_s - before_s;
				const Way way = [=](double t_s) {
					const bool is_paused = t_s >= from_s && t_s < from_s + shown_s;
					return Eigen::Vector3d((DRAG.x_m(t_s) - (is_paused ? back_m : 0.0)) * X);
				};
				const Events events = in_the_open(way, 2.0);
				CHECK(events.said == times(1, "sideways"));
				CHECK(std::abs(events.last_value_m - 0.2) < 0.01);
			}
		}
	}
}

TEST_CASE(
		"a gesture that is told while the tracker shows the hand further back counts from where it set out") {
	for (const double duration_s : { 0.35, 0.4, 0.5 }) {
		for (const double back_m : { 0.05, 0.1 }) {
			for (const double share : { 0.05, 0.1, 0.15 }) {
				CAPTURE(duration_s);
				CAPTURE(back_m);
				CAPTURE(share);
				const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s + share * duration_s;
				const Way way = [=](double t_s) {
					const bool is_paused = t_s >= from_s && t_s < from_s + 0.1;
					return Eigen::Vector3d((drag.x_m(t_s) - (is_paused ? back_m : 0.0)) * X);
				};
				const Events events = in_the_open(way, drag.onset_s + duration_s + 0.3);
				CHECK(events.said == times(1, "sideways"));
				CHECK(std::abs(events.last_value_m - 0.2) < 0.02);
			}
		}
	}
}

TEST_CASE("soon after a hand went elsewhere a gesture begins once it is well under way, and is told as any") {
	const Drag elsewhere{ .onset_s = 1.0, .duration_s = 0.5, .amplitude_m = 0.15 };
	for (const double rests_s : { 0.3, 0.5, 0.8 }) {
		for (const double far_m : { 0.05, 0.2 }) {
			CAPTURE(rests_s);
			CAPTURE(far_m);
			const Drag drag{ .onset_s = 1.5 + rests_s, .duration_s = 0.7, .amplitude_m = far_m };
			const Way way = [&](double t_s) {
				return Eigen::Vector3d(elsewhere.x_m(t_s) * (Y - X).normalized() + drag.x_m(t_s) * X);
			};
			const Events events = in_the_open(way, drag.onset_s + 1.5);
			CHECK(count(events, "started sideways") == (far_m < 0.1 ? 0 : 1));
			CHECK(count(events, "ended sideways") == (far_m < 0.1 ? 0 : 1));
		}
	}
}

TEST_CASE("a hand that moves an eighth of a gesture's way along it and slows down begins none") {
	for (const double duration_s : { 0.2, 0.5, 1.0 }) {
		for (const double share : { 0.13, 0.14, 0.15 }) {
			CAPTURE(duration_s);
			CAPTURE(share);
			const Drag shift{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = share * 0.2 };
			CHECK(in_the_open(along(X, { shift }), 3.0).said.empty());
		}
	}
}

TEST_CASE("a hand that a tracker shows wandering by 1 cm is not shown half of the time as one that makes a "
		  "gesture") {
	constexpr int HANDS = 16;
	constexpr double SECONDS = 20.0, WANDERS_M = 0.01;
	struct Pace {
		double slowest_hz, fastest_hz, share;
	};
	for (const Pace &pace : { Pace{ 0.1, 0.5, 0.25 }, { 0.2, 0.8, 0.35 }, { 0.5, 1.5, 0.4 } }) {
		CAPTURE(pace.fastest_hz);
		double shown_s = 0.0;
		for (int hand = 0; hand < HANDS; ++hand) {
			Random random(static_cast<std::uint64_t>(hand));
			const Oscillation wandering(pace.slowest_hz, pace.fastest_hz, WANDERS_M, random);
			GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
			double last_s = 0.0;
			const Way way = [&](double t_s) -> Eigen::Vector3d {
				shown_s += recogniser.gesture() >= 0 ? t_s - last_s : 0.0;
				last_s = t_s;
				return wandering.at(t_s);
			};
			watch(recogniser, way, SECONDS);
		}
		CHECK(shown_s < pace.share * HANDS * SECONDS);
	}
}
