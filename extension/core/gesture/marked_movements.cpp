#include "gesture/marked_movements.h"

#include "gesture/task.h"

#include <algorithm>
#include <cmath>
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

MarkedDirection &direction_of(std::vector<MarkedDirection> &r_directions, const std::string &gesture,
		bool is_radius, const Eigen::Vector3d &axis) {
	for (MarkedDirection &direction : r_directions) {
		const bool is_near = is_radius || direction.axes.normalized().dot(axis) > std::sqrt(0.5);
		if (direction.gesture == gesture && is_near) {
			return direction;
		}
	}
	r_directions.push_back({ gesture, is_radius, Eigen::Vector3d::Zero(), {} });
	return r_directions.back();
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

} // namespace

void add_movement(std::vector<MarkedDirection> &r_directions, const std::string &gesture, bool is_radius,
		const Eigen::Vector3d &axis, const MotionInstants &instants, const MovementSpan &span, int states) {
	MarkedDirection &direction = direction_of(r_directions, gesture, is_radius, axis);
	direction.axes += is_radius ? Eigen::Vector3d::Zero() : axis;
	const int onset = instants.index(span.onset_s), end = instants.index(span.end_s + SETTLED_S);
	const std::optional<HandMotion> at_onset = instants.last_motion(onset);
	if (!at_onset) {
		return;
	}
	MarkedMovement movement{ span.end_s - span.onset_s,
		log_reach_of(*at_onset, instants, onset, end, is_radius), {} };
	for (int early = LATEST_REST; early <= EARLIEST_REST; early += REST_STEP) {
		std::optional<MotionSequence> sequence =
				instants.sequence({ onset - early, onset, end, end + AFTER }, states);
		if (sequence) {
			movement.sequences.push_back(std::move(*sequence));
		}
	}
	if (!movement.sequences.empty()) {
		direction.movements.push_back(std::move(movement));
	}
}

std::vector<MotionSequence> sequences_of(const MarkedDirection &direction) {
	std::vector<MotionSequence> sequences;
	for (const MarkedMovement &movement : direction.movements) {
		sequences.insert(sequences.end(), movement.sequences.begin(), movement.sequences.end());
	}
	return sequences;
}

SymbolSequence symbols_of(const MotionSequence &sequence, const MotionCodebook &codebook) {
	SymbolSequence symbols;
	for (const auto &point : sequence.points) {
		symbols.push_back(point ? codebook.symbol(*point) : UNSEEN);
	}
	return symbols;
}

DirectedCounts counts_of(const MarkedDirection &direction, const MotionCodebook &codebook, int states,
		double least_deviation) {
	DirectedCounts counts;
	counts.axis = direction.axes.normalized();
	counts.is_radius = direction.is_radius;
	counts.transitions = Eigen::MatrixXd::Zero(states, 2);
	counts.symbols = Eigen::MatrixXd::Zero(states, codebook.symbols());
	std::vector<double> logs;
	for (const MarkedMovement &movement : direction.movements) {
		logs.push_back(movement.log_reach);
		for (const MotionSequence &sequence : movement.sequences) {
			const SymbolSequence symbols = symbols_of(sequence, codebook);
			for (std::size_t i = 0; i < symbols.size(); ++i) {
				const int state = sequence.states[i];
				if (symbols[i] != UNSEEN) {
					counts.symbols(state, symbols[i]) += 1.0;
				}
				if (i > 0) {
					const int before = sequence.states[i - 1];
					counts.transitions(before, state > before ? 1 : 0) += 1.0;
				}
			}
		}
	}
	std::ranges::sort(logs);
	const double quartiles = logs[logs.size() * 3 / 4] - logs[logs.size() / 4];
	counts.reach_m = std::exp(logs[logs.size() / 2]);
	counts.reach_deviation = std::max(quartiles / 1.349, least_deviation);
	return counts;
}

} // namespace steadyhand
