// Without a task, opening fingers are a zoom. The index finger's movement in a zoom is no drag.

#include "gesture/circumcircle.h"
#include "gesture_events.h"
#include "near.h"
#include "signal/minimum_jerk.h"
#include "simulation/other_motion.h"
#include "simulation/subject.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double CLOSED_M = 0.03, GROWTH_M = 0.03; ///< radius
using Tips = std::array<Eigen::Vector2d, 3>;

/// Thumb and two fingers, opened to this radius. The index finger moves straight up.
Tips opened(double radius_m) {
	Tips tips;
	constexpr std::array ANGLES_RAD{ 3.6, 0.5 * std::numbers::pi, 0.4 };
	for (std::size_t i = 0; i < 3; ++i) {
		tips[i] = radius_m * Eigen::Vector2d(std::cos(ANGLES_RAD[i]), std::sin(ANGLES_RAD[i]));
	}
	return tips;
}

HandFrame frame_of(double t_s, const Tips &tips, Tremor &r_tremor,
		const Eigen::Vector3d &shift_m = Eigen::Vector3d::Zero()) {
	HandFrame frame;
	frame.t_s = t_s;
	constexpr std::array JOINTS{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
	for (std::size_t i = 0; i < 3; ++i) {
		frame.set(JOINTS[i], Eigen::Vector3d(tips[i].x(), tips[i].y(), 0.0) + shift_m + r_tremor());
	}
	return frame;
}

GestureRecogniser zooms(double closed_m = CLOSED_M, const std::optional<Task> &task = std::nullopt) {
	return recogniser_of({ zoom_model(closed_m, GROWTH_M) }, task);
}

struct Opening {
	double growth_m = GROWTH_M;
	Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
	double lost_s = 0.0; ///< length of a dropout at 1.35 s
};

struct Outcome {
	int ended = 0;
	double off_m = 0.0; ///< root mean square error of the growth, from 0.2 s after the end on
};

/// The fingers open from 1 to 1.9 s, then rest.
Outcome watch_fingers(const Opening &opening) {
	GestureRecogniser recogniser = zooms();
	Tremor tremor(2e-4, 3);
	ShownChanges shown;
	int ended = 0;
	double sum = 0.0;
	int frames = 0;
	for (int i = 0; i < 260; ++i) {
		const double t_s = i / 100.0, gone = minimum_jerk((t_s - 1.0) / 0.9).value;
		if (t_s < 1.35 || t_s >= 1.35 + opening.lost_s) {
			const Tips tips = opened(CLOSED_M + gone * opening.growth_m);
			recogniser.push(frame_of(t_s, tips, tremor, gone * opening.shift_m));
		}
		recogniser.advance(t_s);
		ended += shown.next(recogniser).ended ? 1 : 0;
		if (t_s > 2.1) {
			sum += std::pow(recogniser.motion(MotionSource::SYNTHESISED).value_m - opening.growth_m, 2);
			++frames;
		}
	}
	return { ended, std::sqrt(sum / frames) };
}

} // namespace

TEST_CASE("opening fingers are one zoom of their own growth") {
	struct Row {
		Opening opening;
		double tolerance_m;
	};
	for (const auto &[opening, tolerance_m] : {
				 Row{ {}, 3e-4 },
				 { { .shift_m = { 0.03, 0.02, 0.0 } }, 3e-4 },
				 { { .shift_m = { 0.0, 0.0, -0.1 } }, 3e-4 },
				 { { .growth_m = 0.75 * GROWTH_M, .lost_s = 0.2 }, 0.06 * GROWTH_M },
				 { { .growth_m = 1.4 * GROWTH_M }, 0.06 * GROWTH_M },
				 { { .growth_m = 1.4 * GROWTH_M, .lost_s = 0.2 }, 0.06 * GROWTH_M },
		 }) {
		INFO("growth ", opening.growth_m, ", lost ", opening.lost_s, ", shift ", opening.shift_m.transpose());
		const Outcome zoom = watch_fingers(opening);
		CHECK(zoom.ended == 1);
		CHECK(zoom.off_m < tolerance_m);
	}
}

