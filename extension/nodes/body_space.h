#pragma once

#include <Eigen/Geometry>

#include <optional>

namespace godot {

/// A space that turns about the vertical with the player while the hand rests. From where the hand sets out
/// until it rests again it stands still, so that the head may look about during a gesture. It turns about the
/// hand: nothing moves by it.
class BodySpace {
public:
	/// p_tip_m: a point of the hand in the origin's space, m. p_head_turn: of the head about the vertical
	/// from the origin's -z, rad; nothing where the head looks too steeply up or down, or is not known.
	void follow(const Eigen::Vector3d &p_tip_m, std::optional<double> p_head_turn, double p_time_s);
	/// From the origin's space.
	const Eigen::Isometry3d &transform() const { return to_body_; }

private:
	/// A resting hand stays within REST_M for REST_S.
	static constexpr double REST_M = 0.02, REST_S = 0.25;

	Eigen::Isometry3d to_body_ = Eigen::Isometry3d::Identity();
	std::optional<Eigen::Vector3d> rest_place_m_;
	double rests_since_s_ = 0.0;
};

/// The turn of the head as the XRServer knows it.
std::optional<double> head_turn();

} // namespace godot
