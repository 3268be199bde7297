#pragma once

#include "estimator.h"
#include "scenario.h"
#include "tracker.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace steadyhand::matrix {

inline constexpr double OUTPUTS_PER_S = 1000.0;

/// The outputs at 0, 1, 2 ... ms until until_s, frames stamped at or before each one pushed before it.
inline std::vector<Output> replay(
		const std::vector<HandFrame> &frames, double until_s, Estimator &r_estimator) {
	std::vector<Output> outputs(static_cast<std::size_t>(std::floor(until_s * OUTPUTS_PER_S)));
	auto next = frames.begin();
	for (std::size_t ms = 0; ms < outputs.size(); ++ms) {
		const double now_s = static_cast<double>(ms) / OUTPUTS_PER_S;
		for (; next != frames.end() && next->t_s <= now_s; ++next) {
			r_estimator.push(*next);
		}
		outputs[ms] = r_estimator.advance(now_s);
	}
	return outputs;
}

} // namespace steadyhand::matrix
