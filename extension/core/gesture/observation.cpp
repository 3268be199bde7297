#include "gesture/observation.h"

namespace steadyhand {

void ObservationWindow::reset() {
	*this = ObservationWindow();
}

void ObservationWindow::push(double t_s, double x_m) {
	if (count_ > 0 && t_s < sample(count_ - 1).t_s) {
		return;
	}
	if (count_ > 1 && t_s - sample(count_ - 2).t_s < LEAST_INTERVAL_S) {
		--count_;
	}
	if (count_ == CAPACITY) {
		first_ = (first_ + 1) % CAPACITY;
		--count_;
	}
	samples_[(first_ + count_) % CAPACITY] = { t_s, x_m };
	++count_;
	while (count_ > 2 && t_s - sample(0).t_s > WINDOW_S) {
		first_ = (first_ + 1) % CAPACITY;
		--count_;
	}
	position_m_ = x_m;
}

double ObservationWindow::slope() const {
	// Sums are taken about the newest sample, so that neither an hour-long clock nor 1e9 m of offset costs
	// digits.
	const Sample newest = sample(count_ - 1);
	double mean_t = 0.0, mean_x = 0.0;
	for (std::size_t i = 0; i < count_; ++i) {
		mean_t += sample(i).t_s - newest.t_s;
		mean_x += sample(i).x_m - newest.x_m;
	}
	mean_t /= static_cast<double>(count_);
	mean_x /= static_cast<double>(count_);
	double covariance = 0.0, variance = 0.0;
	for (std::size_t i = 0; i < count_; ++i) {
		const double dt = sample(i).t_s - newest.t_s - mean_t;
		covariance += dt * (sample(i).x_m - newest.x_m - mean_x);
		variance += dt * dt;
	}
	return variance > 0.0 ? covariance / variance : 0.0;
}

} // namespace steadyhand
