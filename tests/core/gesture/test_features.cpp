#include "gesture/circumcircle.h"
#include "gesture/feature.h"
#include "gesture/feature_choice.h"
#include "gesture/motion_element.h"
#include "near.h"
#include "simulation/synthetic_trial.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace steadyhand;
using Eigen::Vector2d;
using Triangle = std::array<Vector2d, 3>;

namespace {

constexpr double PI = std::numbers::pi;

std::optional<double> radius_of(const Triangle &t) {
	return circumradius(t[0], t[1], t[2]);
}

Vector2d on_circle(const Vector2d &centre, double radius, double angle_rad) {
	return centre + radius * Vector2d(std::cos(angle_rad), std::sin(angle_rad));
}

/// Centre and radius from |p|^2 - 2 o.p = r^2 - |o|^2, three linear equations, by QR in extended precision.
Eigen::Vector3d solved_circle(const Triangle &t) {
	using Matrix = Eigen::Matrix<long double, 3, 3>;
	using Vector = Eigen::Matrix<long double, 3, 1>;
	Matrix a;
	Vector b;
	for (int i = 0; i < 3; ++i) {
		const Eigen::Matrix<long double, 2, 1> p = t[static_cast<std::size_t>(i)].cast<long double>();
		a.row(i) << 2.0L * p.x(), 2.0L * p.y(), 1.0L;
		b(i) = p.squaredNorm();
	}
	const Vector x = a.fullPivHouseholderQr().solve(b);
	return Vector(x(0), x(1), std::sqrt(x(2) + x(0) * x(0) + x(1) * x(1))).cast<double>();
}

/// Error gain by brute force: root of the sum of squares of the radius' change for small steps of each point.
double error_gain(const Triangle &t) {
	const Eigen::Vector3d circle = solved_circle(t);
	double sum = 0.0;
	for (std::size_t i = 0; i < 3; ++i) {
		const double step = 1e-6 * (t[1] - t[0]).norm();
		Triangle out = t, in = t;
		const Vector2d outward = (t[i] - circle.head<2>()).normalized();
		out[i] += step * outward;
		in[i] -= step * outward;
		sum += std::pow((solved_circle(out).z() - solved_circle(in).z()) / (2.0 * step), 2);
	}
	return std::sqrt(sum);
}

HandFrame tips(const Triangle &t) {
	HandFrame frame;
	frame.set(Joint::THUMB, { t[0].x(), t[0].y(), 0.3 });
	frame.set(Joint::INDEX, { t[1].x(), t[1].y(), -0.2 });
	frame.set(Joint::MIDDLE, { t[2].x(), t[2].y(), 0.1 });
	return frame;
}

HandFrame index_at(const Eigen::Vector3d &place) {
	HandFrame frame;
	frame.set(Joint::INDEX, place);
	return frame;
}

std::vector<TrainingRecording> synthetic_recordings(const std::string &gesture) {
	std::vector<TrainingRecording> recordings;
	for (const SyntheticTrialRequest &request :
			plan_synthetic_set({ .subjects = 3, .repetitions = 2, .gestures = { gesture } })) {
		SyntheticTrial made = make_synthetic_trial(request).value();
		recordings.push_back(
				{ made.trial.trial, { made.trial.start_m, made.trial.axis, made.trial.amplitude_m },
						made.trial.start_s, made.trial.end_s, made.measured, made.reference });
	}
	return recordings;
}

} // namespace

TEST_CASE("a feature needs all of its joints in a frame") {
	const Task task{ { 0.02, 0.0, 0.0 }, Eigen::Vector3d::UnitX(), 0.2 };
	HandFrame hand;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		const double angle = 0.7 * static_cast<double>(i);
		hand.set(static_cast<Joint>(i), { 0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.01 });
	}
	for (const Feature &feature : features()) {
		CAPTURE(feature.name);
		REQUIRE(feature.joints != 0);
		HandFrame frame = hand;
		frame.tracked = feature.joints;
		CHECK(feature.measure(frame, task).has_value());
		for (unsigned bit = 1; bit < 1U << JOINT_COUNT; bit <<= 1) {
			frame.tracked = static_cast<std::uint8_t>(hand.tracked & ~bit);
			const bool is_needed = (feature.joints & bit) != 0;
			CHECK(feature.measure(frame, task).has_value() == !is_needed);
			CHECK((feature.place == nullptr || feature.place(frame).has_value() == !is_needed));
		}
	}
}

