// Recognition by the likelihood of the gesture models' HMMs alone. Gestures of synthetic people (tuning
// population) are cut at their true start and end. The model with the greatest likelihood counts, with any
// last state, and with the path in the model's last state.
//
//     bench_likelihood [MODELS]
//
// MODELS: folder of the models (default: models).

#include "gesture/recorded_movements.h"
#include "hmm/forward.h"
#include "models.h"
#include "trials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

const HandFrame &frame_at(const Track &track, double t_s) {
	const auto later = std::find_if(track.frames.begin(), track.frames.end(),
			[t_s](const HandFrame &frame) { return frame.t_s >= t_s; });
	return later != track.frames.end() ? *later : track.frames.back();
}

/// The model's typical task, from the hand's start, in the direction of the hand's motion.
Task task_here(const GestureModel &model, const SyntheticTrial &trial) {
	const HandFrame &first = frame_at(trial.reference, trial.trial.start_s),
					&last = frame_at(trial.reference, trial.trial.end_s);
	const Feature &feature = *find_feature(model.feature);
	Task task = model.typical_task;
	if (feature.is_radius) {
		task.start_m.setZero();
		task.start_m.x() = feature.measure(first, task).value_or(model.typical_task.start_m.x());
		return task;
	}
	task.start_m = first.position(Joint::INDEX);
	const bool is_reverse = !model.other_axes.empty() && feature.measure(last, task).value_or(0.0) < 0.0;
	task.axis *= is_reverse ? -1.0 : 1.0;
	return task;
}

SymbolSequence symbols_of(const GestureModel &model, const SyntheticTrial &trial) {
	const TrainingRecording recording{ trial.trial.trial, task_here(model, trial), trial.trial.start_s,
		trial.trial.end_s, trial.measured, trial.reference };
	const Movement movement{ &recording, { trial.trial.start_s, trial.trial.end_s } };
	SymbolSequence symbols;
	for (const std::optional<Observation> &seen :
			observe(*find_feature(model.feature), movement, model.duration_mean_s)) {
		symbols.push_back(seen ? model.quantiser.symbol(*seen) : UNSEEN);
	}
	return symbols;
}

/// log P(O, path ends in the last state), nats (Rabiner 1989 eq. (19)-(20)).
double log_likelihood_of_whole(const DiscreteHmm &hmm, const SymbolSequence &symbols) {
	Eigen::VectorXd alpha, log_b(hmm.states());
	for (const Symbol symbol : symbols) {
		hmm.emission(symbol, log_b);
		Eigen::VectorXd next = hmm.log_pi;
		for (Eigen::Index j = 0; alpha.size() > 0 && j < hmm.states(); ++j) {
			const Eigen::VectorXd paths = alpha + hmm.log_a.col(j);
			const double largest = std::max(paths.maxCoeff(), -1e300);
			next[j] = largest + std::log((paths.array() - largest).exp().sum());
		}
		alpha = next + log_b;
	}
	return alpha[hmm.states() - 1];
}

} // namespace

int main(int count, char **arguments) {
	const Models models = read_models(count > 1 ? arguments[1] : "models");
	if (models.empty()) {
		return 1;
	}
	int gestures = 0, correct = 0, correct_whole = 0;
	for (const SyntheticTrial &trial : tuning_trials(12, 4, { 1.0, 0.6, 0.4, 1.6 })) {
		const auto known = std::find(GESTURES.begin(), GESTURES.end(), trial.trial.gesture);
		if (known == GESTURES.end()) {
			continue;
		}
		std::array<double, GESTURES.size()> any{}, whole{};
		for (std::size_t i = 0; i < models.size(); ++i) {
			const SymbolSequence symbols = symbols_of(*models[i], trial);
			any[i] = log_likelihood(models[i]->hmm, symbols);
			whole[i] = log_likelihood_of_whole(models[i]->hmm, symbols);
		}
		const auto names = [&](const auto &log) {
			return std::max_element(log.begin(), log.end()) - log.begin() == known - GESTURES.begin();
		};
		++gestures;
		correct += names(any) ? 1 : 0;
		correct_whole += names(whole) ? 1 : 0;
	}
	std::printf("%d gestures: %d correct with any last state, %d correct with the path in the last state\n",
			gestures, correct, correct_whole);
	return 0;
}
