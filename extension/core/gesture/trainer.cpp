#include "gesture/trainer.h"

#include "gesture/feature.h"
#include "gesture/motion_elements.h"
#include "gesture/observation.h"
#include "gesture/recorded_hmms.h"
#include "gesture/recorded_movements.h"
#include "gesture/recording_oddity.h"
#include "gesture/reference_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace steadyhand {
namespace {

/// Progress after each step, by usual durations.
constexpr double CURVES_READ = 0.1;
constexpr double OBSERVED = 0.3;
constexpr double QUANTISED = 0.7;
constexpr double RE_ESTIMATED = 0.95;

/// Reports the progress to a callback, until the callback returns false.
class TrainingProgress {
public:
	explicit TrainingProgress(const std::function<bool(double done)> &callback) : callback_(callback) {}

	/// False if training must stop, and at every later call.
	[[nodiscard]] bool go_on(double done) {
		is_stopped_ = is_stopped_ || (callback_ && !callback_(done));
		return !is_stopped_;
	}

private:
	const std::function<bool(double done)> &callback_;
	bool is_stopped_ = false;
};

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
	for (const double count : { options.baum_welch.pseudo.transition, options.baum_welch.pseudo.symbol }) {
		if (!(count > 0.0) || !std::isfinite(count)) {
			return "pseudo-counts: " + std::to_string(count) + " is not above 0 and finite";
		}
	}
	return {};
}

std::string unknown_feature(const std::string &name) {
	std::string message = "there is no feature '" + name + "', there are:";
	for (const Feature &known : features()) {
		message += ' ' + std::string(known.name);
	}
	return message;
}

/// Returns the movements of the reference curve. The model gets the names of all others.
std::vector<Movement> drop_outliers(
		const RecordedMovements &recorded, const ReferenceCurve &reference, GestureModel &r_model) {
	std::vector<Movement> kept;
	for (std::size_t i = 0; i < recorded.movements.size(); ++i) {
		if (reference.kept[i]) {
			kept.push_back(recorded.movements[i]);
		} else {
			r_model.provenance.dropped.push_back(recorded.movements[i].recording->name);
		}
	}
	for (const LeftOut &left_out : recorded.left_out) {
		r_model.provenance.dropped.push_back(left_out.recording->name);
	}
	r_model.provenance.recordings = static_cast<int>(kept.size());
	return kept;
}

/// Mean directions of the tasks, in order of appearance. Directions within 45 degrees of a cluster's first
/// one are one cluster.
std::vector<Eigen::Vector3d> directions_of(const std::vector<Movement> &movements) {
	struct Cluster {
		Eigen::Vector3d first;
		Eigen::Vector3d sum;
	};
	std::vector<Cluster> clusters;
	for (const Movement &movement : movements) {
		const Eigen::Vector3d &axis = movement.recording->task.axis;
		const auto known = std::find_if(clusters.begin(), clusters.end(),
				[&axis](const Cluster &one) { return one.first.dot(axis) > std::numbers::sqrt2 / 2.0; });
		if (known == clusters.end()) {
			clusters.push_back({ axis, axis });
		} else {
			known->sum += axis;
		}
	}
	std::vector<Eigen::Vector3d> directions;
	directions.reserve(clusters.size());
	for (const Cluster &cluster : clusters) {
		directions.push_back(cluster.sum.normalized());
	}
	return directions;
}

/// Sets typical_task to the mean of the tasks.
void set_typical_task(const std::vector<Movement> &kept, bool is_radius, GestureModel &r_model) {
	Task typical = { Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.0 };
	for (const Movement &movement : kept) {
		typical.start_m += movement.recording->task.start_m;
		typical.amplitude_m += movement.recording->task.amplitude_m;
	}
	const double n = static_cast<double>(kept.size());
	typical.start_m /= n;
	typical.amplitude_m /= n;
	if (!is_radius) {
		r_model.other_axes = directions_of(kept);
		typical.axis = r_model.other_axes.front();
		r_model.other_axes.erase(r_model.other_axes.begin());
	}
	r_model.typical_task = std::move(typical);
}

std::vector<double> durations_of(const std::vector<Movement> &kept) {
	std::vector<double> durations_s;
	durations_s.reserve(kept.size());
	for (const Movement &movement : kept) {
		durations_s.push_back(movement.duration_s());
	}
	return durations_s;
}

std::vector<NormalisedRecording> report(RecordedMovements recorded, const ReferenceCurve &reference) {
	std::vector<NormalisedRecording> rows;
	rows.reserve(recorded.movements.size() + recorded.left_out.size());
	for (std::size_t i = 0; i < recorded.movements.size(); ++i) {
		const TrainingRecording &recording = *recorded.movements[i].recording;
		rows.push_back({ recording.name, std::move(recorded.curves[i]), reference.r2[i], reference.kept[i],
				early_end(recording) });
	}
	for (LeftOut &left_out : recorded.left_out) {
		rows.push_back({ left_out.recording->name, {}, 0.0, false, std::move(left_out.reason) });
	}
	return rows;
}

/// For each movement: its observations, nullopt at instants without a new frame.
using Observations = std::vector<std::vector<std::optional<Observation>>>;

Observations observe(const Feature &feature, const std::vector<Movement> &kept, double duration_mean_s) {
	Observations observed;
	observed.reserve(kept.size());
	for (const Movement &movement : kept) {
		observed.push_back(observe(feature, movement, duration_mean_s));
	}
	return observed;
}

