#include "phase/regime.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

STEADYHAND_INLINE Dampings dampings(const Lanes &rates_per_s, double dt_s) {
	const LaneVector a = load(rates_per_s), fading = exponential(-a * dt_s);
	const LaneVector xx = fading * (1.0 + a * dt_s), xv = fading * dt_s;
	const LaneVector vx = -fading * a * a * dt_s, vv = fading * (1.0 - a * dt_s);
	Dampings by;
	store(by.xx, xx);
	store(by.xv, xv);
	store(by.vx, vx);
	store(by.vv, vv);
	store(by.noise_x, 1.0 - (xx * xx + xv * xv * a * a));
	store(by.noise_xv, -(xx * vx + xv * vv * a * a));
	store(by.noise_v, a * a - (vx * vx + vv * vv * a * a));
	return by;
}

void slow_down(Dampings &r_by, double rate_per_s, double dt_s) {
	constexpr std::size_t FREE = index_of(Regime::FREE);
	constexpr double C = FREE_SLOWING_PER_S;
	const double fading = std::exp(-C * dt_s), gone_s = (1.0 - fading) / C;
	const double speed = rate_per_s * rate_per_s;
	r_by.xx[FREE] = 1.0;
	r_by.xv[FREE] = gone_s;
	r_by.vx[FREE] = 0.0;
	r_by.vv[FREE] = fading;
	r_by.noise_x[FREE] = speed * (2.0 * (dt_s - gone_s) / C - gone_s * gone_s);
	r_by.noise_xv[FREE] = speed * C * gone_s * gone_s;
	r_by.noise_v[FREE] = speed * (1.0 - fading * fading);
}

} // namespace

STEADYHAND_WIDE Passages passages(double dt_s) {
	Lanes hand{}, error{};
	for (std::size_t i = 0; i < REGIMES; ++i) {
		hand[i] = REGIME_NUMBERS[i].hand.rate_per_s;
	}
	for (std::size_t i = 0; i < TRACKER_ERRORS; ++i) {
		error[i] = ERROR_NUMBERS[i].at_start.rate_per_s;
	}
	Passages all{ dampings(hand, dt_s), dampings(error, dt_s) };
	slow_down(all.hand, regime_numbers(Regime::FREE).hand.rate_per_s, dt_s);
	all.pace_variance = PACE_WALK * PACE_WALK * std::clamp(dt_s, 0.0, LONGEST_PACE_WALK_S);
	return all;
}

} // namespace steadyhand
