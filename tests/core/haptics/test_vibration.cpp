#include "haptics/vibration.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

TEST_CASE("no step is above what a full sine makes, whatever changes") {
	for (const double rate_hz : SAMPLE_RATES_HZ) {
		for (const double frequency_hz : { 60.0, 180.0, 300.0 }) {
			CAPTURE(rate_hz);
			CAPTURE(frequency_hz);
			Effect spring = spring_effect();
			spring.trigger = Trigger::ALWAYS;
			spring.frequency_hz = frequency_hz;
			Vibration vibration(rate_hz, 1);
			vibration.seek(0.0);
			std::uint32_t random = 1;
			float last = 0.0F;
			double largest = 0.0;
			for (int change = 0; change < 4000; ++change) {
				random = random * 1664525U + 1013904223U;
				switch ((random >> 28U) % 5U) {
					case 0:
						spring.gain = (random >> 20U) % 2U == 0 ? 1.0 : 0.3;
						break;
					case 1:
						spring.frequency_hz = frequency_hz * ((random >> 20U) % 2U == 0 ? 1.0 : 0.7);
						break;
					case 2:
						spring.trigger = (random >> 20U) % 4U == 0 ? Trigger::ARRIVAL : Trigger::ALWAYS;
						break;
					default:
						break;
				}
				const double position = static_cast<double>((random >> 10U) % 3U) / 2.0;
				vibration.set_effects(set_of(spring));
				vibration.set_motion(still(vibration.time_s(), position));
				if ((random >> 5U) % 7U == 0) {
					vibration.seek(static_cast<double>(random % 1000U));
				}
				const auto out = render(vibration, 16 + (random >> 16U) % 500U);
				largest =
						std::max({ largest, std::abs(static_cast<double>(out[0]) - static_cast<double>(last)),
								largest_step(out) });
				last = out.back();
			}
			CHECK(largest <= 1.02 * step_bound(frequency_hz, rate_hz));
			CHECK(largest > 0.5 * step_bound(frequency_hz, rate_hz));
		}
	}
}

TEST_CASE("motion that is no number, and none at all, is silence") {
	for (const double bad : { NOT_A_NUMBER, HUGE_VAL, -HUGE_VAL, 1e300 }) {
		Vibration vibration(RATE_HZ, 1);
		EffectSet effects = effects_of_gesture("horizontal_drag");
		effects.effects[0].trigger = Trigger::ALWAYS;
		effects.add(impulse_effect());
		vibration.set_effects(effects);
		vibration.seek(bad);
		for (int kind = 0; kind < 5; ++kind) {
			MotionSnapshot snapshot = still(0.0, 0.5);
			(kind == 0                  ? snapshot.time_s
							: kind == 1 ? snapshot.period_s
							: kind == 2 ? snapshot.amplitude_m
							: kind == 3 ? snapshot.knots[1].position
										: snapshot.knots[0].velocity) = bad;
			snapshot.arrival = { static_cast<std::uint32_t>(kind + 1), kind == 4 ? bad : 0.0, bad };
			vibration.set_motion(snapshot);
			vibration.seek(0.0);
			for (const float sample : render(vibration, 3000)) {
				REQUIRE(std::abs(sample) <= 1.0F);
			}
		}
	}
	Vibration vibration(NOT_A_NUMBER, 1);
	CHECK(vibration.sample_rate_hz() == 48000.0);
	vibration.set_effects(effects_of_gesture(""));
	for (const float sample : render(vibration, 1000)) {
		REQUIRE(sample == 0.0F);
	}
	MotionSnapshot snapshot = still(0.0, NOT_A_NUMBER);
	vibration.set_motion(snapshot);
	for (const float sample : render(vibration, 1000)) {
		REQUIRE(sample == 0.0F);
	}
}

