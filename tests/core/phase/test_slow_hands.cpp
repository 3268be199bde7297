// Hands several times as slow as those that the model was trained on, before a tracker that errs once.

#include "follow.h"
#include "overlapping_drags.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

using namespace steadyhand;
using test::Drag, test::follow;

namespace {

constexpr double ONSET_S = 0.6;

/// Values in amplitudes.
struct Hand {
	std::vector<Drag> strokes;

	/// One movement, or several that overlap by half, as slow hands make them (Novak, Miller & Houk 2002).
	Hand(double duration_s, int count) {
		const double step_s = duration_s / (count + 1), stroke_s = count == 1 ? duration_s : 2.0 * step_s;
		for (int i = 0; i < count; ++i) {
			strokes.push_back({ ONSET_S + i * step_s, stroke_s, 1.0 / count });
		}
	}
	[[nodiscard]] double x(double t_s) const { return test::x_m(strokes, t_s); }
	[[nodiscard]] double reaches_s(double share) const {
		double t_s = ONSET_S;
		while (x(t_s) < share) {
			t_s += 0.001;
		}
		return t_s;
	}
};

enum class Fault { GAP, FREEZE, JUMP_AHEAD, JUMP_BACK };

struct Off {
	double furthest_ahead = 0.0;
	double estimate = 0.0, measured = 0.0; ///< root mean squares since the fault
};

Off off(const Hand &hand, double until_s, Fault fault, double at) {
	const double from_s = hand.reaches_s(at);
	const double to_s = from_s + (fault == Fault::GAP || fault == Fault::FREEZE ? 0.25 : 0.05);
	PhaseEstimator estimator(test::drag_model());
	double shown = 0.0;
	Off off;
	int instants = 0;
	const auto show = [&](double t_s) -> std::optional<double> {
		const bool errs = t_s > from_s && t_s <= to_s;
		if (errs && fault == Fault::GAP) {
			return std::nullopt;
		}
		const bool repeats = errs && fault == Fault::FREEZE;
		if (!repeats) {
			shown = hand.x(t_s) + (errs ? (fault == Fault::JUMP_AHEAD ? 0.25 : -0.25) : 0.0);
		}
		return shown;
	};
	follow(estimator, until_s, show, [&](double t_s, double value) {
		if (t_s > from_s) {
			const double error = value - hand.x(t_s), error_shown = shown - hand.x(t_s);
			off.furthest_ahead = std::max(off.furthest_ahead, error);
			off.estimate += error * error;
			off.measured += error_shown * error_shown;
			++instants;
		}
	});
	off.estimate = std::sqrt(off.estimate / instants);
	off.measured = std::sqrt(off.measured / instants);
	return off;
}

} // namespace

TEST_CASE("one fault does not make the estimate of a slow hand run ahead of it" *
		doctest::test_suite("figures")) {
	double estimate = 0.0, measured = 0.0;
	for (const double duration_s : { 2.0, 3.0, 4.0, 5.0 }) {
		for (const int strokes : { 1, 5 }) {
			const Hand hand(duration_s, strokes);
			for (const Fault fault : { Fault::GAP, Fault::FREEZE, Fault::JUMP_AHEAD, Fault::JUMP_BACK }) {
				for (const double at : { 0.2, 0.5, 0.8 }) {
					CAPTURE(duration_s);
					CAPTURE(strokes);
					CAPTURE(static_cast<int>(fault));
					CAPTURE(at);
					const Off now = off(hand, ONSET_S + duration_s + 0.5, fault, at);
					CHECK(now.furthest_ahead < 0.15);
					estimate += now.estimate;
					measured += now.measured;
				}
			}
		}
	}
	CHECK(estimate < measured);
}
