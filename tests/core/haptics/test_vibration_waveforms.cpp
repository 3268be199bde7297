#include "haptics/vibration.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("the spring is M(t) sin(2 pi f t), M the motion at every sample, at every sample rate") {
	for (const double rate_hz : SAMPLE_RATES_HZ) {
		for (const double duration_s : { 0.3, 1.0 }) {
			CAPTURE(rate_hz);
			const Movement movement{ duration_s };
			Effect spring = spring_effect();
			spring.trigger = Trigger::ALWAYS;
			Vibration vibration(rate_hz, 1);
			vibration.set_effects(set_of(spring));
			const auto out = play(vibration, movement, static_cast<std::size_t>(1.2 * duration_s * rate_hz));
			const auto truth = [&](double t_s) { return movement.at(t_s).position * sine_at(180.0, t_s); };
			// The amplitude is a cubic, over a run of 64 samples at least.
			const double run_s = 64.0 / rate_hz;
			const double cubic = std::max(360.0 / std::pow(duration_s, 4.0) * std::pow(run_s, 4.0) / 384.0,
					Vibration::MOST_REMAINDER);
			// The movement's ends have a step in the third derivative.
			const double ends = 60.0 / std::pow(duration_s, 3.0) * std::pow(run_s, 3.0) * 4.0 / 81.0;
			CHECK(largest_error(out, rate_hz, truth) < SAMPLE_ERROR + cubic + ends);
		}
	}
}

TEST_CASE("velocity and acceleration drive it by their own full scale, the curve by its shape") {
	const Movement movement{ 0.5 };
	Vibration vibration(RATE_HZ, 1);
	Effect effect = spring_effect();
	effect.trigger = Trigger::ALWAYS;
	effect.frequency_hz = 250.0;
	effect.gain = 0.8;
	SUBCASE("velocity") {
		effect.drive = Drive::VELOCITY;
		effect.full_scale = 2.0; // m/s: above what is reached
		vibration.set_effects(set_of(effect));
		const auto truth = [&](double t_s) {
			return 0.8 * AMPLITUDE_M * movement.at(t_s).velocity / 2.0 * sine_at(250.0, t_s);
		};
		CHECK(largest_error(play(vibration, movement, 24000), RATE_HZ, truth) < 5e-6);
	}
	SUBCASE("acceleration") {
		effect.drive = Drive::ACCELERATION;
		effect.full_scale = 10.0;
		vibration.set_effects(set_of(effect));
		const auto truth = [&](double t_s) {
			return 0.8 * AMPLITUDE_M * std::abs(movement.at(t_s).acceleration) / 10.0 * sine_at(250.0, t_s);
		};
		// It begins with a corner, which fades in within 20 ms, and has another in the middle.
		const auto out = play(vibration, movement, 24000);
		CHECK(largest_error(std::span(out).first(11900), RATE_HZ, truth, 1000) < 2e-5);
		CHECK(largest_error(out, RATE_HZ, truth) < 2e-2);
	}
	SUBCASE("curve") {
		const float values[] = { 0.0F, 0.0F, 1.0F };
		effect.shape = Shape::CURVE;
		effect.table = { values, 3 };
		vibration.set_effects(set_of(effect));
		const auto truth = [&](double t_s) {
			return 0.8 * std::max(2.0 * movement.at(t_s).position - 1.0, 0.0) * sine_at(250.0, t_s);
		};
		CHECK(largest_error(play(vibration, movement, 24000), RATE_HZ, truth) < 1e-3);
	}
}

