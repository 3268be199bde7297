#pragma once

#include "gesture/feature.h"

#include <cmath>
#include <optional>

namespace steadyhand {

/// A feature followed from frame to frame. Where the hand comes back to places that it has been to, the value
/// nearest to the last one is taken: a whole circle ends at its length and not at 0. Between two frames the
/// hand must go less than half a round.
class MotionElement {
public:
	/// feature must outlive this.
	explicit MotionElement(const Feature &feature) : feature_(&feature) {}

	/// m; nothing where the feature gives nothing.
	std::optional<double> measure(const HandFrame &frame, const Task &task) {
		std::optional<double> x_m = feature_->measure(frame, task);
		if (x_m && is_periodic()) {
			*x_m += rounds_m(last_m_ - *x_m, task);
			last_m_ = *x_m;
		}
		return x_m;
	}

	/// The next value is the one nearest to 0: less by rounds_m() of the last one.
	void restart() { last_m_ = 0.0; }
	/// The whole rounds that are nearest to a way; 0 where the hand does not come back to the same place.
	[[nodiscard]] double rounds_m(double way_m, const Task &task) const {
		if (!is_periodic()) {
			return 0.0;
		}
		const double period_m = feature_->period_m(task);
		return period_m * std::round(way_m / period_m);
	}

	[[nodiscard]] bool is_periodic() const { return feature_->period_m != nullptr; }
	[[nodiscard]] const Feature &feature() const { return *feature_; }

private:
	const Feature *feature_;
	double last_m_ = 0.0;
};

} // namespace steadyhand
