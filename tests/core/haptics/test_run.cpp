#include "haptics/run.h"
#include "near.h"
#include "vibration_rig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

using namespace steadyhand;
using steadyhand::test::TURN;

namespace {

/// One at a time, where the compiler sees no row of them.
[[gnu::noinline]] float one_sample(
		const Level &level, const Carrier &carrier, std::size_t i, std::size_t run = 0) {
	return level.at(static_cast<float>(run * RUN + i)) * carrier.at(carrier.start(run), i);
}

[[gnu::noinline]] float one_windowed(
		const Level &level, const Window &window, const Carrier &carrier, std::size_t i, std::int32_t at) {
	const auto number = static_cast<float>(at + static_cast<std::int32_t>(i));
	return level.at(static_cast<float>(i)) * window.at(number) * carrier.at(carrier.start(0), i);
}

[[gnu::noinline]] float one_decaying(const Carrier &carrier, double scale, float decay, std::size_t i) {
	const auto factor = static_cast<float>(scale);
	const Carrier::Start full = carrier.start(0);
	return decay * carrier.at({ factor * full.sine, factor * full.cosine }, i);
}

} // namespace

TEST_CASE("a carrier is the sine of its 64-bit phase at every sample, over thousands of runs") {
	std::uint64_t random = 1;
	double largest = 0.0, greatest = 0.0;
	for (int round = 0; round < 200; ++round) {
		random = random * 6364136223846793005ULL + 1442695040888963407ULL;
		const std::uint64_t step = random >> (1 + round % 12);
		std::uint64_t phase = random * 2862933555777941757ULL;
		Carrier carrier;
		carrier.set_step(step);
		carrier.set_phase(phase);
		const Level full = Level::hermite(1.0, 0.0, 1.0, 0.0);
		for (int run = 0; run < 200; ++run) {
			Mix mix;
			add_sine(mix, carrier, full);
			for (std::size_t i = 0; i < RUN; ++i) {
				const auto turns = static_cast<long double>(static_cast<std::int64_t>(phase + step * i));
				const long double truth = std::sin(TURN * turns * 0x1p-64L);
				const auto made = static_cast<long double>(mix.samples[i]);
				largest = std::max(largest, static_cast<double>(std::abs(made - truth)));
				greatest = std::max(greatest, std::abs(static_cast<double>(mix.samples[i])));
			}
			const std::uint64_t runs = run % 50 == 49 ? 3 : 1;
			carrier.advance(runs);
			phase += step * RUN * runs;
			REQUIRE(carrier.phase() == phase);
		}
	}
	CHECK(largest < 2e-7);
	CHECK(greatest > 0.99);
}

TEST_CASE("a level has the values and slopes of its ends, and is exact for cubics") {
	const Level level = Level::hermite(0.25, 0.5, -0.5, 2.0);
	CHECK(level.at(0.0F) == test::near(0.25));
	CHECK(level.at(RUN) == test::near(-0.5));
	const auto cubic = [](double s) { return 0.1 + s * (0.2 + s * (-0.7 + 0.9 * s)); };
	const Level same = Level::hermite(cubic(0.0), 0.2, cubic(1.0), 0.2 - 1.4 + 2.7);
	for (int i = 0; i < 64; ++i) {
		REQUIRE(static_cast<double>(same.at(static_cast<float>(i))) ==
				test::near(cubic(i / 64.0)).epsilon(1e-6));
	}
}

TEST_CASE("vector code makes the samples that are made one at a time, to the last bit") {
	std::uint64_t random = 1;
	for (int round = 0; round < 500; ++round) {
		random = random * 6364136223846793005ULL + 1442695040888963407ULL;
		Carrier carrier;
		carrier.set_step(random >> (round % 12));
		carrier.set_phase(random);
		const auto part = [&](unsigned shift) {
			return static_cast<double>((random >> shift) & 0xFFFU) / 4096.0;
		};
		const Level level = Level::hermite(part(0), part(12) - 0.5, part(24), part(36) - 0.5);
		const Window window{ 1.0F + static_cast<float>(part(48)) * 100.0F, 300.0F };
		const std::int32_t at = round - 70;
		Mix plain, windowed, decaying, twice;
		Run decay;
		decay.fill(0.7F);
		add_sine(plain, carrier, level);
		add_windowed_sine(windowed, carrier, level, window, at);
		add_decaying_sine(decaying, carrier, 0.3, decay, round % 64);
		add(twice, plain);
		add_sine(twice, carrier, level);
		const auto from = static_cast<std::size_t>(round % 64);
		Run held{};
		std::array<float, 2 * RUN> pairs{};
		write_held(held.data(), twice, {}, 0.75F);
		write_held(pairs.data(), twice, {}, plain, {}, 0.75F);
		for (std::size_t n = 0; n < RUN; ++n) {
			const float one = one_sample(level, carrier, n);
			REQUIRE(plain.samples[n] == one);
			REQUIRE(windowed.samples[n] == one_windowed(level, window, carrier, n, at));
			REQUIRE(decaying.samples[n] == (n < from ? 0.0F : one_decaying(carrier, 0.3, 0.7F, n)));
			REQUIRE(twice.samples[n] == one + one);
		}
		for (std::size_t n = 0; n < RUN; ++n) {
			REQUIRE(held[n] == std::clamp(twice.samples[n], -0.75F, 0.75F));
			REQUIRE(pairs[2 * n] == held[n]);
			REQUIRE(pairs[2 * n + 1] == std::clamp(plain.samples[n], -0.75F, 0.75F));
		}
	}
}

