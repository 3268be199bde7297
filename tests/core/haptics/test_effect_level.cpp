// The amplitude that a motion gives an effect, as a number and with its slope.

#include "haptics/effect.h"
#include "haptics/oscillator.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double AMPLITUDE_M = 0.2;
constexpr std::array<float, 5> TABLE{ 0.1F, 0.7F, 0.4F, 1.0F, 0.2F };

/// Of 0.1 amplitudes to 0.9 and back, a second each.
MotionPoint swing(double t_s) {
	const double w = std::acos(-1.0);
	return { 0.5 - 0.4 * std::cos(w * t_s), 0.4 * w * std::sin(w * t_s), 0.4 * w * w * std::cos(w * t_s),
		-0.4 * w * w * w * std::sin(w * t_s) };
}

Effect effect_of(Shape shape, Drive drive) {
	Effect effect;
	effect.shape = shape;
	effect.drive = drive;
	effect.gain = 0.8;
	effect.full_scale = drive == Drive::POSITION ? 1.3 : drive == Drive::VELOCITY ? 0.4 : 1.1;
	effect.table = { TABLE.data(), static_cast<std::uint32_t>(TABLE.size()) };
	return effect;
}

} // namespace

TEST_CASE("the slope of a level is its derivative, whichever way the motion goes") {
	constexpr double STEP_S = 1e-6;
	for (const Shape shape : { Shape::SINE, Shape::CURVE, Shape::INERTIAL_VISCOUS }) {
		for (const Drive drive : { Drive::CONSTANT, Drive::POSITION, Drive::VELOCITY, Drive::ACCELERATION }) {
			CAPTURE(static_cast<int>(shape));
			CAPTURE(static_cast<int>(drive));
			for (const double most : { 1.0, 0.3 }) {
				Effect effect = effect_of(shape, drive);
				effect.most = most;
				const auto level = [&](double t_s) { return level_of(effect, swing(t_s), AMPLITUDE_M); };
				int kinks = 0;
				for (int i = 0; i < 199; ++i) {
					const double t_s = 0.0101 * i + 0.0013;
					const LevelPoint before = level(t_s - STEP_S), now = level(t_s),
									 after = level(t_s + STEP_S);
					CHECK(now.value >= 0.0);
					CHECK(now.value <= most);
					const double slope = (after.value - before.value) / (2.0 * STEP_S);
					kinks += std::abs(now.slope - slope) > 1e-4 * std::max(1.0, std::abs(slope)) ? 1 : 0;
				}
				CHECK(kinks == 0);
			}
		}
	}
}

TEST_CASE("the level is the drive by its full scale, over the table where it is a curve, held to the most") {
	const MotionPoint motion{ 0.5, -1.2, 3.0, 40.0 };
	const auto value = [&](Shape shape, Drive drive) {
		return level_of(effect_of(shape, drive), motion, AMPLITUDE_M).value;
	};
	CHECK(value(Shape::SINE, Drive::CONSTANT) == test::near(0.8));
	CHECK(value(Shape::SINE, Drive::POSITION) == test::near(0.8 * 0.5 / 1.3));
	CHECK(value(Shape::SINE, Drive::VELOCITY) == test::near(0.8 * 0.24 / 0.4));
	CHECK(value(Shape::SINE, Drive::ACCELERATION) == test::near(0.8 * 0.6 / 1.1));
	// 0.24 / 0.4 of four cells: 0.4 on from the third number.
	CHECK(value(Shape::CURVE, Drive::VELOCITY) == test::near(0.8 * (0.4 + 0.4 * 0.6)));
	CHECK(value(Shape::CURVE, Drive::CONSTANT) == test::near(0.8 * 0.2));
	CHECK(value(Shape::INERTIAL_VISCOUS, Drive::ACCELERATION) == test::near(0.8 * (0.5 + 0.25 * 0.6)));
	// A drive beyond its full scale is at it; of slope 0, like one that is no number.
	const double infinity = std::numeric_limits<double>::infinity();
	for (const MotionPoint &fast : { MotionPoint{ 0.0, 9.0, 1.0 }, MotionPoint{ 0.0, -9.0, 1.0 } }) {
		const LevelPoint held = level_of(effect_of(Shape::SINE, Drive::VELOCITY), fast, AMPLITUDE_M);
		CHECK(held.value == test::near(0.8));
		CHECK(held.slope == 0.0);
	}
	for (const MotionPoint &bad : { MotionPoint{ 0.5, infinity }, MotionPoint{ infinity, 0.0 },
				 MotionPoint{ std::nan(""), 0.0 }, MotionPoint{ 0.5, std::nan("") } }) {
		const LevelPoint none = level_of(effect_of(Shape::SINE, Drive::POSITION), bad, AMPLITUDE_M);
		CHECK(none.value == 0.0);
		CHECK(none.slope == 0.0);
	}
}

