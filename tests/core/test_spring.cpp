#include "haptics/spring.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

using steadyhand::SpringWaveform;

namespace {

constexpr long double TURN = 2.0L * std::numbers::pi_v<long double>;
constexpr double SAMPLE_RATES_HZ[] = { 8000.0, 11025.0, 44100.0, 48000.0, 96000.0, 192000.0 };
/// Sine polynomial, 24-bit rounding of phase and products, together.
constexpr double SINE_ERROR = 4e-7;

/// A waveform at full amplitude, its ramp behind it and its phase wherever the ramp left it.
SpringWaveform at_full_amplitude(double sample_rate_hz, double frequency_hz) {
	SpringWaveform spring(sample_rate_hz, frequency_hz);
	std::vector<float> ramp(100);
	spring.render(ramp, 1.0);
	return spring;
}

/// Amplitude of the samples' component at a frequency, by its definition.
double amplitude_at(std::span<const float> samples, double frequency_hz, double sample_rate_hz) {
	long double real = 0.0L;
	long double imaginary = 0.0L;
	for (std::size_t i = 0; i < samples.size(); ++i) {
		const long double angle = TURN * frequency_hz * static_cast<long double>(i) / sample_rate_hz;
		real += samples[i] * std::cos(angle);
		imaginary += samples[i] * std::sin(angle);
	}
	return static_cast<double>(2.0L * std::hypot(real, imaginary) / static_cast<long double>(samples.size()));
}

} // namespace

TEST_CASE("the spring is M sin(2 pi f t) at every sample rate") {
	for (const double rate_hz : SAMPLE_RATES_HZ) {
		for (const double frequency_hz : { 1.0, 180.0, 433.7, 3999.0 }) {
			CAPTURE(rate_hz);
			CAPTURE(frequency_hz);
			SpringWaveform spring = at_full_amplitude(rate_hz, frequency_hz);
			std::vector<float> block(5003);
			spring.render(block, 1.0);
			double largest = 0.0;
			for (std::size_t i = 0; i < block.size(); ++i) {
				const long double t_s = static_cast<long double>(i + 100) / rate_hz;
				largest = std::max(largest,
						static_cast<double>(std::abs(block[i] - std::sin(TURN * frequency_hz * t_s))));
			}
			CHECK(largest < SINE_ERROR);
		}
	}
}

TEST_CASE("the amplitude goes in a straight line from block to block") {
	const double rate_hz = 48000.0;
	SpringWaveform spring(rate_hz);
	const double targets[] = { 1.0, 0.25, 0.25, -0.5, 0.0 };
	const std::size_t lengths[] = { 480, 1, 63, 64, 1000 };
	double from = 0.0;
	std::size_t before = 0;
	for (std::size_t b = 0; b < 5; ++b) {
		std::vector<float> block(lengths[b]);
		spring.render(block, targets[b]);
		for (std::size_t i = 0; i < block.size(); ++i) {
			const double share = static_cast<double>(i) / static_cast<double>(block.size());
			const double amplitude = from + (targets[b] - from) * share;
			const double sine = static_cast<double>(
					std::sin(TURN * 180.0L * static_cast<long double>(before + i) / 48000.0L));
			REQUIRE(std::abs(block[i] - amplitude * sine) < SINE_ERROR);
		}
		from = targets[b];
		before += block.size();
		CHECK(spring.amplitude() == targets[b]);
	}
}

TEST_CASE("cutting a render into other blocks changes no more than rounding") {
	SpringWaveform whole = at_full_amplitude(48000.0, 180.0);
	SpringWaveform parts = at_full_amplitude(48000.0, 180.0);
	std::vector<float> expected(4096);
	whole.render(expected, 1.0);
	std::vector<float> out(4096);
	std::size_t done = 0;
	for (std::size_t length = 1; done < out.size(); ++length) {
		const std::size_t left = std::min(length, out.size() - done);
		parts.render(std::span(out).subspan(done, left), 1.0);
		done += left;
	}
	CHECK(parts.phase() == whole.phase());
	for (std::size_t i = 0; i < out.size(); ++i) {
		REQUIRE(std::abs(out[i] - expected[i]) < SINE_ERROR);
	}
}

TEST_CASE("no step is above what the waveform makes, whatever changes") {
	for (const double rate_hz : SAMPLE_RATES_HZ) {
		SpringWaveform spring(rate_hz);
		std::uint32_t random = 1;
		float last = 0.0F;
		double bound = 0.0; // of the step from the last sample to the next: at first, silence to sin(0)
		for (int change = 0; change < 2000; ++change) {
			random = random * 1664525U + 1013904223U;
			const double frequency_hz = 20.0 + static_cast<double>(random % 400U);
			const std::size_t length = 32 + (random >> 16U) % 500U;
			const double amplitude = (random >> 8U) % 2U == 0 ? 1.0 : -0.2;
			const double before = spring.amplitude();
			std::vector<float> block(length);
			spring.set_frequency(frequency_hz);
			spring.render(block, amplitude);
			REQUIRE(std::abs(block[0] - last) <= bound);
			// |d(M sin)| <= |M| 2 sin(pi f / rate) + |dM|
			bound = std::max(std::abs(amplitude), std::abs(before)) * 2.0 *
							std::sin(std::numbers::pi * frequency_hz / rate_hz) +
					std::abs(amplitude - before) / static_cast<double>(length) + 2.0 * SINE_ERROR;
			for (std::size_t i = 1; i < length; ++i) {
				REQUIRE(std::abs(block[i] - block[i - 1]) <= bound);
			}
			last = block.back();
		}
	}
}

