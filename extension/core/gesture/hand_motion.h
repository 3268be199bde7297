#pragma once

#include "gesture/vector_quantiser.h"
#include "signal/slope_window.h"
#include "tracking/frame.h"

#include <Eigen/Core>

namespace steadyhand {

/// What the HMMs of a ClassifierModel observe of a hand, at one instant.
struct HandMotion {
	Eigen::Vector3d tip_m = Eigen::Vector3d::Zero(); ///< of the index finger
	Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();
	double radius_m = 0.0; ///< of the circle through the tips of thumb, index and middle finger
	double radius_rate_m_s = 0.0;
	bool has_radius = false;
};

/// HandMotion from frames at irregular instants; velocities are least-squares slopes over WINDOW_S.
class HandMotionWindow {
public:
	static constexpr double WINDOW_S = 0.06; ///< as ObservationWindow's

	void reset() { *this = HandMotionWindow(); }
	/// False, and nothing is taken, where the index tip is not tracked.
	bool push(const HandFrame &frame);

	[[nodiscard]] HandMotion motion() const;

private:
	/// Enough for 1 kHz sensors; of a faster one some are left out, never the newest.
	static constexpr std::size_t CAPACITY = 64;
	static constexpr double LEAST_INTERVAL_S = WINDOW_S / (CAPACITY - 2);

	template <class Value> struct Samples {
		SlopeWindow<Value, CAPACITY> window;
		Value newest;

		void push(double t_s, const Value &value);
	};
	Samples<Eigen::Vector3d> tip_{ {}, Eigen::Vector3d::Zero() };
	Samples<double> radius_{ {}, 0.0 };
	bool has_radius_ = false;
};

/// A HandMotion relative to the one at a possible onset: how far the tip is from there, its speed away from
/// there and across that, growth of the radius and its rate. It does not depend on the direction of the
/// motion, which is judged once for a gesture (GestureDirection), as it is the same in all its frames.
using MotionObservation = MotionCodebook::Point;

/// Observes a hand from a possible onset on.
class MotionObserver {
public:
	MotionObserver() = default;
	explicit MotionObserver(const HandMotion &onset) : onset_(onset) {}

	[[nodiscard]] const HandMotion &onset() const { return onset_; }
	/// At each instant, in their order.
	MotionObservation observe(const HandMotion &motion);

private:
	HandMotion onset_;
	double peak_m_s_ = 0.0;
};

} // namespace steadyhand
