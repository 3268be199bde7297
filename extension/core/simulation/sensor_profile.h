#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace steadyhand {

/// How a hand tracker errs. What "grows" is times (1 + growth * severity), severity being 0 where the posture
/// is easy to track and 1 at its hardest.
struct SensorProfile {
	std::string_view name;
	std::uint8_t joints; ///< bit i set: reports joint i
	bool reports_confidence;

	// Clock. The period is drawn once a recording.
	double period_min_s, period_max_s;
	double jitter_s;      ///< deviation of an interval
	double skip_fraction; ///< of intervals that are 2, 3 or 4 periods long

	// Content is older than the stamp by a lag drawn once a recording, plus severity times another that is
	// drawn up to `lag_growth_max_s`.
	double lag_min_s, lag_max_s, lag_growth_max_s;

	// White noise, deviation per axis; doubled beyond 25 cm from the sensor.
	double noise_m, noise_y_m;

	// Slow error, deviation per axis: of the whole hand, and of each joint beside it.
	double drift_m, joint_drift_m;
	double drift_tau_min_s, drift_tau_max_s;
	double drift_growth;

	// Faults, each a Poisson process whose rate grows.
	double freeze_per_s, freeze_min_s, freeze_max_s;    ///< the position repeats while time goes on
	double dropout_per_s, dropout_min_s, dropout_max_s; ///< no hand: empty cells or no frames
	double jump_per_s, jump_min_m, jump_max_m;          ///< whole hand elsewhere for 1..10 frames
	double fault_growth;
};

/// leap_stable, leap_unstable, leap_loaded (a busy computer), openxr, liberty.
[[nodiscard]] std::span<const SensorProfile> sensor_profiles();
/// Null where there is none of that name.
[[nodiscard]] const SensorProfile *find_sensor_profile(std::string_view name);

} // namespace steadyhand
