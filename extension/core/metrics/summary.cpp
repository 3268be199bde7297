#include "metrics/summary.h"

#include "signal/sample_clock.h"

#include <algorithm>
#include <cmath>
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

ConditionSummary summarise(std::span<const CurveComparison> trials) {
	const auto field = [&](double CurveComparison::*member) {
		std::vector<double> values;
		values.reserve(trials.size());
		for (const CurveComparison &trial : trials) {
			values.push_back(trial.*member);
		}
		return values;
	};
	const std::vector<double> r2 = field(&CurveComparison::r2);
	const std::vector<double> t_diff_s = field(&CurveComparison::t_diff_s);
	ConditionSummary summary;
	summary.trials = trials.size();
	summary.missed = static_cast<std::size_t>(std::count_if(
			trials.begin(), trials.end(), [](const CurveComparison &trial) { return trial.missed; }));
	summary.mean_r2 = mean(r2);
	summary.worst_r2 = percentile(r2, 5.0);
	summary.mean_r2_zero = mean(field(&CurveComparison::r2_zero));
	summary.median_lag_s = percentile(field(&CurveComparison::lag_s), 50.0);
	summary.median_t_diff_s = percentile(t_diff_s, 50.0);
	summary.low_t_diff_s = percentile(t_diff_s, 2.5);
	summary.high_t_diff_s = percentile(t_diff_s, 97.5);
	summary.mean_sparc = mean(field(&CurveComparison::sparc));
	return summary;
}

} // namespace steadyhand
