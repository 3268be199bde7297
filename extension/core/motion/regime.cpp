#include "motion/regime.h"

// As in lanes.h: what passes vectors is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

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

} // namespace

STEADYHAND_WIDE Passages passages(double dt_s) {
	Lanes hand, error;
	for (std::size_t i = 0; i < REGIMES; ++i) {
		hand[i] = REGIME_NUMBERS[i].hand.rate_per_s;
		error[i] = REGIME_NUMBERS[i].error.rate_per_s;
	}
	return { dampings(hand, dt_s), dampings(error, dt_s) };
}

} // namespace steadyhand