TEST_CASE("effects together are held to what the device bears") {
	constexpr double MOST = 0.5;
	EffectSet effects = effects_of_gesture("horizontal_drag");
	effects.effects[0].trigger = Trigger::ALWAYS;
	effects.add(impulse_effect());
	for (std::size_t i = 0; i < effects.count; ++i) {
		effects.effects[i].most = MOST;
	}
	Vibration vibration(RATE_HZ, 1);
	vibration.set_effects(effects);
	MotionSnapshot snapshot = still(0.0, 1.0);
	snapshot.arrival = at(1, 0.01);
	vibration.set_motion(snapshot);
	float largest = 0.0F;
	for (const float sample : render(vibration, 2400)) {
		largest = std::max(largest, std::abs(sample));
	}
	CHECK(largest <= static_cast<float>(MOST));
	CHECK(largest > 0.97F * static_cast<float>(MOST)); // turned down, and no further
}

TEST_CASE("where a drag's spring gives way to its cue nothing is cut flat, nor steps as no full sine does") {
	for (const double from_s : { 0.3, 0.3007, 0.3013, 0.302, 0.3031 }) { // the spring at any phase
		Vibration vibration(RATE_HZ, 1);
		vibration.set_effects(effects_of_gesture("horizontal_drag"));
		vibration.seek(from_s);
		MotionSnapshot snapshot = still(from_s, 1.0);
		for (MotionSnapshot::Knot &knot : snapshot.knots) {
			knot.acceleration = -30.0;
		}
		snapshot.arrival = at(1, from_s + 0.05);
		snapshot.fit();
		vibration.set_motion(snapshot);
		const std::vector<float> samples = render(vibration, 4800);
		int full = 0, most_full = 0;
		for (const float sample : samples) {
			full = std::abs(sample) >= 1.0F ? full + 1 : 0;
			most_full = std::max(most_full, full);
		}
		CHECK(most_full <= 3);
		CHECK(largest_step(samples) < 1.1 * step_bound(180.0, RATE_HZ));
		CHECK(largest_step(samples) > 0.95 * step_bound(180.0, RATE_HZ)); // both are at full scale
	}
}

TEST_CASE("a cue told late steps no more than its own sine, at any rate, pitch and acceleration") {
	for (const double rate_hz : { 8000.0, 22050.0, 48000.0 }) {
		for (const double frequency_hz : { 60.0, 180.0, 250.0 }) {
			for (const double acceleration_m_s2 : { 1.0, 5.0, 30.0 }) {
				for (const double late_s : { 0.0, 0.005, 0.02 }) {
					CAPTURE(rate_hz);
					CAPTURE(frequency_hz);
					CAPTURE(acceleration_m_s2);
					CAPTURE(late_s);
					Effect cue = inertial_viscous_effect();
					cue.frequency_hz = frequency_hz;
					Vibration vibration(rate_hz, 1);
					vibration.set_effects(set_of(cue));
					vibration.seek(0.0);
					std::vector<float> samples;
					const auto block = static_cast<std::size_t>(0.0111 * rate_hz);
					for (int i = 0; i < 60; ++i) {
						MotionSnapshot snapshot;
						snapshot.time_s = vibration.time_s();
						snapshot.period_s = 0.01;
						snapshot.count = 13;
						snapshot.amplitude_m = AMPLITUDE_M;
						for (std::size_t k = 0; k < snapshot.count; ++k) {
							snapshot.knots[k] = { 1.0, 0.0, acceleration_m_s2 / AMPLITUDE_M, false };
						}
						if (snapshot.time_s >= 0.3 + late_s) {
							snapshot.arrival = at(1, 0.3);
						}
						vibration.set_motion(snapshot);
						const std::vector<float> out = render(vibration, block);
						samples.insert(samples.end(), out.begin(), out.end());
					}
					CHECK(largest_step(samples) <= 1.02 * step_bound(frequency_hz, rate_hz));
					CHECK(largest_step(samples) > 0.1 * step_bound(frequency_hz, rate_hz));
				}
			}
		}
	}
}