TEST_CASE("circumradius() is right for known triangles") {
	CHECK(*circumradius({ 0, 0 }, { 3, 0 }, { 0, 4 }) == test::near(2.5).epsilon(1e-15));
	CHECK(*circumradius({ 0, 0 }, { 1, 0 }, { 0.5, std::sqrt(0.75) }) ==
			test::near(1.0 / std::sqrt(3.0)).epsilon(1e-15));
	CHECK(*circumradius({ 0, 0 }, { 14, 0 }, { 5, 12 }) == test::near(65.0 / 8.0).epsilon(1e-15));
}

TEST_CASE("circumradius() finds the radius of random circles") {
	std::mt19937_64 random(1);
	std::uniform_real_distribution<double> angle(0.0, 2.0 * PI), exponent(-9.0, 9.0), place(-1.0, 1.0);
	int given = 0;
	for (int i = 0; i < 20000; ++i) {
		const double radius = std::pow(10.0, exponent(random));
		const Vector2d centre = 10.0 * radius * Vector2d{ place(random), place(random) };
		const Triangle t{ on_circle(centre, radius, angle(random)), on_circle(centre, radius, angle(random)),
			on_circle(centre, radius, angle(random)) };
		const std::optional<double> found = radius_of(t);
		if (!found) {
			continue;
		}
		++given;
		// The gain magnifies the rounding of the coordinates, which are at most 11 radii: 2^-53 of them.
		REQUIRE(*found == test::near(radius).epsilon(1e-13));
		const Eigen::Rotation2Dd turn(angle(random));
		const Vector2d shift = radius * Vector2d{ place(random), place(random) };
		const Triangle moved{ turn * t[2] + shift, turn * t[0] + shift, turn * t[1] + shift };
		if (const std::optional<double> again = radius_of(moved)) {
			REQUIRE(*again == test::near(*found).epsilon(1e-12));
		}
	}
	CHECK(given > 15000);
}

TEST_CASE("a radius exists only if it magnifies tip errors less than tenfold") {
	std::mt19937_64 random(2);
	std::uniform_real_distribution<double> place(-1.0, 1.0);
	int given = 0, withheld = 0;
	for (int i = 0; i < 20000; ++i) {
		// Half of the triangles are flat, or have two points near each other.
		const double flat = i % 2 == 0 ? 1.0 : 0.1;
		Triangle t;
		for (Vector2d &p : t) {
			p = { place(random), flat * place(random) };
		}
		const double gain = error_gain(t);
		if (std::abs(gain / ERROR_GAIN_MAX - 1.0) < 1e-3) {
			continue; // the difference quotient is no better than that
		}
		const std::optional<double> radius = radius_of(t);
		REQUIRE(radius.has_value() == (gain < ERROR_GAIN_MAX));
		if (radius) {
			REQUIRE(*radius == test::near(solved_circle(t).z()).epsilon(1e-12));
		}
		++(radius ? given : withheld);
	}
	CHECK(given > 5000);
	CHECK(withheld > 2000);
}

TEST_CASE("a zoom's position includes the radius minus the tips' size") {
	// The mean square distance of points on a circle from their mean g is R^2 - |o - g|^2.
	const Feature &zoom = *find_feature("tips_circumradius");
	std::mt19937_64 random(4);
	std::uniform_real_distribution<double> angle(0.0, 2.0 * PI);
	for (int i = 0; i < 1000; ++i) {
		const Vector2d centre(0.1, -0.2);
		const Triangle t{ on_circle(centre, 0.03, angle(random)), on_circle(centre, 0.03, angle(random)),
			on_circle(centre, 0.03, angle(random)) };
		const std::optional<FeaturePlace> place = zoom.place(tips(t));
		if (!place) {
			continue;
		}
		const Vector2d mean = (t[0] + t[1] + t[2]) / 3.0;
		const double size = std::sqrt(0.03 * 0.03 - (centre - mean).squaredNorm());
		REQUIRE((*place - FeaturePlace(mean.x(), mean.y(), 0.03 - size, 0.03)).norm() < 1e-12);
	}
	// Tips that spread keep their shape. At a third of a circle apart, radius and size are equal.
	const auto third = [](double radius) {
		return Triangle{ on_circle({ 0, 0 }, radius, 0.1), on_circle({ 0, 0 }, radius, 0.1 + 2.0 * PI / 3.0),
			on_circle({ 0, 0 }, radius, 0.1 - 2.0 * PI / 3.0) };
	};
	CHECK(std::abs((*zoom.place(tips(third(0.05))))(2)) < 1e-15);
}

