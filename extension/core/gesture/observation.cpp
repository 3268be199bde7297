#include "gesture/observation.h"

namespace steadyhand {

void ObservationWindow::reset() {
	*this = ObservationWindow();
}

void ObservationWindow::push(double t_s, double x_m) {
	const std::size_t count = samples_.size();
	if (!samples_.empty() && t_s < samples_.t_s(count - 1)) {
		return;
	}
	if (count > 1 && t_s - samples_.t_s(count - 2) < LEAST_INTERVAL_S) {
		samples_.drop_newest();
	}
	samples_.push(t_s, x_m, WINDOW_S);
	position_m_ = x_m;
}

} // namespace steadyhand
