// What of a tracker's frames is news, and since when.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "soundness/tracker_standstill.h"
#include "soundness/tracking_soundness.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace steadyhand;

// Values in amplitudes.

namespace {

constexpr double PERIOD_S = 1.0 / 128.0; // times are exact

/// A hand that comes along the way at a speed; returns when the next frame is due.
double run_up(TrackerStandstill &r_standstill, double speed_per_s, int frames) {
	r_standstill.start(0.0, 0.0);
	for (int i = 1; i < frames; ++i) {
		r_standstill.tell(i * PERIOD_S, speed_per_s * i * PERIOD_S, 0.0005);
	}
	return frames * PERIOD_S;
}

/// What a tracker is taken for that has shown the hand where it was told to.
struct Shown {
	TrackingSoundness soundness;
	double t_s = 0.0;

	void at(double x, int frames) {
		for (int i = 0; i < frames; ++i, t_s += PERIOD_S) {
			soundness.push(t_s, x);
		}
	}
};

} // namespace

TEST_CASE("a tracker is judged alike whenever it begins") {
	constexpr double LATER_S = 1024.0;
	for (const int jumps_at : { 1, 2, 30 }) {
		CAPTURE(jumps_at);
		TrackingSoundness early, late;
		for (int i = 0; i < 100; ++i) {
			const double t_s = i * PERIOD_S;
			const double x = 0.5 * t_s + (i >= jumps_at ? 0.3 : 0.0);
			const bool repeats = i > 60 && i < 75;
			early.push(t_s, repeats ? 2.0 : x);
			late.push(t_s + LATER_S, repeats ? 2.0 : x);
			CHECK(early.jumped() == late.jumped());
			CHECK(early.returned() == late.returned());
			CHECK(early.frozen() == late.frozen());
			CHECK(early.told() == late.told());
			CHECK(early.fault() == late.fault());
			CHECK(early.news_s() + LATER_S == late.news_s());
			CHECK(early.lasting_unsoundness() == late.lasting_unsoundness());
		}
	}
}

TEST_CASE("what a frame did is not said of one that repeats it") {
	Shown shown;
	const TrackingSoundness &soundness = shown.soundness;
	shown.at(0.1, 40);
	shown.at(0.5, 1);
	CHECK(soundness.jumped());
	CHECK(soundness.fault() == 1.0);
	shown.at(0.5, 1);
	CHECK_FALSE(soundness.jumped());
	CHECK(soundness.fault() == 0.0);
	shown.at(0.5, 20);
	shown.at(0.7, 1);
	CHECK(soundness.returned());
	shown.at(0.7, 1);
	CHECK_FALSE(soundness.returned());
}

TEST_CASE("a hand that moves beside the way is seen, and so is that it trembles there") {
	TrackingSoundness moving, trembling;
	for (int i = 0; i < 100; ++i) {
		moving.push(i * PERIOD_S, 0.0, FeaturePlace(0.0, 0.5 * i * PERIOD_S, 0.0, 0.0));
		CHECK(moving.told());
		CHECK_FALSE(moving.frozen());
		trembling.push(i * PERIOD_S, 0.0, FeaturePlace(0.0, 1e-4 * std::sin(2.0 * i), 0.0, 0.0));
	}
	for (int i = 0; i < 6; ++i) {
		trembling.push((100 + i) * PERIOD_S, 0.0, FeaturePlace(0.0, 1e-4 * std::sin(198.0), 0.0, 0.0));
	}
	CHECK(trembling.frozen());
	CHECK_FALSE(trembling.told());
}

TEST_CASE("exact rest tells that the hand is there") {
	TrackingSoundness soundness;
	for (int i = 0; i < 50; ++i) {
		soundness.push(i * PERIOD_S, 0.2);
	}
	CHECK(soundness.told());
	CHECK_FALSE(soundness.frozen());
}

TEST_CASE("a slow tracker is known by its first interval") {
	TrackingSoundness soundness;
	const std::vector<double> shown = { 0.0, 0.1, 0.2, 0.2, 0.3, 0.4 };
	for (std::size_t i = 0; i < shown.size(); ++i) {
		soundness.push(static_cast<double>(i) / 12.0, shown[i]);
		CHECK(soundness.fault() == 0.0);
		CHECK_FALSE(soundness.frozen());
	}
}

