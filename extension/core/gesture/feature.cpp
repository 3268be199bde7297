#include "gesture/feature.h"

#include "gesture/circumcircle.h"

#include <array>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

constexpr std::uint8_t INDEX_TIP = joint_bits({ Joint::INDEX });
constexpr std::uint8_t THREE_TIPS = joint_bits({ Joint::THUMB, Joint::INDEX, Joint::MIDDLE });

std::optional<double> index_along_axis(const HandFrame &frame, const Task &task) {
	if (!frame.has_all(INDEX_TIP)) {
		return std::nullopt;
	}
	return (frame.position(Joint::INDEX) - task.start_m).dot(task.axis);
}

std::optional<FeaturePlace> index_place(const HandFrame &frame) {
	if (!frame.has_all(INDEX_TIP)) {
		return std::nullopt;
	}
	FeaturePlace place = FeaturePlace::Zero();
	place.head<3>() = frame.position(Joint::INDEX);
	return place;
}

FeaturePlace along_axis(const Task &task) {
	FeaturePlace direction = FeaturePlace::Zero();
	direction.head<3>() = task.axis;
	return direction;
}

/// Radius of the circle through the tips of thumb, index and middle finger, z left out (paper, "zoom_R").
std::optional<double> tips_radius(const HandFrame &frame) {
	if (!frame.has_all(THREE_TIPS)) {
		return std::nullopt;
	}
	return circumradius(frame.position(Joint::THUMB).head<2>(), frame.position(Joint::INDEX).head<2>(),
			frame.position(Joint::MIDDLE).head<2>());
}

std::optional<double> tips_circumradius(const HandFrame &frame, const Task &task) {
	const std::optional<double> radius_m = tips_radius(frame);
	return radius_m ? std::optional(*radius_m - task.start_m.x()) : std::nullopt;
}

/// Opening fingers keep the shape of their triangle: radius and size grow alike. If only the triangle gets
/// flatter, the radius grows and the size does not.
std::optional<FeaturePlace> tips_place(const HandFrame &frame) {
	const std::optional<double> radius_m = tips_radius(frame);
	if (!radius_m) {
		return std::nullopt;
	}
	const Eigen::Vector2d thumb = frame.position(Joint::THUMB).head<2>(),
						  index = frame.position(Joint::INDEX).head<2>(),
						  middle = frame.position(Joint::MIDDLE).head<2>();
	const Eigen::Vector2d mean = (thumb + index + middle) / 3.0;
	const double size = std::sqrt(
			((thumb - mean).squaredNorm() + (index - mean).squaredNorm() + (middle - mean).squaredNorm()) /
			3.0);
	return FeaturePlace(mean.x(), mean.y(), *radius_m - size, *radius_m);
}

FeaturePlace along_size(const Task & /*task*/) {
	return FeaturePlace::UnitW();
}

/// Circle of a task in the xy plane. It begins along the task's axis, turns counterclockwise as the user sees
/// it, and its circumference is the task's amplitude.
struct Circle {
	double radius_m;
	Eigen::Vector2d ahead, inward; ///< at the start
	Eigen::Vector2d centre_m;

	explicit Circle(const Task &task) :
			radius_m(task.amplitude_m / (2.0 * std::numbers::pi)), ahead(task.axis.head<2>().normalized()),
			inward(-ahead.y(), ahead.x()), centre_m(task.start_m.head<2>() + radius_m * inward) {}
};

/// Angle of the index tip on the circle, times the circle's radius. The tip's own radius and z do not matter.
/// nullopt near the centre, where errors of the tip are amplified.
std::optional<double> index_along_circle(const HandFrame &frame, const Task &task) {
	const Circle circle(task);
	if (!frame.has_all(INDEX_TIP) || circle.ahead.isZero(0.0)) {
		return std::nullopt;
	}
	const Eigen::Vector2d from_centre = frame.position(Joint::INDEX).head<2>() - circle.centre_m;
	if (!(from_centre.norm() * ERROR_GAIN_MAX > circle.radius_m)) {
		return std::nullopt;
	}
	return circle.radius_m * std::atan2(from_centre.dot(circle.ahead), -from_centre.dot(circle.inward));
}

double index_off_circle(const HandFrame &frame, const Task &task) {
	const Circle circle(task);
	const Eigen::Vector3d &index = frame.position(Joint::INDEX);
	return std::hypot(
			(index.head<2>() - circle.centre_m).norm() - circle.radius_m, index.z() - task.start_m.z());
}

double circumference(const Task &task) {
	return task.amplitude_m;
}

/// Weight of the hand's translation: an opening hand may move by several times the radius' growth.
constexpr double TRANSLATION_WEIGHT = 0.2;
/// The growth of the radius depends on the size of the hand, and on how far it was closed.
constexpr double RADIUS_GAIN_FACTOR = 4.5;

constexpr std::array FEATURES{
	Feature{ "index_along_axis", INDEX_TIP, index_along_axis, index_place, along_axis },
	Feature{ .name = "tips_circumradius",
			.joints = THREE_TIPS,
			.measure = tips_circumradius,
			.place = tips_place,
			.direction = along_size,
			.is_radius = true,
			.no_task_gain_factor = RADIUS_GAIN_FACTOR,
			.coordinate_weights = { TRANSLATION_WEIGHT, TRANSLATION_WEIGHT, 1.0, 1.0 } },
	Feature{ "index_along_circle", INDEX_TIP, index_along_circle, nullptr, nullptr, circumference,
			index_off_circle },
};

} // namespace

std::span<const Feature> features() {
	return FEATURES;
}

const Feature *find_feature(std::string_view name) {
	for (const Feature &feature : FEATURES) {
		if (feature.name == name) {
			return &feature;
		}
	}
	return nullptr;
}

} // namespace steadyhand
