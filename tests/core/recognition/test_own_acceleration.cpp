// The own acceleration: acceleration of the hand, without corrections at new frames.

#include "gesture_events.h"

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
