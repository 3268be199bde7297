#pragma once

#include "measures.h"
#include "scenario.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace steadyhand::matrix {

/// What a bound limits; of each, less is better.
enum class Metric : std::uint8_t {
	END_ERROR_MS,       ///< |T_diff|; infinite where the end is missed
	MOVE_ERROR_PERCENT, ///< of the way
	STOP_ERROR_PERCENT, ///< of the way
	WRONG_ENDS,         ///< ended gestures too many or too few
	R2_BELOW_RAW,       ///< zero-lag R2 of the raw samples minus that of the output
	VALUE_STEP_PERCENT, ///< of the way
	VALUE_JUMP_PERCENT, ///< of the way
	VELOCITY_STEP,      ///< amplitudes/s
	OVERSHOOT,          ///< amplitudes; infinite where an output is not finite
};

struct MetricName {
	Metric metric;
	const char *name;
};

/// In the order of Metric.
inline constexpr std::array METRIC_NAMES{ MetricName{ Metric::END_ERROR_MS, "end error, ms" },
	MetricName{ Metric::MOVE_ERROR_PERCENT, "error in the move, %" },
	MetricName{ Metric::STOP_ERROR_PERCENT, "error after 0.3 s, %" },
	MetricName{ Metric::WRONG_ENDS, "wrong ends" }, MetricName{ Metric::R2_BELOW_RAW, "R2 below raw" },
	MetricName{ Metric::VALUE_STEP_PERCENT, "step of value, %" },
	MetricName{ Metric::VALUE_JUMP_PERCENT, "jump of value, %" },
	MetricName{ Metric::VELOCITY_STEP, "step of velocity, A/s" },
	MetricName{ Metric::OVERSHOOT, "overshoot, A" } };

[[nodiscard]] inline const char *name_of(Metric metric) {
	return METRIC_NAMES[static_cast<std::size_t>(metric)].name;
}

[[nodiscard]] inline double value_of(Metric metric, const Scenario &scenario, const Measures &measures) {
	switch (metric) {
		case Metric::END_ERROR_MS:
			return measures.missed ? INFINITY : 1e3 * std::abs(measures.t_diff_s);
		case Metric::MOVE_ERROR_PERCENT:
			return 100.0 * measures.move_error;
		case Metric::STOP_ERROR_PERCENT:
			return 100.0 * measures.stop_error;
		case Metric::WRONG_ENDS:
			return std::abs(measures.ended - scenario.hand.ends);
		case Metric::R2_BELOW_RAW:
			return measures.r2_zero_raw - measures.r2_zero;
		case Metric::VALUE_STEP_PERCENT:
			return 100.0 * measures.value_step;
		case Metric::VALUE_JUMP_PERCENT:
			return 100.0 * measures.value_jump;
		case Metric::VELOCITY_STEP:
			return measures.velocity_step;
		case Metric::OVERSHOOT:
			return measures.is_finite ? measures.overshoot : INFINITY;
	}
	return INFINITY;
}

/// MEASURED: bench_matrix shows how far the core is from it. ASSERTED: test_matrix.cpp fails beyond it.
enum class Standing : std::uint8_t { MEASURED, ASSERTED };

struct Bound {
	std::string_view group; ///< of Scenario; EVERY_GROUP: all of them
	Metric metric;
	double limit; ///< a scenario is outside of it where it is greater
	Standing standing;
};

inline constexpr std::string_view EVERY_GROUP = "every group";

/// No step: no correction quicker than a minimum-jerk movement over the whole way in a third of the quickest
/// gesture's 0.15 s. Its peak speed is 15 / 8 amplitudes a duration, its peak acceleration 10 / sqrt(3)
/// (Flash and Hogan 1985, doi 10.1523/JNEUROSCI.05-07-01688.1985).
inline constexpr double QUICKEST_S = 0.05;
inline constexpr double QUICKEST_VALUE_STEP_PERCENT = 100.0 * 1.875 / QUICKEST_S / OUTPUTS_PER_S;
inline constexpr double QUICKEST_VELOCITY_STEP = 5.7735 / (QUICKEST_S * QUICKEST_S) / OUTPUTS_PER_S;

