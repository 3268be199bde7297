// Jumps, drift and rounding of a tracker during one gesture.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double NEVER_S = 1e9;
constexpr double RATE_HZ = 100.0;

constexpr Drag REACH{ .onset_s = 0.6, .duration_s = 0.8, .amplitude_m = 0.2 };
constexpr double END_S = REACH.onset_s + REACH.duration_s;

/// Events with a task and a jump by off_m from from_s to to_s.
Events jumping(const Eigen::Vector3d &off_m, double from_s, double to_s, double noise_m) {
	GestureRecogniser recogniser({ models()[0] }, Task{}, MotionMode::PHASE);
	const TestPath path = [=](double t_s) {
		return Eigen::Vector3d(REACH.x_m(t_s) * X + (t_s >= from_s && t_s < to_s ? 1.0 : 0.0) * off_m);
	};
	return watch(recogniser, path, END_S + 2.5, NEVER_S, NEVER_S, 110.0, noise_m);
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

TEST_CASE("an outlier at the target does not move a resting hand") {
	constexpr double OUTLIER_S = 1.0, SETTLED_S = 0.1;
	for (const double noise_m : { 0.0, 1e-4 }) {
		for (const double share : { 0.8, 1.0, 1.3 }) {
			INFO("noise ", noise_m, ", share ", share);
			GestureRecogniser task({ models()[0] }, Task{}, MotionMode::PHASE);
			double most_m = 0.0;
			const TestPath path = [&](double t_s) {
				const double value_m = task.motion(MotionSource::SYNTHESISED).value_m;
				most_m = t_s > OUTLIER_S + SETTLED_S ? std::max(most_m, std::abs(value_m)) : 0.0;
				const bool is_outlier = std::abs(t_s - OUTLIER_S) < 0.5 / RATE_HZ;
				return Eigen::Vector3d((is_outlier ? share * Task{}.amplitude_m : 0.0) * X);
			};
			watch(task, path, 1.5, NEVER_S, NEVER_S, RATE_HZ, noise_m);
			CHECK(most_m < 5e-3);
		}
	}
}

TEST_CASE("with a task a jump that stays aborts the gesture") {
	for (const Eigen::Vector3d &off_m :
			{ Eigen::Vector3d(0.3 * Y), Eigen::Vector3d(1.0 * X), Eigen::Vector3d(-2.0 * X) }) {
		for (const double share : { 0.3, 0.7 }) { // of its duration
			for (const double noise_m : { 1e-4, 1e-3 }) {
				INFO("off m ", off_m.transpose(), ", share ", share, ", noise ", noise_m);
				CHECK(jumping(off_m, REACH.onset_s + share * REACH.duration_s, NEVER_S, noise_m).names ==
						std::vector<std::string>{ "started sideways", "aborted sideways" });
			}
		}
	}
}

TEST_CASE("with a task a jump undone within a second does not abort") {
	for (const Eigen::Vector3d &off_m : { Eigen::Vector3d(0.25 * Y), Eigen::Vector3d(-0.4 * Z) }) {
		for (const double share : { 0.3, 0.95 }) { // of its duration
			for (const double lasts_s : { 0.1, 0.9 }) {
				INFO("off m ", off_m.transpose(), ", share ", share, ", lasts ", lasts_s);
				const double from_s = REACH.onset_s + share * REACH.duration_s;
				const Events events = jumping(off_m, from_s, from_s + lasts_s, 1e-4);
				CHECK(events.names == times(1, "sideways"));
				CHECK(events.last_ended_s < std::max(END_S, from_s + lasts_s) + 0.15);
			}
		}
	}
}

TEST_CASE("without a task a freeze of rounded positions does not abort") {
	constexpr double FREEZE_S = 0.2, GRID_M = 2e-3, TREMOR_M = 3e-4;
	for (const double duration_s : { 0.4, 0.8 }) {
		for (const double share : { 0.1, 0.3 }) { // of the duration
			for (unsigned seed = 0; seed < 3; ++seed) {
				INFO("duration ", duration_s, ", share ", share, ", seed ", seed);
				const Drag drag{ .onset_s = 1.2, .duration_s = duration_s, .amplitude_m = 0.2 };
				const double from_s = drag.onset_s + share * duration_s;
				Tremor tremor(TREMOR_M, seed);
				const TestPath seen = [&](double t_s) {
					return rounded(drag.x_m(t_s) * X + tremor(), GRID_M);
				};
				const TestPath path = held(seen, from_s, from_s + FREEZE_S);
				GestureRecogniser recogniser(models(), std::nullopt, MotionMode::PHASE);
				CHECK(watch(recogniser, path, 2.8, NEVER_S, NEVER_S, RATE_HZ, 0.0).names ==
						times(1, "sideways"));
			}
		}
	}
}

TEST_CASE("drift of 0.8 mm hides no gesture of 30 mm") {
	constexpr double ONSET_S = 2.5, AMPLITUDE_M = 0.03;
	Task task;
	task.amplitude_m = AMPLITUDE_M;
	int gestures = 0, started = 0, ended = 0;
	for (const double lasts_s : { 0.03, 0.3 }) {
		for (const double duration_s : { 0.4, 1.5 }) {
			for (unsigned seed = 0; seed < 12; ++seed, ++gestures) {
				INFO("lasts ", lasts_s, ", duration ", duration_s, ", seed ", seed);
				const Drag drag{ ONSET_S, duration_s, AMPLITUDE_M };
				GestureRecogniser recogniser({ models()[0] }, task, MotionMode::PHASE);
				recogniser.set_completion(0.7); // drift shifts the measured endpoint
				Drift drift(lasts_s, seed);
				const TestPath path = [&](double t_s) {
					return Eigen::Vector3d(drag.x_m(t_s) * X + drift());
				};
				const double length_s = ONSET_S + duration_s + 0.8;
				const Events events = watch(recogniser, path, length_s, NEVER_S, NEVER_S, RATE_HZ, 0.0);
				started += static_cast<int>(count(events, "started"));
				ended += static_cast<int>(ends(events));
			}
		}
	}
	CHECK(started < 1.2 * gestures);
	CHECK(std::abs(ended - gestures) <= 0.02 * gestures);
}
