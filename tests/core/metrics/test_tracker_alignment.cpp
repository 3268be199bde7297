#include "metrics/tracker_alignment.h"

#include "base/random.h"
#include "near.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

using namespace steadyhand;

namespace {

using Alignment = TrackerAlignment::Alignment;
using Movement = std::function<Eigen::Vector3d(double t_s)>;

/// A hand that moves in all directions, with a speed of 0.5 m/s (rms). Its periods have no common multiple.
Eigen::Vector3d wander(double t_s) {
	constexpr double TURN = 2.0 * std::numbers::pi;
	return { 0.15 * std::sin(TURN * 0.31 * t_s) + 0.03 * std::sin(TURN * 1.37 * t_s),
		1.2 + 0.12 * std::sin(TURN * 0.47 * t_s + 1.0) + 0.02 * std::sin(TURN * 1.11 * t_s),
		-0.4 + 0.1 * std::sin(TURN * 0.73 * t_s + 2.0) };
}

/// The other tracker and both trackers' faults.
struct Setup {
	double seconds = 12.0;
	double reference_hz = 240.0;
	double other_hz = 90.0;
	double lag_s = 0.0;
	Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); ///< reference = rotation * other + offset
	Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
	double reference_noise_m = 0.0; ///< an axis
	double other_noise_m = 0.0;
	double lost = 0.0;   ///< share of the samples, one by one
	double jumps = 0.0;  ///< share of the samples, by 0.2 m
	double jump_s = 0.0; ///< duration of a jump; 0: one sample
	double jitter_s = 0.0;
	double start_s = 1000.0;
};

Eigen::Vector3d random_vector(Random &random) {
	const double z = random.normal(), y = random.normal(), x = random.normal();
	return { x, y, z };
}

/// Faults of one tracker.
class FaultyTracker {
public:
	FaultyTracker(const Setup &setup, double noise_m, Random &random) :
			setup_(setup), noise_m_(noise_m), random_(random) {}

	/// False for a lost sample.
	bool spoil(double t_s, Eigen::Vector3d &position_m) {
		for (double &x : position_m) {
			x += noise_m_ * random_.normal();
		}
		if (random_.chance(setup_.jumps)) {
			jumps_until_s_ = t_s + setup_.jump_s;
			jump_m_ = 0.2 * random_vector(random_).normalized();
		}
		if (t_s <= jumps_until_s_) {
			position_m += jump_m_;
		}
		return !random_.chance(setup_.lost);
	}

private:
	const Setup &setup_;
	double noise_m_;
	Random &random_;
	double jumps_until_s_ = -std::numeric_limits<double>::infinity();
	Eigen::Vector3d jump_m_ = Eigen::Vector3d::Zero();
};

void push_both(
		TrackerAlignment &alignment, const Setup &setup, Random &random, const Movement &movement = wander) {
	FaultyTracker reference(setup, setup.reference_noise_m, random);
	FaultyTracker other(setup, setup.other_noise_m, random);
	for (int i = 0; i < static_cast<int>(setup.seconds * setup.reference_hz); ++i) {
		const double t_s = i / setup.reference_hz;
		Eigen::Vector3d position_m = movement(t_s);
		if (reference.spoil(t_s, position_m)) {
			alignment.push_reference(setup.start_s + t_s, position_m);
		}
	}
	for (int i = 0; i < static_cast<int>(setup.seconds * setup.other_hz); ++i) {
		const double t_s = i / setup.other_hz + random.uniform(-setup.jitter_s, setup.jitter_s);
		Eigen::Vector3d position_m =
				setup.rotation.conjugate() * (movement(t_s - setup.lag_s) - setup.offset_m);
		if (other.spoil(t_s, position_m)) {
			alignment.push_other(setup.start_s + t_s, position_m);
		}
	}
}