TEST_CASE("a change of frequency or sample rate leaves the phase where it is") {
	SpringWaveform spring = at_full_amplitude(48000.0, 180.0);
	const std::uint64_t phase = spring.phase();
	spring.set_frequency(300.0);
	spring.set_sample_rate(44100.0);
	CHECK(spring.phase() == phase);
	std::vector<float> block(441);
	spring.render(block, 1.0);
	for (std::size_t i = 0; i < block.size(); ++i) {
		const long double turns =
				100.0L * 180.0L / 48000.0L + 300.0L * static_cast<long double>(i) / 44100.0L;
		REQUIRE(std::abs(block[i] - std::sin(TURN * turns)) < SINE_ERROR);
	}
}

TEST_CASE("the phase is off by less than 1e-6 rad after a week") {
	// Whole frequencies and rates: the true phase is the fraction n f mod rate / rate, in integers.
	for (const std::uint64_t rate_hz : { 8000U, 11025U, 22050U, 44100U, 48000U, 96000U, 192000U }) {
		for (const std::uint64_t frequency_hz : { 1U, 60U, 180U, 181U, 300U, 3989U }) {
			CAPTURE(rate_hz);
			CAPTURE(frequency_hz);
			const SpringWaveform spring(static_cast<double>(rate_hz), static_cast<double>(frequency_hz));
			const std::uint64_t samples = 7ULL * 24 * 3600 * rate_hz + 12345;
			const std::uint64_t reached = spring.phase_step() * samples; // modulo one turn
			const std::uint64_t remainder = samples % rate_hz * frequency_hz % rate_hz;
			const long double truth =
					std::ldexp(static_cast<long double>(remainder) / static_cast<long double>(rate_hz), 64);
			// As a signed number: the difference, within half a turn of 0.
			const auto error = static_cast<std::int64_t>(reached - static_cast<std::uint64_t>(truth));
			CHECK(std::abs(std::ldexp(static_cast<long double>(error), -64) * TURN) < 1e-7L);
		}
	}
}

TEST_CASE("rendering moves the phase by exactly one step a sample") {
	SpringWaveform spring(44100.0);
	std::uint64_t samples = 0;
	for (std::size_t length = 0; length < 300; ++length) {
		std::vector<float> block(length);
		spring.render(block, 0.5);
		samples += length;
		REQUIRE(spring.phase() == spring.phase_step() * samples);
	}
}

TEST_CASE("the spectrum has its peak at the set frequency and nothing else above -120 dB") {
	const double rate_hz = 48000.0;
	SpringWaveform spring = at_full_amplitude(rate_hz, 180.0);
	std::vector<float> second(48000);
	spring.render(second, 1.0);
	CHECK(amplitude_at(second, 180.0, rate_hz) == doctest::Approx(1.0).epsilon(1e-7));
	for (const double other_hz : { 179.0, 181.0, 360.0, 540.0, 720.0, 900.0, 1260.0, 5000.0, 23000.0 }) {
		CAPTURE(other_hz);
		CHECK(amplitude_at(second, other_hz, rate_hz) < 1e-6);
	}
}

TEST_CASE("the spring ignores settings that are no frequencies and amplitudes that are no numbers") {
	const double infinity = std::numeric_limits<double>::infinity();
	const double bad = std::numeric_limits<double>::quiet_NaN();
	SpringWaveform spring(bad, -1.0);
	CHECK(spring.sample_rate_hz() == 48000.0);
	CHECK(spring.frequency_hz() == 180.0);
	for (const double number : { bad, infinity, -infinity, 0.0, -5.0 }) {
		spring.set_frequency(number);
		spring.set_sample_rate(number);
	}
	CHECK(spring.sample_rate_hz() == 48000.0);
	CHECK(spring.frequency_hz() == 180.0);
	std::vector<float> block(500);
	for (const double amplitude : { 0.5, bad, infinity, -infinity, 1e300 }) {
		spring.render(block, amplitude);
		for (const float sample : block) {
			REQUIRE(std::abs(sample) <= 1.0F);
		}
	}
	CHECK(spring.amplitude() == 1.0);
	spring.render({}, -1.0);
	CHECK(spring.amplitude() == 1.0);
	// Above half the sample rate it stays there, and one below by less than a unit in the last place is no
	// trouble.
	for (const double frequency_hz : { 1e300, 24000.0, 23999.999999999, 1e-300 }) {
		spring.set_frequency(frequency_hz);
		CHECK(spring.phase_step() <= 1ULL << 63U);
		spring.render(block, 1.0);
	}
}
