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

/// One recorded execution of a gesture, both sensors on one clock.
struct TrainingRecording {
	std::string name;
	Task task;
	double start_s = 0.0; ///< start and end: within the reference
	double end_s = 0.0;
	Track measured;  ///< what the HMM learns from: the sensor as it will be in use
	Track reference; ///< what the motion elements are taken from: the stable sensor
};

/// What became of a recording: the reference curve is the mean of those kept.
struct NormalisedRecording {
	std::string name;
	Eigen::VectorXd curve; ///< CURVE_POINTS over phase 0..1, running from 0 to 1; empty: it was left out
	double r2 = 0.0;       ///< R^2 against the mean of all that were not left out
	bool kept = true;      ///< r2 >= T_h, or the best there is
	std::string oddity;    ///< what looks wrong with it, or why it was left out (recording_oddity.h)
};

struct TrainingOptions {
	static constexpr int MOST_STATES = 20, MOST_SYMBOLS = 1024;

	int states = 4; ///< paper: four for every gesture
	int symbols = 16;
	double r2_threshold = 0.9; ///< T_h; the paper found it by trial and error for each gesture
	std::size_t polynomial_degree = 5;
	BaumWelchOptions baum_welch;
	/// Called as the work goes on, done 0..1; false stops it.
	std::function<bool(double done)> progress;
};

/// What can be told to be wrong before a recording is read: an unknown feature, options out of range, a
/// pseudo-count of 0 (a state that saw nothing would have no probabilities). Empty
/// where nothing is.
[[nodiscard]] std::string training_error(const std::string &feature, const TrainingOptions &options);

/// Trains one gesture (paper, "Primitive motion elements"): reference curve from the reference tracks,
/// outliers dropped; codebook, HMM and state durations from the measured tracks of the recordings that stay.
/// Deterministic, without a random number: equal recordings give an equal model, to the last bit. Errors:
/// training_error(), no recording that anything is to be learnt from (recording_oddity.h), stopped by
/// progress. r_recordings, if given: those that something was learnt from, in their order, then those that
/// were left out. r_warning, if given: what is wrong with the model as a whole, or empty.
Result<GestureModel> train(const std::string &gesture, const std::string &feature,
		std::span<const TrainingRecording> recordings, const TrainingOptions &options,
		std::vector<NormalisedRecording> *r_recordings = nullptr, std::string *r_warning = nullptr);

} // namespace steadyhand
