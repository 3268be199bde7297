#pragma once

#include "gesture/motion_element.h"
#include "metrics/curve_comparison.h"
#include "models.h"
#include "recognition/gesture_recogniser.h"
#include "signal/resample.h"
#include "simulation/synthetic_trial.h"
#include "tracking/track_csv.h"
#include "trained_models.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steadyhand::bench {

/// Trials of synthetic people of the tuning population, each at each pace.
inline std::vector<SyntheticTrial> tuning_trials(
		std::uint32_t subjects, std::uint32_t repetitions, const std::vector<double> &paces) {
	SyntheticSetOptions options;
	options.population = Population::TUNE;
	options.subjects = subjects;
	options.repetitions = repetitions;
	options.paces = paces;
	std::vector<SyntheticTrial> trials;
	for (const SyntheticTrialRequest &request : plan_synthetic_set(options)) {
		trials.push_back(make_synthetic_trial(request).value());
	}
	return trials;
}

/// Trials of a folder. If one cannot be read: none, and an error on stderr.
inline std::vector<SyntheticTrial> read_trials(const std::string &folder) {
	std::vector<SyntheticTrial> trials;
	const std::string path = folder + "/trials.csv";
	const Result<TrialTable> rows = parse_trials_csv(read_text(path), path);
	if (!rows || !rows.value().faults.empty()) {
		std::fprintf(stderr, "%s\n", rows ? rows.value().faults.front().c_str() : rows.error().c_str());
		return {};
	}
	for (const Trial &row : rows.value().trials) {
		SyntheticTrial &trial = trials.emplace_back(row, Track{}, Track{});
		for (const auto &[track, ending] : { std::pair{ &trial.measured, ".measured.csv" },
					 std::pair{ &trial.reference, ".reference.csv" } }) {
			const std::string file = folder + "/" + row.trial + ending;
			Result<Track> parsed = parse_track_csv(read_text(file), file);
			if (!parsed) {
				std::fprintf(stderr, "%s\n", parsed.error().c_str());
				return {};
			}
			if (parsed.value().frames.empty()) {
				std::fprintf(stderr, "%s: no frames\n", file.c_str());
				return {};
			}
			*track = std::move(parsed.value());
		}
	}
	return trials;
}

/// Grid that begins at the whole second before a trial's first frame.
inline UniformGrid grid_of(const SyntheticTrial &trial, double rate_hz = UniformGrid{}.rate_hz) {
	return { .t0_s = std::floor(trial.measured.frames.front().t_s), .rate_hz = rate_hz };
}

/// Reference of a trial, in amplitudes, on grid_of(trial).
inline std::vector<double> reference_curve(
		const SyntheticTrial &trial, const GestureModel &model, std::size_t length) {
	MotionElement element(*find_feature(model.feature));
	std::vector<double> t_s, x;
	for (const HandFrame &frame : trial.reference.frames) {
		if (const std::optional<double> x_m = element.measure(frame, task_of(trial))) {
			t_s.push_back(frame.t_s);
			x.push_back(*x_m / trial.trial.amplitude_m);
		}
	}
	std::vector<double> curve(length);
	resample_linear(t_s, x, grid_of(trial), curve);
	return curve;
}

/// End of the longer track: a dropout at the end of the measured track counts.
inline double end_s(const SyntheticTrial &trial) {
	return std::max(trial.measured.frames.back().t_s, trial.reference.frames.back().t_s);
}

/// Pushes all frames, and calls output(seconds) at each output time, after the frames before it.
template <class Output>
void replay(
		const SyntheticTrial &trial, GestureRecogniser &r_recogniser, double outputs_per_s, Output output) {
	const UniformGrid grid = grid_of(trial, outputs_per_s);
	std::size_t next = 0;
	const auto put_out_until = [&](double until_s) {
		for (; grid.time_s(next) < until_s; ++next) {
			r_recogniser.advance(grid.time_s(next));
			output(grid.time_s(next));
		}
	};
	for (const HandFrame &frame : trial.measured.frames) {
		put_out_until(frame.t_s);
		r_recogniser.push(frame);
	}
	put_out_until(end_s(trial));
}

/// Compares the synthesised motion, held between outputs, with the reference.
inline CurveComparison compare_replay(const SyntheticTrial &trial, const GestureModel &model,
		GestureRecogniser &r_recogniser, double outputs_per_s) {
	std::vector<double> t_s, x;
	replay(trial, r_recogniser, outputs_per_s, [&](double now_s) {
		t_s.push_back(now_s);
		x.push_back(r_recogniser.motion(MotionSource::SYNTHESISED).value_m / trial.trial.amplitude_m);
	});
	const UniformGrid grid = grid_of(trial);
	std::vector<double> held(static_cast<std::size_t>((end_s(trial) - grid.t0_s) * grid.rate_hz));
	resample_hold(t_s, x, 0.0, grid, held);
	return compare_curves(reference_curve(trial, model, held.size()), held, grid,
			{ trial.trial.start_s, trial.trial.end_s });
}

} // namespace steadyhand::bench
