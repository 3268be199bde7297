// In every build the loops below become vector code, which to GCC is a choice of its own where comparisons
// are; what holds a sample to a range is one instruction to it only where no NaN and no sign of a zero
// counts.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math", "finite-math-only", "no-signed-zeros")
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

/// A table is made of so many samples at a time, which wait for none of each other.
constexpr std::size_t ROW = 8;

constexpr Run counted() {
	Run numbers{};
	for (std::size_t i = 0; i < RUN; ++i) {
		numbers[i] = static_cast<float>(i);
	}
	return numbers;
}

/// A load of these is cheaper than a conversion of each.
alignas(64) constexpr Run NUMBERS = counted();

float held(float sample) {
	const float low = sample > -1.0F ? sample : -1.0F;
	return low < 1.0F ? low : 1.0F;
}

} // namespace

void Carrier::set_step(std::uint64_t step) {
	oscillator_.step = step;
	const Phasor each = phasor_of(step), row = phasor_of(ROW * step);
	over_run_ = phasor_of(RUN * step);
	std::array<Phasor, ROW> ahead;
	for (std::size_t i = 1; i < ROW; ++i) {
		ahead[i] = ahead[i - 1].turned(each);
	}
	for (std::size_t from = 0; from < RUN; from += ROW) {
		for (std::size_t i = 0; i < ROW; ++i) {
			sines_[from + i] = static_cast<float>(ahead[i].sine);
			cosines_[from + i] = static_cast<float>(ahead[i].cosine);
			ahead[i] = ahead[i].turned(row);
		}
	}
}

void Carrier::set_phase(std::uint64_t phase) {
	oscillator_.phase = phase;
	start_ = phasor_of(phase);
	to_exact_ = EXACT_RUNS;
}

STEADYHAND_VECTOR void clear(Mix &mix) {
	mix.samples.fill(0.0F);
	mix.is_silent = true;
}

STEADYHAND_VECTOR void add_sine(Mix &out, const Carrier &carrier, const Level &level) {
	const auto sine = static_cast<float>(carrier.start().sine),
			   cosine = static_cast<float>(carrier.start().cosine);
	const Level shape = level;
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::size_t i = 0; i < RUN; ++i) {
		samples[i] += shape.at(NUMBERS[i]) * carrier.at(sine, cosine, i);
	}
}

STEADYHAND_VECTOR void add_decaying_sine(
		Mix &out, const Carrier &carrier, double scale, const Run &decay, std::int32_t first) {
	const auto sine = static_cast<float>(scale * carrier.start().sine);
	const auto cosine = static_cast<float>(scale * carrier.start().cosine);
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		const auto n = static_cast<std::size_t>(i);
		const float sample = decay[n] * carrier.at(sine, cosine, n);
		samples[n] += i < first ? 0.0F : sample;
	}
}

STEADYHAND_VECTOR void add_windowed_sine(
		Mix &out, const Carrier &carrier, const Level &level, const Window &window, std::int32_t at) {
	const auto sine = static_cast<float>(carrier.start().sine),
			   cosine = static_cast<float>(carrier.start().cosine);
	const Level shape = level;
	const Window swell = window;
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		const auto n = static_cast<std::size_t>(i);
		samples[n] +=
				shape.at(NUMBERS[n]) * swell.at(static_cast<float>(at + i)) * carrier.at(sine, cosine, n);
	}
}

STEADYHAND_VECTOR void add_windowed(Mix &out, const Run &values, const Window &window, std::int32_t at) {
	const Window swell = window;
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		const auto n = static_cast<std::size_t>(i);
		samples[n] += values[n] * swell.at(static_cast<float>(at + i));
	}
}

STEADYHAND_VECTOR void add(Mix &out, const Mix &other) {
	out.is_silent = out.is_silent && other.is_silent;
	float *__restrict const samples = out.samples.data();
	for (std::size_t i = 0; i < RUN; ++i) {
		samples[i] += other.samples[i];
	}
}

STEADYHAND_VECTOR void write_held(
		float *__restrict frames, const Mix &mono, std::size_t first, std::size_t count) {
	const float *const samples = mono.samples.data() + first;
	for (std::size_t i = 0; i < count; ++i) {
		frames[i] = held(samples[i]);
	}
}

STEADYHAND_VECTOR void write_held(
		float *__restrict frames, const Mix &left, const Mix &right, std::size_t first, std::size_t count) {
	const float *const lefts = left.samples.data() + first;
	const float *const rights = right.samples.data() + first;
	for (std::size_t i = 0; i < count; ++i) {
		frames[2 * i] = held(lefts[i]);
		frames[2 * i + 1] = held(rights[i]);
	}
}

} // namespace steadyhand
