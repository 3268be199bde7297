// Where a hand was, from places some time apart.

#include "near.h"
#include "strokes/way_knots.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace steadyhand;

namespace {

FeaturePlace at(double x_m) {
	FeaturePlace place = FeaturePlace::Zero();
	place.head<2>() << x_m, 2.0 * x_m;
	return place;
}

} // namespace

TEST_CASE("a way is straight between its places, and stays at the last one") {
	WayKnots way;
	way.restart(1.0, at(0.0));
	// The second newest place is a knot or is none: 0.06 and 0.03 s after the one before.
	for (const double step_s : { 0.06, 0.03 }) {
		for (int i = 1; i <= 20; ++i) {
			way.push(1.0 + step_s * i, at(0.01 * i));
		}
		const double end_s = 1.0 + step_s * 20;
		CHECK((way.place_m(0.0) - at(0.0)).norm() == 0.0);
		CHECK((way.place_m(1.0 + step_s * 9.5) - at(0.095)).norm() < 1e-12);
		for (const double later_s : { 0.0, 0.01, 1.0, 100.0 }) {
			CHECK((way.place_m(end_s + later_s) - at(0.2)).norm() == 0.0);
			CHECK(way.stray_m(end_s, end_s + later_s + 0.5 * WayKnots::APART_S) == 0.0);
		}
		CHECK(way.stray_m(1.0, end_s + 1.0) == test::near(at(0.2).norm()));
		way.restart(1.0, at(0.0));
	}
}
