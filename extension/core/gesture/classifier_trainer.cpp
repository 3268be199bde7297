#include "gesture/classifier_trainer.h"

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

/// Sequences of a gesture begin at these times before its onset.
constexpr int LATEST_REST = 5, EARLIEST_REST = 20, REST_STEP = 5; // symbols
/// Time from the end to the END_STATES. By then a hand that strikes has reversed, and a hand that continues
/// has moved away. AFTER: length of the sequences from there.
constexpr double SETTLED_S = 0.12;
constexpr int AFTER = 40; // symbols
/// Other motion: interval of the assumed onsets, and length of the sequences from there.
constexpr int OTHER_STEP = 20, OTHER_LENGTH = 150; // symbols
/// Most points that the codebook is trained with.
constexpr std::size_t MOST_POINTS = 8000;
constexpr int CODEBOOK_ITERATIONS = 10, OTHER_ITERATIONS = 10;
constexpr PseudoCounts PSEUDO;
/// Initial probability of each later state. Not 0, because ScaledRecursion would renormalise at each symbol.
constexpr double LATE = 1e-9;

struct MarkedMovement {
	double duration_s = 0.0;
	double log_reach = 0.0;
	std::vector<MotionSequence> sequences;
};

struct Direction {
	DirectedHmm model;
	Eigen::Vector3d axes = Eigen::Vector3d::Zero();
	std::vector<MarkedMovement> movements;
};

Direction &direction_of(
		std::vector<Direction> &r_directions, const ClassifierRecording &recording, bool is_radius) {
	const Eigen::Vector3d axis = is_radius ? Eigen::Vector3d::Zero() : recording.recording.task.axis;
	for (Direction &direction : r_directions) {
		const bool is_near = is_radius || direction.axes.normalized().dot(axis) > std::sqrt(0.5);
		if (direction.model.gesture == recording.gesture && is_near) {
			return direction;
		}
	}
	Direction &added = r_directions.emplace_back();
	added.model.gesture = recording.gesture;
	added.model.is_radius = is_radius;
	return added;
}

void add(std::vector<MotionSequence> &r_sequences, std::optional<MotionSequence> sequence) {
	if (sequence) {
		r_sequences.push_back(std::move(*sequence));
	}
}

/// ln of the greatest distance, or growth of the radius, between two instants.
double log_reach_of(
		const HandMotion &at_onset, const MotionInstants &instants, int onset, int end, bool is_radius) {
	MotionObserver observer(at_onset);
	for (int i = onset + 1; i <= end; ++i) {
		if (const std::optional<HandMotion> motion = instants.last_motion(i)) {
			observer.observe(*motion);
		}
	}
	const double reach_m = is_radius ? observer.growth_m() : observer.farthest_m().norm();
	return std::log(std::max(reach_m, SMALLEST_AMPLITUDE_M));
}

void add_other(std::vector<MotionSequence> &r_sequences, const MotionInstants &instants) {
	for (int begin = 0; begin < instants.size(); begin += OTHER_STEP) {
		add(r_sequences,
				instants.sequence({ begin, begin + 1, begin + 2, begin + OTHER_LENGTH }, END_STATES + 2));
	}
}

