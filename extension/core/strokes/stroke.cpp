#include "strokes/stroke.h"

#include <algorithm>

namespace steadyhand {

Stroke Stroke::as_measured() const {
	Stroke shown = *this;
	shown.from = measured_from;
	shown.to = measured_to;
	shown.middle += 0.5 * (measured_from - from + measured_to - to);
	shown.path_m += ((measured_to - measured_from) - (to - from)).norm();
	return shown;
}

Stroke joined(const Stroke &first, const Stroke &second) {
	Stroke both = first;
	both.now_s = second.now_s;
	both.moved_s = second.moved_s;
	both.to = second.to;
	both.measured_to = second.measured_to;
	if (first.path_m + second.path_m > 0.0) {
		both.middle = (first.path_m * first.middle + second.path_m * second.middle) /
				(first.path_m + second.path_m);
	}
	both.peak_m_s = std::max(first.peak_m_s, second.peak_m_s);
	both.path_m = first.path_m + (second.from - first.to).norm() + second.path_m;
	return both;
}

} // namespace steadyhand
