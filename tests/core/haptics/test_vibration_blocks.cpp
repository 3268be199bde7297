#include "haptics/vibration.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

using namespace steadyhand;
using namespace steadyhand::test;

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
