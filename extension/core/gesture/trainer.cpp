#include "gesture/trainer.h"

#include "gesture/feature.h"
#include "gesture/motion_element.h"
#include "gesture/motion_elements.h"
#include "gesture/observation.h"
#include "gesture/reference_curve.h"
#include "gesture/symbol_clock.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace steadyhand {
namespace {

/// Shares of the work that are done after each step, by their usual times.
constexpr double CURVES_READ = 0.1;
constexpr double OBSERVED = 0.3;
constexpr double QUANTISED = 0.7;
constexpr double RE_ESTIMATED = 0.95;

/// What is left of a recording once its reference has been looked at.
struct Movement {
	const TrainingRecording *recording = nullptr;
	MovementSpan span;
};

RecordedCurve reference_motion(const Feature &feature, const TrainingRecording &recording) {
	RecordedCurve curve;
	MotionElement element(feature);
	for (const HandFrame &frame : recording.reference.frames) {
		if (frame.t_s <= recording.start_s) {
			element.restart();
		}
		const std::optional<double> x_m = element.measure(frame, recording.task);
		if (x_m && (curve.t_s.empty() || frame.t_s > curve.t_s.back())) {
			curve.t_s.push_back(frame.t_s);
			curve.x_m.push_back(*x_m);
		}
	}
	return curve;
}

/// Normalised observations at the symbol clock's instants over the movement; empty ones where nothing new was
/// seen.
std::vector<std::optional<Observation>> observe(
		const Feature &feature, const Movement &movement, double duration_mean_s) {
	const TrainingRecording &recording = *movement.recording;
	std::vector<std::optional<Observation>> observations;
	ObservationWindow window;
	MotionElement element(feature);
	SymbolClock clock;
	clock.start(movement.span.onset_s);
	bool fresh = false;
	const auto tick_until = [&](double t_s) {
		while (clock.due(std::min(t_s, movement.span.end_s))) {
			observations.push_back(fresh
							? std::optional(window.normalised(recording.task.amplitude_m, duration_mean_s))
							: std::nullopt);
			fresh = false;
			clock.advance();
		}
	};
	for (const HandFrame &frame : recording.measured.frames) {
		// An instant before this frame saw only the frames before it.
		tick_until(std::nextafter(frame.t_s, -INFINITY));
		if (frame.t_s <= movement.span.onset_s) {
			element.restart();
		}
		if (const std::optional<double> x_m = element.measure(frame, recording.task)) {
			window.push(frame.t_s, *x_m);
			fresh = true;
		}
	}
	tick_until(movement.span.end_s);
	return observations;
}

std::string range_error(const TrainingOptions &options) {
	const auto beyond = [](const char *what, int given, int most) {
		return std::string(what) + ": " + std::to_string(given) + " is not in 1.." + std::to_string(most);
	};
	if (options.states < 1 || options.states > TrainingOptions::MOST_STATES) {
		return beyond("states", options.states, TrainingOptions::MOST_STATES);
	}
	if (options.symbols < 1 || options.symbols > TrainingOptions::MOST_SYMBOLS) {
		return beyond("symbols", options.symbols, TrainingOptions::MOST_SYMBOLS);
	}
	const bool is_share = options.r2_threshold >= 0.0 && options.r2_threshold <= 1.0;
	if (!is_share) {
		return "r2_threshold: " + std::to_string(options.r2_threshold) + " is not in 0..1";
	}
	return {};
}

/// Of a recording whose gesture has no length, or is not wholly where its reference can show it.
std::optional<std::string> recording_error(const TrainingRecording &recording) {
	constexpr double ROUNDING_S = 1e-6; // stamps are decimal text
	if (!(recording.task.amplitude_m >= SMALLEST_AMPLITUDE_M)) {
		return recording.name + ": its amplitude_m is empty or not above 0";
	}
	const std::vector<HandFrame> &frames = recording.reference.frames;
	if (frames.empty()) {
		return recording.name + ": its reference has no frames";
	}
	if (recording.start_s < recording.end_s && recording.start_s >= frames.front().t_s - ROUNDING_S &&
			recording.end_s <= frames.back().t_s + ROUNDING_S) {
		return std::nullopt;
	}
	return recording.name + ": start_s " + std::to_string(recording.start_s) + " .. end_s " +
			std::to_string(recording.end_s) + " is not within its reference, " +
			std::to_string(frames.front().t_s) + " .. " + std::to_string(frames.back().t_s) + " s";
}

} // namespace

