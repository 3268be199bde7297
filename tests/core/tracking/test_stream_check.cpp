// Detection of frames with wrong units or equal time stamps.

#include "tracking/stream_check.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>

using namespace steadyhand;

namespace {

/// The first fault of a hand that moves 20 cm to and fro. per_m, per_s: units per metre and per second.
std::optional<StreamFault> first_fault(
		double per_m, double per_s, double rate_hz = 90.0, double length_s = 3.0) {
	StreamCheck check;
	std::optional<StreamFault> fault;
	for (int i = 0; i < rate_hz * length_s && !fault; ++i) {
		const double t_s = i / rate_hz, x_m = 0.1 * std::sin(2.0 * std::numbers::pi * 0.5 * t_s);
		HandFrame frame;
		frame.t_s = per_s * t_s;
		frame.set(Joint::INDEX, per_m * Eigen::Vector3d(0.1 + x_m, 1.1, -0.35));
		fault = check.push(frame);
	}
	return fault;
}

} // namespace

TEST_CASE("correct frames report no fault at 10 to 1000 Hz") {
	for (const double rate_hz : { 10.0, 30.0, 90.0, 1000.0 }) {
		CHECK(first_fault(1.0, 1.0, rate_hz, 10.0) == std::nullopt);
	}
}

TEST_CASE("millimetres, milliseconds and equal stamps are each reported") {
	for (const double rate_hz : { 30.0, 90.0, 250.0 }) {
		CAPTURE(rate_hz);
		CHECK(first_fault(1e3, 1.0, rate_hz) == StreamFault::TOO_FAST);
		CHECK(first_fault(1e2, 1.0, rate_hz) == StreamFault::TOO_FAST);
		CHECK(first_fault(1.0, 1e3, rate_hz) == StreamFault::TOO_RARE);
		CHECK(first_fault(1.0, 1e6, rate_hz) == StreamFault::TOO_RARE);
		CHECK(first_fault(1.0, 0.0, rate_hz) == StreamFault::EQUAL_TIME_STAMPS);
	}
}

TEST_CASE("jumps, dropouts and repeated frames report no fault") {
	StreamCheck jumping, lost, repeating;
	for (int i = 0; i < 2000; ++i) {
		HandFrame frame;
		frame.t_s = i / 90.0;
		frame.set(Joint::INDEX, Eigen::Vector3d(i % 20 == 0 ? 3.0 : 0.1, 0.0, 0.0));
		CHECK(jumping.push(frame) == std::nullopt);
		HandFrame empty;
		empty.t_s = 5.0 * i;
		CHECK(lost.push(i % 2 == 0 ? frame : empty) == std::nullopt);
		frame.t_s = 0.0;
		frame.set(Joint::INDEX, Eigen::Vector3d::Zero());
		CHECK(repeating.push(frame) == std::nullopt);
	}
}
