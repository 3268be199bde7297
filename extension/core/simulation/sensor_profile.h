#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace steadyhand {

/// Errors of a hand tracker. A "growth" multiplies its quantity by (1 + growth * severity). The severity is 0
/// for a posture that is easy to track, and 1 for the hardest one.
struct SensorProfile {
	std::string_view name;
	std::uint8_t joints; ///< bit i set: reports joint i
	bool reports_confidence;

	// Clock. The period is random, and constant in a recording.
	double period_min_s, period_max_s;
	double jitter_s;      ///< standard deviation of an interval
	double skip_fraction; ///< fraction of intervals of 2, 3 or 4 periods

	// The position is older than the time stamp by a random lag, constant in a recording, plus severity times
	// another random lag of at most lag_growth_max_s.
	double lag_min_s, lag_max_s, lag_growth_max_s;

	// White noise, standard deviation per axis; doubled beyond 25 cm from the sensor.
	double noise_m, noise_y_m;

	// Slow error, standard deviation per axis: of the whole hand, and of each joint relative to it.
	double drift_m, joint_drift_m;
	double drift_tau_min_s, drift_tau_max_s;
	double drift_growth;

	// Faults. Each is a Poisson process; its rate has fault_growth.
	double freeze_per_s, freeze_min_s, freeze_max_s;    ///< repeated positions with new times
	double dropout_per_s, dropout_min_s, dropout_max_s; ///< frames without a hand, or no frames
	double jump_per_s, jump_min_m, jump_max_m;          ///< the whole hand is displaced for 1..10 frames
	double fault_growth;
};

/// leap_stable, leap_unstable, leap_loaded (a busy computer), openxr, liberty.
[[nodiscard]] std::span<const SensorProfile> sensor_profiles();
/// Null if no profile has this name.
[[nodiscard]] const SensorProfile *find_sensor_profile(std::string_view name);

} // namespace steadyhand
