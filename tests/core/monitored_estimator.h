#pragma once

#include "motion/switching_estimator.h"
#include "tracking/tracker_monitor.h"

#include <cmath>

namespace steadyhand::test {

/// A SwitchingEstimator fed through a TrackerMonitor. Readings have one coordinate, in amplitudes.
class MonitoredEstimator {
public:
	static constexpr double AMPLITUDE_M = 0.2;

	explicit MonitoredEstimator(
			const GestureModel &model, std::size_t hypotheses = DEFAULT_HYPOTHESES, double latency_s = 0.0) :
			estimator_(model, AMPLITUDE_M, hypotheses, latency_s) {}

	void push(double t_s, double x) {
		wait(std::nextafter(t_s, -INFINITY));
		estimator_.push(monitor_.push(t_s, { AMPLITUDE_M * x, 0.0, 0.0 }), x);
	}
	/// No frame came until t_s.
	void wait(double t_s) { estimator_.wait(t_s, monitor_.is_overdue(t_s)); }

	[[nodiscard]] MotionEstimate at(double t_s) const { return estimator_.at(t_s); }
	[[nodiscard]] MotionEstimate unblended(double t_s) const { return estimator_.unblended(t_s); }

private:
	TrackerMonitor monitor_;
	SwitchingEstimator estimator_;
};

} // namespace steadyhand::test