TEST_CASE("a stretch is the samples that are made one at a time, to the last bit, in whatever parts it is "
		  "made") {
	Carrier carrier;
	carrier.set_step(phase_step(180.0, 48000.0));
	carrier.set_phase(0x123456789ABCDEF0U);
	const Level level = Level::hermite(0.9, 2.0, 0.2, -3.0, MOST_RUNS);
	for (std::size_t first = 0; first < MOST_RUNS; ++first) {
		for (std::size_t runs = 1; first + runs <= MOST_RUNS; ++runs) {
			std::array<float, MOST_RUNS * RUN> mono{};
			std::array<float, 2 * MOST_RUNS * RUN> stereo{};
			write_sine(mono.data(), 1, carrier, level, first, runs);
			write_sine(stereo.data(), 2, carrier, level, first, runs);
			for (std::size_t n = 0; n < runs * RUN; ++n) {
				const float one = one_sample(level, carrier, n % RUN, first + n / RUN);
				REQUIRE(mono[n] == std::clamp(one, -1.0F, 1.0F));
				REQUIRE(stereo[2 * n] == mono[n]);
				REQUIRE(stereo[2 * n + 1] == mono[n]);
			}
		}
	}
	CHECK(level.at(MOST_RUNS * RUN) == test::near(0.2).epsilon(1e-5));
}

TEST_CASE("a window is nothing outside, everything within, and has no corner at its ends") {
	const Window window{ 16.0F, 100.0F };
	for (const float outside : { -1e6F, -1.0F, 0.0F, 100.0F, 101.0F, 1e6F }) {
		CHECK(window.at(outside) == 0.0F);
	}
	for (int i = 16; i <= 84; ++i) {
		CHECK(window.at(static_cast<float>(i)) == 1.0F);
	}
	CHECK(window.at(8.0F) == 0.5F);
	CHECK(window.at(92.0F) == 0.5F);
	CHECK(window.at(0.01F) < 2e-6F);
	CHECK(window.is_full(16.0F, 84.0F));
	CHECK_FALSE(window.is_full(15.0F, 80.0F));
	CHECK_FALSE(window.is_full(20.0F, 85.0F));
}

TEST_CASE("the phase is off by less than 1e-6 rad after a week") {
	// Whole frequencies and rates: the true phase is the fraction n f mod rate / rate, in integers.
	for (const std::uint64_t rate_hz : { 8000U, 11025U, 22050U, 44100U, 48000U, 96000U, 192000U }) {
		for (const std::uint64_t frequency_hz : { 1U, 60U, 180U, 181U, 300U, 3989U }) {
			CAPTURE(rate_hz);
			CAPTURE(frequency_hz);
			Oscillator oscillator;
			oscillator.step = phase_step(static_cast<double>(frequency_hz), static_cast<double>(rate_hz));
			const std::uint64_t samples = 7ULL * 24 * 3600 * rate_hz + 12345;
			oscillator.advance(samples);
			const std::uint64_t remainder = samples % rate_hz * frequency_hz % rate_hz;
			const long double truth =
					std::ldexp(static_cast<long double>(remainder) / static_cast<long double>(rate_hz), 64);
			// As a signed number: the difference, within half a turn of 0.
			const auto error =
					static_cast<std::int64_t>(oscillator.phase - static_cast<std::uint64_t>(truth));
			CHECK(std::abs(std::ldexp(static_cast<long double>(error), -64) * TURN) < 1e-7L);
		}
	}
}

TEST_CASE("a frequency that is none makes no step, one too high half a turn") {
	for (const double bad : { std::numeric_limits<double>::quiet_NaN(), -1.0, 0.0, -HUGE_VAL }) {
		CHECK(phase_step(bad, 48000.0) == 0);
		CHECK(phase_step(180.0, bad) == 0);
	}
	CHECK(phase_step(180.0, HUGE_VAL) == 0);
	for (const double frequency_hz : { 1e300, HUGE_VAL, 24000.0 }) {
		CHECK(phase_step(frequency_hz, 48000.0) == 1ULL << 63U);
	}
	CHECK(phase_step(23999.999999999, 48000.0) <= 1ULL << 63U);
}