TEST_CASE("a level that has a corner between two motions is not called smooth") {
	const auto smooth = [](Shape shape, Drive drive, const MotionPoint &from, const MotionPoint &to) {
		const Effect effect = effect_of(shape, drive);
		return is_smooth(effect, from, to, level_of(effect, from, AMPLITUDE_M).value,
				level_of(effect, to, AMPLITUDE_M).value);
	};
	// On the way out, near the turn, on the way back; faster than full scale.
	const MotionPoint out = swing(0.3), slower = swing(0.7), back = swing(1.2), fast{ 0.5, 3.0, 1.0 };
	CHECK(smooth(Shape::SINE, Drive::POSITION, out, back));
	CHECK(smooth(Shape::SINE, Drive::VELOCITY, out, slower));
	CHECK_FALSE(smooth(Shape::SINE, Drive::VELOCITY, out, back));
	CHECK_FALSE(smooth(Shape::SINE, Drive::VELOCITY, out, fast));
	CHECK_FALSE(smooth(Shape::SINE, Drive::VELOCITY, fast, out));
	CHECK_FALSE(smooth(Shape::SINE, Drive::ACCELERATION, out, slower));
	CHECK(smooth(Shape::SINE, Drive::ACCELERATION, slower, back));
	CHECK_FALSE(smooth(Shape::INERTIAL_VISCOUS, Drive::CONSTANT, out, slower));
	CHECK_FALSE(smooth(Shape::CURVE, Drive::POSITION, out, slower));
	CHECK(smooth(Shape::CURVE, Drive::CONSTANT, out, back));
	CHECK(smooth(Shape::CURVE, Drive::POSITION, { 0.5 }, { 0.5 }));
	CHECK_FALSE(smooth(Shape::SINE, Drive::POSITION, { -0.1, 1.0 }, { 0.1, 1.0 }));
}

TEST_CASE("an arrival is felt by its speed, up to the full scale, for as long as the effect lasts") {
	Effect impulse = impulse_effect();
	impulse.gain = 0.6;
	impulse.full_scale = 0.5;
	const auto peak = [&](double speed_m_s) {
		return peak_of(impulse, { 1, 2.0, speed_m_s }, {}, AMPLITUDE_M);
	};
	CHECK(peak(0.25) == test::near(0.3));
	CHECK(peak(0.5) == test::near(0.6));
	CHECK(peak(9.0) == test::near(0.6));

	EffectSet effects;
	effects.add(impulse);
	const auto amplitude = [&](double t_s, std::uint32_t number) {
		return strength_of(effects, t_s, {}, true, AMPLITUDE_M, { number, 2.0, 0.25 }).amplitude;
	};
	const double length_s = impulse.length_s();
	CHECK(std::exp(-impulse.decay_per_s * length_s) == test::near(std::exp(-8.0)));
	CHECK(amplitude(1.999, 1) == 0.0);
	CHECK(amplitude(2.0, 0) == 0.0);
	CHECK(amplitude(2.01, 1) == test::near(0.3 * std::exp(-impulse.decay_per_s * 0.01)));
	CHECK(amplitude(2.0 + 0.999 * length_s, 1) > 0.0);
	CHECK(amplitude(2.0 + length_s, 1) == 0.0);

	effects = {};
	Effect curve = effect_of(Shape::CURVE, Drive::CONSTANT);
	curve.trigger = Trigger::ARRIVAL;
	effects.add(curve);
	CHECK(amplitude(2.0 + 0.375 * curve.duration_s, 1) == test::near(0.8 * 0.55));
}

TEST_CASE("together effects are as strong as their sum, at most 1, and have the strongest one's frequency") {
	Effect weak = effect_of(Shape::SINE, Drive::CONSTANT), strong = weak;
	weak.gain = 0.3;
	weak.frequency_hz = 50.0;
	strong.gain = 0.5;
	strong.frequency_hz = 200.0;
	for (const std::vector<Effect> &each :
			{ std::vector{ weak, strong, weak }, std::vector{ strong, weak }, std::vector{ weak, strong } }) {
		EffectSet effects;
		double sum = 0.0;
		for (const Effect &effect : each) {
			effects.add(effect);
			sum += effect.gain;
		}
		const Strength strength = strength_of(effects, 0.0, {}, true, AMPLITUDE_M, {});
		CHECK(strength.amplitude == test::near(std::min(sum, 1.0)));
		CHECK(strength.frequency_hz == 200.0);
		// 50 Hz are the heavy motor's, 200 Hz the light one's, in the proportion that they have to each
		// other.
		CHECK(strength.low == test::near(strength.amplitude * (sum - 0.5) / sum));
		CHECK(strength_of(effects, 0.0, {}, false, AMPLITUDE_M, {}).amplitude == 0.0);
	}
}

TEST_CASE("together effects are no stronger than the device bears") {
	EffectSet effects;
	for (int i = 0; i < 3; ++i) {
		Effect effect = effect_of(Shape::SINE, Drive::CONSTANT);
		effect.most = i == 1 ? 0.5 : 0.4;
		effects.add(effect);
	}
	CHECK(strength_of(effects, 0.0, {}, true, AMPLITUDE_M, {}).amplitude == test::near(0.5));
	CHECK(strength_of({}, 0.0, {}, true, AMPLITUDE_M, {}).amplitude == 0.0);
	// Nothing is left for the light motor where all is the heavy one's, not even less than nothing.
	for (int percent = 1; percent < 100; ++percent) {
		EffectSet low;
		for (int i = 0; i < 3; ++i) {
			Effect effect = effect_of(Shape::SINE, Drive::CONSTANT);
			effect.frequency_hz = 60.0;
			effect.gain = 0.011 * percent;
			effect.most = 0.7;
			low.add(effect);
		}
		const Strength strength = strength_of(low, 0.0, {}, true, AMPLITUDE_M, {});
		REQUIRE(strength.low == strength.amplitude);
	}
}

