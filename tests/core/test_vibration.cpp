#include "haptics/vibration.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

namespace {

constexpr double RATE_HZ = 48000.0;
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

/// From a snapshot each 384 samples of a movement, as it is played on the motion's own clock. Knots are at
/// whole hundredths of a second, where the movement may begin and end.
std::vector<float> play(Vibration &vibration, const Movement &movement, std::size_t samples,
		std::size_t block = 384, const Arrival &expected = {}) {
	std::vector<float> out(samples);
	vibration.seek(0.0);
	for (std::size_t done = 0; done < samples; done += 384) {
		const double now_s = static_cast<double>(done) / vibration.sample_rate_hz();
		MotionSnapshot snapshot = movement.snapshot(0.01 * std::floor(100.0 * now_s));
		snapshot.expected = expected;
		vibration.set_motion(snapshot);
		const std::span<float> part =
				std::span(out).subspan(done, std::min<std::size_t>(384, samples - done));
		for (std::size_t at = 0; at < part.size(); at += block) {
			vibration.render(part.subspan(at, std::min(block, part.size() - at)));
		}
	}
	return out;
}

double sine_at(double frequency_hz, double t_s) {
	return static_cast<double>(std::sin(TURN * frequency_hz * static_cast<long double>(t_s)));
}

/// Largest difference from a function of the sample's time.
template <class Truth>
double largest_error(std::span<const float> samples, double rate_hz, Truth truth, std::size_t from = 0) {
	double largest = 0.0;
	for (std::size_t i = from; i < samples.size(); ++i) {
		const double t_s = static_cast<double>(i) / rate_hz;
		largest = std::max(largest, std::abs(static_cast<double>(samples[i]) - truth(t_s)));
	}
	return largest;
}

double largest_step(std::span<const float> samples) {
	double largest = 0.0;
	for (std::size_t i = 1; i < samples.size(); ++i) {
		largest = std::max(
				largest, std::abs(static_cast<double>(samples[i]) - static_cast<double>(samples[i - 1])));
	}
	return largest;
}

/// Of a full-scale sine.
double step_bound(double frequency_hz, double rate_hz) {
	return 2.0 * std::sin(std::numbers::pi * std::min(frequency_hz / rate_hz, 0.5));
}

Arrival at(std::uint32_t number, double time_s) {
	return { number, time_s, 0.6 };
}

} // namespace

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
					doctest::Approx(truth).epsilon(1e-6));
		}
		CHECK(out[2400 + 192] == 0.0F);
	}
}

TEST_CASE("blocks of any size are made of the same samples") {
	EffectSet effects = effects_of_gesture("horizontal_drag");
	effects.add(impulse_effect());
	const Movement movement{ 0.4 };
	Vibration whole(RATE_HZ, 1);
	whole.set_effects(effects);
	const auto expected = play(whole, movement, 24000, 384, at(1, movement.end_s()));
	for (const std::size_t block : { 1U, 7U, 64U, 100U, 384U }) {
		CAPTURE(block);
		Vibration parts(RATE_HZ, 1);
		parts.set_effects(effects);
		CHECK(play(parts, movement, 24000, block, at(1, movement.end_s())) == expected);
	}
	// Longer than what snapshots tell of.
	Vibration one(RATE_HZ, 2);
	Vibration other(RATE_HZ, 2);
	std::vector<float> long_block(8192), short_blocks(8192);
	for (Vibration *const vibration : { &one, &other }) {
		vibration->set_effects(effects);
		vibration->set_motion(movement.snapshot(0.1));
		vibration->seek(0.1);
	}
	one.render(long_block);
	for (std::size_t done = 0; done < short_blocks.size(); done += 1024) {
		other.render(std::span(short_blocks).subspan(done, 1024));
	}
	CHECK(long_block == short_blocks);
}

