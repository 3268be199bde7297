#pragma once

namespace steadyhand {

/// How old what a frame shows is taken to be unless it is told: less than optical trackers have, as a cue
/// that comes 15 ms early is noticed, and one that is less than 50 ms late is not.
inline constexpr double USUAL_SENSOR_LATENCY_S = 0.007;

/// The motion that drives vibration, at one instant. Derivatives are those of the curve that is put out, and
/// come of the motion elements, not of noisy samples; they are 0 for the conditions that hold a sample
/// (measured, average, One Euro, Kalman).
struct Motion {
	double value_m = 0.0; ///< 0 at the task's start, the amplitude at its end
	double velocity_m_s = 0.0;
	double acceleration_m_s2 = 0.0;
	double progress =
			0.0; ///< 0..1: phase of the synthesised motion; value / amplitude, clamped, of the others
	/// Part of the acceleration that hides what a frame changes, and is none of the hand's.
	double correction_m_s2 = 0.0;
};

/// How motion is synthesised: by the paper's rule, or from a continuous estimate of phase, speed and
/// amplitude.
enum class MotionMode { PHASE, PAPER };

/// Where the motion comes from: the conditions that a study compares.
enum class MotionSource { SYNTHESISED, MEASURED, AVERAGE, ONE_EURO, KALMAN };

} // namespace steadyhand
