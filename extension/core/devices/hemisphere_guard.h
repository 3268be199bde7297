#pragma once

#include <Eigen/Core>

#include <limits>

namespace steadyhand {

/// Finds jumps of one sensor to the mirror image of its position through the source, and undoes them. A
/// magnetic tracker cannot distinguish the two: a sensor that leaves the tracker's half space appears at -p.
/// Positions are in metres from the source, in the source frame or any rotated one.
class HemisphereGuard {
public:
	struct Answer {
		Eigen::Vector3d position_m = Eigen::Vector3d::Zero(); ///< where the sensor is
		bool is_mirrored = false;                             ///< the tracker's position was mirrored back
		bool has_flipped = false;                             ///< is_mirrored changed with this position
	};

	/// Adds a position at `t_s`, s. A flip is a jump to within NEAR_M of the last position's mirror image,
	/// and farther than FAR_M from the last position. Positions nearer to the source than half of FAR_M, or
	/// after more than GAP_S without any, are accepted unchanged: there the two cases cannot be
	/// distinguished.
	[[nodiscard]] Answer update(const Eigen::Vector3d &reported_m, double t_s) {
		const bool is_after_gap = !(t_s - last_s_ <= GAP_S); // also true for the first position
		if (is_after_gap) {
			is_mirrored_ = false;
		}
		Eigen::Vector3d position_m = is_mirrored_ ? Eigen::Vector3d(-reported_m) : reported_m;
		const bool has_flipped = !is_after_gap && (position_m + last_m_).norm() <= NEAR_M &&
				(position_m - last_m_).norm() > FAR_M;
		if (has_flipped) {
			is_mirrored_ = !is_mirrored_;
			position_m = -position_m;
		}
		last_m_ = position_m;
		last_s_ = t_s;
		return { position_m, is_mirrored_, has_flipped };
	}

	/// Accepts the next position unchanged. Call it after a reconnection.
	void reset() { *this = HemisphereGuard(); }

	/// m. A hand moves 5 m/s at most: 2 cm between frames at 240 Hz, NEAR_M after two lost frames.
	static constexpr double NEAR_M = 0.06;
	/// m. Three times NEAR_M: no hand jumps that far between frames.
	static constexpr double FAR_M = 0.18;
	/// s. After it a hand may be anywhere, also beyond the source.
	static constexpr double GAP_S = 0.1;

private:
	Eigen::Vector3d last_m_ = Eigen::Vector3d::Zero();
	double last_s_ = -std::numeric_limits<double>::infinity();
	bool is_mirrored_ = false;
};

} // namespace steadyhand
