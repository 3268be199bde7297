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
			const double period_m = feature_->period_m(task);
			*x_m += period_m * std::round((last_m_ - *x_m) / period_m);
			last_m_ = *x_m;
		}
		return x_m;
	}

	/// The next value is the one nearest to 0.
	void restart() { last_m_ = 0.0; }

	[[nodiscard]] bool is_periodic() const { return feature_->period_m != nullptr; }
	[[nodiscard]] const Feature &feature() const { return *feature_; }

private:
	const Feature *feature_;
	double last_m_ = 0.0;
};

} // namespace steadyhand
