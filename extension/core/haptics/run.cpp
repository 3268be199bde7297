// In every build the loops below become vector code, which to GCC is a choice of its own where comparisons
// are; what holds a sample to a range is one instruction to it only where no NaN and no sign of a zero
// counts.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math", "finite-math-only", "no-signed-zeros")
#endif

#include "haptics/run.h"

// Where the loader can choose (GNU/Linux on x86-64), copies for AVX2 and AVX-512 in twice and four times the
// width. Without FMA: it would round otherwise, and all copies must give the same samples. Not under
// ThreadSanitizer, which is not ready yet when the loader chooses.
#if !defined(__SANITIZE_THREAD__) && defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) &&   \
		!defined(__clang__)
#define STEADYHAND_VECTOR __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define STEADYHAND_VECTOR
#endif

namespace steadyhand {

namespace {

constexpr auto LENGTH = static_cast<std::int32_t>(RUN);

/// A table is made of so many samples at a time, which wait for none of each other.
constexpr std::size_t ROW = 8;

constexpr std::array<float, MOST_RUNS * RUN> counted() {
	std::array<float, MOST_RUNS * RUN> numbers{};
	for (std::size_t i = 0; i < numbers.size(); ++i) {
		numbers[i] = static_cast<float>(i);
	}
	return numbers;
}

/// Of a stretch's samples. A load of these is cheaper than a conversion of each.
alignas(64) constexpr std::array<float, MOST_RUNS *RUN> NUMBERS = counted();

float held(float sample, float most = 1.0F) {
	const float low = sample > -most ? sample : -most;
	return low < most ? low : most;
}

} // namespace

void Carrier::set_step(std::uint64_t step) {
	oscillator_.step = step;
	const Phasor each = phasor_of(step), row = phasor_of(ROW * step), run = phasor_of(RUN * step);
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
	for (std::size_t runs = 1; runs <= MOST_RUNS; ++runs) {
		over_runs_[runs] = over_runs_[runs - 1].turned(run);
	}
}

void Carrier::set_phase(std::uint64_t phase) {
	oscillator_.phase = phase;
	start_ = phasor_of(phase);
	to_exact_ = EXACT_TURNS;
}

void Carrier::advance(std::uint64_t runs) {
	if (runs > MOST_RUNS || (runs > 0 && --to_exact_ == 0)) {
		set_phase(oscillator_.phase + oscillator_.step * RUN * runs);
	} else if (runs > 0) {
		oscillator_.advance(RUN * runs);
		start_ = start_.turned(over_runs_[runs]);
	}
}

STEADYHAND_VECTOR void clear(Mix &mix) {
	mix.samples.fill(0.0F);
	mix.is_silent = true;
	mix.level = 0.0F;
}

// A loop for each number of channels: one template for both is not made vector code in the copies of a
// function that calls it, and takes many times as long.
STEADYHAND_VECTOR void write_mono(float *__restrict frames, const Carrier &carrier, const Level &level,
		std::size_t first, std::size_t runs) {
	const Level shape = level;
	for (std::size_t run = 0; run < runs; ++run) {
		const float *const numbers = &NUMBERS[(first + run) * RUN];
		const Carrier::Start start = carrier.start(first + run);
		for (std::size_t i = 0; i < RUN; ++i) {
			frames[i] = held(shape.at(numbers[i]) * carrier.at(start, i));
		}
		frames += RUN;
	}
}

STEADYHAND_VECTOR void write_stereo(float *__restrict frames, const Carrier &carrier, const Level &level,
		std::size_t first, std::size_t runs) {
	const Level shape = level;
	for (std::size_t run = 0; run < runs; ++run) {
		const float *const numbers = &NUMBERS[(first + run) * RUN];
		const Carrier::Start start = carrier.start(first + run);
		for (std::size_t i = 0; i < RUN; ++i) {
			const float sample = held(shape.at(numbers[i]) * carrier.at(start, i));
			frames[2 * i] = sample;
			frames[2 * i + 1] = sample;
		}
		frames += 2 * RUN;
	}
}

void write_sine(float *frames, std::size_t channels, const Carrier &carrier, const Level &level,
		std::size_t first, std::size_t runs) {
	(channels == 1 ? write_mono : write_stereo)(frames, carrier, level, first, runs);
}

STEADYHAND_VECTOR void add_sine(Mix &out, const Carrier &carrier, const Level &level, std::size_t run) {
	const Carrier::Start start = carrier.start(run);
	const Level shape = level;
	const float *const numbers = &NUMBERS[run * RUN];
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::size_t i = 0; i < RUN; ++i) {
		samples[i] += shape.at(numbers[i]) * carrier.at(start, i);
	}
}

STEADYHAND_VECTOR void add_decaying_sine(Mix &out, const Carrier &carrier, double scale, const Run &decay,
		std::int32_t from, std::size_t run) {
	const auto factor = static_cast<float>(scale);
	const Carrier::Start full = carrier.start(run), start{ factor * full.sine, factor * full.cosine };
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		const auto n = static_cast<std::size_t>(i);
		const float sample = decay[n] * carrier.at(start, n);
		samples[n] += i < from ? 0.0F : sample;
	}
}

STEADYHAND_VECTOR void add_windowed_sine(Mix &out, const Carrier &carrier, const Level &level,
		const Window &window, std::int32_t at, std::size_t run) {
	const Carrier::Start start = carrier.start(run);
	const Level shape = level;
	const Window swell = window;
	const float *const numbers = &NUMBERS[run * RUN];
	out.is_silent = false;
	float *__restrict const samples = out.samples.data();
	for (std::int32_t i = 0; i < LENGTH; ++i) {
		const auto n = static_cast<std::size_t>(i);
		samples[n] += shape.at(numbers[n]) * swell.at(static_cast<float>(at + i)) * carrier.at(start, n);
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
	out.level += other.level;
	float *__restrict const samples = out.samples.data();
	for (std::size_t i = 0; i < RUN; ++i) {
		samples[i] += other.samples[i];
	}
}

STEADYHAND_VECTOR void write_held(float *__restrict frames, const Mix &mono, const Ramp &gain, float most) {
	const float *const samples = mono.samples.data();
	const float each = (gain.to - gain.from) / static_cast<float>(RUN), from = gain.from;
	for (std::size_t i = 0; i < RUN; ++i) {
		frames[i] = held(samples[i] * (from + each * NUMBERS[i]), most);
	}
}

STEADYHAND_VECTOR void write_held(float *__restrict frames, const Mix &left, const Ramp &left_gain,
		const Mix &right, const Ramp &right_gain, float most) {
	const float *const lefts = left.samples.data();
	const float *const rights = right.samples.data();
	const float each_left = (left_gain.to - left_gain.from) / static_cast<float>(RUN);
	const float each_right = (right_gain.to - right_gain.from) / static_cast<float>(RUN);
	const float from_left = left_gain.from, from_right = right_gain.from;
	for (std::size_t i = 0; i < RUN; ++i) {
		frames[2 * i] = held(lefts[i] * (from_left + each_left * NUMBERS[i]), most);
		frames[2 * i + 1] = held(rights[i] * (from_right + each_right * NUMBERS[i]), most);
	}
}

} // namespace steadyhand
