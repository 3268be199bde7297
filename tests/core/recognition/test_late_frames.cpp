// Frames that a busy computer delivers late and in a burst, with the stamps of their arrival.

#include "gesture_events.h"
#include "tracking/tracker_monitor.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double RATE_HZ = 90.0, LENGTH_S = 2.4;

/// Frames of a drag. Those between from_s and to_s arrive at to_s, one every spacing_s.
std::vector<HandFrame> frames_of(double from_s, double to_s, double spacing_s) {
	const TestPath path = along(X, { DRAG });
	Tremor tremor(2e-4, 3);
	std::vector<HandFrame> frames;
	int late = 0;
	for (int i = 0; i < static_cast<int>(LENGTH_S * RATE_HZ); ++i) {
		const double seen_s = i / RATE_HZ;
		HandFrame frame;
		frame.t_s = seen_s > from_s && seen_s <= to_s ? to_s + spacing_s * late++ : seen_s;
		frame.set(Joint::INDEX, path(seen_s) + tremor());
		frames.push_back(frame);
	}
	return frames;
}

struct Run {
	std::vector<double> values_m; ///< synthesised, each millisecond
	double ended_s = 0.0;
};

Run run(const std::vector<HandFrame> &frames) {
	GestureRecogniser recogniser = with_task();
	ShownChanges shown;
	Run result;
	std::size_t next = 0;
	for (int ms = 0; ms < static_cast<int>(1000.0 * LENGTH_S); ++ms) {
		const double t_s = ms / 1000.0;
		while (next < frames.size() && frames[next].t_s <= t_s) {
			recogniser.push(frames[next++]);
		}
		recogniser.advance(t_s);
		result.ended_s = shown.next(recogniser).ended ? t_s : result.ended_s;
		result.values_m.push_back(recogniser.motion(MotionSource::SYNTHESISED).value_m);
	}
	return result;
}

} // namespace

TEST_CASE("after late frames in a burst, motion and end are those of frames in time") {
	const Run in_time = run(frames_of(0.0, 0.0, 0.0));
	for (const double from_s : { 0.3, 0.75, 0.9 }) { // at rest, and in the movement from 0.6 to 1.6 s
		for (const double wait_s : { 0.04, 0.06, 0.1 }) {
			for (const double spacing_s : { 0.0, 0.5e-3, 1.5e-3 }) {
				INFO("from ", from_s, ", wait ", wait_s, ", spacing ", spacing_s);
				const Run late = run(frames_of(from_s, from_s + wait_s, spacing_s));
				double most_m = 0.0; // from 0.1 s after the burst on
				for (auto ms = static_cast<std::size_t>(1000.0 * (from_s + wait_s + 0.1));
						ms < late.values_m.size(); ++ms) {
					most_m = std::max(most_m, std::abs(late.values_m[ms] - in_time.values_m[ms]));
				}
				CHECK(most_m < 5e-3);
				// People do not notice a cue that is up to 50 ms late, but one that is 15 ms early.
				CHECK(late.ended_s > in_time.ended_s - 0.015);
				CHECK(late.ended_s < in_time.ended_s + 0.05);
			}
		}
	}
}

TEST_CASE("late frames in a burst are no jumps and no freezes, and each replaces the one before") {
	for (const double spacing_s : { 0.0, 0.5e-3, 1.5e-3, 3e-3 }) {
		CAPTURE(spacing_s);
		TrackerMonitor monitor;
		int replaced = 0;
		for (const HandFrame &frame : frames_of(0.9, 0.96, spacing_s)) {
			replaced += monitor.push(frame.t_s, frame.position(Joint::INDEX)).replaces_last ? 1 : 0;
		}
		CHECK(monitor.faults().jumps + monitor.faults().freezes == 0);
		CHECK(replaced == 4); // of the five late frames, the first replaces none
	}
}

TEST_CASE("after a dropout between the first two frames, no frame replaces another") {
	TrackerMonitor monitor;
	Tremor tremor(2e-4, 3);
	const TestPath path = along(X, { DRAG });
	for (int i = 0; i < static_cast<int>(LENGTH_S * RATE_HZ); ++i) {
		if (const double t_s = i / RATE_HZ; i == 0 || t_s > 0.5) {
			CHECK(!monitor.push(t_s, path(t_s) + tremor()).replaces_last);
		}
	}
}

TEST_CASE("after a gap and old frames, the frames of a tracker that catches up are used") {
	constexpr double CAMERA_HZ = 73.0, GAP_S = 0.048, AGE_S = 0.047;
	for (const double share : { 0.35, 0.45, 0.5 }) { // of the movement
		for (const int old_frames : { 1, 2 }) {
			INFO("gap at ", share, ", old frames ", old_frames);
			const TestPath path = along(X, { { 1.0, 0.65, 0.3 } });
			const double gap_from_s = 1.0 + 0.65 * share;
			Tremor tremor(4e-4, 3);
			TrackerMonitor monitor;
			int old = 0, rejected = 0;
			for (int i = 0; i < static_cast<int>(LENGTH_S * CAMERA_HZ); ++i) {
				const double t_s = i / CAMERA_HZ;
				if (t_s <= gap_from_s || t_s >= gap_from_s + GAP_S) {
					const bool is_old = t_s > gap_from_s && old++ < old_frames;
					const Measurement seen = monitor.push(t_s, path(t_s - (is_old ? AGE_S : 0.0)) + tremor());
					rejected += seen.status == MeasurementStatus::OUTLIER ? 1 : 0;
				}
			}
			CHECK(rejected == 0);
		}
	}
}

TEST_CASE("a hand at rest that is lost stays at rest") {
	for (const double lost_s : { 0.2, 0.5, 0.9 }) {
		CAPTURE(lost_s);
		GestureRecogniser recogniser = with_task();
		double most_m = 0.0;
		const TestPath resting = [&](double /*t_s*/) {
			most_m = std::max(most_m, std::abs(recogniser.motion(MotionSource::SYNTHESISED).value_m));
			return Eigen::Vector3d(0.0, 0.0, 0.0);
		};
		watch(recogniser, resting, 3.0, { 1.5, 1.5 + lost_s, RATE_HZ, 4e-4 });
		CHECK(most_m < 0.01); // 5 % of the amplitude
	}
}

TEST_CASE("an advance before the first frame changes nothing, also at negative times") {
	constexpr double EARLIER_S = 50.0;
	GestureRecogniser plain = with_task(), early = with_task();
	early.advance(-EARLIER_S - 20.0);
	bool has_ended = false;
	for (int i = 0; i < 250; ++i) {
		const double t_s = 0.01 * i;
		HandFrame frame;
		frame.t_s = t_s - EARLIER_S;
		frame.set(Joint::INDEX, DRAG.x_m(t_s) * X);
		for (GestureRecogniser *one : { &plain, &early }) {
			one->push(frame);
		}
		CHECK(early.motion(MotionSource::SYNTHESISED).value_m ==
				plain.motion(MotionSource::SYNTHESISED).value_m);
		has_ended = has_ended || stage(early) == GestureSession::Stage::ENDED;
	}
	CHECK(has_ended);
}
