// In every build the loops below become vector code, which to GCC is a choice of its own where comparisons
// are.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math")
#endif

#include "haptics/run.h"

// Where the loader can choose (GNU/Linux on x86-64), a second copy for AVX2 in twice the width. Not for FMA:
// it would round otherwise, and both copies must give the same samples. Not under ThreadSanitizer, which is
// not ready yet when the loader chooses.
#if !defined(__SANITIZE_THREAD__) && defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) &&   \
		!defined(__clang__)
#define STEADYHAND_VECTOR __attribute__((target_clones("avx2", "default")))
#else
#define STEADYHAND_VECTOR
#endif

namespace steadyhand {

namespace {

constexpr auto LENGTH = static_cast<std::int32_t>(RUN);

/// The phase's upper half, rounded for the step, which is counted up.
std::uint32_t upper(std::uint64_t phase) {
	return static_cast<std::uint32_t>(phase >> 32U);
}

std::uint32_t upper_of_step(std::uint64_t step) {
	return static_cast<std::uint32_t>((step + (1ULL << 31U)) >> 32U);
}

} // namespace

STEADYHAND_VECTOR void add_sine(Run &out, const Oscillator &oscillator, const Level &level) {
	std::uint32_t phase = upper(oscillator.phase);
	const std::uint32_t step = upper_of_step(oscillator.step);
	const Level held = level;
	float *__restrict const samples = out.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		samples[i] += held.at(static_cast<float>(i)) * sine(phase);
		phase += step;
	}
}

STEADYHAND_VECTOR void add_decaying_sine(
		Run &out, const Oscillator &oscillator, float scale, const Run &decay, std::int32_t first) {
	std::uint32_t phase = upper(oscillator.phase);
	const std::uint32_t step = upper_of_step(oscillator.step);
	float *__restrict const samples = out.data();
	const float *__restrict const envelope = decay.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		const float sample = scale * envelope[i] * sine(phase);
		samples[i] += i < first ? 0.0F : sample;
		phase += step;
	}
}

STEADYHAND_VECTOR void add_windowed_sine(
		Run &out, const Oscillator &oscillator, const Level &level, const Window &window, std::int32_t at) {
	std::uint32_t phase = upper(oscillator.phase);
	const std::uint32_t step = upper_of_step(oscillator.step);
	const Level held = level;
	const Window shape = window;
	float *__restrict const samples = out.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		samples[i] += held.at(static_cast<float>(i)) * shape.at(static_cast<float>(at + i)) * sine(phase);
		phase += step;
	}
}

STEADYHAND_VECTOR void add_windowed(Run &out, const Run &values, const Window &window, std::int32_t at) {
	const Window shape = window;
	float *__restrict const samples = out.data();
	const float *__restrict const added = values.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		samples[i] += added[i] * shape.at(static_cast<float>(at + i));
	}
}

STEADYHAND_VECTOR void hold(Run &out) {
	for (float &sample : out) {
		const float low = sample > -1.0F ? sample : -1.0F;
		sample = low < 1.0F ? low : 1.0F;
	}
}

STEADYHAND_VECTOR void add_held(Run &out, const Run &other) {
	for (std::size_t i = 0; i < RUN; ++i) {
		out[i] += other[i];
	}
	hold(out);
}

} // namespace steadyhand
