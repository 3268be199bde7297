// Several tasks at a time: which one is shown. The others must not change it.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

const Eigen::Vector3d ORIGIN = Eigen::Vector3d::Zero();

ExpectedGesture drag_at(const Eigen::Vector3d &start_m, const Eigen::Vector3d &axis) {
	return { models()[0], Task{ start_m, axis, 0.2 } };
}

struct Run {
	std::vector<double> values_m; ///< synthesised value before each frame
	std::vector<std::size_t> shown;
	Events events;
};

Run run(const std::vector<ExpectedGesture> &gestures, const TestPath &path, double length_s,
		double noise_m = 1e-4) {
	GestureRecogniser recogniser(gestures);
	Run run;
	const TestPath noted = [&](double t_s) {
		run.values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
		run.shown.push_back(recogniser.shown());
		return path(t_s);
	};
	run.events = watch(recogniser, noted, length_s, { .noise_m = noise_m });
	return run;
}

/// A hand that rests at 0.5 m for 3 s, moves to the origin in 0.5 s, and drags after pause_s.
TestPath comes_from(const Eigen::Vector3d &direction, double pause_s) {
	const Drag approach{ .onset_s = 3.0, .duration_s = 0.5, .amplitude_m = 0.5 },
			drag{ .onset_s = 3.5 + pause_s, .duration_s = 0.8, .amplitude_m = 0.2 };
	return [=](double t_s) {
		return Eigen::Vector3d((0.5 - approach.x_m(t_s)) * direction + drag.x_m(t_s) * X);
	};
}

} // namespace

TEST_CASE("distant tasks change no bit of the motion, in any order") {
	const TestPath drag = along(X, { DRAG });
	const Run alone = run({ drag_at(ORIGIN, X) }, drag, 2.5);
	for (const std::size_t place : { 0, 4, 10 }) {
		std::vector<ExpectedGesture> gestures;
		for (int i = 1; i <= 10; ++i) {
			gestures.push_back(
					drag_at(i * Eigen::Vector3d(i % 3 == 0 ? -0.4 * Y : 0.6 * X), i % 2 == 0 ? X : Y));
		}
		gestures.insert(gestures.begin() + static_cast<std::ptrdiff_t>(place), drag_at(ORIGIN, X));
		const Run among = run(gestures, drag, 2.5);
		CHECK(among.values_m == alone.values_m);
		CHECK(among.shown.back() == place);
		CHECK(among.events.names == ENDS);
	}
}

TEST_CASE("an idle hand is shown at its nearest task") {
	const TestPath path = comes_from(-X, 0.5);
	const Run alone = run({ drag_at(ORIGIN, X) }, path, 6.0);
	const Run two = run({ drag_at(-0.5 * X, Y), drag_at(ORIGIN, X) }, path, 6.0);
	CHECK(two.events.names == ENDS);
	for (std::size_t i = 1; i < two.values_m.size(); ++i) {
		const bool is_here = two.shown[i] == 1;
		// At the other task the value is 0. A hand at 2 m/s moves 2 cm between two frames.
		CHECK(std::abs(two.values_m[i] - (is_here ? alone.values_m[i] : 0.0)) < 6e-3);
	}
	CHECK(two.shown[330] == 0); // at 3.0 s, when the hand begins to move
	CHECK(two.shown[385] == 1);
}

TEST_CASE("a hand that comes from another task is followed as usual") {
	for (const double noise_m : { 1e-4, 2e-3 }) {
		for (const Eigen::Vector3d &direction : { Y, Z }) {
			for (const double pause_s : { 0.1, 0.3 }) {
				INFO("noise ", noise_m, ", from ", direction.transpose(), ", pause ", pause_s);
				const TestPath path = comes_from(direction, pause_s);
				const Run alone = run({ drag_at(ORIGIN, X) }, path, 6.0, noise_m);
				const Run coming =
						run({ drag_at(0.5 * direction, direction), drag_at(ORIGIN, X) }, path, 6.0, noise_m);
				CHECK(coming.events.names == alone.events.names);
				const auto onset = static_cast<std::size_t>(110.0 * (3.5 + pause_s));
				for (std::size_t i = onset; i < alone.values_m.size(); ++i) {
					CHECK(std::abs(coming.values_m[i] - alone.values_m[i]) < 5e-3);
				}
			}
		}
	}
}

