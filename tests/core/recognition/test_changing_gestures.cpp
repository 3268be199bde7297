// With nothing given: when a hand that bends from one gesture's way to another's is taken to make the other.

#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double APART_RAD = 0.45;     ///< the two gestures' axes
constexpr double BENDS_UNTIL = 0.7;    ///< of the way
constexpr double LOOKS_UNTIL_S = 1.25; ///< three quarters of the way: nothing has ended

/// By how many nats the other one is likelier than the gesture under way, of which and of none confidence
/// says: odds / (odds + other odds + 1). Very negative where there is no other one.
double nats_of_other(const GestureRecogniser &recogniser) {
	const double odds = std::exp(recogniser.session()->log_odds());
	const double other = odds / recogniser.confidence() - odds - 1.0;
	return std::log(std::max(other, 1e-9) / odds);
}

struct Change {
	std::vector<std::string> said;
	double most_before = -1e9; ///< nats by which the second gesture was likelier while the first was shown
};

/// Of a hand whose way from its start turns from the first gesture's axis by that much.
Change bending_by(double turns_rad) {
	const Eigen::Vector3d second_axis(std::cos(APART_RAD), std::sin(APART_RAD), 0.0);
	GestureRecogniser recogniser({ model("first", X, false), model("second", second_axis, false) },
			std::nullopt, MotionMode::PHASE);
	Change change;
	const Way way = [&](double t_s) {
		if (recogniser.gesture() == 0) {
			change.most_before = std::max(change.most_before, nats_of_other(recogniser));
		}
		const double far_m = DRAG.x_m(t_s), share = far_m / DRAG.amplitude_m;
		const double angle = turns_rad * std::min(share / BENDS_UNTIL, 1.0);
		return Eigen::Vector3d(far_m * std::cos(angle), far_m * std::sin(angle), 0.0);
	};
	change.said = watch(recogniser, way, LOOKS_UNTIL_S).said;
	return change;
}

} // namespace

TEST_CASE("a gesture under way stays the one shown while another one is hardly likelier") {
	const Change change = bending_by(0.35);
	CHECK(change.said == std::vector<std::string>{ "started first" });
	CHECK(change.most_before > 1.0);
	CHECK(change.most_before < 2.0);
}

TEST_CASE("a gesture under way changes for another one once that is likelier by two nats") {
	const Change change = bending_by(0.42);
	CHECK(change.said == std::vector<std::string>{ "started first", "aborted first", "started second" });
	CHECK(change.most_before > 1.0);
	CHECK(change.most_before < 2.0);
}
