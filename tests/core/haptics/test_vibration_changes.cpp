// What is heard while effects, motion and rates change, against closed forms.

#include "haptics/vibration.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

/// Whole runs, so that a change is heard from its own sample on.
constexpr std::size_t BEFORE = 75 * RUN;

Effect held_spring(double frequency_hz = 180.0) {
	Effect spring = spring_effect();
	spring.trigger = Trigger::ALWAYS;
	spring.frequency_hz = frequency_hz;
	return spring;
}

double fading_per_s(double frequency_hz) {
	return std::min(2.0 * std::numbers::pi * frequency_hz, 1000.0);
}

/// Share of a step that is left so long after it.
double left_of_step(double frequency_hz, double since_s) {
	const double x = fading_per_s(frequency_hz) * since_s;
	return (1.0 + x) * std::exp(-x);
}

/// Of the cubic over a run that has its values and slopes; its fourth derivative is 3 at the greatest.
double fading_error(double frequency_hz) {
	return 3.0 * std::pow(fading_per_s(frequency_hz) * static_cast<double>(RUN) / RATE_HZ, 4.0) / 384.0;
}

} // namespace

TEST_CASE("what ends fades out critically damped, at the frequency that it had, at another sample rate too") {
	for (const double frequency_hz : { 90.0, 180.0 }) {
		for (const double rate_hz : { RATE_HZ, 50000.0 }) {
			for (const bool has_another : { false, true }) {
				CAPTURE(frequency_hz);
				CAPTURE(rate_hz);
				CAPTURE(has_another);
				Vibration vibration(RATE_HZ, 1);
				vibration.seek(0.0);
				vibration.set_effects(set_of(held_spring(frequency_hz)));
				vibration.set_motion(still(0.0, 0.5));
				render(vibration, BEFORE);
				Effect other = held_spring(300.0);
				other.trigger = Trigger::ARRIVAL;
				vibration.set_effects(has_another ? set_of(other) : EffectSet{});
				vibration.set_sample_rate(rate_hz);
				const auto faded = [&](double t_s) {
					const double since_begin_s = t_s + static_cast<double>(BEFORE) / RATE_HZ;
					return 0.5 * left_of_step(frequency_hz, t_s) * sine_at(frequency_hz, since_begin_s);
				};
				CHECK(largest_error(render(vibration, 2400), rate_hz, faded) <
						0.5 * fading_error(frequency_hz));
			}
		}
	}
}

TEST_CASE("another sample rate leaves frequency and phase as they were") {
	for (const double rate_hz : { 44100.0, 96000.0 }) {
		CAPTURE(rate_hz);
		Vibration vibration(RATE_HZ, 1);
		vibration.seek(0.0);
		vibration.set_effects(set_of(held_spring()));
		vibration.set_motion(still(0.0, 0.5));
		render(vibration, BEFORE);
		vibration.set_sample_rate(rate_hz);
		const auto goes_on = [](double t_s) {
			return 0.5 * sine_at(180.0, t_s + static_cast<double>(BEFORE) / RATE_HZ);
		};
		CHECK(largest_error(render(vibration, 4800), rate_hz, goes_on) < SAMPLE_ERROR);
	}
}

TEST_CASE("live motion that is caught up with is felt at the pace at which it is") {
	const Movement movement{ 0.4 };
	for (const double behind_s : { 0.02, -0.02 }) { // it is drawn on at 2 % for longer than this lasts
		CAPTURE(behind_s);
		Vibration vibration(RATE_HZ, 1);
		vibration.set_effects(set_of(held_spring()));
		vibration.set_motion(movement.snapshot(0.1));
		vibration.follow(0.1);
		vibration.follow(0.1 + behind_s);
		const auto truth = [&](double t_s) {
			return movement.at(0.1 + (behind_s > 0.0 ? 1.02 : 0.98) * t_s).position * sine_at(180.0, t_s);
		};
		const std::size_t faded_in = 1200;
		CHECK(largest_error(render(vibration, 4500), RATE_HZ, truth, faded_in) < 2.0 * SAMPLE_ERROR);
	}
}

TEST_CASE("what begins again from silence fades in as it did the first time") {
	constexpr double FAINT = 0.1;
	MotionSnapshot snapshot = still(-0.0001, FAINT); // its knots just before the beginnings of runs
	snapshot.count = 4;
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		snapshot.knots[i] = { FAINT, 0.0, 0.0, i != 1 };
	}
	Vibration vibration(RATE_HZ, 1);
	vibration.seek(0.0);
	vibration.set_effects(set_of(spring_effect()));
	vibration.set_motion(snapshot);
	const auto truth = [](double t_s) {
		const double out_s = static_cast<double>(38 * RUN) / RATE_HZ; // the first run after 50 ms
		const double in_s = static_cast<double>(75 * RUN) / RATE_HZ;
		const double level = t_s < out_s ? 1.0 - left_of_step(180.0, t_s)
				: t_s < in_s             ? left_of_step(180.0, t_s - out_s)
										 : 1.0 - left_of_step(180.0, t_s - in_s);
		return FAINT * level * sine_at(180.0, t_s);
	};
	CHECK(largest_error(render(vibration, 7000), RATE_HZ, truth) < FAINT * fading_error(180.0));
}

TEST_CASE("a corner of the amplitude is nowhere rounded by more than a run") {
	// To the turning point and back: the speed has a corner there, the position one where it is held.
	constexpr double SPEED_PER_S = 8.0, BRAKES_PER_S2 = 160.0;
	MotionSnapshot snapshot = still(0.0, 0.0);
	snapshot.period_s = 0.1;
	snapshot.knots[0] = { 0.9, SPEED_PER_S, -BRAKES_PER_S2, true };
	snapshot.knots[1] = { 0.9 + 0.1 * SPEED_PER_S - 0.5 * BRAKES_PER_S2 * 0.01,
		SPEED_PER_S - 0.1 * BRAKES_PER_S2, -BRAKES_PER_S2, true };
	for (const Drive drive : { Drive::POSITION, Drive::VELOCITY }) {
		CAPTURE(static_cast<int>(drive));
		Effect effect = held_spring();
		effect.drive = drive;
		effect.full_scale = drive == Drive::VELOCITY ? 2.0 : 1.0;
		const auto level = [&](double t_s) {
			const double position = 0.9 + SPEED_PER_S * t_s - 0.5 * BRAKES_PER_S2 * t_s * t_s;
			const double speed_m_s = AMPLITUDE_M * std::abs(SPEED_PER_S - BRAKES_PER_S2 * t_s);
			return std::clamp(drive == Drive::VELOCITY ? speed_m_s / 2.0 : position, 0.0, 1.0);
		};
		Vibration vibration(RATE_HZ, 1);
		vibration.seek(0.0);
		vibration.set_effects(set_of(effect));
		vibration.set_motion(snapshot);
		const auto truth = [&](double t_s) { return level(t_s) * sine_at(180.0, t_s); };
		const double a_run_s = static_cast<double>(RUN) / RATE_HZ;
		const double steepest_per_s =
				drive == Drive::VELOCITY ? AMPLITUDE_M * BRAKES_PER_S2 / 2.0 : SPEED_PER_S;
		CHECK(largest_error(render(vibration, 4700), RATE_HZ, truth, 1200) < 0.3 * steepest_per_s * a_run_s);
	}
}
