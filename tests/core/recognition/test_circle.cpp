// A whole circle with a task, by the feature index_along_circle.

#include "gesture/trainer.h"
#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double RADIUS_M = 0.06;
constexpr double ROUND_M = 2.0 * std::numbers::pi * RADIUS_M;
constexpr Drag ROUND{ .onset_s = 0.5, .duration_s = 1.3, .amplitude_m = ROUND_M };
const Task TASK{ { 0.0, RADIUS_M, 0.0 }, { -1.0, 0.0, 0.0 }, ROUND_M };

/// Point at an arc length from the circle's top, counterclockwise.
Eigen::Vector3d on_circle(double arc_m) {
	const double angle_rad = arc_m / RADIUS_M;
	return { -RADIUS_M * std::sin(angle_rad), RADIUS_M * std::cos(angle_rad), 0.0 };
}

Track track_of(double rate_hz, double length_s, const std::vector<Drag> &rounds) {
	Track track;
	for (int i = 0; i < static_cast<int>(length_s * rate_hz); ++i) {
		HandFrame &frame = track.frames.emplace_back();
		frame.t_s = i / rate_hz;
		frame.set(Joint::INDEX, on_circle(x_m(rounds, frame.t_s)));
	}
	return track;
}

GestureRecogniser circles(MotionMode mode = MotionMode::PHASE, const std::optional<Task> &task = TASK) {
	static const auto model = [] {
		std::vector<TrainingRecording> recordings;
		for (int i = 0; i < 12; ++i) {
			const Drag round{ .onset_s = 0.5, .duration_s = 1.0 + 0.05 * i, .amplitude_m = ROUND_M };
			const double end_s = round.onset_s + round.duration_s;
			recordings.push_back({ "circle" + std::to_string(i), TASK, 0.3, end_s,
					track_of(110.0, end_s + 0.5, { round }), track_of(240.0, end_s + 0.5, { round }) });
		}
		return std::make_shared<const GestureModel>(
				train("circle", "index_along_circle", recordings, {}).value());
	}();
	return GestureRecogniser({ { model, task } }, { mode });
}

} // namespace

TEST_CASE("phase mode follows a circle within 2 %; both modes end") {
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		CAPTURE(static_cast<int>(mode));
		GestureRecogniser recogniser = circles(mode);
		double largest_m = 0.0;
		for (const HandFrame &frame : track_of(110.0, 2.5, { ROUND }).frames) {
			recogniser.push(frame);
			const double arc_m = ROUND.x_m(frame.t_s);
			const double value_m = recogniser.motion(MotionSource::SYNTHESISED).value_m;
			largest_m = std::max(largest_m, std::abs(value_m - arc_m));
			CHECK(recogniser.motion(MotionSource::MEASURED).value_m == near(arc_m));
		}
		// `paper` uses the states' mean durations.
		CHECK(largest_m < (mode == MotionMode::PAPER ? 0.125 * ROUND_M : 0.02 * ROUND_M));
		CHECK(stage(recogniser) == GestureSession::Stage::ENDED);
		CHECK(recogniser.motion(MotionSource::SYNTHESISED).value_m == near(ROUND_M).epsilon(0.01));
	}
}

TEST_CASE("three rounds with a rest between them are three circles") {
	const std::vector<Drag> rounds{ { 0.5, 1.2, ROUND_M }, { 2.5, 1.2, ROUND_M }, { 4.5, 1.2, ROUND_M } };
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		CAPTURE(static_cast<int>(mode));
		GestureRecogniser recogniser = circles(mode);
		ShownChanges shown;
		int ended = 0;
		for (const HandFrame &frame : track_of(110.0, 6.5, rounds).frames) {
			recogniser.push(frame);
			ended += shown.next(recogniser).ended ? 1 : 0;
			const Motion motion = recogniser.motion(MotionSource::SYNTHESISED);
			REQUIRE(motion.value_m > -0.1 * ROUND_M);
			REQUIRE(motion.value_m < 1.3 * ROUND_M);
		}
		CHECK(ended == 3);
		CHECK(recogniser.motion(MotionSource::SYNTHESISED).value_m == near(ROUND_M).epsilon(0.05));
	}
}

TEST_CASE("a circle of another size or depth ends only with a task") {
	struct Form {
		double width, height, nearer_m;
	};
	for (const auto &[width, height, nearer_m] : { Form{ 2.0, 2.0, 0.0 }, Form{ 0.5, 0.5, 0.0 },
				 Form{ 0.6, 1.0, 0.0 }, Form{ 1.0, 1.0, -RADIUS_M }, Form{ 1.8, 1.8, RADIUS_M } }) {
		INFO("width ", width, ", nearer ", nearer_m);
		const TestPath hand = [&](double t_s) {
			const Eigen::Vector3d on_m = on_circle(ROUND.x_m(t_s));
			return Eigen::Vector3d(width * on_m.x(), height * on_m.y(), nearer_m);
		};
		CHECK(watch(circles(), hand, 2.5).names == times(1, "circle"));
		CHECK(watch(circles(MotionMode::PHASE, std::nullopt), hand, 2.5).names.empty());
	}
}

TEST_CASE("a hand that moves beside a circle's task starts nothing") {
	// Motion up on the right side, and to the left above the circle, is counterclockwise.
	for (const auto &[from_m, axis] : { std::pair{ Eigen::Vector3d(0.22, -0.1, 0.0), Y },
				 std::pair{ Eigen::Vector3d(0.1, 0.22, 0.0), Eigen::Vector3d(-X) },
				 std::pair{ Eigen::Vector3d(0.02, RADIUS_M, 0.2), Eigen::Vector3d(-X) } }) {
		CAPTURE(from_m.transpose());
		const TestPath there_and_back = along(axis, { { 0.6, 0.8, 0.2 }, { 1.6, 0.8, -0.2 } });
		const TestPath hand = [&](double t_s) { return Eigen::Vector3d(from_m + there_and_back(t_s)); };
		CHECK(watch(circles(), hand, 2.5).names.empty());
	}
}

TEST_CASE("a hand that leaves the circle at 40 % aborts the gesture") {
	GestureRecogniser recogniser = circles();
	const TestPath hand = [](double t_s) {
		const Drag part{ 0.5, 0.7, 0.4 * ROUND_M }, leaves{ 1.0, 0.5, 0.4 };
		return Eigen::Vector3d(on_circle(part.x_m(t_s)) - leaves.x_m(t_s) * X);
	};
	CHECK(watch(recogniser, hand, 2.5).names == EventNames{ "started circle", "aborted circle" });
	CHECK(std::abs(recogniser.motion(MotionSource::SYNTHESISED).progress) < 1e-9);
}