TEST_CASE("a gesture that begins near the last endpoint is shown") {
	// Both are drags to the right. The second begins 15 cm below the end of the first.
	const TestPath path = [](double t_s) {
		const Drag down{ .onset_s = 1.9, .duration_s = 0.4, .amplitude_m = 0.15 };
		const double right_m = x_m({ { 0.6, 0.8, 0.2 }, { 2.7, 0.8, 0.2 } }, t_s);
		return Eigen::Vector3d(right_m * X - down.x_m(t_s) * Y);
	};
	const ExpectedGesture there = drag_at(0.2 * X - 0.15 * Y, X);
	const Run alone = run({ there }, path, 4.5);
	const Run both = run({ drag_at(ORIGIN, X), there }, path, 4.5);
	CHECK(both.events.names == times(2, "horizontal_drag"));
	for (std::size_t i = 0; i < both.values_m.size(); ++i) {
		if (both.shown[i] == 1) {
			CHECK(std::abs(both.values_m[i] - alone.values_m[i]) < 2e-3);
		}
	}
	CHECK(both.shown.back() == 1);
}

TEST_CASE("with two tasks at one place the gesture begins without a step") {
	const Run other = run({ drag_at(ORIGIN, Y), drag_at(ORIGIN, X) }, along(X, { DRAG }), 2.5);
	CHECK(other.events.names == ENDS);
	CHECK(other.events.largest_step < FASTEST_M_MS);
}

TEST_CASE("an idle zoom is shown where no other task is near") {
	constexpr double CLOSED_M = 0.016;
	const Task opens{ { CLOSED_M, 0.0, 0.0 }, X, 0.03 };
	for (const double off_m : { 0.05, 0.5 }) {
		GestureRecogniser recogniser({ { zoom_model(CLOSED_M, 0.03), opens }, drag_at(-X, X) });
		for (int i = 0; i < 60; ++i) {
			HandFrame frame;
			frame.t_s = i / 110.0;
			double angle_rad = 0.0;
			for (const Joint joint : { Joint::THUMB, Joint::INDEX, Joint::MIDDLE }) {
				const Eigen::Vector3d spread(std::cos(angle_rad), std::sin(angle_rad), 0.0);
				frame.set(joint, off_m * Y - X + CLOSED_M * spread);
				angle_rad += 2.1;
			}
			recogniser.push(frame);
		}
		CHECK(recogniser.shown() == (off_m < 0.1 ? 1 : 0));
	}
}

TEST_CASE("a hand midway between two tasks does not switch between them") {
	const TestPath sways = [](double t_s) { return Eigen::Vector3d(0.008 * std::sin(9.0 * t_s) * Y); };
	const Run between = run({ drag_at(0.1 * Y, X), drag_at(-0.1 * Y, X) }, sways, 3.0);
	CHECK(std::ranges::count(between.shown, between.shown.back()) >= std::ssize(between.shown) - 1);
}

TEST_CASE("if expect() removes the shown task, the nearest is shown") {
	const ExpectedGesture here = drag_at(ORIGIN, X), beside = drag_at(0.1 * Y, X), away = drag_at(2.0 * Y, X);
	GestureRecogniser recogniser({ here, beside, away });
	watch(recogniser, along(X, {}), 0.5);
	REQUIRE(recogniser.shown() == 0);
	recogniser.expect({ away, beside });
	CHECK(recogniser.shown() == 1);
}

TEST_CASE("expect() of other tasks at an end keeps the velocity low") {
	GestureRecogniser recogniser({ drag_at(ORIGIN, X) });
	watch(recogniser, along(X, { DRAG }), 1.9);
	recogniser.expect({ drag_at(1.2 * Y, Y), drag_at(0.2 * X + 0.24 * Y, -Y) });
	double fastest_m_s = 0.0;
	for (int i = 210; i < 330; ++i) {
		const Motion motion = recogniser.motion(MotionSource::SYNTHESISED);
		fastest_m_s = std::max(fastest_m_s, std::abs(motion.velocity_m_s));
		HandFrame frame;
		frame.t_s = i / 110.0;
		frame.set(Joint::INDEX, 0.2 * X + 1e-4 * std::sin(3.0 * i) * Y);
		recogniser.push(frame);
	}
	CHECK(recogniser.shown() == 1);
	CHECK(std::abs(recogniser.motion(MotionSource::SYNTHESISED).value_m - 0.24) < 2e-3);
	CHECK(fastest_m_s < 0.2); // as at the begin of a track away from the start
}
