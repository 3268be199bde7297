// What tells a tracker that errs before it shows a fault: frames left out, and the shape of the way.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "signal/minimum_jerk.h"
#include "soundness/skipped_frames.h"
#include "soundness/tracking_soundness.h"
#include "soundness/way_shape.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace steadyhand;

namespace {

constexpr double LEFT_OUT = 0.045, LEFT_OUT_SOUND = 0.012; ///< shares of intervals
constexpr double NATS = 1.9, EVEN = 0.009, MOST = 2.0;

/// Mean of the logarithm while a tracker leaves out that share of its frames.
double mean_log_ratio(double share) {
	SkippedFrames skipped;
	std::mt19937_64 random(1);
	std::bernoulli_distribution is_left_out(share);
	double sum = 0.0;
	constexpr int FRAMES = 20000;
	for (int i = 0; i < FRAMES; ++i) {
		skipped.push(is_left_out(random));
		sum += skipped.log_ratio();
	}
	return sum / FRAMES;
}

/// Beside the x axis; it wanders by that much, and its noise is white.
struct Way {
	double bow, wanders;
	double noise = 0.0;

	[[nodiscard]] FeaturePlace at(double x, std::mt19937_64 &r_random) const {
		std::normal_distribution<double> white(0.0, 1.0);
		FeaturePlace place(0.3 + x, 4.0 * bow * x * (1.0 - x), 0.1, 0.0);
		place.y() += wanders * std::sin(9.0 * x) + noise * white(r_random);
		place.z() += wanders * std::cos(7.0 * x) + noise * white(r_random);
		return place;
	}
};

constexpr int FRAMES = 60;
double x_of(int frame) {
	return frame / static_cast<double>(FRAMES);
}

/// Root mean square distance from the parabola that fits the frames after the start best, by orthogonal
/// factors.
double distance_from_bow(const Way &way, int first, int last) {
	std::mt19937_64 random(3);
	Eigen::MatrixX3d powers(last - first + 1, 3);
	Eigen::MatrixXd places(last - first + 1, 4);
	for (int i = 0; i <= last; ++i) {
		const FeaturePlace place = way.at(x_of(i), random);
		if (i >= first) {
			powers.row(i - first) << 1.0, x_of(i), x_of(i) * x_of(i);
			places.row(i - first) = place;
		}
	}
	const Eigen::MatrixXd off = places - powers * powers.colPivHouseholderQr().solve(places);
	return off.norm() / std::sqrt(static_cast<double>(off.rows()));
}

double greatest_log_ratio(const Way &way) {
	WayShape shape;
	std::mt19937_64 random(3);
	double greatest = 0.0;
	for (int i = 0; i < FRAMES; ++i) {
		shape.push(x_of(i), way.at(x_of(i), random), way.noise);
		greatest = std::max(greatest, shape.log_ratio());
	}
	return greatest;
}

} // namespace

TEST_CASE("each frame that is left out, or not, counts by the logarithm of how much oftener trackers that "
		  "err do so") {
	SkippedFrames skipped;
	for (int i = 0; i < 100; ++i) {
		skipped.push(false);
		CHECK(skipped.log_ratio() == 0.0);
	}
	const double left_out = std::log(LEFT_OUT / LEFT_OUT_SOUND);
	const double regular = std::log((1.0 - LEFT_OUT) / (1.0 - LEFT_OUT_SOUND));
	skipped.push(true);
	CHECK(skipped.log_ratio() == test::near(left_out));
	for (int i = 0; i < 10; ++i) {
		const double before = skipped.log_ratio();
		skipped.push(false);
		CHECK(skipped.log_ratio() - before == test::near(regular));
	}
	skipped.push(true);
	CHECK(skipped.log_ratio() == test::near(2.0 * left_out + 10.0 * regular));
	skipped.push(true);
	CHECK(skipped.log_ratio() == 3.0);
}

TEST_CASE("a single frame beside the way says nothing of the way's shape") {
	const test::Drag drag{ .onset_s = 0.3, .duration_s = 0.8, .amplitude_m = 1.0 };
	for (const double beside : { 0.0, 0.15 }) {
		TrackingSoundness soundness;
		bool strays = false;
		for (int frame = 0; frame < 130; ++frame) {
			const double t_s = 0.009 * frame, x = drag.x_m(t_s) + 1e-4 * std::sin(1e3 * t_s);
			const bool is_there = frame == 59; // a fifth of the way
			soundness.push(t_s, x, { x, is_there ? beside : 0.0, 1e-4, 0.0 });
			strays = strays || soundness.leapt();
		}
		CHECK(strays == (beside > 0.0));
		CHECK(soundness.log_ratio() == 0.0);
	}
}

