#include "motion/regime.h"

#include <Eigen/Core>

namespace steadyhand {
namespace {

constexpr Deviation SMALL_ERROR{ 0.0056, 2.7 };
constexpr std::array<RegimeNumbers, REGIMES> NUMBERS{
	RegimeNumbers{ { 0.025, 9.0 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
	RegimeNumbers{ { 0.05, 4.6 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.041 },
	RegimeNumbers{ { 0.016, 11.0 }, { 0.012, 5.9 }, 0.046, 0.12, 0.035, 0.025 },
	RegimeNumbers{ { 0.55, 4.0 }, SMALL_ERROR, 0.0, 0.0, 0.0, 0.05 },
};

} // namespace

const RegimeNumbers &regime_numbers(Regime regime) {
	return NUMBERS[static_cast<std::size_t>(regime)];
}

Damping::Damping(double rate_per_s, double dt_s, double fading) {
	const double a = rate_per_s;
	xx = fading * (1.0 + a * dt_s);
	xv = fading * dt_s;
	vx = -fading * a * a * dt_s;
	vv = fading * (1.0 - a * dt_s);
	noise_x = 1.0 - (xx * xx + xv * xv * a * a);
	noise_xv = -(xx * vx + xv * vv * a * a);
	noise_v = a * a - (vx * vx + vv * vv * a * a);
}

Passages passages(double dt_s) {
	Eigen::Array<double, 2 * REGIMES, 1> fading;
	for (std::size_t i = 0; i < REGIMES; ++i) {
		fading[2 * i] = -dt_s * NUMBERS[i].hand.rate_per_s;
		fading[2 * i + 1] = -dt_s * NUMBERS[i].error.rate_per_s;
	}
	fading = fading.exp();
	Passages all;
	for (std::size_t i = 0; i < REGIMES; ++i) {
		all[i] = { { NUMBERS[i].hand.rate_per_s, dt_s, fading[2 * i] },
			{ NUMBERS[i].error.rate_per_s, dt_s, fading[2 * i + 1] } };
	}
	return all;
}

} // namespace steadyhand
