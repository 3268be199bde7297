// The own acceleration: acceleration of the hand, without corrections at new frames.

#include "gesture_events.h"
#include "haptics/effect.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

namespace {

/// Acceleration of the drag in closed form, m/s^2.
double acceleration_m_s2(const test::Drag &drag, double t_s) {
	const double s = (t_s - drag.onset_s) / drag.duration_s;
	const double scale = drag.amplitude_m / (drag.duration_s * drag.duration_s);
	return s <= 0.0 || s >= 1.0 ? 0.0 : scale * s * (60.0 + s * (-180.0 + 120.0 * s));
}

double own_m_s2(const GestureRecogniser &recogniser) {
	const Motion motion = recogniser.motion(MotionSource::SYNTHESISED);
	return motion.acceleration_m_s2 - motion.correction_m_s2;
}

} // namespace

TEST_CASE("the own acceleration follows the hand at noise of 0.5 mm") {
	test::Tremor tremor(0.0005, 5);
	double truth_square = 0.0, off_square = 0.0;
	for (const double duration_s : { 0.6, 0.9, 1.2 }) {
		const test::Drag drag{ .onset_s = 0.5, .duration_s = duration_s, .amplitude_m = 0.2 };
		Track track = test::drag_track(drag, 110.0, 2.2);
		GestureRecogniser recogniser({ test::shared_drag_model() }, Task{}, MotionMode::PHASE);
		int ms = 0;
		for (HandFrame &frame : track.frames) {
			frame.set(Joint::INDEX, frame.position(Joint::INDEX) + tremor().x() * test::X);
			for (; 0.001 * ms < frame.t_s; ++ms) {
				recogniser.advance(0.001 * ms);
				const double truth = acceleration_m_s2(drag, 0.001 * ms);
				truth_square += truth * truth;
				off_square += std::pow(own_m_s2(recogniser) - truth, 2);
			}
			recogniser.advance(frame.t_s);
			const double before = own_m_s2(recogniser);
			recogniser.push(frame);
			CAPTURE(frame.t_s);
			REQUIRE((frame.t_s == 0.0 || std::abs(own_m_s2(recogniser) - before) < 1e-9));
		}
	}
	CHECK(std::sqrt(off_square / truth_square) < 0.7);
}

TEST_CASE("an effect uses the own acceleration, linear between knots") {
	const test::Movement movement{ 0.35 };
	MotionSnapshot snapshot = movement.snapshot(0.05);
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		snapshot.knots[i].correction = 90.0 * std::cos(2.0 * static_cast<double>(i));
	}
	MotionCurve curve;
	curve.set(snapshot);
	Effect effect;
	effect.drive = Drive::ACCELERATION;
	effect.full_scale = 1000.0;
	for (int i = 0; i < 270; ++i) {
		const double t_s = 0.05 + 0.00037 * i;
		const auto knot = static_cast<std::size_t>((t_s - 0.05) / 0.01);
		const auto own_at = [&](std::size_t k) {
			return snapshot.knots[k].acceleration - snapshot.knots[k].correction;
		};
		const double slope = (own_at(knot + 1) - own_at(knot)) / 0.01;
		const double own = own_at(knot) + slope * (t_s - 0.05 - 0.01 * static_cast<double>(knot));
		const MotionPoint truth = movement.at(t_s);
		for (const MotionPoint &made : { snapshot.at(t_s), curve.at(t_s) }) {
			REQUIRE(std::abs(made.position - truth.position) < 1e-12);
			REQUIRE(std::abs(made.acceleration - truth.acceleration) < 1e-7);
			REQUIRE(std::abs(made.own_acceleration() - own) < 1e-7);
			const LevelPoint level = level_of(effect, made, test::AMPLITUDE_M);
			REQUIRE(level.value == test::near(test::AMPLITUDE_M * std::abs(own) / 1000.0).epsilon(1e-6));
			const double sign = own < 0.0 ? -1.0 : 1.0;
			REQUIRE(level.slope == test::near(sign * test::AMPLITUDE_M * slope / 1000.0).epsilon(1e-6));
		}
	}
	for (const double t_s : { snapshot.time_s, snapshot.end_s() }) {
		CHECK(snapshot.at(t_s + 1e-9).own_acceleration() ==
				test::near(snapshot.at(t_s - 1e-9).own_acceleration()).epsilon(1e-5));
	}
}
