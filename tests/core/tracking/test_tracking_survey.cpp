#include "base/random.h"
#include "near.h"
#include "simulation/sensor.h"
#include "simulation/sensor_profile.h"
#include "tracking/tracking_survey.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

using namespace steadyhand;
using Eigen::Vector3d;

namespace {

constexpr double TWO_PI = 2.0 * std::numbers::pi;
constexpr int RUNS = 60; ///< of 20, three by chance would be no surprise where one is to be expected

/// The index tip sweeps 50 x 40 x 40 cm in front of the sensor, at up to 0.5 m/s.
Vector3d swept(double t_s) {
	return { 0.25 * std::sin(TWO_PI * 0.23 * t_s), 0.2 * std::sin(TWO_PI * 0.171 * t_s + 1.0),
		-0.4 + 0.2 * std::sin(TWO_PI * 0.083 * t_s + 2.0) };
}

/// Severity: it grows from 0.3 m to 0.5 m from the sensor.
double far_away(const Vector3d &place_m) {
	return std::clamp((-place_m.z() - 0.3) / 0.2, 0.0, 1.0);
}

double same_everywhere(const Vector3d & /*place_m*/) {
	return 0.3;
}

using Severity = double (*)(const Vector3d &place_m);

/// Positions are relative to an origin at -origin_m of the sensor's space.
TrackingSurvey surveyed(
		Severity severity, double span_s, std::uint64_t seed, const Vector3d &origin_m = Vector3d::Zero()) {
	TrueMotion motion;
	motion.span_s = span_s;
	motion.hand = [](double t_s) {
		HandFrame frame;
		frame.t_s = t_s;
		frame.set(Joint::INDEX, swept(t_s));
		return frame;
	};
	motion.severity = [severity](double t_s) { return severity(swept(t_s)); };
	// Some faults a minute at easy positions, one or two a second at hard ones, as in leap_unstable.
	SensorProfile profile = *find_sensor_profile("leap_unstable");
	for (double *per_s : { &profile.freeze_per_s, &profile.dropout_per_s, &profile.jump_per_s }) {
		*per_s /= 5.0;
	}
	profile.fault_growth = 14.0;
	TrackingSurvey survey;
	for (const HandFrame &frame : record_track(motion, profile, seed).frames) {
		if (frame.has(Joint::INDEX)) {
			survey.push(frame.t_s, frame.position(Joint::INDEX) + origin_m);
		}
	}
	return survey;
}

/// Half a minute at each of two positions. The second one has a dropout of 0.2 s each second.
TrackingSurvey surveyed_at_two(
		const Vector3d &first_m, const Vector3d &other_m, double first_noise_m, double other_noise_m) {
	TrackingSurvey survey;
	Random random(3);
	double t_s = 0.0;
	for (int i = 0; i < 6000; ++i) {
		const bool is_other = i >= 3000;
		const Vector3d noise{ random.normal(), random.normal(), random.normal() };
		survey.push(t_s, (is_other ? other_m : first_m) + (is_other ? other_noise_m : first_noise_m) * noise);
		t_s += is_other && i % 100 == 50 ? 0.2 : 0.01;
	}
	return survey;
}

} // namespace

TEST_CASE("two minutes of practice find a stable and an unstable position" * doctest::test_suite("figures")) {
	int distinct = 0;
	double stable_severity = 0.0;
	double unstable_severity = 0.0;
	for (int seed = 1; seed <= RUNS; ++seed) {
		CAPTURE(seed);
		const Result<TrackingSurvey::Proposal> proposal =
				surveyed(far_away, 120.0, static_cast<std::uint64_t>(seed)).propose();
		REQUIRE(proposal.ok());
		const TrackingSurvey::Place &stable = proposal.value().stable;
		const TrackingSurvey::Place &unstable = proposal.value().unstable;
		CHECK(far_away(stable.position_m) < 0.25);
		CHECK(far_away(unstable.position_m) > 0.5);
		CHECK((stable.position_m - unstable.position_m).norm() >= TrackingSurvey::APART_M);
		// The positions are within the sweep and the sensor's error.
		for (const TrackingSurvey::Place *place : { &stable, &unstable }) {
			CHECK((place->position_m - Vector3d(0, 0, -0.4)).cwiseAbs().maxCoeff() < 0.28);
		}
		distinct += proposal.value().distinct() ? 1 : 0;
		stable_severity += far_away(stable.position_m) / RUNS;
		unstable_severity += far_away(unstable.position_m) / RUNS;
	}
	CHECK(stable_severity < 0.1);
	CHECK(unstable_severity > 0.9);
	CHECK(distinct >= RUNS * 17 / 20);
}

