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

/// One row of a trial set with its two tracks: what a trial folder holds, made up.
struct SyntheticTrial {
	Trial trial;
	Track measured;
	Track reference; ///< 240 Hz, from the same clock, without lag or drift
};

/// What to make. Equal requests give equal trials, to the last bit.
struct SyntheticTrialRequest {
	std::string name;         ///< Trial::trial; must be fit for a file
	std::string gesture = {}; ///< one of simulated_gestures(), or "none"
	HandPosition position = HandPosition::STABLE;
	Subject subject = {};
	std::uint64_t seed = 0;
	double duration_s = 0.0; ///< onset to end, for none the whole track; 0: as the person does it
	std::string sensor = {}; ///< one of sensor_profiles(); empty: Leap, stable or unstable as the position is
	std::uint32_t earlier_rounds = 0; ///< the hand makes the gesture so many times before, and comes back
	/// Where the scene has the task, in place of where a sensor would see it. The hand moves as it would
	/// there, and the whole track is turned and shifted; unused for none.
	std::optional<GestureTask> place = {};
	std::string kind = {}; ///< for none, one of other_motions(); empty: any
};

/// The hand rests for at least 0.5 s before start_s and 0.8 s after the motion's end, so that late curves are
/// seen ending. Errors: a name of gesture, sensor or kind that is in no table.
[[nodiscard]] Result<SyntheticTrial> make_synthetic_trial(const SyntheticTrialRequest &request);

struct SyntheticSetOptions {
	Population population = Population::TRAIN;
	std::uint32_t subjects = 8;
	std::uint32_t repetitions = 5;          ///< of each gesture at each position by each subject
	std::vector<std::string> gestures = {}; ///< empty: all but the worked example, and none
	std::vector<HandPosition> positions = { HandPosition::STABLE, HandPosition::UNSTABLE };
	double duration_s = 0.0;          ///< as in SyntheticTrialRequest
	std::uint32_t earlier_rounds = 0; ///< the same
	/// Subject::pace of the repetitions, in turn: { 1, 0.5 } asks for every other one in half the time.
	std::vector<double> paces = { 1.0 };
};

/// A whole set, to be made one by one. Each trial depends on its own place alone: more subjects, repetitions
/// or gestures leave it as it was.
[[nodiscard]] std::vector<SyntheticTrialRequest> plan_synthetic_set(const SyntheticSetOptions &options);

} // namespace steadyhand
