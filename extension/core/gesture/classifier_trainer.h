#pragma once

#include "base/result.h"
#include "gesture/classifier_model.h"
#include "gesture/trainer.h"

#include <span>
#include <string>
#include <vector>

namespace steadyhand {

/// A recording of a gesture, or of a hand that does something else (gesture NO_GESTURE).
struct ClassifierRecording {
	std::string gesture;
	std::string feature; ///< as in Feature::name; unused of NO_GESTURE
	TrainingRecording recording;
};

struct ClassifierTrainingOptions {
	int states = 12;      ///< of each HMM, its rests included; >= 3
	int symbols = 128;    ///< of the codebook
	int other_states = 8; ///< of the HMM of all other motion
	/// Of each state's symbols, this share is as in all motions: a tracker's jump costs a path so much, not
	/// all.
	double odd_symbols = 0.02;
	double reach_deviation =
			0.12; ///< least DirectedHmm::reach_deviation: other hands go further, or less far
};

/// Trains the HMMs of all gestures together, over one codebook: one HMM for each direction in which a gesture
/// is recorded (directions within 45 degrees are one). Which frames are before a gesture and after it the
/// recordings say, so that the states are counted, not estimated: Baum-Welch moves the last state, arrived,
/// into the motion before it. Other motion has no such marks, and is left to Baum-Welch. Deterministic,
/// without a random number. Errors: no recording of a gesture that anything is to be learnt from; an unknown
/// feature.
Result<ClassifierModel> train_classifier(
		std::span<const ClassifierRecording> recordings, const ClassifierTrainingOptions &options = {});

} // namespace steadyhand
