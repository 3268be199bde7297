#pragma once

#include "base/result.h"
#include "simulation/gesture_motion.h"
#include "simulation/subject.h"
#include "tracking/track.h"
#include "tracking/trial_set.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steadyhand {

/// A simulated trial: one row of a trial set, with its two tracks.
struct SyntheticTrial {
	Trial trial;
	Track measured;
	Track reference; ///< 240 Hz, on the same clock, without lag and drift
};

/// Request for a trial. Equal requests give equal trials to the last bit.
struct SyntheticTrialRequest {
	std::string name;         ///< Trial::trial; must be a valid file name
	std::string gesture = {}; ///< one of simulated_gestures(), or "none"
	HandPosition position = HandPosition::STABLE;
	Subject subject = {};
	std::uint64_t seed = 0;
	double duration_s = 0.0; ///< onset to end, or the whole track of "none"; 0: the person's own
	std::string sensor = {}; ///< one of sensor_profiles(); empty: leap_stable or leap_unstable, by position
	std::uint32_t earlier_rounds = 0; ///< repetitions before the gesture, each with a return
	/// Task of the trial, in place of a random one. The motion is simulated at a random task of draw_task(),
	/// and the tracks are turned and shifted to this one. Not used for "none".
	std::optional<GestureTask> place = {};
	std::string kind = {}; ///< for "none": one of other_motions(); empty: a random one
};

/// The hand rests for at least 0.5 s before start_s, and for 0.8 s after the motion's end, so that late
/// curves end in the track. Errors: an unknown gesture, sensor or kind.
[[nodiscard]] Result<SyntheticTrial> make_synthetic_trial(const SyntheticTrialRequest &request);

struct SyntheticSetOptions {
	Population population = Population::TRAIN;
	std::uint32_t subjects = 8;
	std::uint32_t repetitions = 5;          ///< per subject, gesture and position
	std::vector<std::string> gestures = {}; ///< empty: all but the worked example, and none
	std::vector<HandPosition> positions = { HandPosition::STABLE, HandPosition::UNSTABLE };
	double duration_s = 0.0;          ///< as in SyntheticTrialRequest
	std::uint32_t earlier_rounds = 0; ///< as in SyntheticTrialRequest
	/// Subject::pace of the repetitions, in turn: with { 1, 0.5 } every second one takes half the time.
	std::vector<double> paces = { 1.0 };
};

/// The requests of a set. A request does not depend on the numbers of subjects, repetitions and gestures.
[[nodiscard]] std::vector<SyntheticTrialRequest> plan_synthetic_set(const SyntheticSetOptions &options);

} // namespace steadyhand
