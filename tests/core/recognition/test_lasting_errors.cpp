#include "gesture_events.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace steadyhand;
using namespace steadyhand::test;

// Errors of a tracker, or a tremor of the hand, that last from frame to frame, where the way is short against
// them: as fingers that open are shown.

namespace {

constexpr double WAY_M = 0.03, WANDERS_BY_M = 8e-4;
constexpr double RATE_HZ = 100.0;
constexpr double NEVER_S = 1e9;
constexpr unsigned RUNS = 12;

/// A first-order autoregression in each direction.
class Wander {
public:
	Wander(double lasts_s, unsigned seed) :
			kept_(std::exp(-1.0 / (RATE_HZ * lasts_s))),
			news_(WANDERS_BY_M * std::sqrt(1.0 - kept_ * kept_), seed) {}
	/// A frame after the last.
	Eigen::Vector3d operator()() {
		off_m_ = kept_ * off_m_ + news_();
		return off_m_;
	}

private:
	double kept_;
	Tremor news_;
	Eigen::Vector3d off_m_ = Eigen::Vector3d::Zero();
};

struct Run {
	Events events;
	double begun_at; ///< share of the way that the hand had gone when its gesture was told
};

Run of_a_short_way(double lasts_s, unsigned seed, double onset_s, double duration_s) {
	const Drag drag{ .onset_s = onset_s, .duration_s = duration_s, .amplitude_m = WAY_M };
	Task task;
	task.amplitude_m = WAY_M;
	GestureRecogniser recogniser({ models()[0] }, task, MotionMode::PHASE);
	recogniser.set_completion(0.7); // the hand stops where it wanders to
	Wander wander(lasts_s, seed);
	double started_s = 0.0;
	const Way way = [&](double t_s) {
		const GestureSession *const session = recogniser.session();
		const bool is_shown = session != nullptr && session->stage() != GestureSession::Stage::IDLE;
		started_s = is_shown ? started_s : t_s;
		return Eigen::Vector3d(drag.x_m(t_s) * X + wander());
	};
	const double length_s = onset_s + duration_s + 0.8;
	const Events events = watch(recogniser, way, length_s, NEVER_S, NEVER_S, RATE_HZ, 0.0);
	return { events, drag.x_m(started_s) / WAY_M };
}

} // namespace

TEST_CASE("where a hand wanders at rest short gestures hardly begin twice, nor later than well under way") {
	int gestures = 0, begun = 0, ended = 0;
	for (const double lasts_s : { 0.03, 0.1, 0.3 }) {
		for (const double duration_s : { 0.4, 0.8, 1.5 }) {
			for (unsigned seed = 0; seed < RUNS; ++seed) {
				CAPTURE(lasts_s);
				CAPTURE(duration_s);
				CAPTURE(seed);
				const Run run = of_a_short_way(lasts_s, seed, 2.5, duration_s);
				ended += static_cast<int>(std::ranges::count(run.events.said, "ended sideways"));
				CHECK(run.begun_at < 0.6);
				begun += static_cast<int>(std::ranges::count(run.events.said, "started sideways"));
				++gestures;
			}
		}
	}
	CHECK(begun < 1.2 * gestures);
	CHECK(std::abs(ended - gestures) <= 0.02 * gestures);
}
