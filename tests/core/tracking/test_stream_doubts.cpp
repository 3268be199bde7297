// Frames of wrong units, or of a clock that stands, are told from a hand's.

#include "tracking/stream_doubts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>

using namespace steadyhand;

namespace {

/// A hand that goes 20 cm to and fro, in units of so many to a metre and a second.
std::optional<StreamDoubt> doubt(double per_m, double per_s, double rate_hz = 90.0, double length_s = 3.0) {
	StreamDoubts doubts;
	std::optional<StreamDoubt> doubt;
	for (int i = 0; i < rate_hz * length_s && !doubt; ++i) {
		const double t_s = i / rate_hz, way = 0.1 * std::sin(2.0 * std::numbers::pi * 0.5 * t_s);
		HandFrame frame;
		frame.t_s = per_s * t_s;
		frame.set(Joint::INDEX, per_m * Eigen::Vector3d(0.1 + way, 1.1, -0.35));
		doubt = doubts.look(frame);
	}
	return doubt;
}

} // namespace

TEST_CASE("a hand's frames raise no doubt at any rate") {
	for (const double rate_hz : { 10.0, 30.0, 90.0, 1000.0 }) {
		CHECK(doubt(1.0, 1.0, rate_hz, 10.0) == std::nullopt);
	}
}

TEST_CASE("millimetres, milliseconds and one stamp for all are told") {
	for (const double rate_hz : { 30.0, 90.0, 250.0 }) {
		CAPTURE(rate_hz);
		CHECK(doubt(1e3, 1.0, rate_hz) == StreamDoubt::TOO_FAST);
		CHECK(doubt(1e2, 1.0, rate_hz) == StreamDoubt::TOO_FAST);
		CHECK(doubt(1.0, 1e3, rate_hz) == StreamDoubt::TOO_RARE);
		CHECK(doubt(1.0, 1e6, rate_hz) == StreamDoubt::TOO_RARE);
		CHECK(doubt(1.0, 0.0, rate_hz) == StreamDoubt::TIME_STANDS);
	}
}

TEST_CASE("a tracker's errors raise none") {
	StreamDoubts jumping, lost, repeating;
	for (int i = 0; i < 2000; ++i) {
		HandFrame frame;
		frame.t_s = i / 90.0;
		frame.set(Joint::INDEX, Eigen::Vector3d(i % 20 == 0 ? 3.0 : 0.1, 0.0, 0.0));
		CHECK(jumping.look(frame) == std::nullopt);
		HandFrame empty;
		empty.t_s = 5.0 * i;
		CHECK(lost.look(i % 2 == 0 ? frame : empty) == std::nullopt);
		frame.t_s = 0.0; // the same frame, over and over
		frame.set(Joint::INDEX, Eigen::Vector3d::Zero());
		CHECK(repeating.look(frame) == std::nullopt);
	}
}
