#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace steadyhand {

/// Output function of SplitMix64 (Steele, Lea, Flood 2014, doi 10.1145/2660193.2660195): a bijection that
/// maps neighbours to unrelated numbers.
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t bits) {
	bits += 0x9E3779B97F4A7C15U;
	bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
	bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
	return bits ^ (bits >> 31);
}

/// Seed of the stream `stream` of `seed`: streams of one seed, and equal streams of different seeds, are
/// unrelated.
[[nodiscard]] constexpr std::uint64_t stream_seed(std::uint64_t seed, std::uint64_t stream) {
	return mix_bits(mix_bits(seed) ^ stream);
}

/// Random numbers that are equal on every platform for equal seeds. The C++ standard defines std::mt19937_64
/// but not the algorithms of its distributions; so these are implemented here. The last bit of normal() and
/// waiting_time() depends on the platform's log.
class Random {
public:
	explicit Random(std::uint64_t seed) : engine_(mix_bits(seed)) {}

	[[nodiscard]] std::uint64_t bits() { return engine_(); }

	/// A multiple of 2^-53 in [0, 1).
	[[nodiscard]] double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
	[[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
	[[nodiscard]] bool chance(double probability) { return uniform() < probability; }
	/// 0 .. count - 1; count must not be 0. The bias of the modulo is below count / 2^64.
	[[nodiscard]] std::size_t index(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

	/// Standard normal, by Marsaglia's polar method. Its second number is not used, so that there is no
	/// state.
	[[nodiscard]] double normal() {
		for (;;) {
			const double x = uniform(-1.0, 1.0);
			const double y = uniform(-1.0, 1.0);
			const double square = x * x + y * y;
			if (square > 0.0 && square < 1.0) {
				return x * std::sqrt(-2.0 * std::log(square) / square);
			}
		}
	}
	[[nodiscard]] double normal(double mean, double deviation) { return mean + deviation * normal(); }

	/// Waiting time to the next event of a Poisson process; infinite for a rate of 0.
	[[nodiscard]] double waiting_time(double rate) { return -std::log1p(-uniform()) / rate; }

private:
	std::mt19937_64 engine_;
};

} // namespace steadyhand
