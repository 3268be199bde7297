#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace steadyhand {

/// A polynomial of degree at most 7 on [0, 1]: sum over k of coefficients[k] s^k. Unused coefficients are 0.
struct Polynomial {
	static constexpr std::size_t MAX_DEGREE = 7;

	/// Value and derivatives with respect to s.
	struct Point {
		double value = 0.0;
		double first = 0.0;
		double second = 0.0;
	};

	std::array<double, MAX_DEGREE + 1> coefficients{};

	[[nodiscard]] double value(double s) const;
	[[nodiscard]] Point evaluate(double s) const;
};

struct PolynomialFit {
	Polynomial polynomial;
	std::size_t degree = 0;    ///< of the fit, at most max_degree
	std::size_t samples = 0;   ///< number of used samples
	double residual_std = 0.0; ///< sqrt(sum of squares / (samples - degree - 1)); 0 for an exact fit
};

/// Least-squares fit of a polynomial on [0, 1] to the samples (s, y). Samples that are not usable or have s
/// outside [0, 1] are ignored. The degree is lowered to what the values of s determine: two of them give a
/// line, one a constant, none the zero polynomial.
[[nodiscard]] PolynomialFit fit_polynomial(
		std::span<const double> s, std::span<const double> y, std::size_t max_degree);

} // namespace steadyhand
