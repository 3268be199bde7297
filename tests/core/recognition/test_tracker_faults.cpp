// Gestures with faults of the tracker: dropouts, freezes, jumps, drift and rounding.

#include "gesture_events.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double RATE_HZ = 100.0;

/// Checks that the gesture is recognised in `phase` mode, with a task and without one.
void check_found(const TestPath &seen, double length_s, const TestTracker &tracker) {
	CHECK_MESSAGE(watch_without_task(seen, length_s, tracker).names == ENDS, "without a task");
	CHECK_MESSAGE(watch_with_task(seen, length_s, tracker).names == ENDS, "with a task");
}

/// Drift with a standard deviation of 0.8 mm: a first-order autoregression on each axis. lasts_s: time
/// constant.
class Drift {
public:
	Drift(double lasts_s, unsigned seed) :
			kept_(std::exp(-1.0 / (RATE_HZ * lasts_s))), step_(8e-4 * std::sqrt(1.0 - kept_ * kept_), seed) {}
	/// Drift at the next frame.
	Eigen::Vector3d operator()() { return off_m_ = kept_ * off_m_ + step_(); }

private:
	double kept_;
	Tremor step_;
	Eigen::Vector3d off_m_ = Eigen::Vector3d::Zero();
};

} // namespace

TEST_CASE("a dropout of 0.3 s in mid-gesture does not abort") {
	for (const double lost_s : { 0.8, 1.0, 1.2 }) {
		CAPTURE(lost_s);
		check_found(along(X, { DRAG }), 3.0, { lost_s, lost_s + 0.3 });
	}
}

TEST_CASE("a dropout before a gesture does not make the next one lead") {
	const double again_s = 6.0;
	const TestPath path = along(X, { { 1.0, 0.7, 0.2 }, { 2.5, 0.7, -0.2 }, { again_s, 0.7, 0.2 } });
	double lead_m = 0.0;
	int count = 0;
	for (unsigned seed = 0; seed < 20; ++seed) {
		GestureRecogniser recogniser = with_task();
		Tremor tremor(1e-3, seed);
		for (int i = 0; i < 60 * 7; ++i) {
			const double t_s = i / 60.0;
			if (t_s > 0.3 && t_s < 0.45) {
				continue;
			}
			HandFrame frame;
			frame.t_s = t_s;
			frame.set(Joint::INDEX, path(t_s) + tremor());
			recogniser.push(frame);
			if (t_s > again_s && t_s < again_s + 0.7) {
				lead_m += recogniser.motion(MotionSource::SYNTHESISED).value_m - path(t_s).x();
				++count;
			}
		}
	}
	CHECK(std::abs(lead_m / count) < 0.001);
}

TEST_CASE("a dropout or a rounding tracker at the onset hides no gesture") {
	for (const double grid_m : { 0.0, 2e-3 }) {
		for (const double onset_s : { 0.6, 2.0 }) {
			for (const double duration_s : { 0.4, 0.8 }) {
				for (const double gap_s : { 0.1, 0.3 }) {
					INFO("grid ", grid_m, ", onset ", onset_s, ", duration ", duration_s, ", gap ", gap_s);
					const Drag drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = 0.2 };
					const TestPath seen = [=](double t_s) { // tremor below half of the grid
						const double tremor_m = 0.45 * grid_m * std::sin(2.0 * std::numbers::pi * 11.0 * t_s);
						return rounded(drag.x_m(t_s) * X + tremor_m * (X + Y), grid_m);
					};
					const double lost_s = onset_s - 0.05, length_s = onset_s + duration_s + 0.6;
					const TestTracker tracker{ lost_s, lost_s + gap_s, RATE_HZ, 0.0 };
					check_found(seen, length_s, tracker);
					GestureRecogniser paper = recogniser_of(models(), std::nullopt, { MotionMode::PAPER });
					CHECK(watch(paper, seen, length_s, tracker).names == ENDS);
				}
			}
		}
	}
}

