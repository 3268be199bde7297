#pragma once

#include "gesture/task.h"
#include "gesture/vector_quantiser.h"
#include "hmm/discrete_hmm.h"
#include "signal/polynomial.h"

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace steadyhand {

/// What a state sounds and looks like: the piece of the reference curve that is played out while it lasts
/// (paper, "The definition of primitive motion elements"), and how long that is.
struct PrimitiveMotionElement {
	double phase_begin = 0.0; ///< of the reference curve, 0..1
	double phase_end = 1.0;
	Polynomial curve; ///< normalised value over the element's own time, 0..1
	double deviation =
			0.0; ///< standard deviation of the recordings about the reference, mean over the element
	double duration_mean_s = 0.0; ///< of the state in the training recordings (Viterbi alignment)
	double duration_deviation_s = 0.0;
};

/// Where a model came from, so that it can be made again.
struct Provenance {
	std::string trial_set;            ///< as the trainer was told
	std::string trained_with;         ///< program and version
	std::vector<std::string> dropped; ///< recordings under r2_threshold
	int recordings = 0;               ///< kept ones
	double r2_threshold = 0.0;        ///< T_h
	std::vector<double> objective;    ///< Baum-Welch, per iteration (nats)
};

/// No gesture takes longer, nor an element of one: stamps are of another unit.
inline constexpr double LONGEST_GESTURE_S = 3600.0;

/// No motion of a gesture goes further, either way, in amplitudes: its end is at 1.
inline constexpr double FARTHEST_VALUE = 2.0;

/// No element of the reference curve is shorter, in phase: between two of its points there is nothing to fit.
inline constexpr double SHORTEST_ELEMENT = 0.01;

/// One trained gesture: all that recognition and synthesis need, and nothing of a scene.
struct GestureModel {
	std::string gesture;
	std::string feature;
	Task typical_task; ///< mean axis and amplitude of the recordings: stands in where a scene gives none
	/// Unit vectors: directions of the recordings beside typical_task.axis, as of a drag to the left and a
	/// tap down. Without a task each of them is the gesture's.
	std::vector<Eigen::Vector3d> other_axes;
	double duration_mean_s = 1.0; ///< of the whole movement
	double duration_deviation_s = 0.0;
	Eigen::VectorXd reference_mean; ///< CURVE_POINTS over phase 0..1, normalised value
	Eigen::VectorXd reference_deviation;
	VectorQuantiser quantiser;
	DiscreteHmm hmm;
	std::vector<PrimitiveMotionElement> elements; ///< one per state, in order
	Provenance provenance;
};

/// Why no model may be of a gesture of that name, as the rest of a sentence; empty where one may: the name
/// must be fit for a file, and it must not be NO_GESTURE.
[[nodiscard]] std::string_view gesture_name_fault(std::string_view gesture);

/// Value and derivatives with respect to phase of the primitive motion elements at a phase (clamped to 0..1).
struct CurvePoint {
	double value = 0.0;
	double slope = 0.0;     ///< d value / d phase
	double curvature = 0.0; ///< d2 value / d phase2
};
CurvePoint evaluate(const GestureModel &model, double phase);

/// The same, and on beyond the end of the task: a hand that gets there with some speed comes to rest a little
/// further on. Value and slope are continuous for every phase; 0 before the start.
CurvePoint evaluate_onwards(const GestureModel &model, double phase);

/// Phase in which the speed at the end falls to 1/e.
inline constexpr double RUN_OUT = 0.06;

/// The smallest phase at which the reference reaches the value; 0 below its start, 1 beyond its end.
double phase_of_value(const GestureModel &model, double value);

} // namespace steadyhand