TEST_CASE("effects go to their channels; one channel has them all") {
	Effect left = spring_effect(), right = spring_effect(), both = spring_effect();
	left.channels = Effect::LEFT;
	right.channels = Effect::RIGHT;
	right.frequency_hz = 250.0;
	both.frequency_hz = 90.0;
	EffectSet effects;
	for (Effect *const effect : { &left, &right, &both }) {
		effect->gain = 0.3;
		effect->trigger = Trigger::ALWAYS;
		effects.add(*effect);
	}
	const auto make = [&](int channels) {
		Vibration vibration(RATE_HZ, channels);
		vibration.set_effects(effects);
		vibration.set_motion(still(0.0, 1.0));
		vibration.seek(0.0);
		return render(vibration, 9600);
	};
	const auto stereo = make(2), mono = make(1);
	const auto part = [](double frequency_hz, double t_s) { return 0.3 * sine_at(frequency_hz, t_s); };
	for (std::size_t i = 2000; i < 4800; ++i) {
		const double t_s = static_cast<double>(i) / RATE_HZ;
		REQUIRE(std::abs(static_cast<double>(stereo[2 * i]) - part(180.0, t_s) - part(90.0, t_s)) <
				SAMPLE_ERROR);
		REQUIRE(std::abs(static_cast<double>(stereo[2 * i + 1]) - part(250.0, t_s) - part(90.0, t_s)) <
				SAMPLE_ERROR);
		REQUIRE(std::abs(static_cast<double>(mono[i]) - part(180.0, t_s) - part(250.0, t_s) -
						part(90.0, t_s)) < SAMPLE_ERROR);
	}
}

TEST_CASE("the strength without the carrier is the envelope of the samples") {
	const Movement movement{ 0.8 };
	const EffectSet effects = effects_of_gesture("vertical_drag");
	const Arrival arrival = at(1, movement.end_s());
	CHECK(strength_of(effects, 0.2, movement.at(0.2), true, AMPLITUDE_M, {}).amplitude ==
			near(movement.at(0.2).position));
	CHECK(strength_of(effects, 0.2, movement.at(0.2), false, AMPLITUDE_M, {}).amplitude == 0.0);
	const double t_s = arrival.time_s + 0.02;
	CHECK(strength_of(effects, t_s, movement.at(t_s), false, AMPLITUDE_M, arrival).amplitude ==
			near(0.5 + 0.25 * AMPLITUDE_M * std::abs(movement.at(t_s).acceleration)));
	const double late_s = arrival.time_s + 0.061;
	CHECK(strength_of(effects, late_s, movement.at(late_s), false, AMPLITUDE_M, arrival).amplitude == 0.0);
	const Strength impulse =
			strength_of(effects_of_gesture("tap"), t_s, movement.at(t_s), false, AMPLITUDE_M, arrival);
	CHECK(impulse.amplitude == near(0.6 * std::exp(-4.0)));
	CHECK(impulse.frequency_hz == 300.0);
}

TEST_CASE(
		"an hour of play leaves amplitude and phase where they are to be" * doctest::test_suite("figures")) {
	Effect spring = spring_effect();
	spring.trigger = Trigger::ALWAYS;
	Vibration vibration(RATE_HZ, 1);
	vibration.set_effects(set_of(spring));
	vibration.seek(0.0);
	std::vector<float> block(48000);
	for (int second = 0; second < 3600; ++second) {
		const double held = second % 2 == 0 ? 1.0 : 0.25;
		vibration.set_motion(still(second, held));
		vibration.render(block);
		if (second % 600 == 599 || second == 3598) {
			// 180 Hz: whole turns a second.
			CHECK(largest_error(std::span(block).last(24000), RATE_HZ,
						  [&](double t_s) { return held * sine_at(180.0, t_s); }) < SAMPLE_ERROR);
		}
	}
	CHECK(vibration.time_s() == near(3600.0).epsilon(1e-9));
}
