#include "gesture/trainer.h"
#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <numbers>

using namespace steadyhand;

namespace {

constexpr double RADIUS_M = 0.06;
constexpr double ROUND_M = 2.0 * std::numbers::pi * RADIUS_M;

const Task TASK{ { 0.0, RADIUS_M, 0.0 }, { -1.0, 0.0, 0.0 }, ROUND_M };

HandFrame on_the_circle(double t_s, double way_m) {
	HandFrame frame;
	frame.t_s = t_s;
	const double angle_rad = way_m / RADIUS_M;
	frame.set(Joint::INDEX, { -RADIUS_M * std::sin(angle_rad), RADIUS_M * std::cos(angle_rad), 0.0 });
	return frame;
}

Track rounds_track(double rate_hz, double length_s, const std::vector<test::Drag> &rounds) {
	Track track;
	for (int i = 0; i < static_cast<int>(length_s * rate_hz); ++i) {
		double way_m = 0.0;
		for (const test::Drag &round : rounds) {
			way_m += round.x_m(i / rate_hz);
		}
		track.frames.push_back(on_the_circle(i / rate_hz, way_m));
	}
	return track;
}

std::shared_ptr<const GestureModel> circle_model() {
	std::vector<TrainingRecording> recordings;
	for (int i = 0; i < 12; ++i) {
		const test::Drag round{ .onset_s = 0.5, .duration_s = 1.0 + 0.05 * i, .amplitude_m = ROUND_M };
		const double end_s = round.onset_s + round.duration_s;
		recordings.push_back({ "circle" + std::to_string(i), TASK, 0.3, end_s,
				rounds_track(110.0, end_s + 0.5, { round }), rounds_track(240.0, end_s + 0.5, { round }) });
	}
	return std::make_shared<const GestureModel>(
			train("circle", "index_along_circle", recordings, {}).value());
}

} // namespace

TEST_CASE("a whole circle is followed from 0 to its length, where it ends") {
	const std::shared_ptr<const GestureModel> model = circle_model();
	CHECK(evaluate(*model, 1.0).value == test::near(1.0).epsilon(0.01));
	const test::Drag round{ .onset_s = 0.5, .duration_s = 1.3, .amplitude_m = ROUND_M };
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		CAPTURE(static_cast<int>(mode));
		GestureRecogniser hmm({ model }, TASK, mode);
		double largest_m = 0.0;
		for (const HandFrame &frame : rounds_track(110.0, 2.5, { round }).frames) {
			hmm.push(frame);
			const double way_m = round.x_m(frame.t_s);
			largest_m = std::max(largest_m, std::abs(hmm.motion(MotionSource::SYNTHESISED).value_m - way_m));
			CHECK(hmm.motion(MotionSource::MEASURED).value_m == test::near(way_m));
		}
		// Of 0.38 m; `paper`, which goes by the states' mean durations, is an eighth of the way off at most.
		CHECK(largest_m < (mode == MotionMode::PAPER ? 0.125 * ROUND_M : 0.02 * ROUND_M));
		REQUIRE(hmm.session() != nullptr);
		CHECK(hmm.session()->stage() == GestureSession::Stage::ENDED);
		CHECK(hmm.motion(MotionSource::SYNTHESISED).value_m == test::near(ROUND_M).epsilon(0.01));
	}
}

TEST_CASE("a circle is found with its task only, and nothing that goes round there is rejected") {
	const std::shared_ptr<const GestureModel> model = circle_model();
	const test::Drag round{ .onset_s = 0.5, .duration_s = 1.3, .amplitude_m = ROUND_M };
	const auto stage = [&](const std::optional<Task> &task, double narrower) {
		GestureRecogniser hmm({ model }, task, MotionMode::PHASE);
		for (HandFrame frame : rounds_track(110.0, 2.5, { round }).frames) {
			Eigen::Vector3d place = frame.position(Joint::INDEX);
			place.x() *= narrower;
			frame.set(Joint::INDEX, place);
			hmm.push(frame);
		}
		return hmm.session() != nullptr ? hmm.session()->stage() : GestureSession::Stage::IDLE;
	};
	CHECK(stage(std::nullopt, 1.0) == GestureSession::Stage::IDLE);
	CHECK(stage(TASK, 1.0) == GestureSession::Stage::ENDED);
	CHECK(stage(TASK, 0.6) == GestureSession::Stage::ENDED);
}

TEST_CASE("each further round is a circle again") {
	const std::shared_ptr<const GestureModel> model = circle_model();
	const std::vector<test::Drag> rounds{ { 0.5, 1.2, ROUND_M }, { 2.5, 1.2, ROUND_M },
		{ 4.5, 1.2, ROUND_M } };
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		CAPTURE(static_cast<int>(mode));
		GestureRecogniser hmm({ model }, TASK, mode);
		int arrivals = 0;
		auto stage = GestureSession::Stage::IDLE;
		for (const HandFrame &frame : rounds_track(110.0, 6.5, rounds).frames) {
			hmm.push(frame);
			const auto now = hmm.session() != nullptr ? hmm.session()->stage() : GestureSession::Stage::IDLE;
			arrivals += now == GestureSession::Stage::ENDED && stage != now;
			stage = now;
			const Motion motion = hmm.motion(MotionSource::SYNTHESISED);
			REQUIRE(motion.value_m > -0.1 * ROUND_M);
			REQUIRE(motion.value_m < 1.3 * ROUND_M);
		}
		CHECK(arrivals == 3);
		CHECK(hmm.motion(MotionSource::SYNTHESISED).value_m == test::near(ROUND_M).epsilon(0.05));
	}
}

