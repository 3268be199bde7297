#pragma once

namespace steadyhand {

/// Default of the tracker's latency. Optical trackers have more. People notice a cue that is 15 ms early, but
/// not one that is up to 50 ms late.
inline constexpr double USUAL_SENSOR_LATENCY_S = 0.007;

/// The motion that drives vibration, at one instant. The derivatives are exact derivatives of the output
/// curve. They are 0 for the sources that hold a sample between frames (measured, average, One Euro, Kalman).
struct Motion {
	double value_m = 0.0; ///< 0 at the task's start, the amplitude at its end
	double velocity_m_s = 0.0;
	double acceleration_m_s2 = 0.0;
	/// 0..1: the phase if the motion is synthesised, otherwise value / amplitude.
	double progress = 0.0;
	/// Part of the acceleration that only blends corrections at frames, and is not the hand's.
	double correction_m_s2 = 0.0;
};

/// How motion is synthesised. PAPER: element by element, by the states of the HMM. PHASE: from a continuous
/// estimate of phase, speed and amplitude.
enum class MotionMode { PHASE, PAPER };

/// Source of the motion: the conditions that a study compares.
enum class MotionSource { SYNTHESISED, MEASURED, AVERAGE, ONE_EURO, KALMAN };

} // namespace steadyhand
