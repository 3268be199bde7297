#include "body_space.h"

#include "geometry_conversions.h"

#include <godot_cpp/classes/xr_pose.hpp>
#include <godot_cpp/classes/xr_positional_tracker.hpp>
#include <godot_cpp/classes/xr_server.hpp>

#include <cmath>
#include <numbers>

namespace godot {

void BodySpace::follow(const Eigen::Vector3d &p_tip_m, std::optional<double> p_head_turn, double p_time_s) {
	const bool is_first = !rest_place_m_;
	if (is_first || (p_tip_m - *rest_place_m_).norm() > REST_M) {
		rest_place_m_ = p_tip_m;
		rests_since_s_ = p_time_s;
	}
	if ((is_first || p_time_s - rests_since_s_ > REST_S) && p_head_turn) {
		const Eigen::Matrix3d turn =
				Eigen::AngleAxisd(-*p_head_turn, Eigen::Vector3d::UnitY()).toRotationMatrix();
		const Eigen::Vector3d shown_m = to_body_ * p_tip_m;
		to_body_.linear() = turn;
		to_body_.translation() = shown_m - turn * p_tip_m;
	}
}

std::optional<double> head_turn() {
	constexpr double STEEPEST = 70.0 * std::numbers::pi / 180.0;
	const Ref<XRPositionalTracker> head = XRServer::get_singleton()->get_tracker("head");
	const Ref<XRPose> pose = head.is_valid() ? head->get_pose("default") : Ref<XRPose>();
	if (pose.is_null() || !pose->get_has_tracking_data()) {
		return std::nullopt;
	}
	const Eigen::Vector3d ahead = -to_core(pose->get_adjusted_transform().basis).col(2);
	if (std::abs(ahead.y()) > std::sin(STEEPEST) * ahead.norm()) {
		return std::nullopt;
	}
	return std::atan2(-ahead.x(), -ahead.z());
}

} // namespace godot
