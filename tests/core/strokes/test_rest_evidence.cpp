// What the rest before a stroke says of it.

#include "near.h"
#include "strokes/stroke_evidence.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace steadyhand;

namespace {

/// Of a straight stroke of 20 cm whose hand was seen for that long before it, and was that far from its
/// start.
double rest(double watched_s, double unrest_m) {
	Stroke stroke;
	stroke.now_s = 1.0;
	stroke.to = FeaturePlace(0.2, 0.0, 0.0, 0.0);
	stroke.middle = 0.5 * stroke.to;
	stroke.way_m = 0.2;
	stroke.watched_s = watched_s;
	stroke.unrest_m = unrest_m;
	return stroke_evidence(stroke, FeaturePlace::UnitX(), 0.2, 1.0).rest;
}

} // namespace

TEST_CASE("a hand that comes into view on its way speaks against a gesture, by no more than one in ten") {
	CHECK(rest(0.0, 0.0) < -std::log(3.0));
	CHECK(rest(0.0, 0.0) > -std::log(10.0));
	// The longer it was seen at rest, the more that speaks for one.
	for (const double watched_s : { 0.1, 0.2, 0.3, 0.4, 0.5 }) {
		CAPTURE(watched_s);
		CHECK(rest(watched_s, 0.0) > rest(watched_s - 0.1, 0.0) + 0.3);
	}
	CHECK(rest(0.5, 0.0) > std::log(5.0));
}

TEST_CASE("a hand that came from elsewhere makes one gesture in a thousand, however far it came") {
	CHECK(rest(0.5, 1.0) < -std::log(700.0));
	CHECK(rest(0.5, 1.0) > -std::log(1500.0));
	CHECK(rest(0.5, 100.0) == test::near(rest(0.5, 1.0)).epsilon(1e-6));
}