TEST_CASE("the survey does not depend on the origin") {
	// Hands of a headset in world space: 1.6 m up, anywhere in the room, or far away in a large world.
	for (const Vector3d &origin_m : { Vector3d(5.0, 1.6, -3.0), Vector3d(-40000.0, 120.0, 7000.0) }) {
		CAPTURE(origin_m);
		const TrackingSurvey::Proposal here = surveyed(far_away, 120.0, 1).propose().value();
		const Result<TrackingSurvey::Proposal> there = surveyed(far_away, 120.0, 1, origin_m).propose();
		REQUIRE_MESSAGE(there.ok(), there.error());
		CHECK((there.value().stable.position_m - origin_m - here.stable.position_m).norm() < 1e-6);
		CHECK((there.value().unstable.position_m - origin_m - here.unstable.position_m).norm() < 1e-6);
		CHECK(there.value().unstable.lost_share == test::near(here.unstable.lost_share));
		// A position on the border of two cells may be in either.
		CHECK(there.value().contrast == test::near(here.contrast).epsilon(0.01));
	}
}

TEST_CASE("the survey covers a hand's whole reach from any first position") {
	const Vector3d near_m(4.8, 1.35, -3.0), far_m(6.4, 1.35, -3.0);
	const Result<TrackingSurvey::Proposal> proposal = surveyed_at_two(near_m, far_m, 1e-4, 1e-4).propose();
	REQUIRE_MESSAGE(proposal.ok(), proposal.error());
	CHECK((proposal.value().stable.position_m - near_m).norm() < 1e-3);
	CHECK((proposal.value().unstable.position_m - far_m).norm() < 1e-3);
}

TEST_CASE("a uniform sensor has no stable and unstable position" * doctest::test_suite("figures")) {
	int distinct = 0;
	for (int seed = 1; seed <= RUNS; ++seed) {
		const Result<TrackingSurvey::Proposal> proposal =
				surveyed(same_everywhere, 120.0, static_cast<std::uint64_t>(seed)).propose();
		REQUIRE(proposal.ok());
		distinct += proposal.value().distinct() ? 1 : 0;
	}
	CHECK(distinct <= RUNS * 2 / 20);
}

TEST_CASE("lost time counts where a fault begins, noise where it occurs") {
	const Vector3d left_m(-0.35, 0.05, -0.35), right_m(0.35, 0.05, -0.35);
	const TrackingSurvey::Proposal proposal = surveyed_at_two(left_m, right_m, 1e-4, 1e-3).propose().value();
	CHECK((proposal.stable.position_m - left_m).norm() < 1e-3);
	CHECK((proposal.unstable.position_m - right_m).norm() < 1e-3);
	CHECK(proposal.stable.lost_share < 0.01); // the leap from the one to the other
	CHECK(proposal.unstable.lost_share == test::near(30.0 * 0.19 / (30.0 + 30.0 * 0.19)).epsilon(0.05));
	CHECK(proposal.stable.noise_m < 0.3e-3);
	CHECK(proposal.unstable.noise_m == test::near(1e-3).epsilon(0.3));
}

TEST_CASE("long dropouts are worse than frequent short ones") {
	for (const bool freezes : { false, true }) {
		CAPTURE(freezes);
		TrackingSurvey survey;
		Random random(1);
		double t_s = 0.0;
		const auto track = [&](double middle_m, double length_s) {
			Vector3d place;
			for (int i = 0; i < static_cast<int>(100.0 * length_s); ++i) {
				t_s += 0.01;
				const Vector3d noise{ random.normal(), random.normal(), random.normal() };
				place = Vector3d(middle_m + 0.03 * std::sin(3.0 * t_s), 0.02 * std::sin(2.0 * t_s), -0.3) +
						2e-4 * noise;
				survey.push(t_s, place);
			}
			return place;
		};
		for (int visit = 0; visit < 6; ++visit) {
			for (int i = 0; i < 4; ++i) {
				track(-0.3, 1.0);
				t_s += 0.15;
			}
			const Vector3d last = track(0.3, 1.0);
			for (int i = 0; i < 600; ++i) {
				t_s += 0.01;
				if (freezes) {
					survey.push(t_s, last);
				}
			}
		}
		track(-0.3, 1.0);
		const TrackingSurvey::Proposal proposal = survey.propose().value();
		CHECK(proposal.stable.position_m.x() < -0.25);
		CHECK(proposal.stable.lost_share == test::near(0.15 / 1.15).epsilon(0.05));
		CHECK(proposal.unstable.position_m.x() > 0.25);
		CHECK(proposal.unstable.lost_share == test::near(6.0 / 7.0).epsilon(0.02));
	}
	TrackingSurvey away;
	for (const double t_s : { 0.0, 3600.0, 7200.0 }) {
		away.push(t_s, { 0.0, 0.0, -0.3 });
	}
	CHECK(away.duration_s() == 0.0);
}

