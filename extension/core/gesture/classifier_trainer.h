#pragma once

#include "base/result.h"
#include "gesture/classifier_model.h"
#include "gesture/trainer.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// A recording of a gesture, or of other motion (gesture: NO_GESTURE).
struct ClassifierRecording {
	std::string gesture;
	std::string feature; ///< a Feature::name; unused for NO_GESTURE
	TrainingRecording recording;
};

struct ClassifierTrainingOptions {
	int states = 12;      ///< of each HMM, with the rest before the gesture and END_STATES; >= END_STATES + 2
	int symbols = 128;    ///< of the codebook
	int other_states = 8; ///< of the HMM of other motion
	std::size_t paces = 2; ///< HMMs for each direction, of equal numbers of recordings, sorted by duration
	/// Fraction of each state's emissions that has the distribution of all motion. It limits the cost of a
	/// tracker's jump.
	double odd_symbols = 0.02;
	/// Least DirectedHmm::reach_deviation, because other people reach further or less far, and open other
	/// hands.
	double reach_deviation = 0.12, reach_deviation_radius = 0.3;
};

/// Trains the HMMs of all gestures over one codebook, for each recorded direction of a gesture (directions
/// within 45 degrees are one) and each of options.paces. A state cannot remember the pace. The recordings
/// mark onset and end, so states are counted: Baum-Welch would move the last state into the motion. Other
/// motion has no marks and uses Baum-Welch. Deterministic, without random numbers. Errors: no usable
/// recording of a gesture; an unknown feature.
Result<ClassifierModel> train_classifier(
		std::span<const ClassifierRecording> recordings, const ClassifierTrainingOptions &options = {});

} // namespace steadyhand
