// Frames elsewhere, until the tracker is back where the hand is.

#include "follow.h"
#include "phase/phase_estimator.h"
#include "trained_drag.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

using namespace steadyhand;
using test::Drag;

namespace {

constexpr Drag DRAG{ .onset_s = 1.0, .duration_s = 0.8, .amplitude_m = 1.0 };
constexpr double RATE_HZ = 100.0;
constexpr double LENGTH_S = 2.4;

/// Elsewhere by off, in amplitudes, in one frame; or without that frame.
PhaseEstimator seen(double noise, int frame_elsewhere, double off, bool has_frame, int until_frame) {
	PhaseEstimator estimator(test::drag_model());
	std::mt19937_64 random(1);
	std::normal_distribution<double> trembling(0.0, 1.0);
	for (int i = 0; i <= until_frame; ++i) {
		const double t_s = i / RATE_HZ;
		const double x = DRAG.x_m(t_s) + noise * trembling(random);
		if (i != frame_elsewhere) {
			estimator.push(t_s, x);
		} else if (has_frame) {
			estimator.push(t_s, x + off);
		}
	}
	return estimator;
}

} // namespace

TEST_CASE("a single frame elsewhere, once the next ones are seen, is as one that was left out" *
		doctest::test_suite("figures")) {
	constexpr int SETTLES_FRAMES = 10;
	for (const double noise : { 0.0, 1e-3 }) {
		for (const double at_s : { 0.5, 0.95, 1.2, 1.4, 1.6, 2.0 }) {
			for (const double off : { -1.0, -0.4, -0.15, 0.15, 0.4, 1.03, 2.0 }) {
				CAPTURE(noise);
				CAPTURE(at_s);
				CAPTURE(off);
				const int frame = static_cast<int>(std::lround(at_s * RATE_HZ));
				for (int until = frame + SETTLES_FRAMES; until < LENGTH_S * RATE_HZ; until += 5) {
					const double t_s = until / RATE_HZ;
					const double with = seen(noise, frame, off, true, until).at(t_s).value;
					const double without = seen(noise, frame, off, false, until).at(t_s).value;
					CHECK(std::abs(with - without) < 0.01);
				}
			}
		}
	}
}

TEST_CASE("a tracker that shows a hand ahead for a tenth of a second leaves it where it was foretold to be") {
	constexpr double AHEAD = 0.5, AHEAD_S = 0.1;
	double squares = 0.0;
	int instants = 0;
	for (const double duration_s : { 0.8, 1.5 }) {
		const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = 1.0 };
		for (const double share : { 0.05, 0.1, 0.15, 0.2, 0.25, 0.3 }) {
			const double from_s = drag.onset_s + share * duration_s;
			PhaseEstimator estimator(test::drag_model());
			std::mt19937_64 random(2);
			std::normal_distribution<double> trembling(0.0, 1e-3);
			const auto show = [&](double t_s) {
				const bool is_ahead = t_s >= from_s && t_s < from_s + AHEAD_S;
				return drag.x_m(t_s) + (is_ahead ? AHEAD : 0.0) + trembling(random);
			};
			test::follow(estimator, drag.onset_s + duration_s + 0.3, show, [&](double t_s, double value) {
				if (t_s > from_s + 1.5 * AHEAD_S) {
					squares += (value - drag.x_m(t_s)) * (value - drag.x_m(t_s));
					++instants;
				}
			});
		}
	}
	CHECK(std::sqrt(squares / instants) < 0.06);
}

TEST_CASE("two frames elsewhere hardly lead a hand on that goes a sixth less far than asked") {
	constexpr double LENGTH = 0.84;
	double squares = 0.0, largest = 0.0;
	int instants = 0;
	for (const double duration_s : { 0.5, 0.8, 1.2 }) {
		const Drag drag{ .onset_s = 1.0, .duration_s = duration_s, .amplitude_m = LENGTH };
		for (const double share : { 0.2, 0.4, 0.6, 0.8 }) {
			for (const double off : { -0.5, 0.5, 1.0 }) {
				const double from_s = drag.onset_s + share * duration_s, to_s = from_s + 2.0 * test::PERIOD_S;
				PhaseEstimator estimator(test::drag_model());
				std::mt19937_64 random(3);
				std::normal_distribution<double> trembling(0.0, 1e-3);
				const auto show = [&](double t_s) {
					return drag.x_m(t_s) + (t_s >= from_s && t_s < to_s ? off : 0.0) + trembling(random);
				};
				test::follow(estimator, drag.onset_s + duration_s + 0.5, show, [&](double t_s, double value) {
					if (t_s > to_s + 0.1) {
						const double error = value - drag.x_m(t_s);
						squares += error * error;
						largest = std::max(largest, std::abs(error));
						++instants;
					}
				});
			}
		}
	}
	CHECK(std::sqrt(squares / instants) < 0.03);
	CHECK(largest < 0.1);
}
