#pragma once

#include "base/parameters.h"
#include "signal/constant_velocity_state.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace steadyhand {

/// Vector from the nearest point of a path to the point way_m, m. The path begins at 0, with this velocity
/// for 0..most_s.
[[nodiscard]] inline Eigen::Vector3d off_path_m(
		const Eigen::Vector3d &way_m, const Eigen::Vector3d &velocity_m_s, double most_s) {
	const double square = velocity_m_s.squaredNorm();
	const double time_s = square > 0.0 ? std::clamp(way_m.dot(velocity_m_s) / square, 0.0, most_s) : 0.0;
	return way_m - time_s * velocity_m_s;
}

/// Kalman filter of a hand's position and velocity, m and s, with the accelerations and speeds of real hands.
class HandTrack {
public:
	HandTrack() = default;
	/// Starts at position_m.
	HandTrack(double t_s, const Eigen::Vector3d &position_m, const Eigen::Vector3d &velocity_m_s,
			const Eigen::Vector3d &noise_m) :
			t_s_(t_s) {
		for (std::size_t i = 0; i < axes_.size(); ++i) {
			const auto axis = static_cast<Eigen::Index>(i);
			axes_[i] = { .position = position_m[axis],
				.velocity = velocity_m_s[axis],
				.p00 = noise_m[axis] * noise_m[axis],
				.p11 = parameters::tracker::SPEED_M_S * parameters::tracker::SPEED_M_S };
		}
	}

	/// stamp_error_s: standard deviation of the stamp's error.
	void predict(double t_s, double stamp_error_s) {
		const double dt_s = t_s - t_s_;
		t_s_ = t_s;
		step_s_ = dt_s;
		from_m_ = position_m();
		for (ConstantVelocityState &axis : axes_) {
			const double furthest_m = parameters::tracker::SPEED_M_S * (dt_s + stamp_error_s);
			const double before = axis.p00;
			axis.predict(dt_s,
					parameters::tracker::ACCELERATION_M_S2 * parameters::tracker::ACCELERATION_M_S2 * dt_s);
			axis.p00 += parameters::tracker::SPEED_M_S * parameters::tracker::SPEED_M_S * stamp_error_s *
					stamp_error_s;
			axis.p00 = std::min(axis.p00, before + furthest_m * furthest_m);
			axis.p11 = std::min(axis.p11, parameters::tracker::SPEED_M_S * parameters::tracker::SPEED_M_S);
			axis.p01 = std::clamp(axis.p01, -std::sqrt(axis.p00 * axis.p11), std::sqrt(axis.p00 * axis.p11));
		}
	}
	void correct(const Eigen::Vector3d &position_m, const Eigen::Vector3d &noise_m) {
		for (std::size_t i = 0; i < axes_.size(); ++i) {
			const auto axis = static_cast<Eigen::Index>(i);
			axes_[i].correct(position_m[axis], noise_m[axis] * noise_m[axis]);
		}
	}

	/// Vector from the nearest possible position of the hand to position_m, m. Possible is the path from the
	/// last position to the predicted one, extended by late_s: a hand may hit something and stop, and frames
	/// may be older than their stamps. The path has the present velocity or the fastest recent one.
	[[nodiscard]] Eigen::Vector3d residual_m(const Eigen::Vector3d &position_m, double late_s) const {
		const Eigen::Vector3d off_m = position_m - from_m_;
		const double most_s = step_s_ + late_s + behind_s_;
		const Eigen::Vector3d now_m = off_path_m(off_m, velocity_m_s(), most_s);
		const Eigen::Vector3d fastest_m = off_path_m(off_m, fastest_m_s_, most_s);
		return fastest_m.squaredNorm() < now_m.squaredNorm() ? fastest_m : now_m;
	}
	/// Call it before correct(). Measures how old the reading may be. Later readings may catch up by this
	/// time.
	void fall_behind(const Eigen::Vector3d &position_m) {
		const Eigen::Vector3d velocity = velocity_m_s();
		behind_s_ += step_s_ - time_along(velocity, position_m - from_m_);
		behind_s_ = std::clamp(behind_s_, 0.0, parameters::tracker::MOST_BEHIND_S);
		if (velocity.norm() > fastest_m_s_.norm() || t_s_ - fastest_s_ > parameters::tracker::MOST_BEHIND_S) {
			fastest_m_s_ = velocity;
			fastest_s_ = t_s_;
		}
	}
	/// Log density of a reading at residual_m, in log(1/m^3). spread_m: standard deviation of a further
	/// error.
	[[nodiscard]] double log_likelihood(
			const Eigen::Vector3d &residual_m, const Eigen::Vector3d &noise_m, double spread_m = 0.0) const {
		double distance = 0.0, volume = 1.0;
		for (std::size_t i = 0; i < axes_.size(); ++i) {
			const auto axis = static_cast<Eigen::Index>(i);
			const double variance = axes_[i].p00 + noise_m[axis] * noise_m[axis] + spread_m * spread_m;
			distance += residual_m[axis] * residual_m[axis] / variance;
			volume *= 2.0 * std::numbers::pi * variance;
		}
		return -0.5 * (distance + std::log(volume));
	}

	[[nodiscard]] double t_s() const { return t_s_; }
	[[nodiscard]] Eigen::Vector3d position_m() const {
		return { axes_[0].position, axes_[1].position, axes_[2].position };
	}
	[[nodiscard]] Eigen::Vector3d velocity_m_s() const {
		return { axes_[0].velocity, axes_[1].velocity, axes_[2].velocity };
	}

private:
	double t_s_ = 0.0;
	double step_s_ = 0.0;                                   ///< time step of the last predict()
	double fastest_s_ = 0.0;                                ///< time of the fastest recent velocity
	Eigen::Vector3d fastest_m_s_ = Eigen::Vector3d::Zero(); ///< fastest recent velocity
	double behind_s_ = 0.0; ///< by this the last frame may be older than its stamp
	std::array<ConstantVelocityState, 3> axes_{};
	Eigen::Vector3d from_m_ = Eigen::Vector3d::Zero(); ///< position before the last predict()

	/// Time in which a hand with this velocity covers the component of off_m along it; step_s_ at rest.
	[[nodiscard]] double time_along(const Eigen::Vector3d &velocity, const Eigen::Vector3d &off_m) const {
		const double square = velocity.squaredNorm();
		return square > 0.0 ? off_m.dot(velocity) / square : step_s_;
	}
};

} // namespace steadyhand
