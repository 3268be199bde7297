// Renders an hour of vibration at 48 kHz, faster than real time: gestures at 90 Hz, effects that change every
// second, and a spring of constant amplitude. Prints the error of that spring against its sine, the number of
// allocations, and the time for a sample in the first and in the last minutes.

#include "haptics/live_vibration.h"
#include "signal/minimum_jerk.h"
#include "timing.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <numbers>

namespace {

std::atomic<long> allocations = 0;

} // namespace

void *operator new(std::size_t size) {
	++allocations;
	if (void *const memory = std::malloc(size)) {
		return memory;
	}
	throw std::bad_alloc();
}

void operator delete(void *memory) noexcept {
	std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept {
	std::free(memory);
}

namespace {

using namespace steadyhand;

constexpr double RATE_HZ = 48000.0;
constexpr std::size_t BLOCK = 512;
constexpr double FRAME_S = 1.0 / 90.0;
constexpr double STROKE_S = 1.5;
constexpr long MINUTES = 60;
constexpr long BLOCKS_A_MINUTE = 60 * 48000 / static_cast<long>(BLOCK);
constexpr long COMPARED_MINUTES = 5;

/// A hand that drags in 0.75 s and returns in 0.75 s.
MotionSnapshot stroke_at(double now_s) {
	MotionSnapshot snapshot;
	snapshot.time_s = now_s;
	snapshot.period_s = 0.01;
	snapshot.count = 13;
	snapshot.amplitude_m = 0.2;
	for (std::size_t i = 0; i < snapshot.count; ++i) {
		const double phase = 2.0 * std::fmod(now_s + 0.01 * static_cast<double>(i), STROKE_S) / STROKE_S;
		const bool forward = phase < 1.0;
		const auto point = minimum_jerk(forward ? phase : 2.0 - phase);
		const double rate = 2.0 / STROKE_S;
		snapshot.knots[i] = { point.value, (forward ? 1.0 : -1.0) * rate * point.first,
			rate * rate * point.second, forward };
	}
	snapshot.fit();
	const double strokes = std::floor(now_s / STROKE_S + 0.5);
	if (strokes > 0.0) {
		snapshot.arrival = { static_cast<std::uint32_t>(strokes), (strokes - 0.5) * STROKE_S, 0.5 };
	}
	return snapshot;
}

/// Effects of a gesture on the left channel, and a spring of constant amplitude 0.5 on the right one.
EffectSet effects_of(long second) {
	constexpr const char *GESTURES[] = { "horizontal_drag", "tap", "zoom" };
	EffectSet effects;
	Effect held = spring_effect();
	held.drive = Drive::CONSTANT;
	held.trigger = Trigger::ALWAYS;
	held.gain = 0.5;
	held.channels = Effect::RIGHT;
	effects.add(held);
	const EffectSet own = effects_of_gesture(GESTURES[second % 3]);
	for (std::size_t i = 0; i < own.count; ++i) {
		Effect effect = own.effects[i];
		effect.channels = Effect::LEFT;
		effects.add(effect);
	}
	return effects;
}

/// Greatest error of a block's right channel against the sine that began at sample 0.
double held_error(const std::array<float, 2 * BLOCK> &block, long long first_sample) {
	double greatest = 0.0;
	for (std::size_t i = 0; i < BLOCK; ++i) {
		const long long sample = first_sample + static_cast<long long>(i);
		// 180 Hz at 48 kHz: three turns in 800 samples, without rounding.
		const double phase = 2.0 * std::numbers::pi * static_cast<double>(3 * sample % 800) / 800.0;
		greatest =
				std::max(greatest, std::abs(static_cast<double>(block[2 * i + 1]) - 0.5 * std::sin(phase)));
	}
	return greatest;
}

} // namespace

int main() {
	const auto link = std::make_shared<VibrationLink>();
	LiveVibration vibration(link, RATE_HZ, 2);
	std::array<float, 2 * BLOCK> block{};
	std::array<double, MINUTES> ns{};
	double next_frame_s = 0.0;
	long second = -1;
	long long samples = 0;
	const long allocated = allocations;
	for (long minute = 0; minute < MINUTES; ++minute) {
		ns[static_cast<std::size_t>(minute)] = bench::ns_of([&] {
			for (long i = 0; i < BLOCKS_A_MINUTE; ++i) {
				const double now_s = static_cast<double>(samples) / RATE_HZ;
				if (now_s >= next_frame_s) {
					link->motion.publish({ stroke_at(now_s), now_s });
					next_frame_s += FRAME_S;
				}
				if (static_cast<long>(now_s) != second) {
					second = static_cast<long>(now_s);
					link->effects.publish(effects_of(second));
				}
				vibration.render(block);
				samples += BLOCK;
			}
		}) / static_cast<double>(BLOCKS_A_MINUTE * static_cast<long>(BLOCK));
	}
	double first = 0.0, last = 0.0;
	for (std::size_t i = 0; i < COMPARED_MINUTES; ++i) {
		first += ns[i] / COMPARED_MINUTES;
		last += ns[MINUTES - 1 - i] / COMPARED_MINUTES;
	}
	std::printf("%lld samples of two channels, %ld minutes of play\n", samples, MINUTES);
	std::printf("  held spring      within %.1e of its sine in the last block\n",
			held_error(block, samples - static_cast<long long>(BLOCK)));
	// A week is a whole number of turns at 180 Hz.
	Oscillator week{ 0, phase_step(180.0, RATE_HZ) };
	week.advance(7ULL * 24 * 3600 * 48000);
	std::printf("  phase            off by %.1e rad after a week at 180 Hz\n",
			std::abs(static_cast<double>(static_cast<std::int64_t>(week.phase))) * 0x1p-64 * 2.0 *
					std::numbers::pi);
	std::printf("  allocations      %ld\n", allocations - allocated);
	std::printf("  ns per sample    %.3f in the first %ld minutes, %.3f in the last\n", first,
			COMPARED_MINUTES, last);
	return allocations == allocated ? 0 : 1;
}
