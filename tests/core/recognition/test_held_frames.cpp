// Frames that a link lets through several at once are held for a moment (frame_bursts.h): what becomes of
// them depends on their stamps, and not on how often the recogniser is advanced.

#include "recognition/gesture_recogniser.h"
#include "simulation/synthetic_trial.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>

using namespace steadyhand;

namespace {

/// Let through four at once, a fifth of a millisecond apart.
Track in_bursts(const Track &track) {
	constexpr std::size_t AT_ONCE = 4;
	Track bursts = track;
	for (std::size_t i = 0; i < track.frames.size(); ++i) {
		const std::size_t within = i % AT_ONCE,
						  last = std::min(i - within + AT_ONCE, track.frames.size()) - 1;
		bursts.frames[i].t_s = track.frames[last].t_s + 2e-4 * static_cast<double>(within);
	}
	return bursts;
}

} // namespace

TEST_CASE("held frames are used in time, however seldom the recogniser is advanced") {
	SyntheticSetOptions options;
	options.subjects = 8;
	options.repetitions = 2;
	options.paces = { 1.0 };
	options.gestures = { "horizontal_drag" };
	for (SyntheticTrialRequest request : plan_synthetic_set(options)) {
		CAPTURE(request.name);
		const SyntheticTrial trial = make_synthetic_trial(request).value();
		const Task task{ trial.trial.start_m, trial.trial.axis, trial.trial.amplitude_m };
		GestureRecogniser often({ test::shared_drag_model() }, task, MotionMode::PHASE);
		GestureRecogniser seldom({ test::shared_drag_model() }, task, MotionMode::PHASE);
		int ms = 0;
		for (const HandFrame &frame : in_bursts(trial.measured).frames) {
			for (; ms < 1000.0 * frame.t_s; ++ms) {
				often.advance(ms / 1000.0);
			}
			often.push(frame);
			seldom.push(frame);
			REQUIRE(often.motion(MotionSource::SYNTHESISED).value_m ==
					seldom.motion(MotionSource::SYNTHESISED).value_m);
		}
	}
}
