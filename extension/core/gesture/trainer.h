#pragma once

#include "base/result.h"
#include "gesture/gesture_model.h"
#include "gesture/task.h"
#include "hmm/baum_welch.h"
#include "tracking/track.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// One recorded execution of a gesture. Both tracks use one clock.
struct TrainingRecording {
	std::string name;
	Task task;
	double start_s = 0.0; ///< start and end of the gesture, within the reference
	double end_s = 0.0;
	Track measured;  ///< by the sensor that will be used: the HMM is trained with it
	Track reference; ///< by a stable sensor: the motion elements are fitted to it
};

/// A recording after normalisation. The reference curve is the mean of the kept ones.
struct NormalisedRecording {
	std::string name;
	Eigen::VectorXd curve; ///< CURVE_POINTS over phase 0..1, from 0 to 1; empty if it was left out
	double r2 = 0.0;       ///< R^2 against the mean of all recordings that were not left out
	bool kept = true;      ///< r2 >= T_h, or the best r2
	std::string oddity;    ///< warning, or why it was left out (recording_oddity.h)
};

struct TrainingOptions {
	static constexpr int MOST_STATES = 20, MOST_SYMBOLS = 1024;

	int states = 4; ///< paper: four for every gesture
	int symbols = 16;
	double r2_threshold = 0.9; ///< T_h; the paper found it by trial and error for each gesture
	std::size_t polynomial_degree = 5;
	/// Also counts GestureModel::recorded_hmms. Not for a gesture that own_classifier() includes.
	bool without_task = true;
	BaumWelchOptions baum_welch;
	/// Called during training, done: 0..1. If it returns false, training stops.
	std::function<bool(double done)> progress;
};

/// Faults that do not depend on recordings: an unknown feature, options out of range, a pseudo-count of 0 (a
/// state without observations would have no probabilities). Empty if there is none.
[[nodiscard]] std::string training_error(const std::string &feature, const TrainingOptions &options);

/// Trains one gesture (paper, "Primitive motion elements"). The reference curve comes from the reference
/// tracks, without outliers. Codebook, HMM and state durations come from the measured tracks of the kept
/// recordings. Deterministic, without random numbers: equal recordings give a model with equal bits.
/// Errors: training_error(), no usable recording (recording_oddity.h), stopped by progress. r_recordings, if
/// given: the usable recordings in their order, then those that were left out. r_warning, if given: a
/// warning about the whole model, or empty.
Result<GestureModel> train(const std::string &gesture, const std::string &feature,
		std::span<const TrainingRecording> recordings, const TrainingOptions &options,
		std::vector<NormalisedRecording> *r_recordings = nullptr, std::string *r_warning = nullptr);

} // namespace steadyhand