Result<GestureModel> train(const std::string &gesture, const std::string &feature_name,
		std::span<const TrainingRecording> recordings, const TrainingOptions &options,
		std::vector<NormalisedRecording> *r_recordings) {
	if (const std::string fault = range_error(options); !fault.empty()) {
		return Error{ gesture + ": " + fault };
	}
	const Feature *feature = find_feature(feature_name);
	if (feature == nullptr) {
		std::string message = gesture + ": there is no feature '" + feature_name + "', there are:";
		for (const Feature &known : features()) {
			message += ' ' + std::string(known.name);
		}
		return Error{ std::move(message) };
	}
	bool is_stopped = false;
	const auto go_on = [&](double done) {
		is_stopped = is_stopped || (options.progress && !options.progress(done));
		return !is_stopped;
	};
	const Error stopped{ gesture + ": training was stopped" };

	std::vector<Movement> movements;
	std::vector<Eigen::VectorXd> curves;
	for (const TrainingRecording &recording : recordings) {
		if (std::optional<std::string> fault = recording_error(recording)) {
			return Error{ gesture + ": " + *fault };
		}
		const RecordedCurve curve = reference_motion(*feature, recording);
		if (curve.t_s.size() < 2) {
			continue;
		}
		const MovementSpan span = movement_span(curve, recording.start_s, recording.end_s);
		Eigen::VectorXd normalised = normalised_curve(curve, span);
		if (!normalised.isZero(0.0)) {
			movements.push_back({ &recording, span });
			curves.push_back(std::move(normalised));
		}
	}
	if (movements.empty()) {
		return Error{ gesture + ": the feature '" + feature_name + "' moves in none of the " +
			std::to_string(recordings.size()) + " recordings" };
	}

	GestureModel model;
	model.gesture = gesture;
	model.feature = feature_name;
	const ReferenceCurve reference = reference_curve(curves, options.r2_threshold);
	model.reference_mean = reference.mean;
	model.reference_deviation = reference.deviation;
	model.provenance.r2_threshold = options.r2_threshold;
	std::vector<Movement> kept;
	std::vector<double> durations_s;
	model.typical_task = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.0 };
	for (std::size_t i = 0; i < movements.size(); ++i) {
		if (!reference.kept[i]) {
			model.provenance.dropped.push_back(movements[i].recording->name);
			continue;
		}
		kept.push_back(movements[i]);
		durations_s.push_back(movements[i].span.end_s - movements[i].span.onset_s);
		const Task &task = movements[i].recording->task;
		model.typical_task.start_m += task.start_m;
		// Reciprocal moves go both ways along one axis: the first recording says which way is called forward.
		const double way = std::copysign(1.0, task.axis.dot(kept.front().recording->task.axis));
		model.typical_task.axis += way * task.axis;
		model.both_ways = model.both_ways || way < 0.0;
		model.typical_task.amplitude_m += task.amplitude_m;
	}
	model.provenance.recordings = static_cast<int>(kept.size());
	const MeanAndDeviation duration = mean_and_deviation(durations_s);
	model.duration_mean_s = duration.mean;
	model.duration_deviation_s = duration.deviation;
	const double n = static_cast<double>(kept.size());
	model.typical_task.start_m /= n;
	model.typical_task.axis.normalize(); // a radius has none: stays zero
	model.typical_task.amplitude_m /= n;
	if (!go_on(CURVES_READ)) {
		return stopped;
	}

	if (r_recordings != nullptr) {
		r_recordings->clear();
		for (std::size_t i = 0; i < movements.size(); ++i) {
			r_recordings->push_back({ movements[i].recording->name, std::move(curves[i]), reference.r2[i],
					reference.kept[i] });
		}
	}

	std::vector<std::vector<std::optional<Observation>>> observed;
	std::vector<Observation> seen;
	for (const Movement &movement : kept) {
		observed.push_back(observe(*feature, movement, model.duration_mean_s));
		for (const std::optional<Observation> &o : observed.back()) {
			if (o) {
				seen.push_back(*o);
			}
		}
	}
	model.quantiser = VectorQuantiser::trained(seen, options.symbols, [&](int codewords) {
		return go_on(OBSERVED + (QUANTISED - OBSERVED) * codewords / options.symbols);
	});
	if (!go_on(QUANTISED)) {
		return stopped;
	}
	std::vector<SymbolSequence> sequences;
	for (const auto &observations : observed) {
		SymbolSequence &sequence = sequences.emplace_back();
		for (const std::optional<Observation> &o : observations) {
			sequence.push_back(o ? model.quantiser.symbol(*o) : UNSEEN);
		}
	}
	BaumWelchOptions baum_welch_options = options.baum_welch;
	baum_welch_options.go_on = [&](int iterations) {
		return go_on(QUANTISED + (RE_ESTIMATED - QUANTISED) * iterations / options.baum_welch.max_iterations);
	};
	BaumWelchResult trained = baum_welch(left_right_from_equal_segments(sequences, options.states,
												 options.symbols, options.baum_welch.pseudo),
			sequences, baum_welch_options);
	if (!go_on(RE_ESTIMATED)) {
		return stopped;
	}
	model.hmm = std::move(trained.hmm);
	model.provenance.objective = std::move(trained.objective);
	cut_into_elements(sequences, durations_s, options.polynomial_degree, model);
	if (!go_on(1.0)) {
		return stopped;
	}
	return model;
}

} // namespace steadyhand
