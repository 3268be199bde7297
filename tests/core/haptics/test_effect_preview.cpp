#include "haptics/effect_preview.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("a preview is what the movement makes: the spring by its position, the impulse at its end") {
	const Movement movement{ PREVIEW_MOVEMENT_S };
	for (const double rate_hz : { 8000.0, 48000.0 }) {
		Effect spring = spring_effect();
		spring.trigger = Trigger::ALWAYS;
		const std::vector<float> swelling = preview_of(spring, rate_hz);
		REQUIRE(swelling.size() == static_cast<std::size_t>(PREVIEW_LENGTH_S * rate_hz));
		const std::vector<float> impulse = preview_of(impulse_effect(), rate_hz);
		const double speed = PREVIEW_AMPLITUDE_M * movement.at(movement.end_s()).velocity;
		double worst_swelling = 0.0, worst_impulse = 0.0;
		for (std::size_t i = 0; i < swelling.size(); ++i) {
			const double t_s = static_cast<double>(i) / rate_hz;
			const double sine = std::sin(2.0 * std::numbers::pi * 180.0 * t_s);
			worst_swelling = std::max(worst_swelling,
					std::abs(static_cast<double>(swelling[i]) - movement.at(t_s).position * sine));
			const auto first = std::ceil(movement.end_s() * rate_hz);
			const double since_s = (static_cast<double>(i) - first) / rate_hz;
			const double decaying = since_s < 0.0 || since_s > 0.0399
					? 0.0
					: speed * std::exp(-200.0 * since_s) * std::sin(2.0 * std::numbers::pi * 300.0 * since_s);
			worst_impulse = std::max(worst_impulse, std::abs(static_cast<double>(impulse[i]) - decaying));
		}
		CHECK(worst_swelling < 1e-3);
		CHECK(worst_impulse < 1e-3);
	}
}

TEST_CASE("a spectrum has each sine's amplitude at its frequency, and nothing far from it") {
	constexpr double RATE_HZ = 8000.0;
	std::vector<float> samples(8000);
	for (std::size_t i = 0; i < samples.size(); ++i) {
		const double t_s = static_cast<double>(i) / RATE_HZ;
		samples[i] = static_cast<float>(0.5 * std::sin(2.0 * std::numbers::pi * 180.0 * t_s) +
				0.25 * std::cos(2.0 * std::numbers::pi * 300.0 * t_s));
	}
	const std::vector<float> frequencies{ 60.0F, 180.0F, 240.0F, 300.0F, 4000.0F, -1.0F };
	const std::vector<float> found = spectrum_of(samples, RATE_HZ, frequencies);
	CHECK(found[1] == near(0.5).epsilon(1e-4));
	CHECK(found[3] == near(0.25).epsilon(1e-4));
	for (const std::size_t silent : { 0UL, 2UL, 4UL, 5UL }) {
		CHECK(found[silent] < 1e-4F);
	}
	CHECK(spectrum_of({}, RATE_HZ, frequencies)[1] == 0.0F);
}
