// Quick hands before slow cameras: a drag of 0.15 s, the fastest that is studied, is five frames at 30 Hz.

#include "follow.h"
#include "minimum_jerk_drag.h"
#include "near.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace steadyhand;
using test::follow;

namespace {

constexpr int PHASES = 12;
constexpr double TREMBLES = 4e-4; ///< a hand that is at rest shows no frame twice

/// Sums of squares over the gesture and 0.25 s on either side, of the estimate's error and of that of the
/// last frame held; of drags that begin anywhere between two frames.
struct Errors {
	double estimate = 0.0, held = 0.0;
};

/// reads: of each frame.
Errors errors(double duration_s, double rate_hz, int reads = 1) {
	Errors sum;
	for (int phase = 0; phase < PHASES; ++phase) {
		PhaseEstimator estimator(test::drag_model());
		const test::Drag drag{
			.onset_s = 1.0 + phase / (PHASES * rate_hz), .duration_s = duration_s, .amplitude_m = 1.0
		};
		const double begin_s = drag.onset_s - 0.25, end_s = drag.onset_s + duration_s + 0.25;
		std::mt19937_64 random(static_cast<unsigned>(phase));
		std::normal_distribution<double> trembling(0.0, TREMBLES);
		double shown = 0.0;
		int left = 0;
		const auto show = [&](double t_s) {
			if (left == 0) {
				shown = drag.x_m(t_s) + trembling(random);
				left = reads;
			}
			--left;
			return shown;
		};
		const auto look = [&](double t_s, double value) {
			if (t_s >= begin_s) {
				sum.estimate += (value - drag.x_m(t_s)) * (value - drag.x_m(t_s));
				sum.held += (shown - drag.x_m(t_s)) * (shown - drag.x_m(t_s));
			}
		};
		follow(estimator, end_s, show, look, 1.0 / rate_hz / reads);
	}
	return sum;
}

} // namespace

TEST_CASE("what a quick hand does between the frames of a slow camera is caught up with") {
	for (const double rate_hz : { 30.0, 60.0 }) {
		CAPTURE(rate_hz);
		for (const double duration_s : { 0.3, 0.4 }) {
			CAPTURE(duration_s);
			const Errors squared = errors(duration_s, rate_hz);
			CHECK(squared.estimate < squared.held);
		}
		// A quarter of what the model takes, or less: a frame or two are believed late.
		CHECK(errors(0.2, rate_hz).estimate < 3.0 * errors(0.2, rate_hz).held);
		CHECK(errors(0.15, rate_hz).estimate < 8.0 * errors(0.15, rate_hz).held);
	}
}

TEST_CASE("a camera that is read more often than it looks is as good as one that is read once a frame") {
	for (const double rate_hz : { 30.0, 60.0 }) {
		CAPTURE(rate_hz);
		for (const double duration_s : { 0.15, 0.2, 0.3 }) {
			CAPTURE(duration_s);
			const double once = errors(duration_s, rate_hz).estimate;
			for (const int reads : { 2, 4, 8 }) {
				CAPTURE(reads);
				CHECK(errors(duration_s, rate_hz, reads).estimate == test::near(once).epsilon(0.05));
			}
		}
	}
}

TEST_CASE("a drag of 0.15 s before a camera of 30 Hz is shown a frame late, one of 0.3 s is not") {
	struct Shown {
		double since_onset_s, estimate, held;
	};
	constexpr double RATE_HZ = 30.0;
	const auto show = [](double duration_s) {
		std::vector<Shown> all;
		for (int phase = 0; phase < PHASES; ++phase) {
			PhaseEstimator estimator(test::drag_model());
			const test::Drag drag{
				.onset_s = 1.0 + phase / (PHASES * RATE_HZ), .duration_s = duration_s, .amplitude_m = 1.0
			};
			double held = 0.0;
			follow(
					estimator, drag.onset_s + duration_s + 0.4,
					[&](double t_s) { return held = drag.x_m(t_s); },
					[&](double t_s, double value) {
						all.push_back({ t_s - drag.onset_s, value, held });
					},
					1.0 / RATE_HZ);
		}
		return all;
	};
	/// Where the hand was so long ago fits best.
	const auto late_s = [](const std::vector<Shown> &all, double duration_s, double Shown::*value) {
		const test::Drag drag{ .onset_s = 0.0, .duration_s = duration_s, .amplitude_m = 1.0 };
		double best_s = 0.0, least = 1e9;
		for (int ms = 0; ms < 60; ++ms) {
			double sum = 0.0;
			for (const Shown &shown : all) {
				const double off = shown.*value - drag.x_m(shown.since_onset_s - ms / 1000.0);
				sum += off * off;
			}
			best_s = sum < least ? ms / 1000.0 : best_s;
			least = std::min(least, sum);
		}
		return best_s;
	};
	const std::vector<Shown> quick = show(0.15), usual = show(0.3);
	CHECK(std::abs(late_s(quick, 0.15, &Shown::estimate) - 0.036) < 0.008);
	CHECK(std::abs(late_s(quick, 0.15, &Shown::held) - 0.016) < 0.004);
	CHECK(late_s(usual, 0.3, &Shown::estimate) < 0.01);
}
