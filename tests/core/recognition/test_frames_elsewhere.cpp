// A hand that rests to the last bit, before a tracker that shows it elsewhere, or holds its pose.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr Drag LATE_DRAG{ .onset_s = 1.2, .duration_s = 0.8, .amplitude_m = 0.2 };
constexpr double LENGTH_S = 2.8;
constexpr unsigned HANDS = 40;
constexpr double ROUNDING_M = 0.9e-3; ///< and what it hides of where a single frame was

struct Tracker {
	double rate_hz;
	double elsewhere_share; ///< of all frames: some 5 cm off, in any direction
	double grid_m;          ///< to which it rounds; 0: not at all
	double tremor_m;        ///< standard deviation in each direction
};

Way seen(const Tracker &tracker, unsigned seed) {
	std::mt19937_64 random(seed);
	std::uniform_real_distribution<double> any;
	std::normal_distribution<double> noise;
	const auto some = [&](double deviation_m) {
		const double x = noise(random), y = noise(random), z = noise(random);
		return Eigen::Vector3d(deviation_m * Eigen::Vector3d(x, y, z));
	};
	std::vector<Eigen::Vector3d> off_m;
	for (int i = 0; i < static_cast<int>(LENGTH_S * tracker.rate_hz); ++i) {
		const bool is_elsewhere = any(random) < tracker.elsewhere_share;
		const Eigen::Vector3d elsewhere_m = some(0.03), tremor_m = some(tracker.tremor_m);
		off_m.push_back(tremor_m + (is_elsewhere ? elsewhere_m : Eigen::Vector3d::Zero()));
	}
	return [off_m, tracker](double t_s) {
		const auto i = static_cast<std::size_t>(std::lround(t_s * tracker.rate_hz));
		const Eigen::Vector3d place_m = LATE_DRAG.x_m(t_s) * X + off_m.at(i);
		return rounded(place_m, tracker.grid_m);
	};
}

/// Root mean square of how far the motion is from the hand, m.
double error_in_a_task_m(const Way &way, double rate_hz) {
	GestureRecogniser task({ models()[0] }, Task{}, MotionMode::PHASE);
	double squares_m2 = 0.0;
	constexpr int INSTANTS = static_cast<int>(1000.0 * LENGTH_S);
	const int frame_ms = static_cast<int>(std::lround(1000.0 / rate_hz));
	for (int ms = 0; ms < INSTANTS; ++ms) {
		const double t_s = ms / 1000.0;
		if (ms % frame_ms == 0) {
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, way(t_s));
			task.push(frame);
		}
		task.advance(t_s);
		const double off_m = task.motion(MotionSource::SYNTHESISED).value_m - LATE_DRAG.x_m(t_s);
		squares_m2 += off_m * off_m;
	}
	return std::sqrt(squares_m2 / INSTANTS);
}

double mean_error_in_a_task_m(const Tracker &tracker) {
	double sum_m = 0.0;
	for (unsigned seed = 0; seed < HANDS; ++seed) {
		sum_m += error_in_a_task_m(seen(tracker, seed), tracker.rate_hz);
	}
	return sum_m / HANDS;
}

/// Of how many hands the drag is not told, or something else is.
int lost_in_the_open(const Tracker &tracker) {
	int lost = 0;
	for (unsigned seed = 0; seed < HANDS; ++seed) {
		GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
		const Events events =
				watch(open, seen(tracker, seed), LENGTH_S - 0.01, 1e9, 1e9, tracker.rate_hz, 0.0);
		lost += events.said == times(1, "sideways") ? 0 : 1;
	}
	return lost;
}

} // namespace

TEST_CASE(
		"single frames elsewhere mislead no more where a hand rests to the last bit than where it trembles" *
		doctest::test_suite("figures")) {
	for (const double rate_hz : { 100.0, 200.0 }) {
		for (const double per_s : { 1.0, 3.0, 6.0 }) {
			const double share = per_s / rate_hz;
			const Tracker trembling{ rate_hz, share, 0.0, 1e-4 };
			const double trembling_m = mean_error_in_a_task_m(trembling);
			const int lost = lost_in_the_open(trembling);
			for (const double grid_m : { 0.0, 1e-3 }) {
				for (const double tremor_m : { 0.0, 2.0 / 9.0 * grid_m }) {
					CAPTURE(rate_hz);
					CAPTURE(per_s);
					CAPTURE(grid_m);
					CAPTURE(tremor_m);
					const Tracker still{ rate_hz, share, grid_m, tremor_m };
					CHECK(mean_error_in_a_task_m(still) < 1.15 * trembling_m + ROUNDING_M);
					CHECK(lost_in_the_open(still) <= lost);
				}
			}
		}
	}
}

TEST_CASE("a hand at rest that a single frame shows at its task's end, or beside it, is at rest") {
	constexpr double REST_S = 1.5, FRAME_S = 1.0, SETTLED_S = 0.1, RATE_HZ = 100.0;
	for (const double tremor_m : { 0.0, 1e-4 }) {
		for (const double part : { 0.8, 0.9, 1.0, 1.1, 1.3 }) {
			CAPTURE(tremor_m);
			CAPTURE(part);
			GestureRecogniser task({ models()[0] }, Task{}, MotionMode::PHASE);
			Tremor tremor(tremor_m, 1);
			for (int i = 0; i < static_cast<int>(REST_S * RATE_HZ); ++i) {
				HandFrame frame;
				frame.t_s = i / RATE_HZ;
				const bool is_elsewhere = i == static_cast<int>(FRAME_S * RATE_HZ);
				frame.set(Joint::INDEX, (is_elsewhere ? part * Task{}.amplitude_m : 0.0) * X + tremor());
				task.push(frame);
				task.advance(frame.t_s + 0.009);
				if (frame.t_s > FRAME_S + SETTLED_S) {
					CHECK(std::abs(task.motion(MotionSource::SYNTHESISED).value_m) < 5e-3);
				}
			}
		}
	}
}

TEST_CASE("a tracker that rounds, and holds its pose as the hand sets out, has shown no step") {
	constexpr double HELD_S = 0.2, GRID_M = 2e-3, TREMOR_M = 3e-4;
	for (const double duration_s : { 0.4, 0.8 }) {
		for (const double share : { 0.1, 0.2, 0.3 }) {
			for (unsigned seed = 0; seed < 10; ++seed) {
				CAPTURE(duration_s);
				CAPTURE(share);
				CAPTURE(seed);
				const Drag drag{ .onset_s = 1.2, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s + share * duration_s;
				Tremor tremor(TREMOR_M, seed);
				const Way seen = [&](double t_s) { return rounded(drag.x_m(t_s) * X + tremor(), GRID_M); };
				const Way way = held(seen, from_s, from_s + HELD_S);
				GestureRecogniser open(models(), std::nullopt, MotionMode::PHASE);
				CHECK(watch(open, way, 2.8, 1e9, 1e9, 100.0, 0.0).said == times(1, "sideways"));
			}
		}
	}
}
