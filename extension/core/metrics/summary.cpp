#include "metrics/summary.h"

#include "signal/sample_clock.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

namespace steadyhand {

namespace {

std::vector<double> usable(std::span<const double> values) {
	std::vector<double> result;
	std::copy_if(values.begin(), values.end(), std::back_inserter(result), is_usable);
	return result;
}

} // namespace

double mean(std::span<const double> values) {
	const std::vector<double> kept = usable(values);
	const double sum = std::accumulate(kept.begin(), kept.end(), 0.0);
	return kept.empty() ? 0.0 : sum / static_cast<double>(kept.size());
}

double percentile(std::span<const double> values, double percent) {
	std::vector<double> sorted = usable(values);
	if (sorted.empty() || !is_usable(percent)) {
		return 0.0;
	}
	std::sort(sorted.begin(), sorted.end());
	const double rank = std::clamp(percent / 100.0, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
	const auto below = static_cast<std::size_t>(rank);
	const std::size_t above = std::min(below + 1, sorted.size() - 1);
	return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

} // namespace steadyhand
