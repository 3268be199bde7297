// Hands that stand half-way before trackers that have erred.

#include "follow.h"
#include "minimum_jerk_drag.h"
#include "near.h"
#include "phase/hypothesis_births.h"
#include "signal/minimum_jerk.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace steadyhand;
using test::follow;

namespace {

/// A drag of `way` amplitudes before a tracker that trembles, repeats itself for frozen_s in its midst, and
/// then shows `found` of where the hand is. look: of the time since then, and the estimate.
template <typename Found, typename Look>
void follow_found(double way, double frozen_s, const Found &found, const Look &look) {
	constexpr double FROZEN_FROM_S = 1.1;
	const double found_s = FROZEN_FROM_S + frozen_s;
	const test::Drag drag{ .onset_s = 0.8, .duration_s = 0.6, .amplitude_m = way };
	PhaseEstimator estimator(test::drag_model());
	std::mt19937_64 random(2);
	std::normal_distribution<double> trembling(0.0, 1e-3);
	double shown = 0.0;
	const auto show = [&](double t_s) {
		if (t_s < FROZEN_FROM_S || t_s > found_s) {
			shown = (t_s > found_s ? found(drag.x_m(t_s)) : drag.x_m(t_s)) + trembling(random);
		}
		return shown;
	};
	follow(estimator, found_s + 1.0, show,
			[&](double t_s, double) { look(t_s - found_s, estimator.at(t_s)); });
}

} // namespace

TEST_CASE("a hand that stands where the tracker finds it again is there within 0.6 s, and so far in its "
		  "gesture") {
	for (const double way : { 0.3, 0.45, 0.6 }) {
		for (const double frozen_s : { 0.1, 0.2, 0.3 }) {
			for (const double beside : { -0.05, 0.0, 0.05 }) {
				CAPTURE(way);
				CAPTURE(frozen_s);
				CAPTURE(beside);
				double off = 0.0, off_in_phase = 0.0;
				follow_found(
						way, frozen_s, [&](double x) { return x + beside; },
						[&](double since_s, const PhaseEstimate &now) {
							if (since_s > 0.6) {
								off = std::max(off, std::abs(now.value - way));
								off_in_phase =
										std::max(off_in_phase, std::abs(now.phase - minimum_jerk_share(way)));
							}
						});
				CHECK(off < 0.08);
				CHECK(off_in_phase < 0.1);
			}
		}
	}
}

TEST_CASE("a hand that the tracker finds again beyond 0.7 of the way, and that stays there, is rather at the "
		  "end") {
	for (const double shown_at : { 0.75, 0.82 }) {
		for (const double frozen_s : { 0.1, 0.2, 0.3 }) {
			CAPTURE(shown_at);
			CAPTURE(frozen_s);
			double least = 1.0;
			follow_found(
					1.0, frozen_s, [&](double x) { return shown_at * x; },
					[&](double since_s, const PhaseEstimate &now) {
						least = since_s > 0.3 ? std::min(least, now.value) : 1.0;
					});
			CHECK(least > 0.85);
		}
	}
}

TEST_CASE("a hand may stand where it is shown half-way, slow, and has begun") {
	const PhaseEffort effort;
	const HypothesisBirths births(test::drag_model(), effort);
	const auto stands = [&](bool has_begun, double x, double per_s, double stays_s = 0.0) {
		HypothesisBank bank;
		const GestureHypothesis rest = GestureHypothesis::resting(0.0);
		bank.start(rest);
		if (has_begun) {
			bank.add(rest.begun(Regime::SOUND, 0.5, 0.01, 0.0, 0.1));
		}
		births.stand(bank, 1.0, x, per_s, stays_s);
		const std::size_t last = bank.size() - 1;
		CHECK(bank.size() == (has_begun ? 2 : 1) + (bank.is_standing(last) ? 1 : 0));
		CHECK((!bank.is_standing(last) || bank.course(last).gain == test::near(x)));
		return bank.is_standing(last);
	};
	CHECK(stands(true, 0.3, 0.5));
	CHECK(stands(true, 0.65, -0.5));
	CHECK_FALSE(stands(false, 0.3, 0.0));
	CHECK_FALSE(stands(true, 0.3, 0.9));
	CHECK_FALSE(stands(true, 0.3, -0.9));
	CHECK_FALSE(stands(true, 0.1, 0.0));
	CHECK(stands(true, 0.1, 0.0, 0.4));
	CHECK_FALSE(stands(true, -0.1, 0.0, 0.4));
	CHECK_FALSE(stands(false, 0.1, 0.0, 0.4));
	CHECK_FALSE(stands(true, 0.07, 0.0, 0.4));
	CHECK_FALSE(stands(true, 0.75, 0.0));
}

