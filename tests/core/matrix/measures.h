#pragma once

#include "metrics/curve_comparison.h"
#include "replay.h"
#include "scenario.h"
#include "signal/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace steadyhand::matrix {

/// How one scenario was followed. Values in amplitudes, velocities in amplitudes/s.
struct Measures {
	double t_diff_s = 0.0;   ///< CurveComparison's; positive: early
	bool missed = false;     ///< the value never comes to 95 % of the hand's own end
	double move_error = 0.0; ///< largest of the value through the movement
	double stop_error = 0.0; ///< largest of the value from SETTLED_S after the movement on
	double value_step = 0.0; ///< largest between two outputs, less the hand's own largest
	double value_jump = 0.0; ///< largest part of such a step that the velocity put out does not account for
	double velocity_step = 0.0; ///< largest between two outputs, less the hand's own largest
	double overshoot = 0.0;     ///< how far the value leaves the range of hand and task
	double r2_zero = 0.0;
	double r2_zero_raw = 0.0; ///< of the tracker's samples, each held until the next
	int started = 0, ended = 0, aborted = 0;
	double ended_s = NAN; ///< when the first gesture ended; not a number: none has
	bool is_finite = true;
};

inline constexpr double SETTLED_S = 0.3;

inline std::vector<double> truth_of(const Scenario &scenario, std::size_t length) {
	std::vector<double> truth(length);
	for (std::size_t ms = 0; ms < length; ++ms) {
		truth[ms] = scenario.truth(static_cast<double>(ms) / OUTPUTS_PER_S);
	}
	return truth;
}

/// Each of the tracker's samples, held until the next one.
inline std::vector<double> raw_of(
		const Scenario &scenario, const std::vector<HandFrame> &frames, std::size_t length) {
	std::vector<double> t_s, x, raw(length);
	for (const HandFrame &frame : frames) {
		if (frame.has(Joint::INDEX)) {
			const Task &task = scenario.task;
			t_s.push_back(frame.t_s);
			x.push_back((frame.position(Joint::INDEX) - task.start_m).dot(task.axis) / task.amplitude_m);
		}
	}
	resample_hold(t_s, x, x.empty() ? 0.0 : x.front(), { .rate_hz = OUTPUTS_PER_S }, raw);
	return raw;
}

inline void count_events(const std::vector<Output> &outputs, Measures &r_measures) {
	for (std::size_t ms = 0; ms < outputs.size(); ++ms) {
		const Output &now = outputs[ms];
		r_measures.is_finite &= std::isfinite(now.value_m) && std::isfinite(now.velocity_m_s);
		r_measures.started += now.started;
		r_measures.ended += now.ended;
		r_measures.aborted += now.aborted;
		if (now.ended > 0 && std::isnan(r_measures.ended_s)) {
			r_measures.ended_s = static_cast<double>(ms) / OUTPUTS_PER_S;
		}
	}
}

struct Steps {
	double value = 0.0, velocity = 0.0, jump = 0.0;
};

/// Before it a tracker of 10 Hz may not have shown the hand yet.
inline constexpr double SHOWN_S = 0.15;

/// The largest between neighbours from SHOWN_S on; jump: what the mean velocity does not account for.
inline Steps steps_of(const std::vector<double> &values, const std::vector<double> &velocities) {
	Steps steps;
	for (auto ms = static_cast<std::size_t>(SHOWN_S * OUTPUTS_PER_S); ms < values.size(); ++ms) {
		const double step = values[ms] - values[ms - 1];
		const double expected = 0.5 * (velocities[ms] + velocities[ms - 1]) / OUTPUTS_PER_S;
		steps.value = std::max(steps.value, std::abs(step));
		steps.velocity = std::max(steps.velocity, std::abs(velocities[ms] - velocities[ms - 1]));
		steps.jump = std::max(steps.jump, std::abs(step - expected));
	}
	return steps;
}

inline void compare_steps(const Scenario &scenario, const std::vector<Output> &outputs,
		const std::vector<double> &truth, Measures &r_measures) {
	const double amplitude_m = scenario.task.amplitude_m;
	std::vector<double> values, velocities, speeds(truth.size());
	for (const Output &output : outputs) {
		values.push_back(output.value_m / amplitude_m);
		velocities.push_back(output.velocity_m_s / amplitude_m);
	}
	for (std::size_t ms = 1; ms < truth.size(); ++ms) {
		speeds[ms] = (truth[ms] - truth[ms - 1]) * OUTPUTS_PER_S;
	}
	const Steps own = steps_of(truth, speeds), put_out = steps_of(values, velocities);
	r_measures.value_step = std::max(0.0, put_out.value - own.value);
	r_measures.velocity_step = std::max(0.0, put_out.velocity - own.velocity);
	r_measures.value_jump = put_out.jump;
	const auto [truth_least, truth_most] = std::ranges::minmax(truth);
	const auto [least, most] = std::ranges::minmax(values);
	r_measures.overshoot =
			std::max({ 0.0, most - std::max(truth_most, 1.0), std::min(truth_least, 0.0) - least });
}

inline Measures measure(const Scenario &scenario, Estimator &r_estimator) {
	const std::vector<HandFrame> frames = frames_of(scenario);
	const std::vector<Output> outputs = replay(frames, scenario.record_s(), r_estimator);
	Measures measures;
	count_events(outputs, measures);

	const UniformGrid grid{ .rate_hz = OUTPUTS_PER_S };
	const GestureSpan span{ scenario.hand.from_s, scenario.hand.to_s };
	const std::vector<double> truth = truth_of(scenario, outputs.size());
	compare_steps(scenario, outputs, truth, measures);
	std::vector<double> values(outputs.size());
	for (std::size_t ms = 0; ms < outputs.size(); ++ms) {
		values[ms] = outputs[ms].value_m / scenario.task.amplitude_m;
		const double t_s = grid.time_s(ms), error = std::abs(values[ms] - truth[ms]);
		if (t_s >= span.start_s && t_s <= span.end_s) {
			measures.move_error = std::max(measures.move_error, error);
		}
		if (t_s >= span.end_s + SETTLED_S) {
			measures.stop_error = std::max(measures.stop_error, error);
		}
	}
	const CurveComparison followed = compare_curves(truth, values, grid, span);
	measures.t_diff_s = followed.t_diff_s;
	measures.missed = followed.missed;
	measures.r2_zero = followed.r2_zero;
	measures.r2_zero_raw =
			compare_curves(truth, raw_of(scenario, frames, outputs.size()), grid, span).r2_zero;
	return measures;
}

} // namespace steadyhand::matrix
