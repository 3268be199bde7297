// Every kind of hand before every kind of fault, at every point of its way.

#include "follow.h"
#include "overlapping_drags.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

using namespace steadyhand;
using test::Drag;

namespace {

// Values in amplitudes.
constexpr double LATENCY_S = 0.007, NOISE = 7e-4;
constexpr double AFTERWARDS_S = 0.4; ///< the fault is judged for so much longer than it lasts

struct Hand {
	std::string name;
	std::vector<Drag> drags;
	std::vector<double> faults_s; ///< when a tracker errs before it

	[[nodiscard]] double x(double t_s) const { return test::x_m(drags, t_s); }
};

const std::vector<Hand> &hands() {
	static const std::vector<Hand> all = {
		{ "rests", {}, { 0.8 } },
		{ "drags in 0.2 s", { { 0.6, 0.2, 1.0 } }, { 0.3, 0.58, 0.64, 0.7, 0.76, 0.8, 1.3 } },
		{ "drags in 0.4 s", { { 0.6, 0.4, 1.0 } }, { 0.3, 0.58, 0.68, 0.8, 0.92, 1.0, 1.5 } },
		{ "drags in 0.8 s", { { 0.6, 0.8, 1.0 } }, { 0.3, 0.58, 0.76, 1.0, 1.24, 1.4, 1.9 } },
		{ "drags in 3 s", { { 0.6, 3.0, 1.0 } }, { 0.3, 0.58, 1.2, 2.1, 3.0, 3.6, 4.1 } },
		{ "halts", { { 0.6, 0.5, 0.4 }, { 2.0, 0.5, 0.6 } }, { 1.5, 1.98, 2.25 } },
		{ "turns back", { { 0.6, 0.5, 0.5 }, { 1.15, 0.6, -0.5 } }, { 1.1, 1.4, 2.2 } },
		{ "overshoots", { { 0.6, 0.6, 1.2 }, { 1.25, 0.4, -0.2 } }, { 0.9, 1.2, 1.4 } },
		{ "falls short", { { 0.6, 0.6, 0.85 }, { 1.35, 0.4, 0.15 } }, { 0.9, 1.28, 1.5 } },
		{ "drags and comes back", { { 0.6, 0.6, 1.0 }, { 1.8, 0.6, -1.0 } }, { 1.5, 1.9, 2.1, 2.3, 2.6 } },
		{ "drags twice", { { 0.6, 0.5, 1.0 }, { 1.5, 0.5, -1.0 }, { 2.4, 0.5, 1.0 } }, { 2.38, 2.65, 2.9 } },
	};
	return all;
}

enum class Fault { GAP, FREEZE, JUMP_AHEAD, JUMP_BACK, BUMP };

struct Off {
	double estimate = 0.0, measured = 0.0; ///< root mean squares
};

Off off(const Hand &hand, Fault fault, double from_s, double for_s) {
	PhaseEstimator estimator(test::drag_model(), {}, LATENCY_S);
	std::mt19937_64 random(3);
	std::normal_distribution<double> trembling(0.0, NOISE);
	double shown = 0.0;
	Off squares;
	int instants = 0;
	const auto show = [&](double t_s) -> std::optional<double> {
		const bool errs = t_s > from_s && t_s <= from_s + for_s;
		if (errs && fault == Fault::GAP) {
			return std::nullopt;
		}
		double x = hand.x(t_s - LATENCY_S) + trembling(random);
		if (errs) {
			x = fault == Fault::FREEZE ? shown : x;
			x += fault == Fault::JUMP_AHEAD ? 0.25 : (fault == Fault::JUMP_BACK ? -0.25 : 0.0);
			x += fault == Fault::BUMP ? 0.2 * std::sin(std::numbers::pi * (t_s - from_s) / for_s) : 0.0;
		}
		shown = x;
		return x;
	};
	test::follow(estimator, from_s + for_s + AFTERWARDS_S, show, [&](double t_s, double value) {
		if (t_s > from_s) {
			const double estimated = value - hand.x(t_s), measured = shown - hand.x(t_s);
			squares.estimate += estimated * estimated;
			squares.measured += measured * measured;
			++instants;
		}
	});
	return { std::sqrt(squares.estimate / instants), std::sqrt(squares.measured / instants) };
}

} // namespace

TEST_CASE("no fault at any point of any hand's way makes the estimate much worse than what was measured, and "
		  "most make it better" *
		doctest::test_suite("figures")) {
	double estimate = 0.0, measured = 0.0;
	for (const Hand &hand : hands()) {
		for (const Fault fault :
				{ Fault::GAP, Fault::FREEZE, Fault::JUMP_AHEAD, Fault::JUMP_BACK, Fault::BUMP }) {
			for (const double from_s : hand.faults_s) {
				for (const double for_s : { 0.02, 0.1, 0.4 }) {
					CAPTURE(hand.name);
					CAPTURE(static_cast<int>(fault));
					CAPTURE(from_s);
					CAPTURE(for_s);
					const Off now = off(hand, fault, from_s, for_s);
					CHECK(now.estimate < now.measured + 0.25);
					estimate += now.estimate;
					measured += now.measured;
				}
			}
		}
	}
	CHECK(estimate < 0.7 * measured);
}
