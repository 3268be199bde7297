#pragma once

#include "phase/phase_estimator.h"

#include <cmath>
#include <optional>

namespace steadyhand::test {

inline constexpr double PERIOD_S = 0.009; ///< of frames

/// Shows the estimator what `show` says of each frame, by its time (nothing where none came), and tells
/// `look` what it makes of that at each millisecond.
template <typename Show, typename Look>
void follow(PhaseEstimator &r_estimator, double until_s, const Show &show, const Look &look,
		double period_s = PERIOD_S) {
	int frames = 0;
	for (int ms = 0; ms < static_cast<int>(std::lround(1000.0 * until_s)); ++ms) {
		const double t_s = ms / 1000.0;
		for (; frames * period_s <= t_s; ++frames) {
			if (const std::optional<double> x = show(frames * period_s)) {
				r_estimator.push(frames * period_s, *x);
			}
		}
		if (ms % 10 == 0) {
			r_estimator.wait(t_s);
		}
		look(t_s, r_estimator.at(t_s).value);
	}
}

} // namespace steadyhand::test
