// A tracker that shows something else for the hand on its way, nothing given.

#include "gesture_events.h"

#include <doctest/doctest.h>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// What stands beside where the hand is then, from a share of its way on.
struct OtherHand {
	Eigen::Vector3d off_m;
	double from_share, shown_s;

	[[nodiscard]] Way instead_of(const Drag &drag) const {
		const double from_s = drag.onset_s + from_share * drag.duration_s;
		return [=, *this](double t_s) {
			const bool is_shown = t_s >= from_s && t_s < from_s + shown_s;
			return Eigen::Vector3d(drag.x_m(is_shown ? from_s : t_s) * X + (is_shown ? 1.0 : 0.0) * off_m);
		};
	}
};

} // namespace

TEST_CASE("a gesture of which a tracker shows something else for a third of its time is one, and as long as "
		  "it is") {
	for (const double duration_s : { 0.6, 1.0 }) {
		const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 0.2 };
		for (const Eigen::Vector3d &off_m :
				{ Eigen::Vector3d(-0.25, 0.03, 0.0), Eigen::Vector3d(0.25, 0.0, 0.1),
						Eigen::Vector3d(0.0, 0.2, 0.1), Eigen::Vector3d(0.05, 0.1, 0.0) }) {
			for (const double from_share : { 0.2, 0.35, 0.5 }) {
				for (const double shown_share : { 0.08, 0.15, 0.3 }) {
					CAPTURE(duration_s);
					CAPTURE(off_m.transpose());
					CAPTURE(from_share);
					CAPTURE(shown_share);
					const OtherHand other{ off_m, from_share, shown_share * duration_s };
					const Events events =
							in_the_open(other.instead_of(drag), drag.onset_s + duration_s + 0.6);
					CHECK(events.said == times(1, "sideways"));
					CHECK(std::abs(events.last_value_m - drag.amplitude_m) < 0.02);
				}
			}
		}
	}
}
