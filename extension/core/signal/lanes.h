#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace steadyhand {

/// Numbers side by side, as they lie in memory.
inline constexpr std::size_t LANES = 4;
using Lanes = std::array<double, LANES>;

// How vectors pass from function to function differs between processors: all of these are inlined, into
// functions that may be compiled for one kind of processor.
#define STEADYHAND_INLINE __attribute__((always_inline)) inline
#define STEADYHAND_INLINE_LAMBDA __attribute__((always_inline))
// Compiled for processors with wider registers too, and chosen when loaded: the same operations, the same
// bits. (Sanitizers are not ready yet when that is chosen; clang-tidy may have read a use of it before.)
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) &&                           \
		!defined(__clang_analyzer__)
#define STEADYHAND_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define STEADYHAND_WIDE
#endif

/// The same in registers, with the operators of numbers.
using LaneVector = double __attribute__((vector_size(sizeof(Lanes))));
using LaneMask = decltype(LaneVector{} > LaneVector{}); ///< of all bits, or none
using LaneBits = std::uint64_t __attribute__((vector_size(sizeof(Lanes))));

STEADYHAND_INLINE LaneVector load(const Lanes &lanes) {
	LaneVector vector;
	std::memcpy(&vector, lanes.data(), sizeof vector);
	return vector;
}
STEADYHAND_INLINE void store(Lanes &r_lanes, const LaneVector &vector) {
	std::memcpy(r_lanes.data(), &vector, sizeof vector);
}
STEADYHAND_INLINE LaneVector all(double number) {
	return LaneVector{ number, number, number, number };
}
/// f(lane) of each
template <class Function> STEADYHAND_INLINE LaneVector each(const Function &f) {
	return LaneVector{ f(0), f(1), f(2), f(3) };
}
/// f(0) .. f(N - 1), the numbers known when compiled.
template <std::size_t N, class Function> STEADYHAND_INLINE void unrolled(const Function &f) {
	[&]<std::size_t... I>(std::index_sequence<I...>) STEADYHAND_INLINE_LAMBDA {
		(f(std::integral_constant<std::size_t, I>{}), ...);
	}
	(std::make_index_sequence<N>{});
}

/// numbers[index] of each lane's index, kept modulo LANES.
STEADYHAND_INLINE LaneVector pick(const Lanes &numbers, const std::array<std::uint8_t, LANES> &indices) {
#if __has_builtin(__builtin_shuffle)
	std::uint8_t bytes __attribute__((vector_size(LANES)));
	std::memcpy(&bytes, indices.data(), sizeof bytes);
	return __builtin_shuffle(load(numbers), __builtin_convertvector(bytes, LaneBits));
#else
	return each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA { return numbers[indices[l] % LANES]; });
#endif
}

STEADYHAND_INLINE bool any(const LaneMask &mask) {
	return ((mask[0] | mask[1]) | (mask[2] | mask[3])) != 0;
}
/// 0 .. 1; 0 for what is no number
STEADYHAND_INLINE LaneVector within_one(const LaneVector &x) {
	const LaneVector positive = x > 0.0 ? x : LaneVector{};
	return positive < 1.0 ? positive : all(1.0);
}

/// minimum_jerk(s), 0 <= s <= 1
struct LaneMinimumJerk {
	LaneVector value, first, second;

	STEADYHAND_INLINE explicit LaneMinimumJerk(const LaneVector &s) {
		const LaneVector left = 1.0 - s, rise = s * left;
		value = s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
		first = 30.0 * rise * rise;
		second = 60.0 * rise * (1.0 - 2.0 * s);
	}
};

STEADYHAND_INLINE LaneVector square_root(const LaneVector &x) {
	return each([&](std::size_t l) STEADYHAND_INLINE_LAMBDA { return __builtin_sqrt(x[l]); });
}

STEADYHAND_INLINE double sum(const LaneVector &x) {
	return (x[0] + x[1]) + (x[2] + x[3]);
}

/// exp(x) to 2 units in the last place; 0 from -708 down, and x must be below 709.
STEADYHAND_INLINE LaneVector exponential(const LaneVector &x) {
	// x = k ln 2 + r: k by adding a number whose last bit is one, ln 2 in two parts (Cody & Waite 1980).
	constexpr double ROUNDER = 0x1.8p52, LOG2_E = 0x1.71547652b82fep0;
	constexpr double LN2_HIGH = 0x1.62e42fefa0000p-1, LN2_LOW = 0x1.cf79abc9e3b3ap-40;
	const LaneVector held = x > -708.0 ? x : all(-708.0);
	const LaneVector rounded = held * LOG2_E + ROUNDER;
	const LaneVector k = rounded - ROUNDER;
	const LaneVector r = held - k * LN2_HIGH - k * LN2_LOW;
	// Taylor's series, |r| < 0.347, its terms in pairs (Estrin).
	const LaneVector r2 = r * r, r4 = r2 * r2;
	const LaneVector low = (1.0 + r) + r2 * (1.0 / 2.0 + r * (1.0 / 6.0));
	const LaneVector middle = (1.0 / 24.0 + r * (1.0 / 120.0)) + r2 * (1.0 / 720.0 + r * (1.0 / 5040.0));
	const LaneVector high = (1.0 / 40320.0 + r * (1.0 / 362880.0)) +
			r2 * (1.0 / 3628800.0 + r * (1.0 / 39916800.0)) + r4 * (1.0 / 479001600.0);
	const LaneVector mantissa = low + r4 * (middle + r4 * high);
	const LaneVector result = reinterpret_cast<LaneVector>(
			reinterpret_cast<LaneBits>(mantissa) + (reinterpret_cast<LaneBits>(rounded) << 52));
	return x > -708.0 ? result : LaneVector{};
}

/// log(x) to 2 units in the last place of the greater of it and 1; x must be a normal number above 0.
STEADYHAND_INLINE LaneVector logarithm(const LaneVector &x) {
	// x = 2^k m, m from sqrt(1/2) up; log m = 2 artanh((m - 1) / (m + 1)).
	constexpr std::uint64_t ROOT_HALF = 0x3fe6a09e667f3bcd, ONE = 0x3ff0000000000000;
	constexpr double LN2_HIGH = 0x1.62e42fefa0000p-1, LN2_LOW = 0x1.cf79abc9e3b3ap-40;
	const LaneBits offset = reinterpret_cast<LaneBits>(x) - ROOT_HALF + ONE;
	const LaneVector m = reinterpret_cast<LaneVector>((offset & 0x000fffffffffffff) + ROOT_HALF);
	// The exponent as a number: in the last bits of 2^52, from which that and its bias are taken.
	const LaneVector k =
			reinterpret_cast<LaneVector>((offset >> 52) | 0x4330000000000000) - (0x1p52 + 1023.0);
	const LaneVector s = (m - 1.0) / (m + 1.0), s2 = s * s, s4 = s2 * s2, s8 = s4 * s4;
	const LaneVector series = (1.0 / 3.0 + s2 * (1.0 / 5.0)) + s4 * (1.0 / 7.0 + s2 * (1.0 / 9.0)) +
			s8 *
					((1.0 / 11.0 + s2 * (1.0 / 13.0)) + s4 * (1.0 / 15.0 + s2 * (1.0 / 17.0)) +
							s8 * (1.0 / 19.0 + s2 * (1.0 / 21.0)));
	return k * LN2_HIGH + (2.0 * s + (2.0 * s * s2 * series + k * LN2_LOW));
}

} // namespace steadyhand