TEST_CASE("a run too short, or in one place, reports the cause") {
	for (const double short_s : { 10.0, 16.0 }) {
		CHECK(surveyed(far_away, short_s, 1).propose().error().find("too short") != std::string::npos);
	}
	CHECK(surveyed(far_away, 25.0, 1).propose().ok());
	TrackingSurvey still;
	for (int i = 0; i < 5000; ++i) {
		still.push(0.01 * i, { 1e-4 * (i % 3), 0.0, -0.3 });
	}
	CHECK(still.propose().error().find("one place") != std::string::npos);
	CHECK(TrackingSurvey().propose().error().find("too short") != std::string::npos);
}

TEST_CASE("two positions are farther apart than a hand within a 40 cm reach") {
	for (const double reach_m : { 0.1, 0.19, 0.4, 0.6 }) {
		CAPTURE(reach_m);
		TrackingSurvey survey;
		for (int i = 0; i < 6000; ++i) { // from one end to the other and back in a second, with rests there
			const double share = std::clamp(0.5 + 0.8 * std::sin(TWO_PI * 0.01 * i), 0.0, 1.0);
			survey.push(0.01 * i, { reach_m * share + 1e-4 * (i % 3), 0.0, -0.3 });
		}
		CHECK(survey.propose().ok() == (reach_m > 0.3));
	}
}

TEST_CASE("unreachable positions and equal time stamps are ignored") {
	TrackingSurvey survey;
	for (int i = 0; i < 5000; ++i) {
		const double far_m = i % 7 == 0 ? 1e9 : std::numeric_limits<double>::max();
		survey.push(0.01 * (i - i % 2), { i % 3 == 0 ? far_m : 0.1, 0.0, -0.3 });
	}
	CHECK(survey.duration_s() == test::near(0.01 * 4998));
	for (int i = 0; i < 5000; ++i) {
		survey.push(50.0 + 0.01 * i, { i < 2500 ? -0.5 : 0.6, 1e-4 * (i % 3), -0.3 });
	}
	const TrackingSurvey::Proposal proposal = survey.propose().value();
	CHECK(proposal.stable.position_m.allFinite());
	CHECK(proposal.unstable.position_m.allFinite());
	CHECK(std::isfinite(proposal.contrast));
	CHECK(std::isfinite(proposal.unstable.noise_m));
}

TEST_CASE("later wild positions do not displace earlier cells of the survey") {
	TrackingSurvey survey;
	Random random(5);
	double t_s = 0.0;
	const auto rest = [&](double x_m) {
		for (int i = 0; i < 1500; ++i) {
			const Vector3d noise{ random.normal(), random.normal(), random.normal() };
			survey.push(t_s += 0.01, Vector3d(x_m, 0.05, -0.35) + 1e-4 * noise);
		}
	};
	rest(-0.35);
	rest(0.35);
	for (int i = 0; i < 20000; ++i) {
		const auto anywhere = [&] { return random.uniform(-1e5, 1e5); };
		survey.push(t_s += 0.01, { anywhere(), anywhere(), anywhere() });
	}
	const TrackingSurvey::Proposal proposal = survey.propose().value();
	for (const TrackingSurvey::Place *place : { &proposal.stable, &proposal.unstable }) {
		CHECK(std::abs(std::abs(place->position_m.x()) - 0.35) < 1e-3);
		CHECK(place->seconds == test::near(15.0).epsilon(0.01));
	}
}

TEST_CASE("a mouse with rounded positions has no stable and unstable position" *
		doctest::test_suite("figures")) {
	for (const double pixel_m : { 0.0005, 0.001, 0.002 }) {
		for (std::uint64_t seed = 1; seed <= 20; ++seed) {
			Random random(seed);
			const double pace = random.uniform(0.1, 0.6), phase = random.uniform(0.0, TWO_PI);
			const auto rounded = [pixel_m](double value) { return std::round(value / pixel_m) * pixel_m; };
			TrackingSurvey survey;
			for (int frame = 0; frame < 144 * 60; ++frame) {
				const double t_s = frame / 144.0;
				survey.push(t_s,
						{ rounded(0.25 * std::sin(TWO_PI * pace * t_s + phase)),
								1.2 + rounded(0.15 * std::sin(TWO_PI * 0.73 * pace * t_s)), -0.3 });
			}
			CAPTURE(pixel_m);
			CAPTURE(seed);
			const Result<TrackingSurvey::Proposal> proposal = survey.propose();
			CHECK((!proposal.ok() || !proposal.value().distinct()));
		}
	}
}