TEST_CASE("a circle may be wider or narrower than its task, and before or behind its plane") {
	const std::shared_ptr<const GestureModel> model = circle_model();
	const test::Drag round{ .onset_s = 0.5, .duration_s = 1.3, .amplitude_m = ROUND_M };
	for (const auto &[wider, nearer_m] : { std::pair{ 2.0, 0.0 }, std::pair{ 0.5, 0.0 },
				 std::pair{ 1.0, RADIUS_M }, std::pair{ 1.0, -RADIUS_M }, std::pair{ 1.8, RADIUS_M } }) {
		CAPTURE(wider);
		CAPTURE(nearer_m);
		GestureRecogniser hmm({ model }, TASK, MotionMode::PHASE);
		const auto seen = [&](double t_s) {
			const HandFrame frame = on_the_circle(t_s, round.x_m(t_s));
			return Eigen::Vector3d(wider * frame.position(Joint::INDEX) + nearer_m * test::Z);
		};
		CHECK(test::watch(hmm, seen, 2.5).said == test::times(1, "circle"));
	}
}

TEST_CASE("a tracker that shows another place for a quarter of a second does not end a circle") {
	const std::shared_ptr<const GestureModel> model = circle_model();
	const test::Drag round{ .onset_s = 0.5, .duration_s = 1.3, .amplitude_m = ROUND_M };
	for (const double from_s : { 0.9, 1.1, 1.3 }) {
		CAPTURE(from_s);
		GestureRecogniser hmm({ model }, TASK, MotionMode::PHASE);
		const auto seen = [&](double t_s) {
			const bool is_away = t_s > from_s && t_s < from_s + 0.25;
			const Eigen::Vector3d hand_m = on_the_circle(t_s, round.x_m(t_s)).position(Joint::INDEX);
			return Eigen::Vector3d(is_away ? 4.0 * hand_m : hand_m);
		};
		CHECK(test::watch(hmm, seen, 2.5).said == test::times(1, "circle"));
	}
}

TEST_CASE("a hand beside the circle's place makes no circle there, and what it does is shown as if alone") {
	const ExpectedGesture circle{ circle_model(), TASK };
	const test::Drag drag{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.2 },
			back{ .onset_s = 2.0, .duration_s = 0.8, .amplitude_m = -0.2 };
	// Upwards on its right side, and to the left above it, is counterclockwise.
	for (const auto &[from_m, axis] : { std::pair{ Eigen::Vector3d(0.22, -0.1, 0.0), test::Y },
				 std::pair{ Eigen::Vector3d(0.1, 0.22, 0.0), Eigen::Vector3d(-test::X) },
				 std::pair{ Eigen::Vector3d(0.02, RADIUS_M, 0.2), Eigen::Vector3d(-test::X) } }) {
		CAPTURE(from_m.transpose());
		const auto hand = [&](double t_s) {
			return Eigen::Vector3d(from_m + (drag.x_m(t_s) + back.x_m(t_s)) * axis);
		};
		const ExpectedGesture beside{ test::models()[0], Task{ from_m, axis, 0.2 } };
		GestureRecogniser alone({ beside }), both({ circle, beside }), only({ circle });
		const test::Events of_one = test::watch(alone, hand, 3.5), of_both = test::watch(both, hand, 3.5);
		CHECK(of_one.said == test::times(1, "sideways"));
		CHECK(of_both.said == of_one.said);
		CHECK(of_both.largest_step == test::near(of_one.largest_step));
		CHECK(test::watch(only, hand, 3.5).said.empty());
	}
}

TEST_CASE("a hand that leaves a circle half-way for something else has given it up") {
	GestureRecogniser hmm({ ExpectedGesture{ circle_model(), TASK } });
	const test::Drag round{ .onset_s = 0.5, .duration_s = 0.7, .amplitude_m = 0.4 * ROUND_M },
			leaves{ .onset_s = 1.0, .duration_s = 0.5, .amplitude_m = 0.4 };
	const auto hand = [&](double t_s) {
		const Eigen::Vector3d on_m = on_the_circle(t_s, round.x_m(t_s)).position(Joint::INDEX);
		return Eigen::Vector3d(on_m - leaves.x_m(t_s) * test::X);
	};
	CHECK(test::watch(hmm, hand, 2.5).said == std::vector<std::string>{ "started circle", "aborted circle" });
	CHECK(std::abs(hmm.motion(MotionSource::SYNTHESISED).progress) < 1e-9);
}