Result<Alignment> aligned(const Setup &setup, std::uint64_t seed = 1, const Movement &movement = wander) {
	TrackerAlignment alignment;
	Random random(seed);
	push_both(alignment, setup, random, movement);
	return alignment.align();
}

Eigen::Quaterniond random_rotation(Random &random) {
	const double z = random.normal(), y = random.normal(), x = random.normal(), w = random.normal();
	return Eigen::Quaterniond(w, x, y, z).normalized();
}

double angle(const Alignment &alignment, const Setup &setup) {
	return Eigen::Quaterniond(alignment.rotation).angularDistance(setup.rotation);
}

/// Where the middle of the movement ends up, relative to where it belongs.
double shift_m(const Alignment &alignment, const Setup &setup) {
	const Eigen::Vector3d middle_m(0.0, 1.2, -0.4);
	const Eigen::Vector3d other_m = setup.rotation.conjugate() * (middle_m - setup.offset_m);
	return (alignment.rotation * other_m + alignment.translation_m - middle_m).norm();
}

void check_error(const Result<Alignment> &result, const std::string &text) {
	REQUIRE_FALSE(result.ok());
	CHECK_MESSAGE(result.error().find(text) != std::string::npos, result.error());
}

} // namespace

TEST_CASE("trackers without noise align for any rotation, offset and lag") {
	Random random(7);
	for (const double lag_s : { -0.45, -0.1234, -0.004, 0.0, 0.0077, 0.05, 0.2, 0.48 }) {
		CAPTURE(lag_s);
		Setup setup;
		setup.lag_s = lag_s;
		setup.rotation = random_rotation(random);
		setup.offset_m = 3.0 * random_vector(random);
		const Result<Alignment> result = aligned(setup);
		REQUIRE_MESSAGE(result.ok(), result.error());
		// Linear interpolation at 240 Hz is wrong by a dt^2 / 8, below 0.03 mm.
		CHECK(std::abs(result.value().lag_s - lag_s) < 0.0005);
		CHECK(angle(result.value(), setup) < 0.001);
		CHECK(shift_m(result.value(), setup) < 0.0001);
		CHECK(result.value().residual_rms_m < 0.0003);
		CHECK(result.value().rotation.determinant() == test::near(1.0));
		CHECK(result.value().overlap_s > 11.0);
	}
}

TEST_CASE("the rotation is that of Horn's quaternion method on the same samples") {
	// Horn (1987), doi 10.1364/JOSAA.4.000629: the eigenvector of the largest eigenvalue of N.
	for (int seed = 0; seed < 10; ++seed) {
		CAPTURE(seed);
		Random random(static_cast<std::uint64_t>(seed));
		const Eigen::Quaterniond rotation = random_rotation(random);
		TrackerAlignment alignment;
		Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
		Eigen::Vector3d reference_mean_m = Eigen::Vector3d::Zero(), other_mean_m = Eigen::Vector3d::Zero();
		constexpr int COUNT = 1200;
		for (int i = 0; i < COUNT; ++i) {
			const Eigen::Vector3d reference_m = wander(i / 100.0);
			const Eigen::Vector3d noise_m = random_vector(random);
			const Eigen::Vector3d other_m = rotation.conjugate() * reference_m + 0.005 * noise_m;
			CHECK(alignment.push_reference(i / 100.0, reference_m));
			CHECK(alignment.push_other(i / 100.0, other_m));
			sums += other_m * reference_m.transpose();
			reference_mean_m += reference_m / COUNT;
			other_mean_m += other_m / COUNT;
		}
		const Eigen::Matrix3d s = sums / COUNT - other_mean_m * reference_mean_m.transpose();
		Eigen::Matrix4d n = Eigen::Matrix4d::Zero();
		const Eigen::Vector3d delta(s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0));
		n(0, 0) = s.trace();
		n.block<1, 3>(0, 1) = delta.transpose();
		n.block<3, 1>(1, 0) = delta;
		n.block<3, 3>(1, 1) = s + s.transpose() - s.trace() * Eigen::Matrix3d::Identity();
		const Eigen::Vector4d best = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(n).eigenvectors().col(3);
		const Eigen::Quaterniond horn(best[0], best[1], best[2], best[3]);
		const Result<Alignment> result = alignment.align();
		REQUIRE_MESSAGE(result.ok(), result.error());
		// The lag is wrong by some 0.1 ms, and a few outliers are left out. The noise turns both by ten times
		// as much.
		CHECK(Eigen::Quaterniond(result.value().rotation).angularDistance(horn) < 0.0003);
	}
}