/// Codebook of all observations. It has fewer symbols if training is stopped.
VectorQuantiser codebook_of(const Observations &observed, int symbols, TrainingProgress &r_progress) {
	std::vector<Observation> seen;
	for (const auto &observations : observed) {
		for (const std::optional<Observation> &o : observations) {
			if (o) {
				seen.push_back(*o);
			}
		}
	}
	return VectorQuantiser::trained(seen, symbols, [&](int codewords) {
		return r_progress.go_on(OBSERVED + (QUANTISED - OBSERVED) * codewords / symbols);
	});
}

std::vector<SymbolSequence> in_symbols(const Observations &observed, const VectorQuantiser &quantiser) {
	std::vector<SymbolSequence> sequences;
	for (const auto &observations : observed) {
		SymbolSequence &sequence = sequences.emplace_back();
		for (const std::optional<Observation> &o : observations) {
			sequence.push_back(o ? quantiser.symbol(*o) : UNSEEN);
		}
	}
	return sequences;
}

void re_estimate(const std::vector<SymbolSequence> &sequences, const TrainingOptions &options,
		TrainingProgress &r_progress, GestureModel &r_model) {
	BaumWelchOptions baum_welch_options = options.baum_welch;
	baum_welch_options.go_on = [&](int iterations) {
		return r_progress.go_on(
				QUANTISED + (RE_ESTIMATED - QUANTISED) * iterations / options.baum_welch.max_iterations);
	};
	BaumWelchResult trained = baum_welch(left_right_from_equal_segments(sequences, options.states,
												 options.symbols, options.baum_welch.pseudo),
			sequences, baum_welch_options);
	r_model.hmm = std::move(trained.hmm);
	r_model.provenance.objective = std::move(trained.objective);
}

/// Warning that the degree was lowered. degree: result of cut_into_elements().
std::string lowered(std::size_t degree, const TrainingOptions &options) {
	return "polynomials of degree " + std::to_string(options.polynomial_degree) + " in " +
			std::to_string(options.states) + " states leave the recordings' mean; " +
			(degree > 0 ? "degree " + std::to_string(degree) + " is" : "lines between the states are") +
			" used. Use fewer states, or more recordings that are alike";
}

/// Warning that the gesture has no HMMs; empty if it has some, or needs none.
std::string missing_hmms(const Feature &feature, const TrainingOptions &options, const GestureModel &model) {
	const bool is_missing = options.without_task && feature.place != nullptr && model.recorded_hmms.empty();
	return is_missing ? "it is not recognised without a task: the measured tracks must show the hand at rest "
						"before the gesture, and for 0.5 s after it"
					  : "";
}

} // namespace

std::string training_error(const std::string &feature, const TrainingOptions &options) {
	const std::string fault = range_error(options);
	return fault.empty() && find_feature(feature) == nullptr ? unknown_feature(feature) : fault;
}

Result<GestureModel> train(const std::string &gesture, const std::string &feature_name,
		std::span<const TrainingRecording> recordings, const TrainingOptions &options,
		std::vector<NormalisedRecording> *r_recordings, std::string *r_warning) {
	if (const std::string_view fault = gesture_name_fault(gesture); !fault.empty()) {
		return Error{ "the gesture's name '" + gesture + "' " + std::string(fault) };
	}
	if (const std::string fault = training_error(feature_name, options); !fault.empty()) {
		return Error{ gesture + ": " + fault };
	}
	const Feature *const feature = find_feature(feature_name);
	Result<RecordedMovements> recorded = recorded_movements(*feature, recordings);
	if (!recorded) {
		return Error{ gesture + ": " + recorded.error() };
	}
	TrainingProgress progress(options.progress);
	const Error stopped{ gesture + ": training was stopped" };

	GestureModel model;
	model.gesture = gesture;
	model.feature = feature_name;
	const ReferenceCurve reference = reference_curve(recorded.value().curves, options.r2_threshold);
	model.reference_mean = reference.mean;
	model.reference_deviation = reference.deviation;
	model.provenance.r2_threshold = options.r2_threshold;
	const std::vector<Movement> kept = drop_outliers(recorded.value(), reference, model);
	set_typical_task(kept, find_feature(model.feature)->is_radius, model);
	const std::vector<double> durations_s = durations_of(kept);
	const MeanAndDeviation duration = mean_and_deviation(durations_s);
	model.duration_mean_s = duration.mean;
	model.duration_deviation_s = duration.deviation;
	if (!progress.go_on(CURVES_READ)) {
		return stopped;
	}
	if (r_recordings != nullptr) {
		*r_recordings = report(std::move(recorded).value(), reference);
	}

	const Observations observed = observe(*feature, kept, model.duration_mean_s);
	model.quantiser = codebook_of(observed, options.symbols, progress);
	if (!progress.go_on(QUANTISED)) {
		return stopped;
	}
	const std::vector<SymbolSequence> sequences = in_symbols(observed, model.quantiser);
	re_estimate(sequences, options, progress, model);
	if (!progress.go_on(RE_ESTIMATED)) {
		return stopped;
	}
	const std::size_t degree = cut_into_elements(sequences, durations_s, options.polynomial_degree, model);
	if (options.without_task) {
		model.recorded_counts = recorded_counts(*feature, kept);
		model.recorded_hmms = recorded_hmms(gesture, model.recorded_counts);
	}
	if (r_warning != nullptr) {
		*r_warning = degree < options.polynomial_degree ? lowered(degree, options)
														: missing_hmms(*feature, options, model);
	}
	if (!progress.go_on(1.0)) {
		return stopped;
	}
	return model;
}

} // namespace steadyhand