TEST_CASE("a fast hand does not jump before a camera that is read more often than it looks") {
	constexpr test::Drag FAST{ .onset_s = 0.5, .duration_s = 0.3, .amplitude_m = 1.0 };
	for (const int reads : { 1, 2, 3 }) {
		CAPTURE(reads);
		TrackingSoundness soundness;
		for (int i = 0; i < 128; ++i) {
			const double seen_s = (i - i % reads) * PERIOD_S;
			soundness.push(i * PERIOD_S, FAST.x_m(seen_s) + 1e-4 * std::sin(2.0 * (i - i % reads)));
			CHECK_FALSE(soundness.jumped());
			CHECK_FALSE(soundness.returned());
			CHECK(soundness.fault() == 0.0);
		}
	}
}

TEST_CASE("a tracker that has repeated itself does not stand, until it tells something again") {
	TrackerStandstill standstill;
	double t_s = run_up(standstill, 1.5, 40);
	const double lost = 1.5 * (t_s - PERIOD_S);
	CHECK(standstill.stands(t_s, lost + 1e-5, 0.0005));
	standstill.repeat();
	CHECK_FALSE(standstill.stands(t_s, lost + 1e-5, 0.0005));
	standstill.tell(t_s, 1.5 * t_s, 0.0005);
	t_s += PERIOD_S;
	CHECK(standstill.stands(t_s, 1.5 * (t_s - PERIOD_S) + 1e-5, 0.0005));
}

TEST_CASE("the first frames do not stand, and one that is forgotten is where nothing stands") {
	TrackerStandstill first;
	const double early_s = run_up(first, 1.5, 12);
	CHECK_FALSE(first.stands(early_s, 1.5 * (early_s - PERIOD_S), 0.0005));

	TrackerStandstill standstill;
	const double t_s = run_up(standstill, 1.5, 40);
	const double lost = 1.5 * (t_s - PERIOD_S);
	standstill.tell(t_s, lost + 0.3, 0.0005);
	standstill.forget();
	CHECK_FALSE(standstill.stands(t_s + PERIOD_S, lost + 0.3, 0.0005));
	CHECK(standstill.stands(t_s + PERIOD_S, lost + 1e-5, 0.0005));
}

TEST_CASE("a jump beside the way counts once, also where the frame after it repeats it") {
	TrackingSoundness soundness;
	for (int i = 0; i < 40; ++i) {
		soundness.push(i * PERIOD_S, 0.0, FeaturePlace(0.0, i < 38 ? 0.0 : 0.2, 0.0, 0.0));
	}
	CHECK(soundness.lasting_unsoundness() > 0.6);
	CHECK(soundness.lasting_unsoundness() <= 1.0 - std::exp(-1.0)); // a single one
}

TEST_CASE("a single frame elsewhere leaves a fast hand as if it had not been, whichever way it was off") {
	constexpr double SPEED_PER_S = 6.0;
	for (const FeaturePlace &off : { FeaturePlace(0.3, 0.0, 0.0, 0.0), FeaturePlace(0.0, 0.3, 0.0, 0.0),
				 FeaturePlace(0.3, 0.3, 0.0, 0.0) }) {
		CAPTURE(off.transpose());
		TrackingSoundness shown, skipped;
		for (int i = 0; i < 60; ++i) {
			const double t_s = i * PERIOD_S, x = SPEED_PER_S * t_s;
			const FeaturePlace place(x, 0.5 * x, 0.0, 0.0);
			if (i == 40) {
				shown.push(t_s, x + off.x(), place + off);
				CHECK(shown.lasting_unsoundness() > 0.6);
				continue;
			}
			shown.push(t_s, x, place);
			skipped.push(t_s, x, place);
			CHECK_FALSE(shown.jumped());
			CHECK(shown.news_s() == skipped.news_s());
			CHECK(shown.told() == skipped.told());
			CHECK((i == 41 || shown.fault() == 0.0));
			CHECK(shown.lasting_unsoundness() == test::near(0.0).epsilon(0.01));
		}
	}
}

TEST_CASE("a tracker that jumps, and shows a hand at rest there, has not lost it") {
	for (const double to : { 0.3, 1.0, -0.4 }) {
		for (const int frames_between : { 0, 1, 2 }) {
			CAPTURE(to);
			CAPTURE(frames_between);
			Shown shown;
			shown.at(0.0, 60);
			for (int i = 0; i < frames_between; ++i) {
				shown.at(0.5 * to - 0.1 * i, 1);
			}
			shown.at(to, 60);
			CHECK_FALSE(shown.soundness.frozen());
			CHECK(shown.soundness.told());
		}
	}
}
