#include "signal/polynomial.h"

#include "signal/sample_clock.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steadyhand {

namespace {

constexpr std::size_t COEFFICIENTS = Polynomial::MAX_DEGREE + 1;

/// The degree of a fit is lowered if its basis functions differ by less than this at the samples.
constexpr double RANK_THRESHOLD = 1e-6;

/// Chebyshev polynomials of u = 2s - 1. They are nearly orthogonal on [0, 1]; powers of s would lose 8 digits
/// at degree 7.
Eigen::MatrixXd chebyshev_basis(const Eigen::VectorXd &s, Eigen::Index columns) {
	const Eigen::ArrayXd u = 2.0 * s.array() - 1.0;
	Eigen::MatrixXd basis = Eigen::MatrixXd::Ones(s.size(), columns);
	if (columns > 1) {
		basis.col(1) = u;
	}
	for (Eigen::Index n = 2; n < columns; ++n) {
		basis.col(n) = 2.0 * u * basis.col(n - 1).array() - basis.col(n - 2).array();
	}
	return basis;
}

/// Coefficients of powers of s from weights of the Chebyshev polynomials. Their integer coefficients make
/// this exact up to rounding.
Polynomial from_chebyshev(const Eigen::VectorXd &weights) {
	Polynomial result;
	std::array<double, COEFFICIENTS> previous{};
	std::array<double, COEFFICIENTS> current{};
	current[0] = 1.0;
	for (Eigen::Index n = 0; n < weights.size(); ++n) {
		for (std::size_t k = 0; k < COEFFICIENTS; ++k) {
			result.coefficients[k] += weights[n] * current[k];
		}
		// T_1 = u and T_(n+1) = 2 u T_n - T_(n-1), with u = 2s - 1.
		const double factor = n == 0 ? 1.0 : 2.0;
		std::array<double, COEFFICIENTS> next{};
		for (std::size_t k = 0; k < COEFFICIENTS; ++k) {
			const double shifted = k > 0 ? 2.0 * current[k - 1] : 0.0;
			next[k] = factor * (shifted - current[k]) - previous[k];
		}
		previous = current;
		current = next;
	}
	return result;
}

} // namespace

double Polynomial::value(double s) const {
	double sum = 0.0;
	for (std::size_t k = COEFFICIENTS; k-- > 0;) {
		sum = sum * s + coefficients[k];
	}
	return sum;
}

Polynomial::Point Polynomial::evaluate(double s) const {
	Point point;
	for (std::size_t k = COEFFICIENTS; k-- > 0;) {
		point.second = point.second * s + 2.0 * point.first;
		point.first = point.first * s + point.value;
		point.value = point.value * s + coefficients[k];
	}
	return point;
}

PolynomialFit fit_polynomial(std::span<const double> s, std::span<const double> y, std::size_t max_degree) {
	std::vector<double> used_s;
	std::vector<double> used_y;
	for (std::size_t i = 0; i < std::min(s.size(), y.size()); ++i) {
		if (s[i] >= 0.0 && s[i] <= 1.0 && is_usable(y[i])) {
			used_s.push_back(s[i]);
			used_y.push_back(y[i]);
		}
	}
	PolynomialFit fit;
	fit.samples = used_s.size();
	if (fit.samples == 0) {
		return fit;
	}
	const auto rows = static_cast<Eigen::Index>(fit.samples);
	const Eigen::Map<const Eigen::VectorXd> abscissae(used_s.data(), rows);
	const Eigen::Map<const Eigen::VectorXd> ordinates(used_y.data(), rows);
	const std::size_t degree = std::min({ max_degree, Polynomial::MAX_DEGREE, fit.samples - 1 });
	const Eigen::MatrixXd basis = chebyshev_basis(abscissae, static_cast<Eigen::Index>(degree) + 1);

	for (Eigen::Index columns = basis.cols(); columns > 0; --columns) {
		Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
		qr.setThreshold(RANK_THRESHOLD);
		qr.compute(basis.leftCols(columns));
		if (qr.rank() < columns) {
			continue;
		}
		const Eigen::VectorXd weights = qr.solve(ordinates);
		const double squares = (basis.leftCols(columns) * weights - ordinates).squaredNorm();
		fit.polynomial = from_chebyshev(weights);
		fit.degree = static_cast<std::size_t>(columns - 1);
		fit.residual_std = rows > columns ? std::sqrt(squares / static_cast<double>(rows - columns)) : 0.0;
		break;
	}
	return fit;
}

} // namespace steadyhand