TEST_CASE("a zoom that stops half-way aborts, also with 1 mm noise") {
	for (const double noise_m : { 1e-4, 1e-3 }) {
		CAPTURE(noise_m);
		GestureRecogniser recogniser = zooms();
		Tremor tremor(noise_m, 3);
		ShownChanges shown;
		int started = 0;
		for (int i = 0; i < 500; ++i) {
			const double t_s = i / 100.0, gone = 0.5 * minimum_jerk((t_s - 1.0) / 0.5).value;
			recogniser.push(frame_of(t_s, opened(CLOSED_M + gone * GROWTH_M), tremor));
			started += shown.next(recogniser).started ? 1 : 0;
		}
		CHECK(started > 0);
		CHECK(recogniser.gesture() < 0);
	}
}

TEST_CASE("fidgeting fingers end less than 1 zoom per minute" * doctest::test_suite("figures")) {
	const Subject subject = draw_subject(Population::TUNE, 1);
	int ended = 0;
	for (std::uint64_t seed = 0; seed < 60; ++seed) {
		Random random(seed);
		const TrueMotion hand = make_other_motion(
				*find_other_motion("fidgeting"), HandPosition::STABLE, subject, 10.0, random);
		GestureRecogniser recogniser = zooms();
		ShownChanges shown;
		for (int i = 0; i < 1000; ++i) {
			recogniser.push(hand.hand(i / 100.0));
			ended += shown.next(recogniser).ended ? 1 : 0;
		}
	}
	CHECK(ended < 10); // in ten minutes
}

TEST_CASE("with a task noise of 1 mm hardly starts a zoom") {
	int started = 0;
	for (unsigned seed = 0; seed < 20; ++seed) {
		Tremor tremor(1e-3, seed);
		GestureRecogniser recogniser = zooms(CLOSED_M, Task{ { 0.016, 0.0, 0.0 }, X, GROWTH_M });
		ShownChanges shown;
		for (int i = 0; i < 600; ++i) {
			recogniser.push(frame_of(i / 60.0, opened(0.016), tremor));
			started += shown.next(recogniser).started ? 1 : 0;
		}
	}
	CHECK(started <= 3); // in 200 s
}

TEST_CASE("repeated zooms end no drag; a drag after them ends") {
	constexpr double OUT_S = 0.55, REST_S = 0.1, BACK_S = 1.0, PERIOD_S = 1.85, SMALL_M = 0.016;
	constexpr int STROKES = 4;
	std::vector<Drag> radius_m; // minimum jerk, as of a drag
	for (int i = 0; i < STROKES; ++i) {
		radius_m.push_back({ 1.2 + i * PERIOD_S, OUT_S, GROWTH_M });
		radius_m.push_back({ 1.2 + i * PERIOD_S + OUT_S + REST_S, BACK_S, -GROWTH_M });
	}
	const Drag drag{ 1.8 + STROKES * PERIOD_S, 0.6, 0.2 };
	for (unsigned seed = 0; seed < 20; ++seed) {
		CAPTURE(seed);
		Tremor tremor(2e-4, seed);
		GestureRecogniser recogniser =
				recogniser_of({ zoom_model(SMALL_M, GROWTH_M), models()[1] }, std::nullopt);
		ShownChanges shown;
		std::array<int, 2> ended{};
		for (int i = 0; i < 60.0 * (drag.onset_s + 1.2); ++i) {
			const double t_s = i / 60.0;
			recogniser.push(frame_of(t_s, opened(SMALL_M + x_m(radius_m, t_s)), tremor, drag.x_m(t_s) * Y));
			if (shown.next(recogniser).ended) {
				++ended.at(static_cast<std::size_t>(recogniser.gesture()));
			}
			CHECK((t_s > drag.onset_s || ended[1] == 0));
		}
		CHECK(ended == std::array{ STROKES, 1 });
	}
}
