#include "tracking/frame_filter.h"

#include <doctest/doctest.h>

#include <limits>

using namespace steadyhand;

namespace {

constexpr unsigned NOT_FINITE = 1U << static_cast<unsigned>(FrameFault::NOT_FINITE);
constexpr unsigned ZERO = 1U << static_cast<unsigned>(FrameFault::ZERO);
const Eigen::Vector3d PLACE(0.1, 0.2, -0.3);

DeviceFrame frame_at(const Eigen::Vector3d &index_m) {
	DeviceFrame frame;
	frame.hand.set(Joint::INDEX, index_m);
	return frame;
}

DeviceFrame hand_at(const Eigen::Vector3d &place_m) {
	DeviceFrame frame = frame_at(place_m);
	frame.hand.set(Joint::PALM, place_m);
	return frame;
}

} // namespace

TEST_CASE("joints that are not finite are not tracked") {
	for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
				 std::numeric_limits<double>::infinity(), -2.0 * FARTHEST_M }) {
		FrameFilter filter;
		DeviceFrame frame = hand_at(PLACE);
		frame.hand.positions_m[static_cast<std::size_t>(Joint::INDEX)].y() = bad;
		frame.skeleton.set(SkeletonJoint::INDEX_DISTAL, { bad, 0.0, 0.0 });
		CHECK(filter.clean(frame) == NOT_FINITE);
		CHECK_FALSE(frame.hand.has(Joint::INDEX));
		CHECK(frame.hand.has(Joint::PALM));
		CHECK_FALSE(frame.skeleton.has(SkeletonJoint::INDEX_DISTAL));
	}
}

TEST_CASE("a hand whose joints are all exactly zero is lost") {
	FrameFilter filter;
	DeviceFrame frame = hand_at(PLACE);
	CHECK(filter.clean(frame) == 0);
	CHECK(frame.hand.tracked != 0);
	for (int i = 0; i < 20; ++i) {
		frame = hand_at(Eigen::Vector3d::Zero());
		CHECK(filter.clean(frame) == ZERO);
		CHECK(frame.hand.tracked == 0);
	}
	frame = hand_at(PLACE);
	CHECK(filter.clean(frame) == 0);
	CHECK(frame.hand.tracked != 0);
}

TEST_CASE("a single point that jumps to zero is lost") {
	FrameFilter filter;
	DeviceFrame frame = frame_at(PLACE);
	CHECK(filter.clean(frame) == 0);
	frame = frame_at(Eigen::Vector3d::Zero());
	CHECK(filter.clean(frame) == ZERO);
}

TEST_CASE("a single point may start at the origin and pass through it") {
	FrameFilter filter;
	for (const double x : { 0.0, 0.0, 0.01, 0.02, 0.01, 0.0, -0.01 }) {
		DeviceFrame frame = frame_at({ x, 0.0, 0.0 });
		CHECK(filter.clean(frame) == 0);
		CHECK(frame.hand.has(Joint::INDEX));
	}
}