TEST_CASE("tips in a line or in one point have no radius") {
	for (const double size : { 1e-300, 1e-9, 1.0, 1e9, 1e300 }) {
		const Vector2d a(0.1 * size, 0.7 * size), along(0.3 * size, -0.2 * size);
		CHECK_FALSE(circumradius(a, a, a));
		CHECK_FALSE(circumradius(a, a, a + along));
		CHECK_FALSE(circumradius(a, a + along, a));
		CHECK_FALSE(circumradius(a, a + along, a + along));
		CHECK_FALSE(circumradius(a, a + along, a + 2.0 * along));
		CHECK_FALSE(circumradius(a, a + along, a - along));
		CHECK(*circumradius(a, a + along, a + Vector2d(-along.y(), along.x())) ==
				test::near(along.stableNorm() / std::sqrt(2.0)).epsilon(1e-9));
	}
	CHECK_FALSE(circumradius({ 0, 0 }, { 0, 0 }, { 0, 0 }));
	const double largest = std::numeric_limits<double>::max();
	CHECK_FALSE(circumradius({ -largest, 0 }, { largest, 0 }, { 0, largest }));
	// Nearer and nearer to a line: each value is finite.
	int given = 0;
	for (int halvings = 0; halvings < 1060; ++halvings) {
		const double height = std::ldexp(1.0, -halvings);
		if (const std::optional<double> radius = circumradius({ -1, 0 }, { 1, 0 }, { 0, height })) {
			CHECK(halvings == given++);
			CHECK(*radius == test::near((1.0 + height * height) / (2.0 * height)));
		}
	}
	// w = ((1 + h^2) / 4 h^2, the same, (h^2 - 1) / 2 h^2): |w| passes 10 at a height of h = 0.245.
	CHECK(given == 3);
}

TEST_CASE("tips_circumradius ignores z, needs three tips, is 0 at the start") {
	const Feature *const feature = find_feature("tips_circumradius");
	REQUIRE(feature != nullptr);
	const Task task{ { 0.015, 0.0, 0.0 }, Eigen::Vector3d::Zero(), 0.03 };
	const Vector2d centre(0.2, -0.1);
	const auto open_to = [&](double radius_m) {
		return tips({ on_circle(centre, radius_m, 3.6), on_circle(centre, radius_m, 1.5),
				on_circle(centre, radius_m, 0.4) });
	};
	for (const double radius_m : { 0.015, 0.02, 0.045 }) {
		CHECK(*feature->measure(open_to(radius_m), task) == test::near(radius_m - 0.015));
	}
	for (const Joint joint : { Joint::THUMB, Joint::INDEX, Joint::MIDDLE }) {
		HandFrame frame = open_to(0.02);
		frame.tracked = static_cast<std::uint8_t>(frame.tracked & ~(1U << static_cast<unsigned>(joint)));
		CHECK_FALSE(feature->measure(frame, task));
	}
}

TEST_CASE("index_along_circle is the arc length over several rounds, in both directions") {
	const Feature *const feature = find_feature("index_along_circle");
	REQUIRE(feature != nullptr);
	std::mt19937_64 random(3);
	std::uniform_real_distribution<double> any(-1.0, 1.0);
	for (int i = 0; i < 50; ++i) {
		const double radius_m = 0.05 + 0.03 * any(random);
		const double begin_rad = PI * any(random);
		const Eigen::Vector3d centre{ any(random), any(random), any(random) };
		const auto place = [&](double angle_rad, double share) {
			return Eigen::Vector3d(centre.x() + share * radius_m * std::cos(begin_rad + angle_rad),
					centre.y() + share * radius_m * std::sin(begin_rad + angle_rad), any(random));
		};
		const Task task{ place(0.0, 1.0), { -std::sin(begin_rad), std::cos(begin_rad), 0.0 },
			2.0 * PI * radius_m };
		MotionElement element(*feature);
		// Back by more than half a round, forward by almost three, and back.
		for (int step = 0; step <= 380; ++step) {
			const double angle_rad = 0.1 * (step < 40 ? -step : step < 260 ? step - 80 : 440 - step);
			const std::optional<double> x_m =
					element.measure(index_at(place(angle_rad, 1.0 + 0.3 * any(random))), task);
			REQUIRE(x_m);
			REQUIRE(*x_m == test::near(radius_m * angle_rad).epsilon(1e-9));
		}
		CHECK(*feature->measure(index_at(place(2.0, 1.0)), task) == test::near(2.0 * radius_m));
		CHECK(*feature->measure(index_at(place(4.0, 1.0)), task) == test::near((4.0 - 2.0 * PI) * radius_m));
		element.restart();
		CHECK(*element.measure(index_at(place(0.5, 1.0)), task) == test::near(0.5 * radius_m));
		CHECK_FALSE(feature->measure(index_at(place(1.0, 0.05)), task));
		CHECK_FALSE(feature->measure(index_at(centre), task));
		CHECK_FALSE(feature->measure(HandFrame{}, task));
	}
	// No circle in the xy plane begins along z.
	CHECK_FALSE(feature->measure(index_at({ 1, 1, 1 }), { {}, Eigen::Vector3d::UnitZ(), 0.3 }));
}

