// Without a task, the index finger's movement in a zoom is no drag.

#include "gesture_events.h"
#include "signal/minimum_jerk.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double CLOSED_M = 0.016, GROWTH_M = 0.03;
constexpr double OPENS_S = 1.2; ///< onset of the first zoom

/// Thumb and two fingers. The index finger moves straight up.
HandFrame fingers(double t_s, double radius_m, Tremor &r_tremor) {
	constexpr std::array JOINTS{ Joint::THUMB, Joint::INDEX, Joint::MIDDLE };
	constexpr std::array ANGLES_RAD{ 3.6, 0.5 * std::numbers::pi, 0.4 };
	HandFrame frame;
	frame.t_s = t_s;
	for (std::size_t i = 0; i < JOINTS.size(); ++i) {
		const Eigen::Vector3d tip(std::cos(ANGLES_RAD[i]), std::sin(ANGLES_RAD[i]), 0.0);
		frame.set(JOINTS[i], radius_m * tip + r_tremor());
	}
	return frame;
}

struct Shown {
	int ended = 0;       ///< zooms that ended
	int drags = 0;       ///< drags that ended
	int drag_frames = 0; ///< frames with an active or ended drag
};

/// frame: f(t_s).
template <class Function> Shown shown(Function frame, double rate_hz, double length_s) {
	GestureRecogniser recogniser(
			{ zoom_model(CLOSED_M, GROWTH_M), models()[1] }, std::nullopt, MotionMode::PHASE);
	Shown shown;
	int ended_before = -1;
	for (int i = 0; i < rate_hz * length_s; ++i) {
		recogniser.push(frame(i / rate_hz));
		const bool has_ended =
				recogniser.gesture() >= 0 && recogniser.session()->stage() == GestureSession::Stage::ENDED;
		const int ended = has_ended ? recogniser.gesture() : -1;
		shown.ended += ended == 0 && ended_before != 0 ? 1 : 0;
		shown.drags += ended == 1 && ended_before != 1 ? 1 : 0;
		shown.drag_frames += recogniser.gesture() == 1 ? 1 : 0;
		ended_before = ended;
	}
	return shown;
}

} // namespace

TEST_CASE("a drag after a zoom is shown as a drag") {
	Tremor tremor(2e-4, 4);
	const test::Drag drag{ .onset_s = 2.6, .duration_s = 0.6, .amplitude_m = 0.2 };
	const auto frame = [&](double t_s) {
		HandFrame seen =
				fingers(t_s, CLOSED_M + GROWTH_M * minimum_jerk((t_s - OPENS_S) / 0.6).value, tremor);
		for (const Joint joint : { Joint::THUMB, Joint::INDEX, Joint::MIDDLE }) {
			seen.set(joint, seen.position(joint) + drag.x_m(t_s) * Y);
		}
		return seen;
	};
	const Shown both = shown(frame, 110.0, 4.0);
	CHECK(both.ended == 1);
	CHECK(both.drag_frames > 100);
}

TEST_CASE("repeated zooms with 1 mm noise end no drag") {
	constexpr double OUT_S = 0.55, REST_S = 0.1, BACK_S = 1.0, PERIOD_S = 1.75;
	constexpr int STROKES = 4;
	const auto radius_m = [](double t_s) {
		double opened = 0.0;
		for (int stroke = 0; stroke < STROKES; ++stroke) {
			const double since_s = t_s - OPENS_S - stroke * PERIOD_S;
			opened += minimum_jerk(since_s / OUT_S).value -
					minimum_jerk((since_s - OUT_S - REST_S) / BACK_S).value;
		}
		return CLOSED_M + GROWTH_M * opened;
	};
	for (unsigned seed = 0; seed < 20; ++seed) {
		CAPTURE(seed);
		Tremor tremor(1e-3, seed);
		const auto frame = [&](double t_s) { return fingers(t_s, radius_m(t_s), tremor); };
		const Shown zooms = shown(frame, 60.0, OPENS_S + STROKES * PERIOD_S);
		CHECK(zooms.ended == STROKES);
		CHECK(zooms.drags == 0);
	}
}
