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

/// Faults that a DegradedHand adds to a hand without any. Each field is off at 0, and so is one that is
/// negative or no number. A fault needs both its rate, 6000 per minute at most, and its duration.
struct DegradeSettings {
	double dropouts_per_minute = 0.0;
	double dropout_s = 0.0;           ///< how long a dropout lasts, s
	bool dropouts_are_silent = false; ///< no frames come in a dropout; else frames come without a hand

	double freezes_per_minute = 0.0;
	double freeze_s = 0.0; ///< how long the last pose repeats while stamps go on, s

	double jumps_per_minute = 0.0;
	double jump_m = 0.0; ///< how far from its place the hand appears, in any direction, m
	double jump_s = 0.0; ///< for how long, s

	double drift_m = 0.0; ///< slow error: standard deviation on each axis, m
	double drift_s = 0.0; ///< its time constant, s; 0: 1 s

	double latency_s = 0.0;  ///< a frame stamped t shows the hand at t - latency_s; 2 s at most
	double rate_hz = 0.0;    ///< at most so many frames a second; 0: all
	double rounding_m = 0.0; ///< positions are multiples of it, m
	double noise_m = 0.0;    ///< white noise: standard deviation on each axis of each joint, m

	std::uint64_t seed = 0; ///< equal seeds give equal faults
};

/// Settings that turn a hand without errors into one that a Leap tracks in the paper's "stable" or "unstable"
/// position: the means of the sensor profile leap_stable or leap_unstable, at a severity of 0.5 where that
/// grows. None for another name.
[[nodiscard]] std::optional<DegradeSettings> degrade_preset(std::string_view name);

/// Adds a tracker's faults to the frames of a sound one. Faults are Poisson processes on the frames' own time
/// from the first frame on. Equal frames and settings give equal frames, to the last bit, and a frame depends
/// on frames before it only. Each kind of fault has its own random numbers: to switch one on changes no
/// other. Hand and skeleton move as one. Allocates in the constructor only.
class DegradedHand {
public:
	explicit DegradedHand(const DegradeSettings &settings);

	/// The frame as the degraded tracker delivers it, with the stamps of `frame`; empty where it delivers
	/// none. Frames come in the order of their finite `hand.t_s`. With a latency the first frames are empty.
	std::optional<DeviceFrame> apply(const DeviceFrame &frame);

private:
	/// Instants of one kind of fault.
	class Faults {
	public:
		Faults(double per_minute, double length_s, std::uint64_t seed);

		/// Goes on to t_s; true where a fault has begun since the last call.
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

	[[nodiscard]] bool is_thinned(double t_s);
	/// The hand at the time of `frame` less latency_s, interpolated. Null: no frame is that old.
	const DeviceFrame *seen(const DeviceFrame &frame);
	void displace(double t_s, DeviceFrame &r_frame);
	void add_noise(DeviceFrame &r_frame);
	void round_positions(DeviceFrame &r_frame) const;

	DegradeSettings settings_;
	Faults dropouts_, freezes_, jumps_;
	Random drift_random_, noise_random_;
	std::array<Drift, 3> drift_;
	Eigen::Vector3d jump_m_ = Eigen::Vector3d::Zero();
	std::array<Eigen::Vector3d, SKELETON_JOINT_COUNT> noise_m_{};

	std::vector<DeviceFrame> history_; ///< ring of the frames since t - latency_s, and one before
	std::size_t oldest_ = 0;
	std::size_t count_ = 0;
	DeviceFrame between_; ///< interpolated from two of them

	std::optional<double> first_s_;
	double last_s_ = 0.0;
	double last_slot_ = -1.0;
	bool has_time_ = false;
	DeviceFrame last_; ///< what a freeze repeats
	bool has_last_ = false;
};

} // namespace steadyhand
