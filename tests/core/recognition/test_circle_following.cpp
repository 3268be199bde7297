#include "gesture/trainer.h"
#include "minimum_jerk_drag.h"
#include "near.h"
#include "recognition/gesture_recogniser.h"

#include <doctest/doctest.h>

#include <cmath>
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
		REQUIRE(hmm.follower() != nullptr);
		CHECK(hmm.follower()->stage() == GestureFollower::Stage::ARRIVED);
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
		return hmm.follower() != nullptr ? hmm.follower()->stage() : GestureFollower::Stage::RESTING;
	};
	CHECK(stage(std::nullopt, 1.0) == GestureFollower::Stage::RESTING);
	CHECK(stage(TASK, 1.0) == GestureFollower::Stage::ARRIVED);
	CHECK(stage(TASK, 0.6) == GestureFollower::Stage::ARRIVED);
}

TEST_CASE("each further round is a circle again") {
	const std::shared_ptr<const GestureModel> model = circle_model();
	const std::vector<test::Drag> rounds{ { 0.5, 1.2, ROUND_M }, { 2.5, 1.2, ROUND_M },
		{ 4.5, 1.2, ROUND_M } };
	for (const MotionMode mode : { MotionMode::PHASE, MotionMode::PAPER }) {
		CAPTURE(static_cast<int>(mode));
		GestureRecogniser hmm({ model }, TASK, mode);
		int arrivals = 0;
		auto stage = GestureFollower::Stage::RESTING;
		for (const HandFrame &frame : rounds_track(110.0, 6.5, rounds).frames) {
			hmm.push(frame);
			const auto now =
					hmm.follower() != nullptr ? hmm.follower()->stage() : GestureFollower::Stage::RESTING;
			arrivals += now == GestureFollower::Stage::ARRIVED && stage != now;
			stage = now;
			const Motion motion = hmm.motion(MotionSource::SYNTHESISED);
			REQUIRE(motion.value_m > -0.1 * ROUND_M);
			REQUIRE(motion.value_m < 1.3 * ROUND_M);
		}
		CHECK(arrivals == 3);
		CHECK(hmm.motion(MotionSource::SYNTHESISED).value_m == test::near(ROUND_M).epsilon(0.05));
	}
}
