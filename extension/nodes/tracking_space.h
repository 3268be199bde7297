#pragma once

#include "geometry_conversions.h"

#include <godot_cpp/classes/xr_server.hpp>

#include <Eigen/Geometry>

namespace godot {

/// From the tracking space, in which an XRTracker has its poses, to the space of the XROrigin3D: as
/// XRPose.get_adjusted_transform().
inline Eigen::Affine3d tracking_to_origin() {
	const XRServer *const server = XRServer::get_singleton();
	return to_core(server->get_reference_frame()) * Eigen::Scaling(server->get_world_scale());
}

inline Eigen::Affine3d tracking_to_world() {
	return to_core(XRServer::get_singleton()->get_world_origin()) * tracking_to_origin();
}

} // namespace godot
