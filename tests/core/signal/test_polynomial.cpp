#include "near.h"
#include "signal/polynomial.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

using steadyhand::fit_polynomial;
using steadyhand::Polynomial;
using steadyhand::PolynomialFit;

namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

struct Samples {
	std::vector<double> s;
	std::vector<double> y;
};

Samples sample(const Polynomial &polynomial, int count) {
	Samples samples;
	for (int i = 0; i < count; ++i) {
		samples.s.push_back(static_cast<double>(i) / (count - 1));
		samples.y.push_back(polynomial.value(samples.s.back()));
	}
	return samples;
}

} // namespace

TEST_CASE("a fit recovers a polynomial of each degree") {
	const Polynomial full{ { 0.3, -1.0, 2.0, 0.5, -3.0, 1.5, 4.0, -2.0 } };
	for (std::size_t degree = 0; degree <= Polynomial::MAX_DEGREE; ++degree) {
		CAPTURE(degree);
		Polynomial truth;
		for (std::size_t k = 0; k <= degree; ++k) {
			truth.coefficients[k] = full.coefficients[k];
		}
		const Samples samples = sample(truth, 200);
		const PolynomialFit fit = fit_polynomial(samples.s, samples.y, degree);
		CHECK(fit.degree == degree);
		CHECK(fit.samples == 200);
		CHECK(fit.residual_std < 1e-14);
		for (std::size_t k = 0; k <= Polynomial::MAX_DEGREE; ++k) {
			CHECK(std::abs(fit.polynomial.coefficients[k] - truth.coefficients[k]) < 1e-10);
		}
	}
}

TEST_CASE("a line through noise is the textbook's regression") {
	// s = 0, 1/3, 2/3, 1 and y = 1, 3, 2, 5. Mean s = 1/2, mean y = 11/4; sum of (s - mean s)^2 = 5/9, of
	// (s - mean s)(y - mean y) = 11/6: slope 3.3, intercept 1.1. Residuals -0.1, 0.8, -1.3, 0.6: squares 2.7.
	const std::vector<double> s{ 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 };
	const std::vector<double> y{ 1.0, 3.0, 2.0, 5.0 };
	const PolynomialFit fit = fit_polynomial(s, y, 1);
	CHECK(fit.polynomial.coefficients[0] == steadyhand::test::near(1.1).epsilon(1e-13));
	CHECK(fit.polynomial.coefficients[1] == steadyhand::test::near(3.3).epsilon(1e-13));
	CHECK(fit.residual_std == steadyhand::test::near(std::sqrt(2.7 / 2.0)).epsilon(1e-13));
}

TEST_CASE("derivatives are those of central differences") {
	const Polynomial polynomial{ { 0.3, -1.0, 2.0, 0.5, -3.0, 1.5, 4.0, -2.0 } };
	const double h = 1e-4;
	for (int step = 0; step <= 16; ++step) {
		const double s = step / 16.0;
		const Polynomial::Point point = polynomial.evaluate(s);
		const double before = polynomial.value(s - h);
		const double after = polynomial.value(s + h);
		CHECK(point.value == polynomial.value(s));
		CHECK(point.first == steadyhand::test::near((after - before) / (2.0 * h)).epsilon(1e-6));
		CHECK(point.second ==
				steadyhand::test::near((after - 2.0 * point.value + before) / (h * h)).epsilon(1e-5));
	}
}

TEST_CASE("the degree is no higher than the samples allow") {
	const std::vector<double> none;
	CHECK(fit_polynomial(none, none, 5).samples == 0);
	CHECK(fit_polynomial(none, none, 5).polynomial.value(0.5) == 0.0);

	const PolynomialFit constant = fit_polynomial(std::vector{ 0.2 }, std::vector{ 7.0 }, 5);
	CHECK(constant.degree == 0);
	CHECK(constant.polynomial.value(0.9) == steadyhand::test::near(7.0));
	CHECK(constant.residual_std == 0.0);

	const PolynomialFit line = fit_polynomial(std::vector{ 0.25, 0.75 }, std::vector{ 1.0, 2.0 }, 5);
	CHECK(line.degree == 1);
	CHECK(line.polynomial.value(0.0) == steadyhand::test::near(0.5));
	CHECK(line.polynomial.value(1.0) == steadyhand::test::near(2.5));

	// Many samples, but at two places only: still a line, through the mean at each.
	const std::vector<double> s{ 0.0, 0.0, 1.0, 1.0, 1.0 };
	const std::vector<double> y{ 1.0, 3.0, 5.0, 6.0, 7.0 };
	const PolynomialFit clusters = fit_polynomial(s, y, 7);
	CHECK(clusters.degree == 1);
	CHECK(clusters.polynomial.value(0.0) == steadyhand::test::near(2.0));
	CHECK(clusters.polynomial.value(1.0) == steadyhand::test::near(6.0));

	// At one place: their mean, not a line of any slope.
	const PolynomialFit place =
			fit_polynomial(std::vector{ 0.5, 0.5, 0.5 + 1e-12 }, std::vector{ 1.0, 2.0, 6.0 }, 3);
	CHECK(place.degree == 0);
	CHECK(place.polynomial.value(0.0) == steadyhand::test::near(3.0));
	CHECK(place.residual_std == steadyhand::test::near(std::sqrt(14.0 / 2.0)));
}

TEST_CASE("samples that are no numbers or outside the range are left out") {
	const double infinity = std::numeric_limits<double>::infinity();
	const std::vector<double> s{ 0.0, NOT_A_NUMBER, 0.5, 0.6, 1.0, -0.1, 1.1, infinity };
	const std::vector<double> y{ 1.0, 50.0, NOT_A_NUMBER, infinity, 3.0, 9.0, 9.0, 9.0 };
	const PolynomialFit fit = fit_polynomial(s, y, 3);
	CHECK(fit.samples == 2);
	CHECK(fit.degree == 1);
	CHECK(fit.polynomial.value(0.5) == steadyhand::test::near(2.0));
}

TEST_CASE("a fit works alike at any scale of the values") {
	const Polynomial truth{ { 0.0, 0.0, 0.0, 10.0, -15.0, 6.0, 0.0, 0.0 } }; // minimum jerk
	for (const double scale : { 1e-9, 1.0, 1e9 }) {
		Samples samples = sample(truth, 50);
		for (double &y : samples.y) {
			y *= scale;
		}
		const PolynomialFit fit = fit_polynomial(samples.s, samples.y, 7);
		CHECK(fit.degree == 7);
		for (int step = 0; step <= 8; ++step) {
			const double s = step / 8.0;
			CHECK(std::abs(fit.polynomial.value(s) - scale * truth.value(s)) < 1e-12 * scale);
		}
	}
}
