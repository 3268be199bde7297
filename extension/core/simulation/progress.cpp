#include "simulation/progress.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steadyhand {

namespace {

constexpr int BISECTIONS = 50;
constexpr int SEARCH_STEPS = 2000; // finer than any submovement

/// The boundary between false (at `low`) and true (at `high`).
template <class Predicate> double bisect(double low, double high, Predicate is_beyond) {
	for (int i = 0; i < BISECTIONS; ++i) {
		const double middle = 0.5 * (low + high);
		(is_beyond(middle) ? high : low) = middle;
	}
	return high;
}

} // namespace

double bend_for_peak(double peak_fraction) {
	const double s = std::clamp(peak_fraction, 0.25, 0.75);
	// d2/ds2 minimum_jerk(w(s)) = 0 with w' = 1 + a (1 - 2 s), w'' = -2 a, divided by 60 w (1 - w).
	const auto slows_down = [s](double bend) {
		const double w = s + bend * s * (1.0 - s);
		const double rate = 1.0 + bend * (1.0 - 2.0 * s);
		return (1.0 - 2.0 * w) * rate * rate <= bend * w * (1.0 - w);
	};
	return bisect(-1.0, 1.0, slows_down);
}

Progress::Progress(
		double initial, std::vector<Submovement> submovements, std::vector<Hesitation> hesitations) :
		initial_(initial),
		submovements_(std::move(submovements)), hesitations_(std::move(hesitations)) {
	for (const Submovement &part : submovements_) {
		duration_s_ = std::max(duration_s_, part.start_s + part.duration_s);
	}
	for (const Hesitation &hesitation : hesitations_) {
		duration_s_ += hesitation.lost_s;
	}
}

double Progress::at(double t_s) const {
	double own_t_s = t_s;
	for (const Hesitation &hesitation : hesitations_) {
		// The slope of minimum_jerk is at most 1.875, so half of it never turns the clock back.
		own_t_s -= hesitation.lost_s * minimum_jerk((t_s - hesitation.t_s) / (2.0 * hesitation.lost_s)).value;
	}
	double progress = initial_;
	for (const Submovement &part : submovements_) {
		const double s = std::clamp((own_t_s - part.start_s) / part.duration_s, 0.0, 1.0);
		progress += part.amplitude * minimum_jerk(s + part.bend * s * (1.0 - s)).value;
	}
	return progress;
}

double Progress::crossing_s(double level) const {
	const double step_s = duration_s_ / SEARCH_STEPS;
	for (int i = 1; i <= SEARCH_STEPS; ++i) {
		if (at(i * step_s) >= level) {
			return bisect(
					(i - 1) * step_s, i * step_s, [this, level](double t_s) { return at(t_s) >= level; });
		}
	}
	return duration_s_;
}

double Progress::settling_s(double tolerance) const {
	const double end = at(duration_s_);
	const auto is_near = [this, end, tolerance](double t_s) { return std::abs(at(t_s) - end) <= tolerance; };
	const double step_s = duration_s_ / SEARCH_STEPS;
	for (int i = SEARCH_STEPS - 1; i >= 0; --i) {
		if (!is_near(i * step_s)) {
			return bisect(i * step_s, (i + 1) * step_s, is_near);
		}
	}
	return 0.0;
}

Progress Progress::stretched(double factor) const {
	Progress slower = *this;
	slower.duration_s_ *= factor;
	for (Submovement &part : slower.submovements_) {
		part.start_s *= factor;
		part.duration_s *= factor;
	}
	for (Hesitation &hesitation : slower.hesitations_) {
		hesitation.t_s *= factor;
		hesitation.lost_s *= factor;
	}
	return slower;
}

} // namespace steadyhand
