#pragma once

#include "gesture/directed_hmm.h"
#include "gesture/task.h"
#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "signal/polynomial.h"

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// Piece of the reference curve for one state of the HMM (paper, "The definition of primitive motion
/// elements"), and the duration of the state.
struct PrimitiveMotionElement {
	double phase_begin = 0.0; ///< of the reference curve, 0..1
	double phase_end = 1.0;
	Polynomial curve; ///< normalised value over the element's own time, 0..1
	/// Standard deviation of the recordings about the reference curve, mean over the element.
	double deviation = 0.0;
	double duration_mean_s = 0.0; ///< of the state in the training recordings (Viterbi alignment)
	double duration_deviation_s = 0.0;
};

/// Origin of a model, so that it can be trained again.
struct Provenance {
	std::string trial_set;            ///< name given to the trainer
	std::string trained_with;         ///< program and version
	std::vector<std::string> dropped; ///< unusable recordings, and those below r2_threshold
	int recordings = 0;               ///< number of kept recordings
	double r2_threshold = 0.0;        ///< T_h
	std::vector<double> objective;    ///< Baum-Welch, for each iteration (nats)
};

/// Longest duration of a gesture or an element. If it is longer, stamps have another unit.
inline constexpr double LONGEST_GESTURE_S = 3600.0;

/// Limit of |value| of a gesture's curve, in amplitudes. The end of a gesture is at 1.
inline constexpr double FARTHEST_VALUE = 2.0;

/// Least length of an element in phase: the distance of two points of the reference curve.
inline constexpr double SHORTEST_ELEMENT = 0.01;

/// One trained gesture: all that recognition and synthesis need, independent of a scene.
struct GestureModel {
	std::string gesture;
	std::string feature;
	Task typical_task; ///< mean of the recordings' tasks; used without a task
	/// Further recorded directions, unit vectors, such as a drag to the left. Without a task the gesture may
	/// have any of them, or typical_task.axis.
	std::vector<Eigen::Vector3d> other_axes;
	double duration_mean_s = 1.0; ///< of the whole movement
	double duration_deviation_s = 0.0;
	Eigen::VectorXd reference_mean; ///< CURVE_POINTS over phase 0..1, normalised value
	Eigen::VectorXd reference_deviation;
	VectorQuantiser quantiser;
	DiscreteHmm hmm;
	std::vector<PrimitiveMotionElement> elements; ///< one for each state, in order
	/// Counts over the codebook of own_classifier(), for each recorded direction, and the HMMs from them.
	/// They recognise the gesture without a task, in place of those of own_classifier(). May be empty.
	std::vector<DirectedCounts> recorded_counts;
	std::vector<DirectedHmm> recorded_hmms;
	Provenance provenance;
};

/// Why a gesture must not have this name, as the rest of a sentence; empty if it may. The name must be valid
/// as a file name, and must not be NO_GESTURE.
[[nodiscard]] std::string_view gesture_name_fault(std::string_view gesture);

/// Value and derivatives with respect to phase of the primitive motion elements at a phase (clamped to 0..1).
struct CurvePoint {
	double value = 0.0;
	double slope = 0.0;     ///< d value / d phase
	double curvature = 0.0; ///< d2 value / d phase2
};
CurvePoint evaluate(const GestureModel &model, double phase);

/// evaluate(), continued beyond phase 1: the slope decays exponentially, so the hand comes to rest beyond the
/// end. Value and slope are continuous from phase 0 on. 0 before the start.
CurvePoint evaluate_onwards(const GestureModel &model, double phase);

/// Phase in which evaluate_onwards() reduces the end slope to 1/e.
inline constexpr double RUN_OUT = 0.06;

/// Smallest phase at which the reference curve reaches the value; 0 below its start, 1 beyond its end.
double phase_of_value(const GestureModel &model, double value);

} // namespace steadyhand