// Without noise, a freeze is equal to a hand at rest.
TEST_CASE("a freeze of 0.3 s at the onset hides no gesture") {
	for (const double tremor_m : { 1e-4, 1e-3 }) {
		for (const double duration_s : { 0.4, 0.8 }) {
			for (const double share : { -0.2, 0.05, 0.2 }) {
				INFO("tremor ", tremor_m, ", duration ", duration_s, ", share ", share);
				const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s + share * duration_s;
				const TestPath seen = [=, tremor = Tremor(tremor_m, 1)](double t_s) mutable {
					return Eigen::Vector3d(drag.x_m(t_s) * X + tremor());
				};
				check_found(held(seen, from_s, from_s + 0.3), 2.4, { .rate_hz = RATE_HZ, .noise_m = 0.0 });
			}
		}
	}
}

TEST_CASE("without a task a freeze of rounded positions does not abort") {
	constexpr double FREEZE_S = 0.2, GRID_M = 2e-3, TREMOR_M = 3e-4;
	for (const double duration_s : { 0.8, 1.0 }) {
		for (const double share : { 0.1, 0.3 }) { // of the duration
			for (unsigned seed = 0; seed < 3; ++seed) {
				INFO("duration ", duration_s, ", share ", share, ", seed ", seed);
				const Drag drag{ .onset_s = 1.2, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s + share * duration_s;
				const TestPath seen = [=, tremor = Tremor(TREMOR_M, seed)](double t_s) mutable {
					return rounded(drag.x_m(t_s) * X + tremor(), GRID_M);
				};
				CHECK(watch_without_task(held(seen, from_s, from_s + FREEZE_S), 2.8,
							  { .rate_hz = RATE_HZ, .noise_m = 0.0 })
								.names == ENDS);
			}
		}
	}
}

TEST_CASE("a persistent jump before the onset does not change the gesture") {
	const Events events = watch_without_task(jumped(along(X, { DRAG }), 0.3, NEVER_S, 0.04 * X), 2.2);
	CHECK(events.names == ENDS);
	CHECK(events.last_value_m == near(0.2).epsilon(0.02));
	for (const double off_m : { 0.05, 0.15, -0.3 }) {
		CAPTURE(off_m);
		const TestPath aside = jumped(along(X, { { .onset_s = 2.0 } }), 0.0, 1.0, off_m * Y);
		CHECK(watch_with_task(aside, 4.0).names == ENDS);
	}
}

TEST_CASE("a track that begins in motion does not hide the next gesture") {
	const TestPath arriving = [](double t_s) {
		const Drag come{ .onset_s = -0.15, .duration_s = 0.3, .amplitude_m = 0.3 };
		const Drag late{ .onset_s = 1.0, .duration_s = 1.0, .amplitude_m = 0.2 };
		return Eigen::Vector3d(late.x_m(t_s), 0.0, come.x_m(t_s));
	};
	CHECK(watch_without_task(arriving, 3.0).names == ENDS);
}

TEST_CASE("without a task an undone jump keeps events and value") {
	for (const Eigen::Vector3d &off_m : { Eigen::Vector3d(-0.03, 0.0, 0.0), Eigen::Vector3d(-0.15, 0.0, 0.0),
				 Eigen::Vector3d(0.2, 0.0, 0.0), Eigen::Vector3d(0.25, 0.0, 0.1),
				 Eigen::Vector3d(0.05, 0.1, 0.0) }) {
		for (const double from_s : { 0.495, 0.594, 0.8, 1.1, 1.595, 1.8 }) {
			for (const double lasts_s : { 0.005, 0.1 }) { // 0.005: one frame
				INFO("off ", off_m.transpose(), ", from ", from_s, ", lasts ", lasts_s);
				const Events events =
						watch_without_task(jumped(along(X, { DRAG }), from_s, from_s + lasts_s, off_m), 2.2);
				CHECK(events.names == ENDS);
				CHECK(events.last_value_m == near(0.2).epsilon(0.02));
			}
		}
	}
}

TEST_CASE("an undone jump with a freeze does not shorten the gesture") {
	for (const double duration_s : { 0.6, 1.0 }) {
		for (const Eigen::Vector3d &off_m :
				{ Eigen::Vector3d(-0.25, 0.03, 0.0), Eigen::Vector3d(0.05, 0.1, 0.0) }) {
			for (const double from_share : { 0.2, 0.5 }) { // of the duration
				INFO("duration ", duration_s, ", off ", off_m.transpose(), ", from ", from_share);
				const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = 1.0 + from_share * duration_s, to_s = from_s + 0.3 * duration_s;
				const TestPath stands = held(along(X, { drag }), from_s, to_s);
				const Events events =
						watch_without_task(jumped(stands, from_s, to_s, off_m), duration_s + 1.6);
				CHECK(events.names == ENDS);
				CHECK(std::abs(events.last_value_m - 0.2) < 0.02);
			}
		}
	}
}

TEST_CASE("an outlier at the target does not move a resting hand") {
	for (const double noise_m : { 0.0, 1e-4 }) {
		for (const double off_m : { 0.16, 0.2, 0.26 }) {
			INFO("noise ", noise_m, ", off ", off_m);
			GestureRecogniser task = with_task();
			double most_m = 0.0; // from 0.1 s after the outlier on
			const TestPath path = [&](double t_s) {
				const double value_m = task.motion(MotionSource::SYNTHESISED).value_m;
				most_m = t_s > 1.1 ? std::max(most_m, std::abs(value_m)) : 0.0;
				return Eigen::Vector3d((std::abs(t_s - 1.0) < 0.5 / RATE_HZ ? off_m : 0.0) * X);
			};
			watch(task, path, 1.5, { .rate_hz = RATE_HZ, .noise_m = noise_m });
			CHECK(most_m < 5e-3);
		}
	}
}

TEST_CASE("with a task only a jump that stays aborts the gesture") {
	const TestPath reach = along(X, { { 0.6, 0.8, 0.2 } });
	for (const Eigen::Vector3d &off_m :
			{ Eigen::Vector3d(0.3 * Y), Eigen::Vector3d(1.0 * X), Eigen::Vector3d(-2.0 * X) }) {
		for (const double from_s : { 0.84, 1.16 }) {
			for (const double noise_m : { 1e-4, 1e-3 }) {
				INFO("off ", off_m.transpose(), ", from ", from_s, ", noise ", noise_m);
				CHECK(watch_with_task(jumped(reach, from_s, NEVER_S, off_m), 3.9, { .noise_m = noise_m })
								.names == ABORTS);
			}
		}
	}
	for (const Eigen::Vector3d &off_m : { Eigen::Vector3d(0.25 * Y), Eigen::Vector3d(-0.4 * Z) }) {
		for (const double from_s : { 0.84, 1.36 }) {
			for (const double lasts_s : { 0.1, 0.9 }) {
				INFO("off ", off_m.transpose(), ", from ", from_s, ", lasts ", lasts_s);
				const Events events = watch_with_task(jumped(reach, from_s, from_s + lasts_s, off_m), 3.9);
				CHECK(events.names == ENDS);
				CHECK(events.last_ended_s < std::max(1.4, from_s + lasts_s) + 0.15);
			}
		}
	}
}

TEST_CASE("drift of 0.8 mm hides no gesture of 30 mm") {
	constexpr double ONSET_S = 2.5, AMPLITUDE_M = 0.03;
	int gestures = 0, started = 0, ended = 0;
	for (const double lasts_s : { 0.03, 0.3 }) {
		for (const double duration_s : { 0.4, 1.5 }) {
			for (unsigned seed = 0; seed < 12; ++seed, ++gestures) {
				GestureRecogniser recogniser = with_task({ Eigen::Vector3d::Zero(), X, AMPLITUDE_M });
				recogniser.set_completion(0.7); // drift shifts the measured endpoint
				const Drag drag{ ONSET_S, duration_s, AMPLITUDE_M };
				const TestPath path = [=, drift = Drift(lasts_s, seed)](double t_s) mutable {
					return Eigen::Vector3d(drag.x_m(t_s) * X + drift());
				};
				const Events events = watch(
						recogniser, path, ONSET_S + duration_s + 0.8, { .rate_hz = RATE_HZ, .noise_m = 0.0 });
				started += static_cast<int>(count(events, "started"));
				ended += static_cast<int>(ends(events));
			}
		}
	}
	CHECK(started < 1.2 * gestures);
	CHECK(std::abs(ended - gestures) <= 0.02 * gestures);
}
