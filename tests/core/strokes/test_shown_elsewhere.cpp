#include "minimum_jerk_drag.h"
#include "signal/minimum_jerk.h"
#include "strokes/shown_elsewhere.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;
using Sight = ShownElsewhere::Sight;

namespace {

constexpr double RATE_HZ = 90.0, LENGTH_S = 2.0;

/// Frames of a hand that goes 20 cm to the right within a second, beside which another place is shown.
struct Seen {
	double from_s, to_s;
	FeaturePlace off_m; ///< of that, from where the hand was at from_s
	int left = 0, returned = 0;
	double returned_s = 0.0;

	Seen &watch() {
		const test::Drag drag{ .onset_s = 0.5, .duration_s = 1.0, .amplitude_m = 0.2 };
		ShownElsewhere elsewhere;
		for (int i = 0; i < LENGTH_S * RATE_HZ; ++i) {
			const double t_s = i / RATE_HZ;
			const bool is_elsewhere = t_s >= from_s && t_s < to_s;
			FeaturePlace place_m{ drag.x_m(is_elsewhere ? from_s : t_s), 0.0, 0.0, 0.0 };
			place_m += is_elsewhere ? off_m : FeaturePlace(FeaturePlace::Zero());
			const Sight sight = elsewhere.look(t_s, place_m);
			left += sight == Sight::LEAVES ? 1 : 0;
			returned += sight == Sight::RETURNS ? 1 : 0;
			returned_s = sight == Sight::RETURNS ? t_s : returned_s;
		}
		return *this;
	}
};

} // namespace

TEST_CASE("a tracker that shows another place for some tenths of a second leaves, and returns with the first "
		  "frame of the hand") {
	for (const double to_s : { 0.93, 1.02, 1.11 }) {
		CAPTURE(to_s);
		const Seen seen = Seen{ 0.8, to_s, { -0.2, 0.1, 0.0, 0.0 } }.watch();
		CHECK(seen.left == 1);
		CHECK(seen.returned == 1);
		CHECK(seen.returned_s - to_s < 1.0 / RATE_HZ);
	}
}

TEST_CASE("one that stays there for half a second, or goes to a third place, has not returned") {
	const Seen late = Seen{ 0.8, 1.3, { -0.2, 0.1, 0.0, 0.0 } }.watch();
	CHECK(late.left == 2);
	CHECK(late.returned == 0);
	ShownElsewhere elsewhere;
	const FeaturePlace still_m = FeaturePlace::Zero(), second_m{ 0.2, 0.0, 0.0, 0.0 };
	const FeaturePlace third_m{ 0.1, 0.3, 0.0, 0.0 }, near_m{ 0.001, 0.0, 0.0, 0.0 };
	CHECK(elsewhere.look(0.00, still_m) == Sight::ON_ITS_WAY);
	CHECK(elsewhere.look(0.01, near_m) == Sight::ON_ITS_WAY);
	CHECK(elsewhere.look(0.02, second_m) == Sight::LEAVES);
	CHECK(elsewhere.look(0.03, second_m) == Sight::ON_ITS_WAY);
	CHECK(elsewhere.look(0.04, third_m) == Sight::ON_ITS_WAY);
	CHECK(elsewhere.look(0.05, still_m) == Sight::RETURNS);
	CHECK(elsewhere.look(0.06, third_m) == Sight::LEAVES);
}

TEST_CASE("no hand leaves: 20 cm to and fro in 0.2 s each, before any rate, repeated frames and 2 mm of "
		  "noise") {
	for (const double rate_hz : { 15.0, 30.0, 60.0, 110.0, 500.0 }) {
		for (const int repeats : { 1, 4 }) {
			CAPTURE(rate_hz);
			CAPTURE(repeats);
			ShownElsewhere elsewhere;
			std::mt19937_64 random(1);
			std::normal_distribution<double> noise(0.0, 2e-3);
			int other = 0;
			for (int i = 0; i < 4.0 * rate_hz; ++i) {
				const double t_s = i / rate_hz, phase = std::fmod(t_s, 0.4) / 0.2;
				const double x_m = 0.2 * minimum_jerk(phase < 1.0 ? phase : 2.0 - phase).value;
				const FeaturePlace place_m{ x_m + noise(random), noise(random), noise(random), 0.0 };
				for (int k = 0; k < repeats; ++k) {
					other += elsewhere.look(t_s + k / (rate_hz * repeats), place_m) != Sight::ON_ITS_WAY ? 1
																										 : 0;
				}
			}
			CHECK(other == 0);
		}
	}
}