SymbolSequence symbols_of(const MotionSequence &sequence, const MotionCodebook &codebook) {
	SymbolSequence symbols;
	for (const auto &point : sequence.points) {
		symbols.push_back(point ? codebook.symbol(*point) : UNSEEN);
	}
	return symbols;
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

std::vector<MotionSequence> sequences_of(const Direction &direction) {
	std::vector<MotionSequence> sequences;
	for (const MarkedMovement &movement : direction.movements) {
		sequences.insert(sequences.end(), movement.sequences.begin(), movement.sequences.end());
	}
	return sequences;
}

/// Divides each direction into groups of equal size by duration, without empty ones.
std::vector<Direction> divided_by_pace(std::vector<Direction> directions, std::size_t paces) {
	std::vector<Direction> divided;
	for (Direction &direction : directions) {
		std::vector<MarkedMovement> &movements = direction.movements;
		std::ranges::stable_sort(movements, {}, &MarkedMovement::duration_s);
		for (std::size_t k = 0; k < paces; ++k) {
			const std::size_t first = k * movements.size() / paces, end = (k + 1) * movements.size() / paces;
			if (first < end) {
				const auto begin = std::make_move_iterator(movements.begin());
				divided.push_back({ direction.model, direction.axes,
						{ begin + static_cast<std::ptrdiff_t>(first),
								begin + static_cast<std::ptrdiff_t>(end) } });
			}
		}
	}
	return divided;
}

/// Left-right without skips, by counting in the marked states.
DiscreteHmm left_right(const std::vector<MotionSequence> &sequences,
		const std::vector<SymbolSequence> &symbols, int states, int n_symbols) {
	Eigen::MatrixXd a = Eigen::MatrixXd::Zero(states, states);
	Eigen::MatrixXd b = Eigen::MatrixXd::Constant(states, n_symbols, PSEUDO.symbol);
	for (int i = 0; i < states; ++i) {
		a(i, i) = PSEUDO.transition;
		if (i + 1 < states) {
			a(i, i + 1) = PSEUDO.transition;
		}
	}
	for (std::size_t s = 0; s < sequences.size(); ++s) {
		for (std::size_t i = 0; i < symbols[s].size(); ++i) {
			const int state = sequences[s].states[i];
			if (symbols[s][i] != UNSEEN) {
				b(state, symbols[s][i]) += 1.0;
			}
			if (i > 0) {
				const int before = sequences[s].states[i - 1];
				a(before, before + (state > before ? 1 : 0)) += 1.0;
			}
		}
	}
	DiscreteHmm hmm;
	hmm.log_pi = Eigen::VectorXd::Constant(states, std::log(LATE));
	hmm.log_pi(0) = std::log1p(-(states - 1) * LATE);
	hmm.log_a = (a.array().colwise() / a.rowwise().sum().array()).log();
	hmm.log_b = (b.array().colwise() / b.rowwise().sum().array()).log();
	return hmm;
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
	std::vector<Direction> directions;
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
		const MovementSpan span = recorded.value().movements.front().span;
		Direction &direction = direction_of(directions, recording, feature->is_radius);
		direction.axes += feature->is_radius ? Eigen::Vector3d::Zero() : recording.recording.task.axis;
		const int onset = instants.index(span.onset_s), end = instants.index(span.end_s + SETTLED_S);
		const std::optional<HandMotion> at_onset = instants.last_motion(onset);
		if (!at_onset) {
			continue;
		}
		MarkedMovement movement{ span.end_s - span.onset_s,
			log_reach_of(*at_onset, instants, onset, end, feature->is_radius), {} };
		for (int early = LATEST_REST; early <= EARLIEST_REST; early += REST_STEP) {
			add(movement.sequences,
					instants.sequence({ onset - early, onset, end, end + AFTER }, options.states));
		}
		if (!movement.sequences.empty()) {
			direction.movements.push_back(std::move(movement));
		}
	}
	std::erase_if(directions, [](const Direction &direction) { return direction.movements.empty(); });
	if (directions.empty()) {
		return Error{ "there is no usable recording of a gesture" };
	}
	directions = divided_by_pace(std::move(directions), options.paces);

	std::vector<MotionObservation> points = points_of(other, MOST_POINTS / 2);
	for (const Direction &direction : directions) {
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

	for (Direction &direction : directions) {
		const std::vector<MotionSequence> sequences = sequences_of(direction);
		DiscreteHmm hmm =
				left_right(sequences, symbols_of(sequences, model.codebook), options.states, options.symbols);
		hmm.log_b = ((1.0 - options.odd_symbols) * hmm.log_b.array().exp() +
				options.odd_symbols * common.array().replicate(options.states, 1))
							.log();
		direction.model.axis = direction.axes.normalized();
		direction.model.hmm = std::move(hmm);
		std::vector<double> logs;
		std::ranges::transform(direction.movements, std::back_inserter(logs), &MarkedMovement::log_reach);
		std::ranges::sort(logs);
		const double median = logs[logs.size() / 2];
		const double quartiles = logs[logs.size() * 3 / 4] - logs[logs.size() / 4];
		direction.model.reach_m = std::exp(median);
		direction.model.reach_deviation = std::max(quartiles / 1.349,
				direction.model.is_radius ? options.reach_deviation_radius : options.reach_deviation);
		model.gestures.push_back(std::move(direction.model));
	}
	return model;
}

} // namespace steadyhand
