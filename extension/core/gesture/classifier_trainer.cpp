#include "gesture/classifier_trainer.h"

#include "gesture/marked_movements.h"
#include "gesture/motion_sequences.h"
#include "gesture/recorded_movements.h"
#include "tracking/trial_set.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <utility>

namespace steadyhand {
namespace {

/// Other motion: interval of the assumed onsets, and length of the sequences from there.
constexpr int OTHER_STEP = 20, OTHER_LENGTH = 150; // symbols
/// Most points that the codebook is trained with.
constexpr std::size_t MOST_POINTS = 8000;
constexpr int CODEBOOK_ITERATIONS = 10, OTHER_ITERATIONS = 10;

void add(std::vector<MotionSequence> &r_sequences, std::optional<MotionSequence> sequence) {
	if (sequence) {
		r_sequences.push_back(std::move(*sequence));
	}
}

void add_other(std::vector<MotionSequence> &r_sequences, const MotionInstants &instants) {
	for (int begin = 0; begin < instants.size(); begin += OTHER_STEP) {
		add(r_sequences,
				instants.sequence({ begin, begin + 1, begin + 2, begin + OTHER_LENGTH }, END_STATES + 2));
	}
}

std::vector<SymbolSequence> symbols_of(
		std::span<const MotionSequence> sequences, const MotionCodebook &codebook) {
	std::vector<SymbolSequence> symbols;
	symbols.reserve(sequences.size());
	for (const MotionSequence &sequence : sequences) {
		symbols.push_back(symbols_of(sequence, codebook));
	}
	return symbols;
}

std::vector<MotionObservation> points_of(std::span<const MotionSequence> sequences, std::size_t most) {
	std::vector<MotionObservation> all, some;
	for (const MotionSequence &sequence : sequences) {
		for (const auto &point : sequence.points) {
			if (point) {
				all.push_back(*point);
			}
		}
	}
	const std::size_t step = all.size() / most + 1;
	for (std::size_t i = 0; i < all.size(); i += step) {
		some.push_back(all[i]);
	}
	return some;
}

/// Divides each direction into groups of equal size by duration, without empty ones.
std::vector<MarkedDirection> divided_by_pace(std::vector<MarkedDirection> directions, std::size_t paces) {
	std::vector<MarkedDirection> divided;
	for (MarkedDirection &direction : directions) {
		std::vector<MarkedMovement> &movements = direction.movements;
		std::ranges::stable_sort(movements, {}, &MarkedMovement::duration_s);
		for (std::size_t k = 0; k < paces; ++k) {
			const std::size_t first = k * movements.size() / paces, end = (k + 1) * movements.size() / paces;
			if (first < end) {
				const auto begin = std::make_move_iterator(movements.begin());
				divided.push_back({ direction.gesture, direction.is_radius, direction.axes,
						{ begin + static_cast<std::ptrdiff_t>(first),
								begin + static_cast<std::ptrdiff_t>(end) } });
			}
		}
	}
	return divided;
}

/// Ergodic HMM of other motion by Baum-Welch. Initially each state prefers one part of the sorted codebook.
DiscreteHmm other_hmm(const std::vector<MotionSequence> &sequences, const Eigen::RowVectorXd &common,
		const MotionCodebook &codebook, const ClassifierTrainingOptions &options) {
	const int states = options.other_states, symbols = codebook.symbols();
	constexpr double STAY = 0.9, OWN = 4.0; // initial self-transition; factor of preferred symbols
	Eigen::MatrixXd a = Eigen::MatrixXd::Constant(states, states, (1.0 - STAY) / std::max(states - 1, 1));
	a.diagonal().setConstant(states > 1 ? STAY : 1.0);
	Eigen::MatrixXd b = common.replicate(states, 1);
	for (int k = 0; k < symbols; ++k) {
		b(k * states / symbols, k) *= OWN;
	}
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::VectorXd::Constant(states, -std::log(states));
	hmm.log_a = a.array().log();
	hmm.log_b = (b.array().colwise() / b.rowwise().sum().array()).log();
	BaumWelchOptions training;
	training.max_iterations = OTHER_ITERATIONS;
	return baum_welch(std::move(hmm), symbols_of(sequences, codebook), training).hmm;
}

} // namespace

Result<ClassifierModel> train_classifier(
		std::span<const ClassifierRecording> recordings, const ClassifierTrainingOptions &options) {
	std::vector<MarkedDirection> directions;
	std::vector<MotionSequence> other;
	for (const ClassifierRecording &recording : recordings) {
		if (recording.recording.measured.frames.empty()) {
			continue;
		}
		const MotionInstants instants(recording.recording.measured);
		add_other(other, instants);
		if (recording.gesture == NO_GESTURE) {
			continue;
		}
		const Feature *const feature = find_feature(recording.feature);
		if (feature == nullptr) {
			return Error{ "there is no feature '" + recording.feature + "'" };
		}
		const Result<RecordedMovements> recorded =
				recorded_movements(*feature, std::span(&recording.recording, 1));
		if (!recorded) {
			continue;
		}
		add_movement(directions, recording.gesture, feature->is_radius, recording.recording.task.axis,
				instants, recorded.value().movements.front().span, options.states);
	}
	std::erase_if(directions, [](const MarkedDirection &direction) { return direction.movements.empty(); });
	if (directions.empty()) {
		return Error{ "there is no usable recording of a gesture" };
	}
	directions = divided_by_pace(std::move(directions), options.paces);

	std::vector<MotionObservation> points = points_of(other, MOST_POINTS / 2);
	for (const MarkedDirection &direction : directions) {
		const std::vector<MotionObservation> own =
				points_of(sequences_of(direction), MOST_POINTS / 2 / directions.size());
		points.insert(points.end(), own.begin(), own.end());
	}
	ClassifierModel model;
	model.codebook = MotionCodebook::trained(points, options.symbols, {}, CODEBOOK_ITERATIONS);

	Eigen::RowVectorXd common = Eigen::RowVectorXd::Ones(options.symbols);
	for (const MotionSequence &sequence : other) {
		for (const Symbol symbol : symbols_of(sequence, model.codebook)) {
			if (symbol != UNSEEN) {
				common(symbol) += 1.0;
			}
		}
	}
	common /= common.sum();
	model.other = other_hmm(other, common, model.codebook, options);

	for (const MarkedDirection &direction : directions) {
		const DirectedCounts counts = counts_of(direction, model.codebook, options.states,
				direction.is_radius ? options.reach_deviation_radius : options.reach_deviation);
		model.gestures.push_back(directed_hmm(direction.gesture, counts, common, options.odd_symbols));
	}
	return model;
}

} // namespace steadyhand
