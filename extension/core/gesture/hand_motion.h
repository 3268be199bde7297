#pragma once

#include "gesture/vector_quantiser.h"
#include "signal/slope_window.h"
#include "tracking/frame.h"
#include "tracking/tracker_monitor.h"

#include <Eigen/Core>

namespace steadyhand {

/// Motion of a hand at one instant, from which the HMMs of a ClassifierModel get their observations.
struct HandMotion {
	/// Index tip, without the tracker's jumps (Measurement::displacement_m).
	Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();
	Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
	double radius_m = 0.0; ///< of the circle through the tips of thumb, index and middle finger
	double radius_rate_m_s = 0.0;
	bool has_radius = false;
};

/// HandMotion from frames at irregular intervals. Velocities are least-squares slopes over WINDOW_S. Over a
/// gap in the usable frames they are the mean over the gap.
class HandMotionWindow {
public:
	static constexpr double WINDOW_S = 0.06; ///< equal to ObservationWindow's

	void reset() { *this = HandMotionWindow(); }
	/// Ignores the frame and returns false if TrackerMonitor finds no usable index tip in it.
	bool push(const HandFrame &frame);

	[[nodiscard]] HandMotion motion() const;

private:
	/// Enough for 1 kHz. Of faster sensors some older samples are dropped, never the newest.
	static constexpr std::size_t CAPACITY = 64;
	static constexpr double LEAST_INTERVAL_S = WINDOW_S / (CAPACITY - 2);

	template <class Value> struct Samples {
		SlopeWindow<Value, CAPACITY> window;
		Value newest;

		void push(double t_s, const Value &value);
	};
	TrackerMonitor monitor_;
	Samples<Eigen::Vector3d> tip_{ {}, Eigen::Vector3d::Zero() };
	Samples<double> radius_{ {}, 0.0 };
	bool has_radius_ = false;
};

/// A HandMotion relative to the one at a possible onset: distance of the tip, its speed away from the onset
/// and across, its peak speed so far, growth of the radius and its rate. The direction of the motion is not
/// part of it. It is the same in all frames, so it counts once for a gesture (GestureDirection).
using MotionObservation = MotionCodebook::Point;

/// Makes the MotionObservations since a possible onset.
class MotionObserver {
public:
	MotionObserver() = default;
	explicit MotionObserver(const HandMotion &onset) : onset_(onset) {}

	[[nodiscard]] const HandMotion &onset() const { return onset_; }
	/// Must be called for each instant in order: it remembers the greatest speed, distance and growth.
	MotionObservation observe(const HandMotion &motion);
	/// From the onset to the index tip where it was farthest away. A hand that strikes comes back.
	[[nodiscard]] const Eigen::Vector3d &farthest_m() const { return farthest_m_; }
	/// Distance of the path's centre from the straight line to farthest_m(), in lengths of this line.
	[[nodiscard]] double bow() const;
	/// Greatest growth of the radius, >= 0.
	[[nodiscard]] double growth_m() const { return growth_m_; }

private:
	HandMotion onset_;
	double peak_m_s_ = 0.0;
	Eigen::Vector3d newest_m_ = Eigen::Vector3d::Zero();
	Eigen::Vector3d path_sum_m2_ = Eigen::Vector3d::Zero(); ///< integral of the position over the path
	double path_m_ = 0.0;
	Eigen::Vector3d farthest_m_ = Eigen::Vector3d::Zero();
	Eigen::Vector3d centre_m_ = Eigen::Vector3d::Zero(); ///< of the path to farthest_m_
	double growth_m_ = 0.0;
};

} // namespace steadyhand
