#include "gesture/feature_track.h"

#include "base/parameters.h"

namespace steadyhand {
namespace {

/// The point for TrackerMonitor. For a radius: x and y of the fingertips' mean, and the radius. place: of the
/// feature in the frame.
std::optional<Eigen::Vector3d> tracked_point(
		const Feature &feature, const std::optional<FeaturePlace> &place, const HandFrame &frame) {
	if (place) {
		return feature.is_radius ? Eigen::Vector3d(place->x(), place->y(), place->w())
								 : Eigen::Vector3d(place->head<3>());
	}
	return feature.place == nullptr && frame.has(Joint::INDEX) ? std::optional(frame.position(Joint::INDEX))
															   : std::nullopt;
}

} // namespace

FeaturePlace place_of(const Feature &feature, const Eigen::Vector3d &point_m) {
	return feature.is_radius ? FeaturePlace(point_m.x(), point_m.y(), 0.0, point_m.z())
							 : FeaturePlace(point_m.x(), point_m.y(), point_m.z(), 0.0);
}

void FeatureTrack::push(const HandFrame &frame) {
	place_ = feature_->place != nullptr ? feature_->place(frame) : std::nullopt;
	measurement_ = { .t_s = frame.t_s };
	if (const std::optional<Eigen::Vector3d> point_m = tracked_point(*feature_, place_, frame);
			point_m && point_m->allFinite()) {
		measurement_ = monitor_.push(frame.t_s, *point_m);
	}
	if (place_ && !place_->allFinite()) {
		place_.reset();
	}
	if (!place_) {
		return;
	}
	displacement_m_ = place_of(*feature_, measurement_.displacement_m);
	if (measurement_.is_usable() && frame.t_s - last_measurement_s() >= parameters::LEAST_FRAME_S) {
		past_.push({ frame.t_s, *place_ - displacement_m_ });
	}
}

} // namespace steadyhand
