// Trackers that fall behind the hand and catch up with it within some frames, and hands so quick that a
// tracker shows them as if it did.

#include "follow.h"
#include "minimum_jerk_drag.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// A first-order lag of late_s (time constant) from a tenth of the way on, for so long, and of back_s from
/// then on.
class LaggingTracker {
public:
	LaggingTracker(const Drag &drag, double late_s, double for_s, double back_s) :
			drag_(drag), late_s_(late_s), back_s_(back_s) {
		while (drag_.x_m(falls_behind_s_) < 0.1) {
			falls_behind_s_ += STEP_S;
		}
		catches_up_s_ = falls_behind_s_ + for_s;
	}
	/// t_s must increase.
	double operator()(double t_s) {
		for (; now_s_ < t_s; now_s_ += STEP_S) {
			const double time_constant_s = now_s_ < falls_behind_s_ ? STEP_S
					: now_s_ < catches_up_s_                        ? late_s_
																	: back_s_;
			shown_ += (drag_.x_m(now_s_) - shown_) * -std::expm1(-STEP_S / time_constant_s);
		}
		return shown_ + 1e-3 * normal_(random_);
	}
	[[nodiscard]] double catches_up_s() const { return catches_up_s_; }

private:
	static constexpr double STEP_S = 1e-3;

	Drag drag_;
	double late_s_, back_s_;
	double falls_behind_s_ = 0.0, catches_up_s_ = 0.0, now_s_ = 0.0, shown_ = 0.0;
	std::mt19937_64 random_{ 4 };
	std::normal_distribution<double> normal_;
};

} // namespace

TEST_CASE("a tracker that has fallen behind and catches up is followed again within a fifth of a second") {
	for (const double duration_s : { 0.7, 0.8, 0.9 }) {
		for (const double late_s : { 0.2, 0.25 }) {
			for (const double back_s : { 0.02, 0.03 }) {
				CAPTURE(duration_s);
				CAPTURE(late_s);
				CAPTURE(back_s);
				const Drag drag{ .onset_s = 0.6, .duration_s = duration_s, .amplitude_m = 1.0 };
				LaggingTracker tracker(drag, late_s, 0.35, back_s);
				PhaseEstimator estimator(drag_model());
				double off = 0.0, at_end = 0.0;
				const double end_s = drag.onset_s + duration_s;
				follow(
						estimator, end_s + 1.0, [&](double t_s) { return tracker(t_s); },
						[&](double t_s, double value) {
							const double error = std::abs(value - drag.x_m(t_s));
							off = t_s > tracker.catches_up_s() + 0.2 ? std::max(off, error) : off;
							at_end = t_s > end_s + 0.2 ? std::max(at_end, error) : at_end;
						});
				CHECK(off < 0.09);
				CHECK(at_end < 0.05);
			}
		}
	}
}

TEST_CASE("a hand whose quick start looks like a jump is at its end once a sound tracker shows it there") {
	for (const double time_constant_s : { 0.016, 0.018, 0.02, 0.022, 0.025, 0.03 }) {
		for (const int seed : { 1, 2, 3, 4, 5, 6 }) {
			CAPTURE(time_constant_s);
			CAPTURE(seed);
			const double onset_s = 0.6 + 0.0017 * seed;
			const auto hand = [&](double t_s) { // critically damped: quick at first, and slower and slower
				const double gone = std::max(t_s - onset_s, 0.0) / time_constant_s;
				return 1.0 - (1.0 + gone) * std::exp(-gone);
			};
			PhaseEstimator estimator(drag_model());
			std::mt19937_64 random(static_cast<std::uint64_t>(seed));
			std::normal_distribution<double> normal;
			double off = 0.0;
			follow(
					estimator, 2.5, [&](double t_s) { return hand(t_s) + 1e-3 * normal(random); },
					[&](double t_s, double value) {
						off = t_s > onset_s + 0.4 ? std::max(off, std::abs(value - 1.0)) : off;
					});
			CHECK(off < 0.05);
		}
	}
}