TEST_CASE("the blocks of a live vibration change no bit of it either, however they lie to what is told") {
	constexpr std::size_t NEWS = 533, SAMPLES = 24000;
	const Movement movement{ 0.45 };
	const auto made_of = [&](std::size_t block) {
		Vibration vibration(RATE_HZ, 2);
		EffectSet effects = effects_of_gesture("horizontal_drag");
		effects.add(impulse_effect());
		effects.effects[2].channels = Effect::RIGHT;
		vibration.set_effects(effects);
		std::vector<float> out(2 * SAMPLES);
		for (std::size_t done = 0; done < SAMPLES; done += NEWS) {
			const double now_s = static_cast<double>(done) / RATE_HZ;
			MotionSnapshot snapshot = movement.snapshot(now_s - 0.003);
			snapshot.expected = at(1, movement.end_s());
			vibration.set_motion(snapshot);
			vibration.follow(now_s + 1e-4 * static_cast<double>(done % 7));
			const std::size_t end = std::min(done + NEWS, SAMPLES);
			for (std::size_t from = done; from < end; from += block) {
				const std::size_t count = std::min(block, end - from);
				vibration.render(std::span(out).subspan(2 * from, 2 * count));
			}
		}
		return out;
	};
	const auto whole = made_of(NEWS);
	for (const std::size_t block : { 1U, 13U, 64U, 128U, 200U, 512U }) {
		CAPTURE(block);
		const auto parts = made_of(block);
		CHECK(std::memcmp(parts.data(), whole.data(), whole.size() * sizeof(float)) == 0);
	}
}

TEST_CASE("an effect that lasts while a gesture does ends with it, wherever in a stretch that is") {
	for (const double end_s : { 0.02, 0.03, 0.05 }) {
		CAPTURE(end_s);
		Effect tone = spring_effect();
		tone.drive = Drive::CONSTANT;
		MotionSnapshot snapshot = Movement{ 0.5 }.snapshot(0.0);
		for (std::size_t i = 0; i < snapshot.count; ++i) {
			snapshot.knots[i].moving = 0.01 * static_cast<double>(i) < end_s - 1e-9;
		}
		Vibration vibration(RATE_HZ, 1);
		vibration.set_effects(set_of(tone));
		vibration.set_motion(snapshot);
		vibration.seek(0.0);
		const auto out = render(vibration, 4800);
		const auto peak = [&](double from_s, double to_s) {
			float greatest = 0.0F;
			const auto first = static_cast<std::size_t>(from_s * RATE_HZ);
			for (const float sample :
					std::span(out).subspan(first, static_cast<std::size_t>(to_s * RATE_HZ) - first)) {
				greatest = std::max(greatest, std::abs(sample));
			}
			return greatest;
		};
		const double run_s = 64.0 / RATE_HZ;
		CHECK(peak(end_s - 0.004, end_s) > 0.99F);
		CHECK(peak(end_s + run_s + 0.01, 0.1) < 0.001F);
	}
}

TEST_CASE("an arrival that is expected is felt on its own sample, once, and may be taken back before") {
	const auto begin = [](Vibration &vibration) {
		vibration.set_effects(set_of(impulse_effect()));
		MotionSnapshot snapshot = still(0.0, 0.8);
		snapshot.expected = at(1, 0.02);
		vibration.set_motion(snapshot);
		vibration.seek(0.0);
	};
	const auto sounds = [](std::span<const float> samples) {
		return std::any_of(samples.begin(), samples.end(), [](float sample) { return sample != 0.0F; });
	};
	Vibration vibration(RATE_HZ, 1);
	begin(vibration);
	SUBCASE("once") {
		const auto out = render(vibration, 6000);
		CHECK_FALSE(sounds(std::span(out).first(960)));
		CHECK(sounds(std::span(out).subspan(960, 10)));
		MotionSnapshot later = still(0.125, 0.96);
		later.arrival = at(1, 0.021);
		vibration.set_motion(later);
		CHECK_FALSE(sounds(render(vibration, 4800)));
		later.arrival = at(2, 0.22);
		vibration.set_motion(later);
		CHECK(sounds(render(vibration, 4800)));
	}
	SUBCASE("taken back") {
		render(vibration, 896);
		vibration.set_motion(still(0.018, 0.8));
		CHECK_FALSE(sounds(render(vibration, 4800)));
	}
	SUBCASE("moved") {
		render(vibration, 896);
		MotionSnapshot later = still(0.018, 0.8);
		later.expected = at(1, 0.03);
		vibration.set_motion(later);
		const auto out = render(vibration, 4800);
		CHECK_FALSE(sounds(std::span(out).first(1440 - 896)));
		CHECK(sounds(std::span(out).subspan(1440 - 896, 10)));
	}
	SUBCASE("noticed late, at once; too late, not at all") {
		vibration.set_motion(still(0.018, 0.8));
		render(vibration, 4800);
		MotionSnapshot later = still(0.1, 0.96);
		later.arrival = at(1, 0.06);
		vibration.set_motion(later);
		CHECK(sounds(std::span<const float>(render(vibration, 64)).first(8)));
		render(vibration, 9600);
		later.arrival = at(2, 0.2);
		vibration.set_motion(later);
		CHECK_FALSE(sounds(render(vibration, 4800)));
	}
}

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

