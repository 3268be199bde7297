#pragma once

#include "base/parameters.h"

#include <numbers>
#include <utility>
#include <vector>

namespace steadyhand::bench {

/// A mechanism, and values of parameters that switch it off.
struct Mechanism {
	const char *name;
	std::vector<std::pair<double *, double>> off;
	/// The mechanism affects recognition only: the motion with a task does not depend on it.
	bool is_of_events = false;
};

namespace ablation {

using namespace parameters;
using namespace parameters::sessions;
namespace t = parameters::tracker;

constexpr double NEVER = 1e9, NONE = 1e-9;

} // namespace ablation

inline std::vector<Mechanism> mechanisms() {
	using namespace ablation;
	return {
		{ "tracker mode LAGGING", { { &LAGGING_SHARE, 0.0 } } },
		{ "faults are evidence of a lag",
				{ { &LOG_FAULTS, 0.0 }, { &LOG_JUMPS, 0.0 }, { &LOG_FAULTS_PER_S, 0.0 },
						{ &FAULTS_PER_S, 0.0 } } },
		{ "a jump is evidence of a lag", { { &LOG_JUMPS, NONE } } },
		{ "a longer fault is more evidence", { { &LOG_FAULTS_PER_S, 0.0 } } },
		{ "time without faults is evidence of none", { { &FAULTS_PER_S, 0.0 } } },
		{ "further latency after a fault", { { &FAULTY_LATENCY_S, 0.0 } } },
		{ "lag builds up", { { &LAG_SETTLING_S, 0.0 } } },
		{ "share of the minimum-jerk curve", { { &SHAPE_MEAN, 0.0 }, { &SHAPE_SPREAD, NONE } } },
		{ "unknown endpoint", { { &GAIN_SPREAD, NONE } } },
		{ "change of pace", { { &PACE_WALK, 0.0 } } },
		{ "hand deviates from the curve", { { &DEVIATION, 1e-3 } } },
		{ "errors of close frames are alike", { { &ALIKE_S, 0.0 } } },
		{ "outliers that TrackerMonitor misses", { { &OUTLIERS, NONE } } },
		{ "hand mode FREE", { { &GESTURE_TO_FREE_PER_S, 0.0 }, { &HOLD_TO_FREE_PER_S, 0.0 } } },
		{ "hold within a gesture", { { &GESTURE_TO_HOLD_PER_S, 0.0 } } },
		{ "births only near the start, and unseen ones beyond it", { { &START_SPREAD, NEVER } } },
		{ "early phases are not put out", { { &VISIBLE_PHASE, 0.0 } } },

		{ "TrackerMonitor: jumps and freezes", { { &t::FAULTS_PER_S, 1e-300 } } },
		{ "TrackerMonitor: dropouts", { { &t::DROPOUT_PERIODS, NEVER } } },
		{ "TrackerMonitor: catch-up is no displacement", { { &t::STOOD, 0.0 } } },
		{ "TrackerMonitor: late frames", { { &t::MOST_BEHIND_S, 0.0 } } },

		{ "with a task: evidence of the movement", { { &LOG_PRIOR_TASK, 1e3 } } },
		{ "with a task: direction", { { &TASK_DIRECTION, std::numbers::sqrt2 } } },
		{ "with a task: bow", { { &BOW, 0.55 } } },
		{ "with a task: place of the onset", { { &START, 1.0 } } },
		{ "with a task: evidence of early ends", { { &STOP_LOG_ODDS, -NEVER } } },
		{ "with a task: probability of a start", { { &START_PROBABILITY, 0.0 } } },
		{ "with a task: drift delays the start", { { &START_DRIFTS, 0.0 } } },
		{ "with a task: halfway starts at any probability", { { &HALFWAY, NEVER } } },
		{ "with a task: gestures that enter the view", { { &REST_UNSEEN, NEVER } } },

		{ "without a task: early starts", { { &START_POSTERIOR, END_POSTERIOR } }, true },
		{ "without a task: lower limit of an abort", { { &ABORT_POSTERIOR, START_POSTERIOR } }, true },
		{ "without a task: least reach of a start", { { &SHORTEST, 0.0 } }, true },

		{ "several gestures: margin of a change", { { &SWITCH_MARGIN, 0.0 } }, true },
	};
}

} // namespace steadyhand::bench
