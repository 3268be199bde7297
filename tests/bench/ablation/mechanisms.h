#pragma once

#include "base/parameters.h"

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
namespace s = parameters::strokes;
namespace r = parameters::sessions;
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
		{ "births only near the start", { { &START_SPREAD, NEVER } } },
		{ "early phases are not put out", { { &VISIBLE_PHASE, 0.0 } } },

		{ "TrackerMonitor: jumps and freezes", { { &t::FAULTS_PER_S, 1e-300 } } },
		{ "TrackerMonitor: dropouts", { { &t::DROPOUT_PERIODS, NEVER } } },
		{ "TrackerMonitor: catch-up is no displacement", { { &t::STOOD, 0.0 } } },
		{ "TrackerMonitor: late frames", { { &t::MOST_BEHIND_S, 0.0 } } },

		{ "with a task: strokes decide", { { &s::LOG_PRIOR_TASK, 1e3 } } },
		{ "with a task: strokes decide early ends", { { &r::STOP_LOG_ODDS, -NEVER } } },
		{ "with a task: probability of a start", { { &r::START_PROBABILITY, 0.0 } } },
		{ "with a task: drift delays the start", { { &r::START_DRIFTS, 0.0 } } },
		{ "with a task: halfway starts at any probability", { { &r::HALFWAY, NEVER } } },
		{ "with a task: gestures that enter the view", { { &s::UNSEEN_PART, 0.0 } } },

		{ "strokes: direction", { { &s::DIRECTION, NEVER } }, true },
		{ "strokes: later turn", { { &s::LATER_TURN, 0.0 } }, true },
		{ "strokes: bow", { { &s::BOW, 0.55 } }, true },
		{ "strokes: detour", { { &s::OTHER_DETOUR, NEVER }, { &s::DETOUR_M, 0.1 * NEVER } }, true },
		{ "strokes: rest before", { { &s::NO_REST_SHARE, 1.0 - NONE }, { &s::REST_UNSEEN, 0.0 } }, true },
		{ "strokes: rest unseen", { { &s::REST_UNSEEN, 0.0 } }, true },
		{ "strokes: longer rest before slow ones", { { &s::LONGEST_REST_S, 0.0 } }, true },
		{ "strokes: duration", { { &s::ANY_PACE_SHARE, 1.0 - NONE } }, true },
		{ "strokes: any pace", { { &s::ANY_PACE_SHARE, NONE } }, true },
		{ "strokes: slowing down", { { &s::SLOWING_SHARE, 0.0 } }, true },
		{ "strokes: means against noise", { { &s::LONGEST_MEAN_S, 0.0 } }, true },
		{ "strokes: hopeless ones abort", { { &r::REJECT_LOG_ODDS, -NEVER } }, true },
		{ "strokes: predicted ends", { { &r::END_LOG_ODDS, NEVER } }, true },
		{ "strokes: start before the onset", { { &r::BEFORE_ONSET_S, 0.0 } }, true },

		{ "several gestures: margin of a change", { { &r::SWITCH_MARGIN, 0.0 } }, true },
		{ "several gestures: part of another", { { &r::PART, 0.0 } }, true },
	};
}

} // namespace steadyhand::bench
