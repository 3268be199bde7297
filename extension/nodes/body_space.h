#pragma once

#include <Eigen/Geometry>

#include <optional>

namespace godot {

/// A space that turns about the vertical with the player's head while the hand rests. It does not turn while
/// the hand moves, so the player may look around during a gesture. It turns about the hand, so the hand's
/// position does not change.
class BodySpace {
public:
	/// p_tip_m: a point of the hand in the origin's space, m. p_head_turn: angle of the head about the
	/// vertical from the origin's -z, rad; nullopt if it is unknown, or the head looks steeply up or down.
	void follow(const Eigen::Vector3d &p_tip_m, std::optional<double> p_head_turn, double p_time_s);
	/// From the origin's space to this space.
	const Eigen::Isometry3d &transform() const { return to_body_; }

private:
	/// A resting hand stays within REST_M for REST_S.
	static constexpr double REST_M = 0.02, REST_S = 0.25;

	Eigen::Isometry3d to_body_ = Eigen::Isometry3d::Identity();
	std::optional<Eigen::Vector3d> rest_place_m_;
	double rests_since_s_ = 0.0;
};

/// The head's angle by the XRServer, as for follow().
std::optional<double> head_turn();

} // namespace godot