TEST_CASE("what a frame changes of that is told once, and a gap changes nothing") {
	TrackingSoundness soundness;
	double t_s = 0.0, told = 0.0;
	const auto come_after = [&](double periods) {
		t_s += 0.01 * periods;
		const double before = soundness.log_ratio();
		soundness.push(t_s, 1e-4 * std::sin(1e3 * t_s));
		told += soundness.log_ratio_news();
		CHECK(soundness.log_ratio_news() == soundness.log_ratio() - before);
		CHECK(told == test::near(soundness.log_ratio()));
	};
	for (const double periods : { 0.0, 1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 2.0 }) {
		come_after(periods);
	}
	CHECK(soundness.log_ratio_news() > 1.0);
	come_after(20.0);
	CHECK(soundness.log_ratio_news() == 0.0);
}

TEST_CASE("a tracker that leaves out 1 % of its frames is hardly suspected, one that leaves out 5 % is") {
	CHECK(mean_log_ratio(0.005) < 0.3);
	CHECK(mean_log_ratio(0.01) < 0.6);
	CHECK(mean_log_ratio(0.05) > 2.0);
}

TEST_CASE("a way's shape counts by its distance from the bow that fits it best") {
	const Way way{ .bow = 0.1, .wanders = 0.024 };
	WayShape shape;
	std::mt19937_64 random(3);
	const int first = 2; // the last frame at the start
	REQUIRE(x_of(first) < 0.05);
	REQUIRE(x_of(first + 1) >= 0.05);
	bool is_between = false;
	for (int i = 0; i < 0.8 * FRAMES; ++i) {
		const double x = x_of(i);
		shape.push(x, way.at(x, random), 0.0);
		if (x > 0.15) {
			const double nats = NATS * std::log(distance_from_bow(way, first, i) / (EVEN * x));
			CHECK(shape.log_ratio() == test::near(std::clamp(nats, 0.0, MOST)).epsilon(1e-4));
			is_between = is_between || (shape.log_ratio() > 0.1 && shape.log_ratio() < MOST - 0.1);
		}
	}
	CHECK(is_between);
}

TEST_CASE("no bow, and no noise that is known, speaks against a tracker; wandering does") {
	for (const double bow : { 0.0, 0.05, -0.2, 0.4 }) {
		CAPTURE(bow);
		CHECK(greatest_log_ratio({ .bow = bow, .wanders = 0.0 }) == 0.0);
		CHECK(greatest_log_ratio({ .bow = bow, .wanders = 0.0, .noise = 0.002 }) < 1.0);
		CHECK(greatest_log_ratio({ .bow = bow, .wanders = 0.06 }) == MOST);
	}
}

TEST_CASE("a way that is first seen half-way, or is over, says nothing, and a new one begins anew") {
	const Way way{ .bow = 0.1, .wanders = 0.03 };
	WayShape shape;
	std::mt19937_64 random(3);
	for (int i = FRAMES / 4; i < FRAMES; ++i) {
		shape.push(x_of(i), way.at(x_of(i), random), 0.0);
		CHECK(shape.log_ratio() == 0.0);
	}
	for (int i = 0; i < FRAMES; ++i) {
		const double before = shape.log_ratio();
		shape.push(x_of(i), way.at(x_of(i), random), 0.0);
		CHECK((x_of(i) <= 0.8 || shape.log_ratio() == before));
	}
	CHECK(shape.log_ratio() > 0.0);
	shape.push(0.0, way.at(0.0, random), 0.0);
	CHECK(shape.log_ratio() == 0.0);
}

TEST_CASE("a way in space that wanders speaks against a tracker, and a hand that wanders while it grows does "
		  "not") {
	for (const bool is_grown : { false, true }) {
		CAPTURE(is_grown);
		TrackingSoundness soundness;
		double greatest = 0.0;
		for (int i = 0; i < 100; ++i) {
			const double x = minimum_jerk(i / 100.0).value;
			const FeaturePlace place(
					is_grown ? 0.3 : x, 0.03 * std::sin(9.0 * x), 0.1, is_grown ? x + 0.5 : 0.0);
			soundness.push(0.009 * i, x, place);
			greatest = std::max(greatest, soundness.log_ratio());
		}
		CHECK((greatest > 0.0) == !is_grown);
	}
}
