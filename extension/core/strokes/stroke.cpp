#include "strokes/stroke.h"

namespace steadyhand {

Stroke Stroke::as_measured() const {
	Stroke shown = *this;
	shown.from = measured_from;
	shown.to = measured_to;
	shown.middle += 0.5 * (measured_from - from + measured_to - to);
	shown.path_m += ((measured_to - measured_from) - (to - from)).norm();
	return shown;
}

} // namespace steadyhand