TEST_CASE("the reference may be the slower tracker") {
	Setup setup;
	setup.reference_hz = 60.0;
	setup.other_hz = 240.0;
	setup.lag_s = 0.031;
	setup.rotation = Eigen::AngleAxisd(2.0, Eigen::Vector3d(1.0, 2.0, -1.0).normalized());
	const Result<Alignment> result = aligned(setup);
	REQUIRE_MESSAGE(result.ok(), result.error());
	CHECK(std::abs(result.value().lag_s - 0.031) < 0.0005);
	CHECK(angle(result.value(), setup) < 0.001);
	CHECK(result.value().samples > 650);
}

TEST_CASE("1 mm of noise moves the lag by less than 3 ms") {
	double squares = 0.0;
	constexpr int RUNS = 20;
	for (int seed = 0; seed < RUNS; ++seed) {
		CAPTURE(seed);
		Random random(static_cast<std::uint64_t>(seed));
		Setup setup;
		setup.lag_s = random.uniform(-0.3, 0.3);
		setup.rotation = random_rotation(random);
		setup.offset_m = random_vector(random);
		setup.reference_noise_m = setup.other_noise_m = 0.001;
		setup.jitter_s = 0.002;
		const Result<Alignment> result = aligned(setup, static_cast<std::uint64_t>(seed));
		REQUIRE_MESSAGE(result.ok(), result.error());
		CHECK(std::abs(result.value().lag_s - setup.lag_s) < 0.003);
		// 1 mm over some 1000 samples of 0.08 m deviation: 0.0004 rad; five times that.
		CHECK(angle(result.value(), setup) < 0.002);
		CHECK(shift_m(result.value(), setup) < 0.0003);
		squares += std::pow(result.value().lag_s - setup.lag_s, 2);
	}
	CHECK(std::sqrt(squares / RUNS) < 0.0005);
}

TEST_CASE("the residual is the noise of the slower tracker") {
	for (const double noise_m : { 0.0005, 0.001, 0.003 }) {
		CAPTURE(noise_m);
		Setup setup;
		setup.seconds = 30.0;
		setup.lag_s = 0.04;
		setup.other_noise_m = noise_m;
		const Result<Alignment> result = aligned(setup);
		REQUIRE_MESSAGE(result.ok(), result.error());
		// Three axes; the rms of 8100 numbers is known to 1 %.
		CHECK(result.value().residual_rms_m == test::near(std::sqrt(3.0) * noise_m).epsilon(0.03));
		CHECK(result.value().residual_max_m > 2.0 * result.value().residual_rms_m);
		CHECK(result.value().residual_max_m < 4.0 * result.value().residual_rms_m);
	}
}

