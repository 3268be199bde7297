#include "gesture/circumcircle.h"
#include "near.h"
#include "recognition/gesture_recogniser.h"
#include "signal/minimum_jerk.h"
#include "simulation/other_motion.h"
#include "simulation/subject.h"
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
	return test::zoom_model(CLOSED_M, GROWTH_M);
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

struct Opening {
	Tips (*shape)(double radius_m) = opened;
	double growth_m = GROWTH_M;
	Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
	double lost_from_s = 1e9, lost_to_s = 1e9;
};

struct Outcome {
	int ended = 0;      ///< gestures
	double off_m = 0.0; ///< the motion's radius from the hand's, root mean square from 0.2 s after its end on
};

/// From 1 to 1.9 s, then still.
Outcome watch(const Opening &opening) {
	GestureRecogniser hmm({ zoom_model() }, std::nullopt, MotionMode::PHASE);
	std::mt19937_64 random(3);
	std::normal_distribution<double> noise(0.0, 2e-4);
	Outcome outcome;
	double sum = 0.0;
	int frames = 0;
	GestureSession::Stage stage = GestureSession::Stage::IDLE;
	for (int i = 0; i < 260; ++i) {
		const double t_s = i / 100.0, gone = minimum_jerk((t_s - 1.0) / 0.9).value;
		const Tips tips = opening.shape(CLOSED_M + gone * opening.growth_m);
		HandFrame frame;
		frame.t_s = t_s;
		const std::array joints{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
		for (std::size_t k = 0; k < 3; ++k) {
			const Eigen::Vector2d trembling{ noise(random), noise(random) };
			Eigen::Vector3d place = gone * opening.shift_m;
			place.head<2>() += tips[k] + trembling;
			frame.set(joints[k], place);
		}
		if (t_s < opening.lost_from_s || t_s >= opening.lost_to_s) {
			hmm.push(frame);
		}
		hmm.advance(t_s);
		const GestureSession::Stage now =
				hmm.session() != nullptr ? hmm.session()->stage() : GestureSession::Stage::IDLE;
		outcome.ended += now == GestureSession::Stage::ENDED && stage != now ? 1 : 0;
		stage = now;
		if (t_s > 2.1) {
			sum += std::pow(hmm.motion(MotionSource::SYNTHESISED).value_m - opening.growth_m, 2);
			++frames;
		}
	}
	outcome.off_m = std::sqrt(sum / frames);
	return outcome;
}

} // namespace

TEST_CASE("fingers that open are a zoom, also where the hand moves meanwhile") {
	for (const Eigen::Vector3d &shift_m : { Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.03, 0.02, 0.0),
				 Eigen::Vector3d(0.0, 0.0, -0.1) }) {
		CAPTURE(shift_m.transpose());
		const Outcome zoom = watch({ .shift_m = shift_m });
		CHECK(zoom.ended == 1);
		CHECK(zoom.off_m < 3e-4);
	}
}

TEST_CASE("fingers that come into one line are no zoom, though their circle grows twofold") {
	// As the zoom does.
	const auto radius = [](const Tips &tips) { return *circumradius(tips[0], tips[1], tips[2]); };
	CHECK(radius(flattened(0.06)) == test::near(radius(opened(0.06))));
	CHECK(watch({ .shape = flattened }).ended == 0);
}

TEST_CASE("fingers that move each by itself make hardly a zoom") {
	const Subject subject = draw_subject(Population::TUNE, 1);
	int zooms = 0;
	for (std::uint64_t seed = 0; seed < 60; ++seed) {
		Random random(seed);
		const TrueMotion hand = make_other_motion(
				*find_other_motion("fidgeting"), HandPosition::STABLE, subject, 10.0, random);
		GestureRecogniser hmm({ zoom_model() }, std::nullopt, MotionMode::PHASE);
		GestureSession::Stage stage = GestureSession::Stage::IDLE;
		for (int i = 0; i < 1000; ++i) {
			hmm.push(hand.hand(i / 100.0));
			const GestureSession::Stage now =
					hmm.session() != nullptr ? hmm.session()->stage() : GestureSession::Stage::IDLE;
			zooms += now == GestureSession::Stage::ENDED && stage != now ? 1 : 0;
			stage = now;
		}
	}
	CHECK(zooms <= 2); // in ten minutes: 0.2 a minute
}

TEST_CASE("fingers that open further or less far than the model knows are shown as far open, also after a "
		  "gap") {
	for (const double length : { 0.75, 1.0, 1.4 }) {
		for (const double lost_s : { 0.0, 0.1, 0.2 }) {
			CAPTURE(length);
			CAPTURE(lost_s);
			const Outcome outcome =
					watch({ .growth_m = length * GROWTH_M, .lost_from_s = 1.35, .lost_to_s = 1.35 + lost_s });
			CHECK(outcome.ended == 1);
			CHECK(outcome.off_m < 0.06 * GROWTH_M);
		}
	}
}

TEST_CASE("fingers that rest before a tracker that trembles begin hardly any zoom") {
	constexpr double LENGTH_S = 20.0;
	for (const double rate_hz : { 60.0, 120.0 }) {
		for (const double noise_m : { 0.7e-3, 1e-3, 2e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(noise_m);
			GestureRecogniser recogniser({ zoom_model() }, std::nullopt, MotionMode::PHASE);
			std::mt19937_64 random(7);
			std::normal_distribution<double> noise(0.0, noise_m);
			const Tips tips = opened(CLOSED_M);
			int frames = 0, shown = 0;
			for (; frames < LENGTH_S * rate_hz; ++frames) {
				HandFrame frame;
				frame.t_s = frames / rate_hz;
				constexpr std::array JOINTS{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
				for (std::size_t i = 0; i < JOINTS.size(); ++i) {
					frame.set(JOINTS[i],
							{ tips[i].x() + noise(random), tips[i].y() + noise(random), noise(random) });
				}
				recogniser.push(frame);
				shown += recogniser.gesture() >= 0 ? 1 : 0;
			}
			CHECK(shown < 0.06 * frames);
		}
	}
}

TEST_CASE("with the task given, fingers at rest hardly seem to set out before a tracker that trembles by 1 "
		  "mm") {
	const Task task{ { 0.016, 0.0, 0.0 }, Eigen::Vector3d::UnitX(), GROWTH_M };
	int starts = 0;
	for (std::uint64_t seed = 0; seed < 20; ++seed) {
		std::mt19937_64 random(seed);
		std::normal_distribution<double> noise(0.0, 1e-3);
		GestureRecogniser hmm({ zoom_model() }, task, MotionMode::PHASE);
		GestureSession::Stage stage = GestureSession::Stage::IDLE;
		for (int i = 0; i < 600; ++i) {
			const Tips tips = opened(0.016);
			HandFrame frame;
			frame.t_s = i / 60.0;
			const std::array joints{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
			for (std::size_t k = 0; k < 3; ++k) {
				const Eigen::Vector2d trembling{ noise(random), noise(random) };
				frame.set(joints[k],
						Eigen::Vector3d(tips[k].x() + trembling.x(), tips[k].y() + trembling.y(), 0.0));
			}
			hmm.push(frame);
			const GestureSession::Stage now =
					hmm.session() != nullptr ? hmm.session()->stage() : GestureSession::Stage::IDLE;
			starts += now == GestureSession::Stage::ACTIVE && stage != now ? 1 : 0;
			stage = now;
		}
	}
	CHECK(starts <= 3); // in 200 s; those of 0.03 of the way and more are 34
}
