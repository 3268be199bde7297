#include "gesture/feature.h"

#include <array>

namespace steadyhand {
namespace {

std::optional<double> index_along_axis(const HandFrame &frame, const Task &task) {
	if (!frame.has(Joint::INDEX)) {
		return std::nullopt;
	}
	return (frame.position(Joint::INDEX) - task.start_m).dot(task.axis);
}

void index_start_here(const HandFrame &frame, Task &r_task) {
	if (frame.has(Joint::INDEX)) {
		r_task.start_m = frame.position(Joint::INDEX);
	}
}

std::optional<FeaturePlace> index_place(const HandFrame &frame) {
	if (!frame.has(Joint::INDEX)) {
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

constexpr std::array FEATURES{
	Feature{ "index_along_axis", index_along_axis, index_start_here, index_place, along_axis },
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
