// Tasks at several places, of which the hand is at one: what the others cost, and show, is nothing.

#include "gesture_events.h"

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

TEST_CASE("at rest the task is shown that the hand is nearest to, and counted along its way") {
	const Way way = comes_from(-X, 0.5);
	const Run alone = run({ drag_at(HERE.start_m, X) }, way, 6.0);
	const Run two = run({ drag_at(-0.5 * X, Y), drag_at(HERE.start_m, X) }, way, 6.0);
	CHECK(two.events.said == times(1, "sideways"));
	for (std::size_t i = 1; i < two.values_m.size(); ++i) {
		const bool is_here = two.shown[i] == 1;
		// Else it is aside. A hand at 2 m/s goes on by 2 cm until the next frame.
		CHECK(std::abs(two.values_m[i] - (is_here ? alone.values_m[i] : 0.0)) < 6e-3);
	}
	CHECK(two.shown[330] == 0); // of 110 a second, as the hand sets out
	CHECK(two.shown[385] == 1);
}

TEST_CASE("a gesture that is made from another one's end, with no way back, is shown along its own way") {
	// 15 cm down from the end of the first, and on from there: both are drags to the right.
	const Drag first{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.2 },
			down{ .onset_s = 1.9, .duration_s = 0.4, .amplitude_m = 0.15 },
			second{ .onset_s = 2.7, .duration_s = 0.8, .amplitude_m = 0.2 };
	const Way way = [&](double t_s) {
		return Eigen::Vector3d((first.x_m(t_s) + second.x_m(t_s)) * X - down.x_m(t_s) * Y);
	};
	const ExpectedGesture there = drag_at(0.2 * X - 0.15 * Y, X);
	const Run alone = run({ there }, way, 4.5);
	const Run both = run({ drag_at(HERE.start_m, X), there }, way, 4.5);
	CHECK(both.events.said == times(2, "sideways"));
	for (std::size_t i = 0; i < both.values_m.size(); ++i) {
		if (both.shown[i] == 1) {
			CHECK(std::abs(both.values_m[i] - alone.values_m[i]) < 2e-3);
		}
	}
	CHECK(both.shown.back() == 1);
}

TEST_CASE("a tracker that shows the hand at another task for a while does not make its own task lose it") {
	double found = 0.0, runs = 0.0;
	for (const double away_s : { 1.2, 1.6, 2.0 }) {
		for (const double until : { 0.3, 0.6, 0.85 }) { // of the drag's time
			for (const double duration_s : { 0.6, 0.9, 1.2 }) {
				const Drag drag{ .onset_s = 4.0, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double back_s = 4.0 + until * duration_s;
				// Nearer to the last part of the way than its start is.
				const Eigen::Vector3d there_m = 0.2 * X + 0.12 * Y;
				const Way way = [&](double t_s) {
					const bool is_away = t_s > back_s - away_s && t_s < back_s;
					return is_away ? there_m : Eigen::Vector3d(drag.x_m(t_s) * X);
				};
				const Run two = run({ drag_at(HERE.start_m, X), drag_at(there_m, Y) }, way, 7.0, 3e-4);
				found += ends(two.events) == 1 ? 1.0 : 0.0;
				runs += 1.0;
			}
		}
	}
	CHECK(found >= 0.9 * runs); // two thirds, if a task were let be after a second
}

TEST_CASE("of two tasks at one place the other one's gesture begins without a step") {
	const Run other = run({ drag_at(HERE.start_m, Y), drag_at(HERE.start_m, X) }, along(X, { DRAG }), 2.5);
	CHECK(other.events.said == times(1, "sideways"));
	CHECK(other.events.largest_step < FASTEST_M_MS);
}

TEST_CASE("a zoom may begin anywhere: at rest it is shown where no other task is near") {
	constexpr double CLOSED_M = 0.016;
	const Task opens{ { CLOSED_M, 0.0, 0.0 }, X, 0.03 };
	for (const double off_m : { 0.05, 0.5 }) {
		GestureRecogniser recogniser({ { zoom_model(CLOSED_M, 0.03), opens }, drag_at(-X, X) });
		for (int i = 0; i < 60; ++i) {
			HandFrame frame;
			frame.t_s = i / 110.0;
			int tip = 0;
			for (const Joint joint : { Joint::THUMB, Joint::INDEX, Joint::MIDDLE }) {
				const double angle_rad = 2.1 * tip++;
				const Eigen::Vector3d spread(std::cos(angle_rad), std::sin(angle_rad), 0.0);
				frame.set(joint, off_m * Y - X + CLOSED_M * spread);
			}
			recogniser.push(frame);
		}
		CHECK(recogniser.shown() == (off_m < 0.1 ? 1 : 0));
	}
}

TEST_CASE("where the one shown is expected no longer, the nearest of those that stay is shown at once") {
	const ExpectedGesture here = drag_at(HERE.start_m, X), beside = drag_at(0.1 * Y, X),
						  away = drag_at(2.0 * Y, X);
	GestureRecogniser recogniser({ here, beside, away });
	watch(
			recogniser, [](double) { return Eigen::Vector3d(Eigen::Vector3d::Zero()); }, 0.5);
	REQUIRE(recogniser.shown() == 0);
	recogniser.expect({ away, beside });
	CHECK(recogniser.shown() == 1);
}

TEST_CASE("where others are expected from an end on, the motion of the hand that stands there stands") {
	GestureRecogniser recogniser({ drag_at(HERE.start_m, X) });
	bool is_changed = false;
	double fastest_m_s = 0.0;
	watch(
			recogniser,
			[&](double t_s) {
				if (is_changed) {
					const Motion motion = recogniser.motion(MotionSource::SYNTHESISED);
					fastest_m_s = std::max(fastest_m_s, std::abs(motion.velocity_m_s));
				} else if (t_s > 1.9) {
					is_changed = true;
					recogniser.expect({ drag_at(1.2 * Y, Y), drag_at(0.2 * X + 0.24 * Y, -Y) });
				}
				return Eigen::Vector3d(DRAG.x_m(t_s) * X);
			},
			3.0);
	CHECK(recogniser.shown() == 1);
	CHECK(std::abs(recogniser.motion(MotionSource::SYNTHESISED).value_m - 0.24) < 2e-3);
	CHECK(fastest_m_s < 0.2); // as that of any hand that comes into view off the start, in its first frames
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
