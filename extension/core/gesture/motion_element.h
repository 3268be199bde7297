#pragma once

#include "gesture/feature.h"

#include <cmath>
#include <optional>

namespace steadyhand {

/// A feature, unwrapped from frame to frame. On a closed path it takes the value nearest to the last one, so
/// a whole circle ends at its length and not at 0. Between two frames the hand must move less than half a
/// round.
class MotionElement {
public:
	/// feature must outlive this.
	explicit MotionElement(const Feature &feature) : feature_(&feature) {}

	/// Value in m; nullopt if the feature has none.
	std::optional<double> measure(const HandFrame &frame, const Task &task) {
		std::optional<double> x_m = feature_->measure(frame, task);
		if (x_m && is_periodic()) {
			*x_m += whole_rounds_m(last_m_ - *x_m, task);
			last_m_ = *x_m;
		}
		return x_m;
	}

	/// The next value is the one nearest to 0: whole rounds are dropped.
	void restart() { last_m_ = 0.0; }
	/// Length of the whole rounds nearest to length_m; 0 if the path is not closed.
	[[nodiscard]] double whole_rounds_m(double length_m, const Task &task) const {
		if (!is_periodic()) {
			return 0.0;
		}
		const double period_m = feature_->period_m(task);
		return period_m * std::round(length_m / period_m);
	}

	[[nodiscard]] bool is_periodic() const { return feature_->period_m != nullptr; }
	[[nodiscard]] const Feature &feature() const { return *feature_; }

private:
	const Feature *feature_;
	double last_m_ = 0.0;
};

} // namespace steadyhand