TEST_CASE("samples are as strong as they are around an instant") {
	// 200 Hz for 10 ms, at 0.2, then as long at 0.4, then nothing.
	constexpr double RATE_HZ = 48e3;
	std::vector<float> samples(24000, 0.0F);
	for (std::size_t i = 0; i < 960; ++i) {
		const double phase = 2.0 * std::acos(-1.0) * 200.0 * static_cast<double>(i) / RATE_HZ;
		samples[i] = static_cast<float>((i < 480 ? 0.2 : 0.4) * std::sin(phase));
	}
	Effect effect = effect_of(Shape::SAMPLES, Drive::CONSTANT);
	effect.trigger = Trigger::ARRIVAL;
	effect.table = { samples.data(), static_cast<std::uint32_t>(samples.size()) };
	effect.table_rate_hz = RATE_HZ;
	EffectSet effects;
	effects.add(effect);
	const auto amplitude = [&](double since_s) {
		return strength_of(effects, 2.0 + since_s, {}, true, AMPLITUDE_M, { 1, 2.0, 0.25 }).amplitude;
	};
	CHECK(amplitude(0.0) == test::near(0.8 * 0.2).epsilon(1e-3));
	CHECK(amplitude(0.004) == test::near(0.8 * 0.2).epsilon(1e-3));
	CHECK(amplitude(0.014) == test::near(0.8 * 0.4).epsilon(1e-3));
	CHECK(amplitude(0.0251) == 0.0);
	CHECK(amplitude(0.4999) == 0.0);
	CHECK(amplitude(0.51) == 0.0);
	CHECK(effect.table.greatest(-9.0, -1.0) == 0.0);
	CHECK(effect.table.greatest(30000.0, 40000.0) == 0.0);
	CHECK(Table{}.greatest(-1.0, 1.0) == 0.0);
}

TEST_CASE("no sine is faster than half the sample rate, and none without a rate goes on") {
	CHECK(phase_step(12e3, 48e3) == std::uint64_t{ 1 } << 62);
	CHECK(phase_step(24e3, 48e3) == std::uint64_t{ 1 } << 63);
	CHECK(phase_step(1e6, 48e3) == std::uint64_t{ 1 } << 63);
	for (const double bad : { 0.0, -1.0, std::nan("") }) {
		CHECK(phase_step(bad, 48e3) == 0);
		CHECK(phase_step(180.0, bad) == 0);
	}
	CHECK(phase_step(180.0, std::numeric_limits<double>::infinity()) == 0);
}

TEST_CASE("an effect uses the own acceleration, linear between knots") {
	const test::Movement movement{ 0.35 };
	MotionSnapshot snapshot = movement.snapshot(0.05);
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		snapshot.knots[i].correction = 90.0 * std::cos(2.0 * static_cast<double>(i));
	}
	MotionCurve curve;
	curve.set(snapshot);
	Effect effect;
	effect.drive = Drive::ACCELERATION;
	effect.full_scale = 1000.0;
	for (int i = 0; i < 270; ++i) {
		const double t_s = 0.05 + 0.00037 * i;
		const auto knot = static_cast<std::size_t>((t_s - 0.05) / 0.01);
		const auto own_at = [&](std::size_t k) {
			return snapshot.knots[k].acceleration - snapshot.knots[k].correction;
		};
		const double slope = (own_at(knot + 1) - own_at(knot)) / 0.01;
		const double own = own_at(knot) + slope * (t_s - 0.05 - 0.01 * static_cast<double>(knot));
		const MotionPoint truth = movement.at(t_s);
		for (const MotionPoint &made : { snapshot.at(t_s), curve.at(t_s) }) {
			REQUIRE(std::abs(made.position - truth.position) < 1e-12);
			REQUIRE(std::abs(made.acceleration - truth.acceleration) < 1e-7);
			REQUIRE(std::abs(made.own_acceleration() - own) < 1e-7);
			const LevelPoint level = level_of(effect, made, test::AMPLITUDE_M);
			REQUIRE(level.value == test::near(test::AMPLITUDE_M * std::abs(own) / 1000.0).epsilon(1e-6));
			const double sign = own < 0.0 ? -1.0 : 1.0;
			REQUIRE(level.slope == test::near(sign * test::AMPLITUDE_M * slope / 1000.0).epsilon(1e-6));
		}
	}
	for (const double t_s : { snapshot.time_s, snapshot.end_s() }) {
		CHECK(snapshot.at(t_s + 1e-9).own_acceleration() ==
				test::near(snapshot.at(t_s - 1e-9).own_acceleration()).epsilon(1e-5));
	}
}
