#include "simulation/sensor_profile.h"

#include <algorithm>
#include <array>

namespace steadyhand {

namespace {

constexpr std::uint8_t ALL_JOINTS = 0b1111111;
// Thumb, index, middle: the gestures need no more sensors of a Liberty.
constexpr std::uint8_t THREE_TIPS = 0b0000111;

constexpr SensorProfile LEAP_STABLE = {
	.name = "leap_stable",
	.joints = ALL_JOINTS,
	.reports_confidence = true,
	// 15 recordings of leapmotion/leapjs-playback: median 8.66..9.04 ms, 0.7..2.6 % of intervals doubled or
	// more.
	.period_min_s = 8.66e-3,
	.period_max_s = 9.04e-3,
	.jitter_s = 0.08e-3,
	.skip_fraction = 0.015,
	// Manufacturer's value without the display: 10..30 ms.
	.lag_min_s = 0.010,
	.lag_max_s = 0.030,
	.lag_growth_max_s = 0.0,
	// Second differences of resting fingers in the same recordings.
	.noise_m = 0.02e-3,
	.noise_y_m = 0.05e-3,
	// Against motion capture (Ganguly et al. 2021, doi 10.3390/s21051750) 4..11 mm, most of it a constant
	// offset.
	.drift_m = 2e-3,
	.joint_drift_m = 0.5e-3,
	.drift_tau_min_s = 0.5,
	.drift_tau_max_s = 2.0,
	.drift_growth = 0.0,
	// The durations of faults are assumed: there is no source.
	.freeze_per_s = 0.01,
	.freeze_min_s = 0.03,
	.freeze_max_s = 0.10,
	.dropout_per_s = 0.01,
	.dropout_min_s = 0.05,
	.dropout_max_s = 0.20,
	.jump_per_s = 0.02,
	.jump_min_m = 0.010,
	.jump_max_m = 0.030,
	.fault_growth = 0.0,
};

constexpr SensorProfile LEAP_UNSTABLE = [] {
	SensorProfile profile = LEAP_STABLE;
	profile.name = "leap_unstable";
	// Near a surface the rate was 30 % lower, and fewer trials were viable (Tung et al. 2015,
	// doi 10.1088/0967-3334/36/5/1025).
	profile.period_min_s /= 0.7;
	profile.period_max_s /= 0.7;
	profile.skip_fraction = 0.05;
	profile.lag_growth_max_s = 0.22; // 0.25 s in all
	profile.drift_m = 6e-3;
	profile.joint_drift_m = 1e-3;
	profile.drift_growth = 2.0;
	profile.freeze_per_s = 0.15;
	profile.freeze_min_s = 0.05;
	profile.freeze_max_s = 0.30;
	profile.dropout_per_s = 0.15;
	profile.dropout_max_s = 0.50;
	profile.jump_per_s = 0.17;
	profile.jump_max_m = 0.060;
	profile.fault_growth = 2.0;
	return profile;
}();

constexpr SensorProfile LEAP_LOADED = [] {
	SensorProfile profile = LEAP_STABLE;
	profile.name = "leap_loaded";
	profile.skip_fraction = 0.207; // the one recording made on a loaded machine
	return profile;
}();

constexpr SensorProfile OPENXR = [] {
	SensorProfile profile = LEAP_STABLE;
	profile.name = "openxr";
	profile.reports_confidence = false;
	// Sampled once per displayed frame, 60..90 Hz.
	profile.period_min_s = 1.0 / 90.0;
	profile.period_max_s = 1.0 / 60.0;
	profile.jitter_s = 0.3e-3;
	profile.skip_fraction = 0.01;
	// Quest 2: 38..45 ms, fingertip error 1.1 cm (Abdlkarim et al. 2023, doi 10.3758/s13428-022-02051-8).
	profile.lag_min_s = 0.038;
	profile.lag_max_s = 0.045;
	profile.drift_m = 8e-3;
	profile.joint_drift_m = 2e-3;
	profile.freeze_per_s = 0.05; // joints that are valid but not tracked
	profile.freeze_max_s = 0.30;
	profile.dropout_per_s = 0.02;
	profile.dropout_max_s = 0.50;
	return profile;
}();

constexpr SensorProfile LIBERTY = {
	.name = "liberty",
	.joints = THREE_TIPS,
	.reports_confidence = false,
	.period_min_s = 1.0 / 240.0,
	.period_max_s = 1.0 / 240.0,
	.jitter_s = 0.0,
	.skip_fraction = 0.0,
	// Frames need 3.5 ms to the host, but the frame count gives the time of measurement.
	.lag_min_s = 0.0,
	.lag_max_s = 0.0,
	.lag_growth_max_s = 0.0,
	.noise_m = 0.005e-3, // at 0.61 m from its source
	.noise_y_m = 0.005e-3,
	.drift_m = 0.0,
	.joint_drift_m = 0.0,
	.drift_tau_min_s = 1.0,
	.drift_tau_max_s = 1.0,
	.drift_growth = 0.0,
	.freeze_per_s = 0.0,
	.freeze_min_s = 0.0,
	.freeze_max_s = 0.0,
	.dropout_per_s = 0.0,
	.dropout_min_s = 0.0,
	.dropout_max_s = 0.0,
	.jump_per_s = 0.0,
	.jump_min_m = 0.0,
	.jump_max_m = 0.0,
	.fault_growth = 0.0,
};

constexpr std::array<SensorProfile, 5> PROFILES = { LEAP_STABLE, LEAP_UNSTABLE, LEAP_LOADED, OPENXR,
	LIBERTY };

} // namespace

std::span<const SensorProfile> sensor_profiles() {
	return PROFILES;
}

const SensorProfile *find_sensor_profile(std::string_view name) {
	const auto *const found = std::find_if(PROFILES.begin(), PROFILES.end(),
			[name](const SensorProfile &profile) { return profile.name == name; });
	return found == PROFILES.end() ? nullptr : found;
}

} // namespace steadyhand
