// Cost and accuracy of settings: a line of CSV for each number of hypotheses of `phase` mode, and for `paper`
// mode with several numbers of states and symbols, decoders, precisions and output rates.
//
//     bench_quality [MODELS [TRIALS]]
//
// MODELS: folder of the models (default: models). TRIALS: a trial set (default: synthetic people of the
// tuning population).

#include "metrics/recognition.h"
#include "metrics/summary.h"
#include "models.h"
#include "quality_settings.h"
#include "recogniser_of.h"
#include "recognition/gesture_recogniser.h"
#include "shown_changes.h"
#include "timing.h"
#include "trained_models.h"
#include "trials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace {

using namespace steadyhand;
using namespace steadyhand::bench;

constexpr int ROUNDS = 21;

struct Accuracy {
	double r2_stable, r2_unstable; ///< mean zero-lag R2
	double t_diff_s;               ///< mean |T_diff|
	double missed, recognised;     ///< fractions of the trials
	double alarms_per_minute;
};

class Study {
public:
	/// models: by number of states and symbols.
	Study(std::map<std::pair<int, int>, Models> models, std::vector<SyntheticTrial> trials) :
			models_(std::move(models)) {
		for (SyntheticTrial &trial : trials) {
			const auto known = std::find(GESTURES.begin(), GESTURES.end(), trial.trial.gesture);
			const auto gesture = static_cast<std::size_t>(known - GESTURES.begin());
			(gesture < GESTURES.size() ? trials_[gesture] : nothing_).push_back(std::move(trial));
		}
	}

	/// Time for a frame and its outputs, ns, for one gesture with a task, over the first trials of each
	/// gesture.
	[[nodiscard]] double cost_ns(const Setting &setting) const {
		constexpr std::size_t TRIALS = 2;
		double ns = 0.0;
		std::size_t frames = 0;
		for (std::size_t g = 0; g < trials_.size(); ++g) {
			for (std::size_t i = 0; i < std::min(TRIALS, trials_[g].size()); ++i) {
				const SyntheticTrial &trial = trials_[g][i];
				GestureRecogniser recogniser({ { models_of(setting)[g], task_of(trial) } },
						{ setting.mode, setting.hypotheses, 0.0, setting.decoding });
				ns += ns_of([&] {
					replay(trial, recogniser, setting.outputs_per_s,
							[&](double) { keep(recogniser.motion(MotionSource::SYNTHESISED)); });
				});
				frames += trial.measured.frames.size();
			}
		}
		return ns / static_cast<double>(frames);
	}

	[[nodiscard]] Accuracy accuracy(const Setting &setting) const {
		std::vector<double> stable, unstable, t_diff;
		std::size_t missed = 0, recognised = 0, alarms = 0, trials = 0;
		for (std::size_t g = 0; g < trials_.size(); ++g) {
			for (const SyntheticTrial &trial : trials_[g]) {
				const CurveComparison compared = compare(trial, g, setting);
				(trial.trial.position == HandPosition::STABLE ? stable : unstable)
						.push_back(compared.r2_zero);
				t_diff.push_back(std::abs(compared.t_diff_s));
				missed += compared.missed ? 1 : 0;
				const std::vector<int> found = ended(trial, setting);
				recognised += !found.empty() && found.back() == static_cast<int>(g) ? 1 : 0;
				++trials;
			}
		}
		double idle_s = 0.0;
		for (const SyntheticTrial &trial : nothing_) {
			alarms += ended(trial, setting).size();
			idle_s += trial.measured.frames.back().t_s - grid_of(trial).t0_s;
		}
		const auto count = static_cast<double>(trials);
		return { mean(stable), mean(unstable), mean(t_diff), static_cast<double>(missed) / count,
			static_cast<double>(recognised) / count, false_alarms_per_minute(alarms, idle_s) };
	}

private:
	std::map<std::pair<int, int>, Models> models_;
	std::array<std::vector<SyntheticTrial>, GESTURES.size()> trials_;
	std::vector<SyntheticTrial> nothing_;

