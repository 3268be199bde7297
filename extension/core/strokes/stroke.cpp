#include "strokes/stroke.h"

#include <algorithm>

namespace steadyhand {

Stroke Stroke::as_shown() const {
	Stroke shown = *this;
	shown.from = shown_from;
	shown.to = shown_to;
	shown.middle += 0.5 * (shown_from - from + shown_to - to);
	shown.way_m += ((shown_to - shown_from) - (to - from)).norm();
	return shown;
}

Stroke joined(const Stroke &first, const Stroke &second) {
	Stroke both = first;
	both.now_s = second.now_s;
	both.moved_s = second.moved_s;
	both.to = second.to;
	both.shown_to = second.shown_to;
	if (first.way_m + second.way_m > 0.0) {
		both.middle =
				(first.way_m * first.middle + second.way_m * second.middle) / (first.way_m + second.way_m);
	}
	both.peak_m_s = std::max(first.peak_m_s, second.peak_m_s);
	both.way_m = first.way_m + (second.from - first.to).norm() + second.way_m;
	both.is_joined = true;
	return both;
}

} // namespace steadyhand
