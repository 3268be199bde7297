#include "haptics/breakpoints.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace steadyhand {

double value_at(std::span<const Breakpoint> points, double time_s, double before) {
	const auto next = std::upper_bound(points.begin(), points.end(), time_s,
			[](double time, const Breakpoint &point) { return time < point.time_s; });
	if (next == points.begin()) {
		return before;
	}
	const Breakpoint &last = *(next - 1);
	if (next == points.end()) {
		return last.value;
	}
	const double share = (time_s - last.time_s) / (next->time_s - last.time_s);
	return last.value + share * (next->value - last.value);
}

std::vector<Breakpoint> simplified(std::span<const Breakpoint> points, double error) {
	std::vector<Breakpoint> kept;
	double lowest = 0.0, highest = 0.0; // slopes from the last point kept that pass all points since
	const auto keep = [&](const Breakpoint &point) {
		kept.push_back(point);
		lowest = -std::numeric_limits<double>::infinity();
		highest = std::numeric_limits<double>::infinity();
	};
	for (std::size_t i = 0; i < points.size(); ++i) {
		if (i == 0) {
			keep(points[0]);
			continue;
		}
		const auto slope_to = [&](double value) {
			return (value - kept.back().value) / (points[i].time_s - kept.back().time_s);
		};
		const bool steps = !(points[i].time_s > points[i - 1].time_s);
		const bool ends_piece =
				steps || slope_to(points[i].value) < lowest || slope_to(points[i].value) > highest;
		const bool is_kept =
				kept.back().time_s == points[i - 1].time_s && kept.back().value == points[i - 1].value;
		if (ends_piece && !is_kept) {
			keep(points[i - 1]);
		}
		if (steps) {
			keep(points[i]);
			continue;
		}
		lowest = std::max(lowest, slope_to(points[i].value - error));
		highest = std::min(highest, slope_to(points[i].value + error));
		if (i + 1 == points.size()) {
			keep(points[i]);
		}
	}
	return kept;
}

} // namespace steadyhand
