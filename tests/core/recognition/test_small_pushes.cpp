// With a task, hands that do a little of a gesture, or something beside it, and go back.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// As long as the taps of people are: 0.35 s.
std::shared_ptr<const GestureModel> quick() {
	GestureModel model = drag_model();
	const double faster = 0.35 / model.duration_mean_s;
	model.duration_mean_s *= faster;
	model.duration_deviation_s *= faster;
	return std::make_shared<const GestureModel>(std::move(model));
}

} // namespace

TEST_CASE(
		"a hand that is seen to stop before half of the way has not come to the end, after whatever fault") {
	const std::shared_ptr<const GestureModel> model = quick();
	for (const double to : { 0.2, 0.3, 0.4, 0.45 }) {
		for (const double takes_s : { 0.15, 0.2, 0.25 }) {
			const Drag there{ .onset_s = 0.8, .duration_s = takes_s, .amplitude_m = 0.2 * to },
					back{ .onset_s = 1.8, .duration_s = takes_s, .amplitude_m = -0.2 * to };
			// One that stood to the last bit would be a tracker that repeats itself.
			const Way way = [=](double t_s) {
				const Eigen::Vector3d tremor(
						std::sin(61.0 * t_s), std::sin(47.0 * t_s), std::cos(53.0 * t_s));
				return Eigen::Vector3d(x_m({ there, back }, t_s) * X + 2e-4 * tremor);
			};
			for (const double lost : { 0.3, 0.5, 0.7, 0.9 }) { // of its time
				for (const double lasts_s : { 0.06, 0.1, 0.15 }) {
					CAPTURE(to);
					CAPTURE(takes_s);
					CAPTURE(lost);
					CAPTURE(lasts_s);
					const double from_s = there.onset_s + lost * takes_s, to_s = from_s + lasts_s;
					GestureRecogniser gap({ model }, Task{}, MotionMode::PHASE),
							freeze({ model }, Task{}, MotionMode::PHASE);
					CHECK(none_ends(watch(gap, way, 3.0, from_s, to_s)));
					CHECK(none_ends(watch(freeze, held(way, from_s, to_s), 3.0, 1e9, 1e9, 110.0, 0.0)));
				}
			}
		}
	}
}

TEST_CASE("a twitch that goes rather across a task's way than along it begins nothing there") {
	for (const double degrees : { 0.0, 30.0, 60.0, 75.0 }) {
		const double angle_rad = degrees * std::numbers::pi / 180.0;
		const Eigen::Vector3d direction = std::cos(angle_rad) * X + std::sin(angle_rad) * Y;
		for (const double far_m : { 0.04, 0.08, 0.12 }) {
			for (const double takes_s : { 0.25, 0.45 }) {
				CAPTURE(degrees);
				CAPTURE(far_m);
				CAPTURE(takes_s);
				const Drag there{ .onset_s = 1.0, .duration_s = takes_s, .amplitude_m = far_m },
						back{ .onset_s = 1.0 + takes_s, .duration_s = takes_s, .amplitude_m = -far_m };
				const Events events = in_a_task(along(direction, { there, back }), 3.5);
				CHECK(none_ends(events));
				CHECK(events.said.empty() == (degrees > 50.0));
			}
		}
	}
}