	[[nodiscard]] const Models &models_of(const Setting &setting) const {
		return models_.at({ setting.states, setting.symbols });
	}

	/// Comparison with a task.
	[[nodiscard]] CurveComparison compare(
			const SyntheticTrial &trial, std::size_t gesture, const Setting &setting) const {
		GestureRecogniser recogniser({ { models_of(setting)[gesture], task_of(trial) } },
				{ setting.mode, setting.hypotheses, 0.0, setting.decoding });
		return compare_replay(trial, *models_of(setting)[gesture], recogniser, setting.outputs_per_s);
	}

	/// Gestures that ended, with all models active and without a task.
	[[nodiscard]] std::vector<int> ended(const SyntheticTrial &trial, const Setting &setting) const {
		GestureRecogniser recogniser = test::recogniser_of(models_of(setting), std::nullopt,
				{ setting.mode, setting.hypotheses, 0.0, setting.decoding });
		std::vector<int> found;
		test::ShownChanges shown;
		for (const HandFrame &frame : trial.measured.frames) {
			recogniser.push(frame);
			if (shown.next(recogniser).ended) {
				found.push_back(recogniser.gesture());
			}
		}
		return found;
	}
};

} // namespace

int main(int count, char **arguments) {
	Models models = read_models(count > 1 ? arguments[1] : "models");
	if (models.empty()) {
		return 1;
	}
	std::vector<SyntheticTrial> trials = count > 2 ? read_trials(arguments[2]) : tuning_trials(8, 2, { 1.0 });
	if (trials.empty()) {
		return 1;
	}
	const std::vector<SyntheticTrial> training = training_trials();
	std::map<std::pair<int, int>, Models> by_size;
	for (const auto &[states, symbols] : MODEL_SIZES) {
		by_size[{ states, symbols }] = train_models(models, training, states, symbols);
		if (by_size[{ states, symbols }].empty()) {
			return 1;
		}
	}
	by_size[{ Setting().states, Setting().symbols }] = std::move(models);
	const Study study(std::move(by_size), std::move(trials));
	std::vector<Setting> all = paper_settings();
	for (Setting &setting : phase_settings()) {
		all.push_back(std::move(setting));
	}
	std::vector<std::vector<double>> ns(all.size());
	for (int round = 0; round < ROUNDS; ++round) {
		for (std::size_t i = 0; i < all.size(); ++i) {
			ns[i].push_back(study.cost_ns(all[i]));
		}
	}
	std::printf("setting,states,symbols,decoder,lag,precision,hypotheses,outputs_per_s,"
				"ns_a_frame,x_paper,r2_zero_stable,r2_zero_unstable,t_diff_s,missed,recognised,"
				"false_alarms_per_minute\n");
	for (std::size_t i = 0; i < all.size(); ++i) {
		const Setting &setting = all[i];
		const bool is_phase = setting.mode == MotionMode::PHASE;
		const Accuracy accuracy = study.accuracy(setting);
		std::printf("%s,%d,%d,%s,%d,%s,%zu,%g,%.0f,%.3f,%.5f,%.5f,%.4f,%.4f,%.4f,%.3f\n",
				setting.name.c_str(), setting.states, setting.symbols,
				setting.decoding.rule == StateDecoding::Rule::FILTER ? "filter" : "viterbi",
				setting.decoding.lag,
				setting.decoding.precision == StateDecoding::Precision::SINGLE ? "float" : "double",
				is_phase ? setting.hypotheses : 0, setting.outputs_per_s, least(ns[i]),
				least(ns[i]) / least(ns.front()), accuracy.r2_stable, accuracy.r2_unstable, accuracy.t_diff_s,
				accuracy.missed, accuracy.recognised, accuracy.alarms_per_minute);
	}
	return 0;
}
