// Tasks at several places, of which the hand is at one: what the others cost, and show, is nothing.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

const Task HERE{ Eigen::Vector3d::Zero(), X, 0.2 };

ExpectedGesture drag_at(const Eigen::Vector3d &start_m, const Eigen::Vector3d &axis) {
	return { models()[0], Task{ start_m, axis, 0.2 } };
}

struct Run {
	std::vector<double> values_m; ///< synthesised, at each frame, before it is seen
	std::vector<std::size_t> shown;
	Events events;
};

Run run(const std::vector<ExpectedGesture> &gestures, const Way &way, double length_s,
		double noise_m = 1e-4) {
	GestureRecogniser recogniser(gestures);
	Run run;
	const Way noted = [&](double t_s) {
		run.values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
		run.shown.push_back(recogniser.shown());
		return way(t_s);
	};
	run.events = watch(recogniser, noted, length_s, 1e9, 1e9, 110.0, noise_m);
	return run;
}

/// Rests 0.5 m off for 3 s, comes to the origin within half a second, and drags pause_s later.
Way comes_from(const Eigen::Vector3d &direction, double pause_s) {
	const Drag approach{ .onset_s = 3.0, .duration_s = 0.5, .amplitude_m = 0.5 },
			drag{ .onset_s = 3.5 + pause_s, .duration_s = 0.8, .amplitude_m = 0.2 };
	return [=](double t_s) {
		return Eigen::Vector3d((0.5 - approach.x_m(t_s)) * direction + drag.x_m(t_s) * X);
	};
}

} // namespace

TEST_CASE("tasks elsewhere change nothing, to the last bit, in whatever order: the one at hand is shown") {
	const Way drag = along(X, { DRAG });
	const Run alone = run({ drag_at(HERE.start_m, X) }, drag, 2.5);
	for (const Eigen::Vector3d &aside : { Eigen::Vector3d(0.6 * X), Eigen::Vector3d(-0.4 * Y) }) {
		std::vector<ExpectedGesture> gestures;
		for (int i = 1; i <= 10; ++i) {
			gestures.push_back(drag_at(i * aside, i % 2 == 0 ? X : Y));
		}
		for (const std::size_t place : { 0, 4, 10 }) {
			std::vector<ExpectedGesture> with_this = gestures;
			with_this.insert(
					with_this.begin() + static_cast<std::ptrdiff_t>(place), drag_at(HERE.start_m, X));
			const Run among = run(with_this, drag, 2.5);
			CHECK(std::ranges::equal(alone.values_m, among.values_m));
			CHECK(among.shown.back() == place);
			CHECK(among.events.said == times(1, "sideways"));
		}
	}
}

TEST_CASE("at rest the task is shown that the hand is nearest to, and nothing jumps as it goes from one to "
		  "the next") {
	const std::vector<ExpectedGesture> two{ drag_at(0.5 * Y, X), drag_at(Eigen::Vector3d::Zero(), X) };
	const Run there = run(two, comes_from(Y, 0.5), 6.0);
	CHECK(there.shown[300] == 0); // of 110 a second
	CHECK(there.shown[400] == 1);
	CHECK(there.events.said == times(1, "sideways"));
	CHECK(there.events.largest_step < FASTEST_M_MS);

	// Along x the one that the hand comes from has it half a metre off as the other one's gesture begins.
	const std::vector<ExpectedGesture> on_one_line{ drag_at(-0.5 * X, Y),
		drag_at(Eigen::Vector3d::Zero(), X) };
	const Run onward = run(on_one_line, comes_from(-X, 0.5), 6.0);
	CHECK(onward.events.said == times(1, "sideways"));
	CHECK(onward.events.largest_step < 2.5 * FASTEST_M_MS); // 0.5 m in place of 0.2
	for (std::size_t i = 430; i < 450; ++i) {               // from 3.9 s on, before it drags
		CHECK(std::abs(onward.values_m[i]) < 2e-3);
	}
}

TEST_CASE("a hand about as near to either of two tasks does not change between them") {
	const std::vector<ExpectedGesture> two{ drag_at(0.1 * Y, X), drag_at(-0.1 * Y, X) };
	const Run between = run(
			two, [](double t_s) { return Eigen::Vector3d(0.008 * std::sin(9.0 * t_s) * Y); }, 3.0);
	CHECK(std::ranges::count(between.shown, between.shown.back()) >= std::ssize(between.shown) - 1);
}

TEST_CASE("a hand that comes from elsewhere is followed as if it had been all along") {
	for (const double noise_m : { 1e-4, 2e-3 }) {
		for (const Eigen::Vector3d &direction : { Y, Z, Eigen::Vector3d(-Y) }) {
			for (const double pause_s : { 0.1, 0.3 }) {
				CAPTURE(noise_m);
				CAPTURE(direction.transpose());
				CAPTURE(pause_s);
				const Way way = comes_from(direction, pause_s);
				const Run alone = run({ drag_at(HERE.start_m, X) }, way, 6.0, noise_m);
				// It goes the other way than a hand that comes here.
				const Run coming = run(
						{ drag_at(0.5 * direction, direction), drag_at(HERE.start_m, X) }, way, 6.0, noise_m);
				CHECK(coming.events.said == alone.events.said);
				for (auto i = static_cast<std::size_t>(110.0 * (3.5 + pause_s)); i < alone.values_m.size();
						++i) {
					CHECK(std::abs(coming.values_m[i] - alone.values_m[i]) < 5e-3);
				}
			}
		}
	}
}
