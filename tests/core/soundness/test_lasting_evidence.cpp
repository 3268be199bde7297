// What is known of a tracker for longer than a fault lasts.

#include "soundness/tracking_soundness.h"

#include <doctest/doctest.h>

using namespace steadyhand;

TEST_CASE("a tracker that lost the hand is known for one for some seconds, and held to be late for as long") {
	constexpr double PERIOD_S = 0.01, SPEED_PER_S = 0.3;
	TrackingSoundness soundness;
	double t_s = 0.0;
	const auto see_for = [&](double seconds) {
		const double until_s = t_s + seconds;
		while (t_s < until_s) {
			soundness.push(t_s, SPEED_PER_S * t_s);
			t_s += PERIOD_S;
		}
	};
	see_for(1.0);
	CHECK(soundness.lasting_unsoundness() == 0.0);
	t_s += 0.3; // nothing is seen
	see_for(0.05);
	const double known = soundness.lasting_unsoundness(), late = soundness.lateness();
	CHECK(known > 0.5);
	CHECK(late > 0.5);
	see_for(2.0);
	CHECK(soundness.lasting_unsoundness() > 0.6 * known);
	CHECK(soundness.lateness() > 0.6 * late);
	CHECK(soundness.unsoundness() < 0.3 * known); // of this moment
	see_for(4.0);
	CHECK(soundness.lasting_unsoundness() < 0.6 * known);
	CHECK(soundness.lateness() < 0.6 * late);
	see_for(14.0);
	CHECK(soundness.lasting_unsoundness() < 0.05);
	CHECK(soundness.lateness() < 0.05);
}
