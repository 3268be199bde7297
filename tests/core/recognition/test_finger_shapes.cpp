#include "gesture/circumcircle.h"
#include "recognition/gesture_recogniser.h"
#include "signal/minimum_jerk.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace steadyhand;

// With nothing given: fingers that open are a zoom, fingers that come into one line are none, though the
// circle through their tips grows as much.

namespace {

constexpr double PI = std::numbers::pi;
constexpr double CLOSED_M = 0.03, GROWTH_M = 0.03; ///< radius
using Tips = std::array<Eigen::Vector2d, 3>;

std::shared_ptr<const GestureModel> zoom_model() {
	GestureModel zoom = test::drag_model();
	zoom.gesture = "zoom";
	zoom.feature = "tips_circumradius";
	zoom.typical_task = { { CLOSED_M, 0.0, 0.0 }, Eigen::Vector3d::UnitX(), GROWTH_M };
	return std::make_shared<const GestureModel>(std::move(zoom));
}

Tips on_circle(double radius_m, const std::array<double, 3> &angles_rad) {
	Tips tips;
	for (std::size_t i = 0; i < 3; ++i) {
		tips[i] = radius_m * Eigen::Vector2d(std::cos(angles_rad[i]), std::sin(angles_rad[i]));
	}
	return tips;
}

/// Thumb against two fingers, opened to this radius.
Tips opened(double radius_m) {
	return on_circle(radius_m, { 3.6, 1.5, 0.4 });
}

/// Thumb and middle finger stay; the index finger sinks to the line between them as far as makes this radius.
Tips flattened(double radius_m) {
	const double half_m = CLOSED_M;
	const double height_m = radius_m - std::sqrt(radius_m * radius_m - half_m * half_m);
	return { Eigen::Vector2d(-half_m, 0.0), Eigen::Vector2d(0.0, height_m), Eigen::Vector2d(half_m, 0.0) };
}

int gestures_ended(Tips (*shape)(double), const Eigen::Vector3d &shift_m = Eigen::Vector3d::Zero()) {
	GestureRecogniser hmm({ zoom_model() }, std::nullopt, MotionMode::PHASE);
	std::mt19937_64 random(3);
	std::normal_distribution<double> noise(0.0, 2e-4);
	int ended = 0;
	GestureFollower::Stage stage = GestureFollower::Stage::RESTING;
	for (int i = 0; i < 300; ++i) {
		const double t_s = i / 100.0, gone = minimum_jerk((t_s - 1.0) / 0.9).value;
		const Tips tips = shape(CLOSED_M + gone * GROWTH_M);
		HandFrame frame;
		frame.t_s = t_s;
		const std::array joints{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
		for (std::size_t k = 0; k < 3; ++k) {
			const Eigen::Vector2d trembling(noise(random), noise(random));
			Eigen::Vector3d place = gone * shift_m;
			place.head<2>() += tips[k] + trembling;
			frame.set(joints[k], place);
		}
		hmm.push(frame);
		const GestureFollower::Stage now =
				hmm.follower() != nullptr ? hmm.follower()->stage() : GestureFollower::Stage::RESTING;
		ended += now == GestureFollower::Stage::ARRIVED && stage != now ? 1 : 0;
		stage = now;
	}
	return ended;
}

} // namespace

TEST_CASE("fingers that open are a zoom, also where the hand moves meanwhile") {
	CHECK(gestures_ended(opened) == 1);
	CHECK(gestures_ended(opened, { 0.03, 0.02, 0.0 }) == 1);
	CHECK(gestures_ended(opened, { 0.0, 0.0, -0.1 }) == 1);
}

TEST_CASE("fingers that come into one line are no zoom, though their circle grows twofold") {
	// As the zoom does.
	const auto radius = [](const Tips &tips) { return circumcircle(tips[0], tips[1], tips[2])->radius; };
	CHECK(radius(flattened(0.06)) == doctest::Approx(radius(opened(0.06))));
	CHECK(gestures_ended(flattened) == 0);
}
