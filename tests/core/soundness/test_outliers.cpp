// Single frames in which a tracker shows the hand elsewhere.

#include "minimum_jerk_drag.h"
#include "soundness/tracking_soundness.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace steadyhand;

// Values in amplitudes.

namespace {

constexpr double ELSEWHERE = 0.4; ///< so far from the hand an outlier is
constexpr double CAMERA_HZ = 60.0;

/// Pushes what the camera shows so often before it looks again.
template <typename Push> void read(int times, int frame, const Push &push) {
	for (int k = 0; k < times; ++k) {
		push((frame + static_cast<double>(k) / times) / CAMERA_HZ);
	}
}

} // namespace

TEST_CASE("a single frame elsewhere is taken back, also where a camera is read more often than it looks") {
	for (const int reads : { 1, 2, 3 }) {
		CAPTURE(reads);
		TrackingSoundness soundness;
		std::mt19937_64 random(3);
		std::normal_distribution<double> trembling(0.0, 4e-4);
		for (int i = 0; i < 90; ++i) {
			const double x = 0.005 * i + trembling(random) + (i == 60 ? ELSEWHERE : 0.0);
			const FeaturePlace place(x, trembling(random), 0.0, 0.0);
			read(reads, i, [&](double t_s) { soundness.push(t_s, x, place); });
			if (i == 60) {
				CHECK(soundness.unsoundness() > 0.5);
			}
		}
		CHECK(soundness.unsoundness() < 0.01);
	}
}

TEST_CASE("a slow hand that stands still after a single frame elsewhere is at rest, and the tracker sound") {
	constexpr int OUTLIER = 60, STANDS_FROM = 63;
	constexpr double PERIOD_S = 0.009, STEP = 0.0005;
	for (const double elsewhere : { -ELSEWHERE, ELSEWHERE, 3.0 * ELSEWHERE }) {
		CAPTURE(elsewhere);
		TrackingSoundness soundness;
		for (int i = 0; i < 120; ++i) {
			const double x = STEP * std::min(i, STANDS_FROM) + (i == OUTLIER ? elsewhere : 0.0);
			soundness.push(PERIOD_S * i, x, FeaturePlace(x, 0.0, 0.0, 0.0));
		}
		CHECK_FALSE(soundness.frozen());
		CHECK(soundness.unsoundness() < 0.01);
	}
}

TEST_CASE("the tracker has returned in the first frame after it lost the hand, and in none that follows") {
	constexpr double LOST_S = 1.04, FOUND_S = 1.1;
	const test::Drag quick{ .onset_s = 1.0, .duration_s = 0.2, .amplitude_m = 1.0 };
	std::mt19937_64 random(3);
	std::normal_distribution<double> trembling(0.0, 1e-4);
	TrackingSoundness soundness;
	int returned = 0;
	for (int i = 0; i < 170; ++i) {
		const double t_s = 0.01 * i;
		if (t_s > LOST_S && t_s < FOUND_S) {
			continue;
		}
		soundness.push(t_s, quick.x_m(t_s) + trembling(random));
		returned += soundness.returned() ? 1 : 0;
		if (soundness.returned()) {
			CHECK(soundness.news_s() < LOST_S + 0.001); // what was news last
		} else {
			CHECK(soundness.news_s() == t_s);
		}
	}
	CHECK(returned == 1);
}
