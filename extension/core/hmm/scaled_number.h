#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace steadyhand {

/// 2^exponent. Returns 0 below the smallest normal number, and infinity above the largest.
[[nodiscard]] inline double power_of_two(std::int64_t exponent) {
	constexpr std::int64_t BIAS = 1023;
	if (exponent < 1 - BIAS) {
		return 0.0;
	}
	const std::int64_t biased = exponent > BIAS ? 2 * BIAS + 1 : exponent + BIAS;
	return std::bit_cast<double>(biased << 52);
}

/// A number >= 0, mantissa * 2^exponent. Holds probabilities of sequences of millions of symbols.
struct ScaledNumber {
	/// Exponent of 0: smaller than that of any other number.
	static constexpr std::int64_t NEVER = -(std::int64_t{ 1 } << 60);

	double mantissa = 0.0; ///< 1..2, or 0
	std::int64_t exponent = NEVER;

	ScaledNumber() = default;
	/// m * 2^e for a finite m >= 0. An m below the smallest normal number gives 0.
	ScaledNumber(double m, std::int64_t e) {
		constexpr std::uint64_t FRACTION = (std::uint64_t{ 1 } << 52) - 1, ONE = std::uint64_t{ 1023 } << 52;
		const auto bits = std::bit_cast<std::uint64_t>(m);
		const auto biased = static_cast<std::int64_t>(bits >> 52);
		if (biased > 0) {
			mantissa = std::bit_cast<double>((bits & FRACTION) | ONE);
			exponent = e + biased - 1023;
		}
	}

	[[nodiscard]] ScaledNumber operator*(double factor) const { return { mantissa * factor, exponent }; }
	[[nodiscard]] ScaledNumber operator+(const ScaledNumber &other) const {
		const std::int64_t difference = other.exponent - exponent;
		return difference > 0
				? ScaledNumber(mantissa * power_of_two(-difference) + other.mantissa, other.exponent)
				: ScaledNumber(mantissa + other.mantissa * power_of_two(difference), exponent);
	}
	[[nodiscard]] bool operator<(const ScaledNumber &other) const {
		return exponent != other.exponent ? exponent < other.exponent : mantissa < other.mantissa;
	}
	/// Natural logarithm; -infinity for 0.
	[[nodiscard]] double log() const {
		return mantissa > 0.0 ? std::log(mantissa) + std::numbers::ln2 * static_cast<double>(exponent)
							  : -INFINITY;
	}
};

} // namespace steadyhand