/// To assert a bound, change its standing. A drift cannot be told from a hand's motion: what follows it is
/// held against the raw track. A jump of 1 % is 40 dB below the whole way.
inline constexpr std::array BOUNDS{
	Bound{ EVERY_GROUP, Metric::OVERSHOOT, 1.0, Standing::ASSERTED },
	Bound{ EVERY_GROUP, Metric::VALUE_STEP_PERCENT, QUICKEST_VALUE_STEP_PERCENT, Standing::ASSERTED },
	Bound{ EVERY_GROUP, Metric::VALUE_JUMP_PERCENT, 1.0, Standing::ASSERTED },
	Bound{ EVERY_GROUP, Metric::VELOCITY_STEP, QUICKEST_VELOCITY_STEP, Standing::MEASURED },
	Bound{ "move", Metric::END_ERROR_MS, 10.0, Standing::ASSERTED },
	Bound{ "move", Metric::R2_BELOW_RAW, 0.0006, Standing::ASSERTED },
	Bound{ "move", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "move, noise", Metric::END_ERROR_MS, 10.0, Standing::MEASURED },
	Bound{ "move, noise", Metric::R2_BELOW_RAW, 0.0006, Standing::MEASURED },
	Bound{ "move, noise", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "move, coarse noise", Metric::R2_BELOW_RAW, 0.0006, Standing::MEASURED },
	Bound{ "move, coarse noise", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "move, few frames", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "move, few frames", Metric::R2_BELOW_RAW, 0.0, Standing::MEASURED },
	Bound{ "move, few frames", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "quick hand 0.15 s", Metric::END_ERROR_MS, 10.0, Standing::MEASURED },
	Bound{ "quick hand 0.15 s", Metric::WRONG_ENDS, 0.0, Standing::MEASURED },
	Bound{ "slow hand 4 s", Metric::END_ERROR_MS, 10.0, Standing::MEASURED },
	Bound{ "slow hand 4 s", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "short task", Metric::END_ERROR_MS, 5.0, Standing::MEASURED },
	Bound{ "short task", Metric::MOVE_ERROR_PERCENT, 2.0, Standing::MEASURED },
	Bound{ "short task", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "dead stop", Metric::STOP_ERROR_PERCENT, 2.0, Standing::MEASURED },
	Bound{ "dead stop", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "smooth stop", Metric::STOP_ERROR_PERCENT, 2.0, Standing::MEASURED },
	Bound{ "smooth stop", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "halt", Metric::R2_BELOW_RAW, 0.0, Standing::MEASURED },
	Bound{ "halt", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "dropout 0.1 s", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "dropout 0.1 s", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "dropout 0.1 s", Metric::VELOCITY_STEP, QUICKEST_VELOCITY_STEP, Standing::MEASURED },
	Bound{ "dropout 0.3 s", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "dropout 0.3 s", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "dropout 0.3 s", Metric::VELOCITY_STEP, QUICKEST_VELOCITY_STEP, Standing::MEASURED },
	Bound{ "zeros 0.2 s", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "zeros 0.2 s", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "freeze 0.5 s", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "freeze 0.5 s", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "other hand, 6 frames", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "other hand, 6 frames", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "jump 7 cm, 1 frame", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "jump 7 cm, 1 frame", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "late 60 ms for 0.3 s", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "late 60 ms for 0.3 s", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "end hidden by the fault", Metric::END_ERROR_MS, 30.0, Standing::MEASURED },
	Bound{ "end hidden by the fault", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "drift 1 cm", Metric::R2_BELOW_RAW, 0.0, Standing::MEASURED },
	Bound{ "drift 1 cm", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "rest", Metric::STOP_ERROR_PERCENT, 2.0, Standing::MEASURED },
	Bound{ "rest", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "rest, coarse noise", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "rest, fault", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "there and back", Metric::END_ERROR_MS, 10.0, Standing::ASSERTED },
	Bound{ "there and back", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
	Bound{ "past the end", Metric::END_ERROR_MS, 10.0, Standing::ASSERTED },
	Bound{ "past the end", Metric::WRONG_ENDS, 0.0, Standing::ASSERTED },
};

[[nodiscard]] inline bool applies(const Bound &bound, const Scenario &scenario) {
	return bound.group == EVERY_GROUP || bound.group == scenario.group;
}

} // namespace steadyhand::matrix