TEST_CASE("dropouts and jumps leave the alignment as it is") {
	for (const double jump_s : { 0.0, 0.03, 0.3 }) {
		for (int seed = 0; seed < 5; ++seed) {
			CAPTURE(jump_s);
			CAPTURE(seed);
			Random random(static_cast<std::uint64_t>(100 + seed));
			Setup setup;
			setup.seconds = 20.0;
			setup.lag_s = 0.065;
			setup.rotation = random_rotation(random);
			setup.offset_m = { 1.0, -2.0, 0.5 };
			setup.reference_noise_m = setup.other_noise_m = 0.001;
			setup.lost = 0.1;
			// About 5 % of the time, whatever the duration.
			setup.jumps = jump_s > 0.0 ? 0.05 / (jump_s * 165.0) : 0.05;
			setup.jump_s = jump_s;
			const Result<Alignment> result = aligned(setup, static_cast<std::uint64_t>(seed));
			REQUIRE_MESSAGE(result.ok(), result.error());
			CHECK(std::abs(result.value().lag_s - 0.065) < 0.003);
			CHECK(angle(result.value(), setup) < 0.005);
			CHECK(shift_m(result.value(), setup) < 0.001);
			CHECK(result.value().residual_rms_m < 0.0035);
		}
	}
}

TEST_CASE("a dropout of seconds shortens the overlap only") {
	TrackerAlignment alignment;
	Random random(3);
	Setup setup;
	setup.lag_s = 0.08;
	push_both(alignment, setup, random);
	setup.start_s = 1030.0;
	push_both(alignment, setup, random, [](double t_s) { return wander(t_s + 30.0); });
	const Result<Alignment> result = alignment.align();
	REQUIRE_MESSAGE(result.ok(), result.error());
	CHECK(std::abs(result.value().lag_s - 0.08) < 0.0005);
	CHECK(result.value().overlap_s == test::near(24.0).epsilon(0.02));
	CHECK(alignment.followed_s() == test::near(24.0).epsilon(0.01));
}

TEST_CASE("steady waving finds the lag within half a period") {
	// The speed of waving has twice its frequency: 0.25 s from the lag it looks the same.
	const Movement waving = [](double t_s) {
		constexpr double TURN = 2.0 * std::numbers::pi;
		return Eigen::Vector3d(0.1 * std::sin(TURN * 2.0 * t_s),
				0.05 * std::sin(TURN * 2.0 * t_s + 1.0) + 0.01 * t_s, 0.04 * std::sin(TURN * 0.9 * t_s));
	};
	Setup setup;
	setup.lag_s = 0.07;
	setup.other_noise_m = 0.001;
	const Result<Alignment> result = aligned(setup, 1, waving);
	REQUIRE_MESSAGE(result.ok(), result.error());
	CHECK(std::abs(result.value().lag_s - 0.07) < 0.001);
}

TEST_CASE("a full buffer keeps the newest two minutes") {
	TrackerAlignment alignment;
	Random random(1);
	Setup setup;
	setup.seconds = 100.0;
	setup.rotation = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX());
	push_both(alignment, setup, random);
	setup.start_s += setup.seconds;
	setup.rotation = Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY());
	setup.seconds = 125.0;
	push_both(alignment, setup, random);
	const Result<Alignment> result = alignment.align();
	REQUIRE_MESSAGE(result.ok(), result.error());
	CHECK(angle(result.value(), setup) < 0.001);
	CHECK(result.value().overlap_s == test::near(120.0).epsilon(0.02));
}

TEST_CASE("no samples, or too few, are an error") {
	TrackerAlignment alignment;
	check_error(alignment.align(), "no samples of the reference; check that it runs");
	CHECK(alignment.push_reference(0.0, Eigen::Vector3d::Zero()));
	check_error(alignment.align(), "no samples of the other tracker");
	Setup setup;
	for (const double seconds : { 0.02, 1.0, 4.9 }) {
		setup.seconds = seconds;
		check_error(aligned(setup), "at least 5 s are needed");
	}
	setup.seconds = 5.2;
	CHECK(aligned(setup).ok());
	setup.seconds = 12.0;
	setup.other_hz = 10.0;
	check_error(aligned(setup), "at 20 or more samples a second");
}

TEST_CASE("tracks at different times have no overlap") {
	TrackerAlignment alignment;
	for (int i = 0; i < 2400; ++i) {
		CHECK(alignment.push_reference(i / 240.0, wander(i / 240.0)));
		CHECK(alignment.push_other(50.0 + i / 240.0, wander(i / 240.0)));
	}
	check_error(alignment.align(), "together for only 0.0 s");
}