TEST_CASE("the impulse is M exp(-N t) sin(2 pi f t) from the first sample after the contact on") {
	for (const double rate_hz : SAMPLE_RATES_HZ) {
		for (const double contact_s : { 0.1, 0.10001, 0.123456 }) {
			CAPTURE(rate_hz);
			CAPTURE(contact_s);
			Vibration vibration(rate_hz, 1);
			vibration.set_effects(set_of(impulse_effect()));
			const auto out = play(vibration, Movement{ 0.5 }, static_cast<std::size_t>(0.2 * rate_hz), 384,
					at(1, contact_s));
			const double first = std::ceil(contact_s * rate_hz - 1e-6);
			const auto truth = [&](double t_s) {
				const double since_s = t_s - first / rate_hz;
				const bool sounds = since_s > -1e-9 && since_s < 0.04;
				return sounds ? 0.6 * std::exp(-200.0 * since_s) * sine_at(300.0, since_s) : 0.0;
			};
			// It ends within the run in which it is down to exp(-8).
			CHECK(largest_error(out, rate_hz, truth) < 0.6 * std::exp(-8.0));
			const auto end = static_cast<std::size_t>((contact_s + 0.04) * rate_hz) - 1;
			CHECK(largest_error(std::span(out).first(end), rate_hz, truth) < SAMPLE_ERROR);
			CHECK(out[static_cast<std::size_t>(first) - 1] == 0.0F);
			CHECK(out[static_cast<std::size_t>(first) + 1] != 0.0F);
		}
	}
}

TEST_CASE("the inertial-viscous cue is 60 ms of viscous + inertia |a|, swelling over half a period") {
	const Movement movement{ 0.8 };
	const double end_s = movement.end_s();
	Vibration vibration(RATE_HZ, 1);
	vibration.set_effects(set_of(inertial_viscous_effect()));
	const auto out = play(vibration, movement, 43200, 384, at(1, end_s));
	const double first_s = std::ceil(end_s * RATE_HZ) / RATE_HZ;
	const auto swell = [](double s) {
		s = std::clamp(s, 0.0, 1.0);
		return s * s * (3.0 - 2.0 * s);
	};
	const auto truth = [&](double t_s) {
		const double since_s = t_s - first_s;
		const double window = swell(since_s * 360.0) * swell((0.06 - since_s) * 360.0);
		const double level = 0.5 + 0.25 * AMPLITUDE_M * std::abs(movement.at(t_s).acceleration);
		return std::min(level, 1.0) * window * sine_at(180.0, since_s);
	};
	// The end of the movement is a corner of the acceleration.
	CHECK(largest_error(out, RATE_HZ, truth) < 5e-3);
	CHECK(largest_error(std::span(out).first(static_cast<std::size_t>(0.79 * RATE_HZ)), RATE_HZ, truth) <
			2e-5);
}

TEST_CASE("a custom effect at an arrival is its curve over a carrier, or its samples") {
	const float values[] = { 0.0F, 1.0F, 0.5F, 0.25F, 0.0F };
	Effect effect = impulse_effect();
	effect.drive = Drive::CONSTANT;
	effect.gain = 0.5;
	effect.table = { values, 5 };
	Vibration vibration(RATE_HZ, 1);
	SUBCASE("curve") {
		effect.shape = Shape::CURVE;
		effect.duration_s = 0.1;
		vibration.set_effects(set_of(effect));
		const auto out = play(vibration, Movement{ 0.5 }, 9600, 384, at(1, 0.05));
		const double spots_s[] = { 0.06, 0.075, 0.0875, 0.1, 0.12 };
		for (const double t_s : spots_s) {
			const double truth =
					0.5 * effect.table.value((t_s - 0.05) / 0.1 * 4.0) * sine_at(300.0, t_s - 0.05);
			CHECK(std::abs(static_cast<double>(out[static_cast<std::size_t>(std::round(t_s * RATE_HZ))]) -
						  truth) < SAMPLE_ERROR);
		}
		CHECK(out[2399] == 0.0F);
		CHECK(out[7201] == 0.0F);
	}
	SUBCASE("samples") {
		effect.shape = Shape::SAMPLES;
		effect.frequency_hz = 3000.0; // its ramps: half a period
		effect.table_rate_hz = 1000.0;
		vibration.set_effects(set_of(effect));
		const auto out = play(vibration, Movement{ 0.5 }, 9600, 384, at(1, 0.05));
		for (int i = 10; i < 180; ++i) {
			const double truth = 0.5 * effect.table.value(i / 48.0);
			REQUIRE(static_cast<double>(out[static_cast<std::size_t>(2400 + i)]) ==
					near(truth).epsilon(1e-6));
		}
		CHECK(out[2400 + 192] == 0.0F);
	}
}