TEST_CASE("live motion that is not heard of fades out, and a mix that comes late leaps to now") {
	Effect spring = spring_effect();
	spring.trigger = Trigger::ALWAYS;
	Vibration vibration(RATE_HZ, 1);
	vibration.set_effects(set_of(spring));
	vibration.set_motion(still(9.99, 0.5));
	vibration.follow(9.99);
	render(vibration, 480);
	vibration.set_motion(still(10.0, 0.5));
	vibration.follow(10.0);
	const auto out = render(vibration, 48000 / 5);
	CHECK(largest_error(std::span(out).subspan(1000, 3000), RATE_HZ,
				  [](double t_s) { return 0.5 * sine_at(180.0, t_s + 1480.0 / RATE_HZ); }) < SAMPLE_ERROR);
	CHECK(out.back() == 0.0F);
	CHECK(largest_step(out) <= 0.51 * step_bound(180.0, RATE_HZ));
	// 2 s later: what happened in between is not caught up with.
	MotionSnapshot later = still(12.2, 1.0);
	later.arrival = at(5, 11.0);
	vibration.set_motion(later);
	vibration.follow(12.2);
	CHECK(vibration.time_s() == 12.2);
	CHECK(largest_step(render(vibration, 4800)) <= 1.02 * step_bound(180.0, RATE_HZ));
}

TEST_CASE("where samples are made for half a second at a time a held hand does not fade in between") {
	constexpr double LOW_HZ = 8000.0;
	constexpr std::size_t AT_ONCE = 4096;
	Effect spring = spring_effect();
	spring.trigger = Trigger::ALWAYS;
	Vibration vibration(LOW_HZ, 1);
	vibration.set_effects(set_of(spring));
	double now_s = 10.0;
	const auto burst = [&] {
		vibration.set_motion(still(now_s, 0.5));
		vibration.follow(now_s);
		now_s += static_cast<double>(AT_ONCE) / LOW_HZ;
		return render(vibration, AT_ONCE);
	};
	const auto greatest = [](std::span<const float> samples) {
		float most = 0.0F;
		for (const float sample : samples) {
			most = std::max(most, std::abs(sample));
		}
		return most;
	};
	for (int i = 0; i < 5; ++i) {
		const auto out = burst();
		CHECK(greatest(out) < (i == 0 ? 0.51F : 0.5001F));
		for (std::size_t from = i == 0 ? 200 : 0; from < AT_ONCE - 50; from += 50) {
			REQUIRE(greatest(std::span(out).subspan(from, 50)) > 0.45F);
		}
	}
	// It is over where none comes any more; a single stall teaches no patience.
	CHECK(greatest(std::span<const float>(render(vibration, 2 * AT_ONCE)).last(100)) == 0.0F);
	for (int i = 0; i < 20; ++i) {
		vibration.set_motion(still(now_s, 0.5));
		vibration.follow(now_s);
		now_s += 0.01;
		render(vibration, i == 10 ? 8000 : 80);
	}
	CHECK(greatest(std::span<const float>(render(vibration, 2000)).last(500)) == 0.0F);
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
			doctest::Approx(movement.at(0.2).position));
	CHECK(strength_of(effects, 0.2, movement.at(0.2), false, AMPLITUDE_M, {}).amplitude == 0.0);
	const double t_s = arrival.time_s + 0.02;
	CHECK(strength_of(effects, t_s, movement.at(t_s), false, AMPLITUDE_M, arrival).amplitude ==
			doctest::Approx(0.5 + 0.25 * AMPLITUDE_M * std::abs(movement.at(t_s).acceleration)));
	const double late_s = arrival.time_s + 0.061;
	CHECK(strength_of(effects, late_s, movement.at(late_s), false, AMPLITUDE_M, arrival).amplitude == 0.0);
	const Strength impulse =
			strength_of(effects_of_gesture("tap"), t_s, movement.at(t_s), false, AMPLITUDE_M, arrival);
	CHECK(impulse.amplitude == doctest::Approx(0.6 * std::exp(-4.0)));
	CHECK(impulse.frequency_hz == 300.0);
}

TEST_CASE("an hour of play leaves amplitude and phase where they are to be") {
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
	CHECK(vibration.time_s() == doctest::Approx(3600.0).epsilon(1e-9));
}
