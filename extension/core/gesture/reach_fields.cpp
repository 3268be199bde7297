#include "gesture/reach_fields.h"

#include "gesture/task.h"
#include "tracking/frame.h"

#include <cmath>

namespace steadyhand::json_fields {
namespace {

constexpr double LENGTH_TOLERANCE = 1e-6; // of an axis
constexpr double LEAST_LOG_DEVIATION = 1e-3, MOST_LOG_DEVIATION = 10.0;

} // namespace

Json reach_to_json(const GestureReach &reach) {
	return { { "axis", row_to_json(reach.axis) }, { "is_radius", reach.is_radius },
		{ "reach_m", reach.reach_m }, { "reach_deviation", reach.reach_deviation } };
}

GestureReach reach_from_json(const Json &json) {
	GestureReach reach;
	reach.axis = point(json, "axis");
	reach.is_radius = flag(json, "is_radius");
	const double length = reach.is_radius ? 0.0 : 1.0;
	if (!(std::abs(reach.axis.norm() - length) < LENGTH_TOLERANCE)) {
		throw Fault(
				json["axis"], reach.is_radius ? "axis: must be 0 for a radius" : "axis: its length is not 1");
	}
	reach.reach_m = within(json, "reach_m", SMALLEST_AMPLITUDE_M, FARTHEST_M);
	reach.reach_deviation = within(json, "reach_deviation", LEAST_LOG_DEVIATION, MOST_LOG_DEVIATION);
	return reach;
}

} // namespace steadyhand::json_fields
