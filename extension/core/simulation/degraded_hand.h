#pragma once

#include "base/random.h"
#include "simulation/drift.h"
#include "tracking/hand_skeleton.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace steadyhand {

/// Faults that DegradedHand adds. A field that is 0, negative or not finite is off. A fault needs a rate, at
/// most 6000 per minute, and a duration.
struct DegradeSettings {
	double dropouts_per_minute = 0.0;
	double dropout_s = 0.0;           ///< duration of a dropout, s
	bool dropouts_are_silent = false; ///< true: a dropout has no frames; false: frames without a hand

	double freezes_per_minute = 0.0;
	double freeze_s = 0.0; ///< time for which the last pose is repeated with new time stamps, s

	double jumps_per_minute = 0.0;
	double jump_m = 0.0; ///< displacement in a random direction, m
	double jump_s = 0.0; ///< duration, s

	double drift_m = 0.0; ///< slow error: standard deviation on each axis, m
	double drift_s = 0.0; ///< its time constant, s; 0: 1 s

	double latency_s = 0.0;  ///< the frame at t has the hand of t - latency_s; at most 2 s
	double rate_hz = 0.0;    ///< greatest frame rate; 0: all frames
	double rounding_m = 0.0; ///< positions are rounded to multiples of it, m
	double noise_m = 0.0;    ///< white noise: standard deviation on each axis of each joint, m

	std::uint64_t seed = 0;
};

/// Faults of a Leap in the paper's "stable" or "unstable" position: means of the sensor profile leap_stable
/// or leap_unstable at a severity of 0.5. nullopt for another name.
[[nodiscard]] std::optional<DegradeSettings> degrade_preset(std::string_view name);

/// Adds tracker faults to frames without faults. Faults are Poisson processes on the frame times, from the
/// first frame on. Equal frames and settings give equal results to the last bit. A result depends only on
/// earlier frames. Each kind of fault has its own random numbers, so that one kind does not change another.
/// Hand and skeleton get the same faults. Only the constructor allocates.
class DegradedHand {
public:
	explicit DegradedHand(const DegradeSettings &settings);

	/// The degraded frame, with the time stamps of `frame`; nullopt if it is not delivered. Frames must be in
	/// the order of `hand.t_s`, which must be finite. With a latency the first frames are not delivered.
	std::optional<DeviceFrame> apply(const DeviceFrame &frame);

private:
	/// Times of one kind of fault.
	class Faults {
	public:
		Faults(double per_minute, double length_s, std::uint64_t seed);

		/// Advances to t_s. True if a fault has begun since the last call.
		bool advance(double t_s);
		[[nodiscard]] bool is_on(double t_s) const { return t_s < until_s_; }
		Random &random() { return random_; }

	private:
		double per_s_;
		double length_s_;
		Random random_;
		double last_s_ = 0.0;
		double next_s_ = 0.0;
		double until_s_;
		bool is_started_ = false;
	};

	[[nodiscard]] bool is_above_rate(double t_s);
	/// The frame latency_s before `frame`, interpolated; null if no frame is that old.
	const DeviceFrame *delayed(const DeviceFrame &frame);
	void displace(double t_s, DeviceFrame &r_frame);
	void add_noise(DeviceFrame &r_frame);
	void round_positions(DeviceFrame &r_frame) const;

	DegradeSettings settings_;
	Faults dropouts_, freezes_, jumps_;
	Random drift_random_, noise_random_;
	std::array<Drift, 3> drift_;
	Eigen::Vector3d jump_m_ = Eigen::Vector3d::Zero();
	std::array<Eigen::Vector3d, SKELETON_JOINT_COUNT> noise_m_{};

	std::vector<DeviceFrame> history_; ///< ring of the frames since t - latency_s, and the one before
	std::size_t oldest_ = 0;
	std::size_t count_ = 0;
	DeviceFrame between_; ///< interpolated from two frames of history_

	std::optional<double> first_s_;
	double last_s_ = 0.0;
	double last_slot_ = -1.0;
	bool has_time_ = false;
	DeviceFrame last_; ///< is repeated by a freeze
	bool has_last_ = false;
};

} // namespace steadyhand