TEST_CASE("a hand that hardly moves is an error") {
	Setup setup;
	check_error(aligned(setup, 1, [](double t_s) { return Eigen::Vector3d(0.1 * wander(t_s)); }),
			"at least 10 cm");
	setup.other_noise_m = setup.reference_noise_m = 0.001;
	check_error(aligned(setup, 1, [](double) { return Eigen::Vector3d(1.0, 2.0, 3.0); }), "at least 10 cm");
}

TEST_CASE("a movement along one line is an error, in a plane it is none") {
	const Eigen::Vector3d along = Eigen::Vector3d(1.0, 2.0, -1.0).normalized();
	Setup setup;
	setup.other_noise_m = setup.reference_noise_m = 0.001;
	setup.rotation = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY());
	check_error(aligned(setup, 1, [&](double t_s) { return Eigen::Vector3d(along * wander(t_s).x()); }),
			"move it in all directions");
	setup.lag_s = 0.03;
	const Result<Alignment> plane = aligned(
			setup, 1, [](double t_s) { return Eigen::Vector3d(wander(t_s).x(), wander(t_s).y(), 0.0); });
	REQUIRE_MESSAGE(plane.ok(), plane.error());
	CHECK(angle(plane.value(), setup) < 0.002);
}

TEST_CASE("unrelated movements are an error") {
	for (int seed = 0; seed < 10; ++seed) {
		TrackerAlignment alignment;
		Random random(static_cast<std::uint64_t>(seed));
		const double pace = random.uniform(0.6, 1.7);
		for (int i = 0; i < 2400; ++i) {
			const double t_s = i / 240.0;
			alignment.push_reference(t_s, wander(t_s));
			alignment.push_other(t_s, wander(50.0 + 20.0 * seed + pace * t_s));
		}
		CHECK_FALSE(alignment.align().ok());
	}
}

TEST_CASE("a lag beyond half a second is an error") {
	Setup setup;
	setup.lag_s = 0.7;
	CHECK_FALSE(aligned(setup).ok());
}

TEST_CASE("mirrored axes and other units are an error") {
	for (const Eigen::Vector3d &scale :
			{ Eigen::Vector3d(1.0, 1.0, -1.0), Eigen::Vector3d(10.0, 10.0, 10.0) }) {
		TrackerAlignment alignment;
		for (int i = 0; i < 2400; ++i) {
			const double t_s = i / 240.0;
			alignment.push_reference(t_s, wander(t_s));
			alignment.push_other(t_s, scale.asDiagonal() * wander(t_s));
		}
		check_error(alignment.align(), "in metres, with axes that are not mirrored");
	}
}

TEST_CASE("samples that are not finite or not later are refused") {
	constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
	constexpr double INFINITE = std::numeric_limits<double>::infinity();
	TrackerAlignment alignment;
	Random random(1);
	push_both(alignment, {}, random);
	for (const double bad : { NOT_A_NUMBER, INFINITE, -INFINITE, 1e300 }) {
		CHECK_FALSE(alignment.push_reference(bad, Eigen::Vector3d::Zero()));
		CHECK_FALSE(alignment.push_other(2000.0, Eigen::Vector3d(0.0, bad, 0.0)));
	}
	CHECK_FALSE(alignment.push_other(500.0, Eigen::Vector3d::Zero()));
	CHECK(alignment.align().ok());
	CHECK(alignment.push_other(3000.0, Eigen::Vector3d::Zero()));
	CHECK_FALSE(alignment.push_other(3000.0, Eigen::Vector3d::Zero()));
	alignment.clear();
	CHECK(alignment.followed_s() == 0.0);
	check_error(alignment.align(), "no samples");
	CHECK(alignment.push_other(1.0, Eigen::Vector3d::Zero()));
}