TEST_CASE("every feature is finite or nullopt at extreme coordinates") {
	std::mt19937_64 random(4);
	std::uniform_real_distribution<double> any(-1.0, 1.0);
	for (const Feature &feature : features()) {
		for (const double size : { 0.0, 1e-9, 1e-3, 1.0, 1e9 }) {
			for (int i = 0; i < 500; ++i) {
				HandFrame frame;
				for (const Joint joint : { Joint::THUMB, Joint::INDEX, Joint::MIDDLE }) {
					frame.set(joint, size * Eigen::Vector3d{ any(random), any(random), any(random) });
				}
				const Task task{ size * Eigen::Vector3d{ any(random), any(random), any(random) },
					Eigen::Vector3d{ any(random), any(random), any(random) }.normalized(), 0.2 };
				MotionElement element(feature);
				for (int repetition = 0; repetition < 3; ++repetition) {
					const std::optional<double> x_m = element.measure(frame, task);
					REQUIRE(std::isfinite(x_m.value_or(0.0)));
				}
			}
		}
	}
}

TEST_CASE("a feature's position and motion element grow alike along its direction") {
	std::mt19937_64 random(5);
	std::uniform_real_distribution<double> any(-1.0, 1.0);
	for (const Feature &feature : features()) {
		CHECK((feature.place == nullptr) == (feature.direction == nullptr));
		if (feature.place == nullptr) {
			continue;
		}
		for (int i = 0; i < 200; ++i) {
			const Task task{ Eigen::Vector3d{ any(random), any(random), any(random) },
				Eigen::Vector3d{ any(random), any(random), any(random) }.normalized(), 0.2 };
			std::array<HandFrame, 2> frames;
			for (HandFrame &frame : frames) {
				for (const Joint joint : { Joint::THUMB, Joint::INDEX, Joint::MIDDLE }) {
					frame.set(joint, { any(random), any(random), any(random) });
				}
			}
			const std::optional<double> from_m = feature.measure(frames[0], task),
										to_m = feature.measure(frames[1], task);
			const std::optional<FeaturePlace> from = feature.place(frames[0]), to = feature.place(frames[1]);
			REQUIRE(from.has_value() == from_m.has_value());
			REQUIRE(to.has_value() == to_m.has_value());
			if (from && to) {
				REQUIRE((*to - *from).dot(feature.direction(task)) == test::near(*to_m - *from_m));
			}
		}
	}
}

TEST_CASE("the feature is found from the axes of the recordings") {
	for (const auto &[gesture, feature] : { std::pair("horizontal_drag", "index_along_axis"),
				 std::pair("vertical_drag", "index_along_axis"), std::pair("tap", "index_along_axis"),
				 std::pair("zoom", "tips_circumradius"), std::pair("circle", "index_along_circle") }) {
		const Feature *const chosen = choose_feature(synthetic_recordings(gesture));
		REQUIRE(chosen != nullptr);
		CHECK(chosen->name == feature);
	}
	std::vector<TrainingRecording> astray = synthetic_recordings("tap");
	for (TrainingRecording &recording : astray) {
		recording.task.amplitude_m = 5.0;
	}
	CHECK(choose_feature(astray) == nullptr);
	CHECK(choose_feature({}) == nullptr);
}
