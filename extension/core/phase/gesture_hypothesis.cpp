#include "phase/gesture_hypothesis.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// A tracker falls behind gradually: in a shorter gesture it comes to less of its lag.
constexpr double LAG_SETTLING_S = 0.39;
/// Of the minimum jerk's share in the curve: people differ from the recordings.
constexpr double SHAPE_MEAN = 0.36;
constexpr double SHAPE_DEVIATION = 0.33;
constexpr double STANDS_BESIDE = 0.02; ///< deviation from where the tracker shows it

/// rate_per_s: 1 / duration
double share_of_lag(double rate_per_s) {
	return 1.0 / (1.0 + LAG_SETTLING_S * rate_per_s);
}

} // namespace

double GestureHypothesis::expected_lag_s(Regime regime, double duration_s) {
	return share_of_lag(1.0 / duration_s) * regime_numbers(regime).lag_s;
}

void GestureHypothesis::begin_at(std::size_t i, double mean, double deviation) {
	mean_[i] = mean;
	covariance_[entry(i, i)] = deviation * deviation;
}

GestureHypothesis GestureHypothesis::resting(double d) {
	GestureHypothesis h;
	const RegimeNumbers &numbers = regime_numbers(Regime::REST);
	h.begin_at(HAND, d, numbers.hand.amplitudes);
	h.begin_at(HAND_RATE, 0.0, numbers.hand.amplitudes * numbers.hand.rate_per_s);
	h.begin_error();
	return h;
}

GestureHypothesis GestureHypothesis::leaving(double d, double d_rate) {
	GestureHypothesis h = resting(d).in(Regime::FREE);
	const Deviation &hand = regime_numbers(Regime::FREE).hand;
	h.begin_at(HAND_RATE, d_rate, hand.amplitudes * hand.rate_per_s);
	return h;
}

void GestureHypothesis::begin_error() {
	const Deviation &error = error_numbers(error_).at_start;
	begin_at(ERROR, 0.0, error.amplitudes);
	begin_at(ERROR_RATE, 0.0, error.amplitudes * error.rate_per_s);
}

GestureHypothesis GestureHypothesis::begun(Regime regime, double onset_s, double onset_deviation_s,
		double log_duration, double log_duration_deviation, double gain_spread) const {
	GestureHypothesis h = in(regime);
	const RegimeNumbers &numbers = regime_numbers(regime);
	h.on_its_way_ = true;
	h.begin_at(ONSET, onset_s, onset_deviation_s);
	h.begin_at(LOG_DURATION, log_duration, log_duration_deviation);
	h.begin_at(GAIN, 0.0, gain_spread * numbers.gain_deviation);
	h.begin_at(SHAPE, SHAPE_MEAN, SHAPE_DEVIATION);
	h.rate_per_s_ = std::exp(-log_duration);
	const double lags = share_of_lag(h.rate_per_s_);
	h.begin_at(LAG, lags * numbers.lag_s, lags * numbers.lag_deviation_s);
	return h;
}

GestureHypothesis GestureHypothesis::in(Regime regime) const {
	GestureHypothesis h = *this;
	h.regime_ = regime;
	h.error_ = regime_numbers(regime).error;
	if (error_ == TrackerError::SLIDING_BACK) {
		const Deviation &error = error_numbers(h.error_).at_start;
		h.forget(ERROR_RATE);
		h.begin_at(ERROR_RATE, 0.0, error.amplitudes * error.rate_per_s);
	}
	return h;
}

GestureHypothesis GestureHypothesis::leaving_end() const {
	GestureHypothesis h = in(Regime::FREE);
	h.on_its_way_ = false;
	h.rate_per_s_ = 1.0;
	// d becomes 1 + g + d; of the gesture nothing is left.
	h.mean_[HAND] += 1.0;
	h.add_to(HAND, GAIN);
	std::fill(h.mean_.begin() + ONSET, h.mean_.end(), 0.0);
	std::fill(h.covariance_.begin() + entry(ONSET, 0), h.covariance_.end(), 0.0);
	return h;
}

