#pragma once

#include "gesture/directed_hmm.h"
#include "gesture/motion_sequences.h"
#include "gesture/reference_curve.h"
#include "gesture/vector_quantiser.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace steadyhand {

/// A recorded movement of a gesture whose onset and end are known.
struct MarkedMovement {
	double duration_s = 0.0;
	double log_reach = 0.0; ///< natural logarithm of DirectedHmm::reach_m
	/// Begin at several times before the onset.
	std::vector<MotionSequence> sequences;
};

/// Movements of one gesture in one direction.
struct MarkedDirection {
	std::string gesture;
	bool is_radius = false;
	Eigen::Vector3d axes = Eigen::Vector3d::Zero(); ///< sum of the recordings' axes; zero if is_radius
	std::vector<MarkedMovement> movements;
};

/// Adds the movement to its gesture's direction within 45 degrees, or to a new one. If the hand is not
/// tracked near the onset, only the axis is added. axis: unit vector. states: of the HMM.
void add_movement(std::vector<MarkedDirection> &r_directions, const std::string &gesture, bool is_radius,
		const Eigen::Vector3d &axis, const MotionInstants &instants, const MovementSpan &span, int states);

[[nodiscard]] std::vector<MotionSequence> sequences_of(const MarkedDirection &direction);

[[nodiscard]] SymbolSequence symbols_of(const MotionSequence &sequence, const MotionCodebook &codebook);

/// least_deviation: of DirectedHmm::reach_deviation.
[[nodiscard]] DirectedCounts counts_of(
		const MarkedDirection &direction, const MotionCodebook &codebook, int states, double least_deviation);

} // namespace steadyhand
