#pragma once

#include "gesture/trainer.h"
#include "models.h"
#include "simulation/synthetic_trial.h"

#include <cstdio>
#include <string>
#include <vector>

namespace steadyhand::bench {

inline Task task_of(const SyntheticTrial &trial) {
	return { trial.trial.start_m, trial.trial.axis, trial.trial.amplitude_m };
}

/// Training set of the shipped models (demo_project/tools/own_models.gd).
inline std::vector<SyntheticTrial> training_trials() {
	SyntheticSetOptions options;
	options.population = Population::TRAIN;
	options.subjects = 12;
	options.repetitions = 6;
	options.paces = { 1.0, 0.6, 0.4 };
	std::vector<SyntheticTrial> trials;
	for (const SyntheticTrialRequest &request : plan_synthetic_set(options)) {
		trials.push_back(make_synthetic_trial(request).value());
	}
	return trials;
}

/// The shipped models, trained with these numbers of states and symbols. If training fails: none, and an
/// error on stderr.
inline Models train_models(
		const Models &shipped, const std::vector<SyntheticTrial> &trials, int states, int symbols) {
	Models models;
	for (const std::shared_ptr<const GestureModel> &model : shipped) {
		std::vector<TrainingRecording> recordings;
		for (const SyntheticTrial &trial : trials) {
			if (trial.trial.gesture == model->gesture) {
				recordings.push_back({ trial.trial.trial, task_of(trial), trial.trial.start_s,
						trial.trial.end_s, trial.measured, trial.reference });
			}
		}
		TrainingOptions training;
		training.states = states;
		training.symbols = symbols;
		training.without_task = false; // as the shipped models
		Result<GestureModel> trained = train(model->gesture, model->feature, recordings, training);
		if (!trained) {
			std::fprintf(stderr, "%s\n", trained.error().c_str());
			return {};
		}
		models.push_back(std::make_shared<const GestureModel>(std::move(trained.value())));
	}
	return models;
}

} // namespace steadyhand::bench