GestureHypothesis GestureHypothesis::at_end(double onset_s, double log_duration) const {
	GestureHypothesis h = begun(Regime::SOUND, onset_s, 0.0, log_duration, 0.0);
	// Where the hand is is known: d becomes d - 1 - g, with the minimum jerk's end, which is 1.
	h.begin_at(SHAPE, 1.0, 0.0);
	const double gain_variance = h.covariance_[entry(GAIN, GAIN)];
	h.mean_[HAND] -= 1.0;
	h.covariance_[entry(HAND, HAND)] += gain_variance;
	h.covariance_[entry(GAIN, HAND)] = -gain_variance;
	return h;
}

GestureHypothesis GestureHypothesis::standing(double x, double onset_s) {
	GestureHypothesis h = resting(0.0).begun(Regime::UNSOUND, onset_s, 0.0, 0.0, 0.0);
	h.error_ = TrackerError::SLIGHT;
	h.begin_at(HAND, 0.0, regime_numbers(Regime::UNSOUND).hand.amplitudes);
	h.begin_at(HAND_RATE, 0.0, 0.0);
	h.begin_at(GAIN, x - 1.0, STANDS_BESIDE);
	h.begin_at(SHAPE, 1.0, 0.0);
	h.begin_at(LAG, 0.0, 0.0);
	return h;
}

GestureHypothesis GestureHypothesis::free_for(double unseen_s) const {
	constexpr std::size_t FREE = index_of(Regime::FREE);
	GestureHypothesis h = *this;
	const Dampings by = passages(unseen_s).hand;
	const double deviation = regime_numbers(Regime::FREE).hand.amplitudes;
	const double variance = deviation * deviation;
	h.covariance_[entry(HAND, HAND)] += variance * by.noise_x[FREE];
	h.covariance_[entry(HAND_RATE, HAND)] += variance * by.noise_xv[FREE];
	h.covariance_[entry(HAND_RATE, HAND_RATE)] += variance * by.noise_v[FREE];
	h.forget_error();
	return h;
}

GestureHypothesis GestureHypothesis::displaced(double deviation) const {
	GestureHypothesis h = *this;
	h.covariance_[entry(ERROR, ERROR)] += deviation * deviation;
	return h;
}

GestureHypothesis GestureHypothesis::displaced_sliding_back(double deviation) const {
	GestureHypothesis h = *this;
	h.error_ = TrackerError::SLIDING_BACK;
	h.forget_error();
	return h.displaced(deviation);
}

GestureHypothesis GestureHypothesis::caught_up(double behind_s, double deviation) const {
	GestureHypothesis h = displaced_sliding_back(deviation);
	h.covariance_[entry(ONSET, ONSET)] += behind_s * behind_s;
	return h;
}

GestureHypothesis GestureHypothesis::found_elsewhere(double deviation) const {
	GestureHypothesis h = *this;
	const Deviation &hand = regime_numbers(Regime::FREE).hand;
	h.forget(HAND);
	h.forget(HAND_RATE);
	h.begin_at(HAND, mean_[HAND], deviation);
	h.begin_at(HAND_RATE, 0.0, hand.amplitudes * hand.rate_per_s);
	h.forget_error();
	return h;
}

/// A state becomes its sum with another.
void GestureHypothesis::add_to(std::size_t sum, std::size_t added) {
	mean_[sum] += mean_[added];
	covariance_[entry(sum, sum)] +=
			2.0 * covariance_[symmetric_entry(sum, added)] + covariance_[entry(added, added)];
	for (std::size_t i = 0; i < STATES; ++i) {
		covariance_[symmetric_entry(i, sum)] += i == sum ? 0.0 : covariance_[symmetric_entry(i, added)];
	}
}

/// What it has in common with the other states.
void GestureHypothesis::forget(std::size_t forgotten) {
	for (std::size_t i = 0; i < STATES; ++i) {
		covariance_[symmetric_entry(i, forgotten)] = 0.0;
	}
}

void GestureHypothesis::forget_error() {
	forget(ERROR);
	forget(ERROR_RATE);
	begin_error();
}

} // namespace steadyhand