namespace {

/// A hand that halts before a tracker that freezes on its way, wanders, and freezes again.
struct WanderingHalt {
	double share; ///< of the way, at which the hand halts
	double frozen_s;
	double wander_hz;

	static constexpr double FROZEN_FROM_S = 1.1, HALTED_S = 1.3, FROZEN_FROM_AGAIN_S = 2.0, FROZEN_TO_S = 2.3;

	/// Mean distance of the estimate from the hand, amplitudes, between two times.
	[[nodiscard]] double off(double from_s, double to_s) const {
		const test::Drag drag{ .onset_s = HALTED_S - 0.5, .duration_s = 0.5, .amplitude_m = share };
		PhaseEstimator estimator(test::drag_model());
		double shown = 0.0, sum = 0.0;
		int looks = 0;
		const auto show = [&](double t_s) {
			if (!is_frozen(t_s)) {
				const double turns = 2.0 * std::numbers::pi * wander_hz * t_s;
				shown = drag.x_m(t_s) + 0.03 * std::sin(turns) + 0.02 * std::cos(1.6 * turns);
			}
			return shown;
		};
		follow(estimator, to_s, show, [&](double t_s, double value) {
			if (t_s > from_s) {
				sum += std::abs(value - share);
				++looks;
			}
		});
		return sum / looks;
	}

private:
	[[nodiscard]] bool is_frozen(double t_s) const {
		return (t_s >= FROZEN_FROM_S && t_s <= FROZEN_FROM_S + frozen_s) ||
				(t_s >= FROZEN_FROM_AGAIN_S && t_s <= FROZEN_TO_S);
	}
};

/// Of many of them.
double mean_off(double from_s, double to_s) {
	double sum = 0.0;
	int count = 0;
	for (const double share : { 0.25, 0.35, 0.45, 0.55 }) {
		for (const double frozen_s : { 0.1, 0.2 }) {
			for (const double wander_hz : { 1.0, 1.3, 1.7 }) {
				sum += WanderingHalt{ share, frozen_s, wander_hz }.off(from_s, to_s);
				++count;
			}
		}
	}
	return sum / count;
}

} // namespace

TEST_CASE("a hand that halts before a tracker that has erred is followed, though the tracker wanders") {
	CHECK(mean_off(WanderingHalt::HALTED_S + 0.2, WanderingHalt::FROZEN_FROM_AGAIN_S) < 0.05);
}

TEST_CASE("a hand that has halted before a tracker that wanders stays there while nothing is seen") {
	CHECK(mean_off(WanderingHalt::FROZEN_FROM_AGAIN_S, WanderingHalt::FROZEN_TO_S) < 0.03);
}

TEST_CASE("a hand that goes back in part, and stands before a tracker that is right, is shown there") {
	constexpr double BACK_FROM_S = 1.9, SEEN_FOR_S = 5.5;
	for (const double far : { 0.7, 0.85, 1.0 }) {
		for (const double near : { 0.4, 0.5, 0.6 }) {
			for (const double back_s : { 0.2, 0.3, 0.4 }) {
				CAPTURE(far);
				CAPTURE(near);
				CAPTURE(back_s);
				const test::Drag out{ .onset_s = 0.6, .duration_s = 0.5, .amplitude_m = far };
				const test::Drag back{
					.onset_s = BACK_FROM_S, .duration_s = back_s, .amplitude_m = far - near
				};
				PhaseEstimator estimator(test::drag_model());
				std::mt19937_64 random(1);
				std::normal_distribution<double> trembling(0.0, 5e-4);
				double off = 0.0;
				follow(
						estimator, SEEN_FOR_S,
						[&](double t_s) { return out.x_m(t_s) - back.x_m(t_s) + trembling(random); },
						[&](double t_s, double value) {
							off = t_s > BACK_FROM_S + back_s + 0.5 ? std::max(off, std::abs(value - near))
																   : off;
						});
				CHECK(off < 0.02);
			}
		}
	}
}
