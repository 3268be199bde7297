#include "haptics/spring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace steadyhand {

namespace {

/// The compiler turns a loop of this fixed length into vector code on its own. Within it the phase runs in 32
/// bits, which after 64 steps is off by 2^-26 turns at most; each run starts from the 64-bit phase again.
constexpr std::size_t RUN = 64;

/// sin(pi x) for x in -1..1 as x (1 - x) (1 + x) Q(x^2), Q of degree 5 for the least largest error (1.3e-9,
/// found by reweighted least squares). The roots at -1, 0 and 1 are exact, and no case needs a branch.
inline float sine_of_half_turns(float x) {
	const float z = x * x;
	float q = -3.8981590e-4F;
	q = q * z + 6.8679219e-3F;
	q = q * z - 7.5192224e-2F;
	q = q * z + 5.2403718e-1F;
	q = q * z - 2.0261195F;
	q = q * z + 3.1415926F;
	return x * (1.0F - x) * (1.0F + x) * q;
}

// Where the loader can choose (GNU/Linux on x86-64), a second copy for AVX2 in twice the width. Not for FMA:
// it would round otherwise, and both copies must give the same samples.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("avx2", "default")))
#endif
void render_run(float *out, std::uint32_t phase, std::uint32_t step, float amplitude, float slope) {
	for (std::int32_t i = 0; i < static_cast<std::int32_t>(RUN); ++i) {
		// As a signed number the phase lies within half a turn of 0.
		const auto half_turns = static_cast<float>(static_cast<std::int32_t>(phase)) * 0x1p-31F;
		out[i] = (amplitude + slope * static_cast<float>(i)) * sine_of_half_turns(half_turns);
		phase += step;
	}
}

bool is_positive(double number) {
	return number > 0.0 && std::isfinite(number);
}

} // namespace

SpringWaveform::SpringWaveform(double sample_rate_hz, double frequency_hz) {
	update_phase_step();
	set_sample_rate(sample_rate_hz);
	set_frequency(frequency_hz);
}

void SpringWaveform::set_sample_rate(double sample_rate_hz) {
	if (is_positive(sample_rate_hz)) {
		sample_rate_hz_ = sample_rate_hz;
		update_phase_step();
	}
}

void SpringWaveform::set_frequency(double frequency_hz) {
	if (is_positive(frequency_hz)) {
		frequency_hz_ = frequency_hz;
		update_phase_step();
	}
}

void SpringWaveform::update_phase_step() {
	// The quotient and what its rounding lost, so that the step is exact to its last bit: half a unit of
	// 2^-64 turns a sample is 1e-8 rad in a week at 192 kHz, the rounding of a double alone would be 1e-7.
	const double frequency_hz = std::min(frequency_hz_, 0.5 * sample_rate_hz_);
	const double turns = frequency_hz / sample_rate_hz_;
	const double lost_turns = std::fma(-turns, sample_rate_hz_, frequency_hz) / sample_rate_hz_;
	const double units = std::ldexp(turns, 64);
	const double whole = std::floor(units);
	const double rest = (units - whole) + std::ldexp(lost_turns, 64);
	phase_step_ = static_cast<std::uint64_t>(whole) + static_cast<std::uint64_t>(std::llround(rest));
}

void SpringWaveform::render(std::span<float> out, double amplitude) {
	if (out.empty()) {
		return;
	}
	const double target = std::isnan(amplitude) ? amplitude_ : std::clamp(amplitude, -1.0, 1.0);
	const double slope = (target - amplitude_) / static_cast<double>(out.size());
	const auto step = static_cast<std::uint32_t>((phase_step_ + (1ULL << 31U)) >> 32U);
	for (std::size_t done = 0; done < out.size(); done += RUN) {
		const auto from = static_cast<float>(amplitude_ + slope * static_cast<double>(done));
		const auto phase = static_cast<std::uint32_t>(phase_ >> 32U);
		const std::size_t left = std::min(RUN, out.size() - done);
		if (left == RUN) {
			render_run(&out[done], phase, step, from, static_cast<float>(slope));
		} else {
			std::array<float, RUN> last_run;
			render_run(last_run.data(), phase, step, from, static_cast<float>(slope));
			std::copy_n(last_run.begin(), left, out.begin() + static_cast<std::ptrdiff_t>(done));
		}
		phase_ += phase_step_ * left;
	}
	amplitude_ = target;
}

} // namespace steadyhand
