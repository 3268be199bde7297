#include "metrics/spectral_arc_length.h"
#include "near.h"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

using steadyhand::spectral_arc_length;

// The figures come from the published algorithm (Balasubramanian et al. 2015, the authors' Python code's
// defaults: padding level 4, 10 Hz, threshold 0.05) written with numpy.fft.fft, NumPy 2.4.

namespace {

/// Speed of a minimum-jerk movement of unit length and the given duration, end points included.
std::vector<double> minimum_jerk_speed(std::size_t steps) {
	std::vector<double> speed;
	for (std::size_t i = 0; i <= steps; ++i) {
		const double s = static_cast<double>(i) / static_cast<double>(steps);
		speed.push_back(30.0 * s * s * (1.0 - s) * (1.0 - s));
	}
	return speed;
}

/// The definition, term by term: the DFT of the speed, padded to 16 times the next power of two.
double by_definition(const std::vector<double> &speed, double rate_hz) {
	std::size_t length = 16;
	while (length < 16 * speed.size()) {
		length *= 2;
	}
	std::vector<double> spectrum;
	for (std::size_t k = 0; k <= length / 2; ++k) {
		const double step = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length);
		std::complex<double> sum;
		for (std::size_t i = 0; i < speed.size(); ++i) {
			sum += speed[i] * std::polar(1.0, -step * static_cast<double>(i));
		}
		if (static_cast<double>(k) * rate_hz / static_cast<double>(length) <= 10.0) {
			spectrum.push_back(std::abs(sum));
		}
	}
	std::size_t last = spectrum.size() - 1;
	while (spectrum[last] < 0.05 * spectrum[0]) {
		--last;
	}
	double arc = 0.0;
	for (std::size_t k = 1; k <= last; ++k) {
		arc += std::hypot(1.0 / static_cast<double>(last), (spectrum[k] - spectrum[k - 1]) / spectrum[0]);
	}
	return -arc;
}

} // namespace

TEST_CASE("SPARC is its definition, where the speed is fast beyond 10 Hz and where the rate ends below") {
	for (const double rate_hz : { 15.0, 60.0, 100.0 }) {
		for (const double tremor_hz : { 3.0, 7.0, 9.9, 10.6, 13.0 }) {
			CAPTURE(rate_hz);
			CAPTURE(tremor_hz);
			std::vector<double> speed = minimum_jerk_speed(40);
			for (std::size_t i = 0; i < speed.size(); ++i) {
				const double turns = tremor_hz * static_cast<double>(i) / rate_hz;
				speed[i] *= 1.0 + 0.9 * std::sin(2.0 * std::numbers::pi * turns);
			}
			CHECK(spectral_arc_length(speed, rate_hz) ==
					steadyhand::test::near(by_definition(speed, rate_hz)).epsilon(1e-9));
		}
	}
}

TEST_CASE("SPARC takes a speed's size, and what is no number as rest") {
	std::vector<double> speed = minimum_jerk_speed(50), turned = speed, unseen = speed;
	for (std::size_t i = 0; i < speed.size(); i += 3) {
		turned[i] = -turned[i];
		unseen[i] = i % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e200;
	}
	CHECK(spectral_arc_length(turned, 100.0) == spectral_arc_length(speed, 100.0));
	for (std::size_t i = 0; i < speed.size(); i += 3) {
		speed[i] = 0.0;
	}
	CHECK(spectral_arc_length(unseen, 100.0) == spectral_arc_length(speed, 100.0));
	for (const double rate_hz :
			{ -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() }) {
		CHECK(spectral_arc_length(speed, rate_hz) == 0.0);
	}
}

TEST_CASE("SPARC of the authors' own example") {
	// "sal" in the documentation of their function: -1.41403.
	std::vector<double> speed;
	for (int i = -100; i < 100; ++i) {
		speed.push_back(std::exp(-5.0 * (0.01 * i) * (0.01 * i)));
	}
	CHECK(std::abs(spectral_arc_length(speed, 100.0) - -1.41403) < 5e-6);
}

TEST_CASE("SPARC of minimum-jerk movements of 1 s and 0.35 s") {
	CHECK(std::abs(spectral_arc_length(minimum_jerk_speed(1000), 1000.0) - -1.402426062911) < 1e-10);
	CHECK(std::abs(spectral_arc_length(minimum_jerk_speed(350), 1000.0) - -1.407502619487) < 1e-10);
}

TEST_CASE("SPARC of a jerky movement") {
	std::vector<double> speed = minimum_jerk_speed(1000);
	for (std::size_t i = 0; i < speed.size(); ++i) {
		speed[i] *= 1.0 + 0.5 * std::sin(2.0 * std::numbers::pi * 4.0 * static_cast<double>(i) / 1000.0);
	}
	CHECK(std::abs(spectral_arc_length(speed, 1000.0) - -1.874818649384) < 1e-10);
}

TEST_CASE("SPARC does not depend on how far the movement goes") {
	std::vector<double> speed = minimum_jerk_speed(500);
	const double unit = spectral_arc_length(speed, 1000.0);
	for (double &sample : speed) {
		sample *= 1e-9;
	}
	CHECK(spectral_arc_length(speed, 1000.0) == steadyhand::test::near(unit).epsilon(1e-12));
}

TEST_CASE("SPARC of no movement, of one sample and of no numbers is finite") {
	CHECK(spectral_arc_length({}, 1000.0) == 0.0);
	CHECK(spectral_arc_length(std::vector<double>(100, 0.0), 1000.0) == 0.0);
	CHECK(std::isfinite(spectral_arc_length(std::vector{ 1.0 }, 1000.0)));
	CHECK(spectral_arc_length(std::vector{ 1.0, 2.0 }, 0.0) == 0.0);
	const double bad = std::numeric_limits<double>::quiet_NaN();
	CHECK(spectral_arc_length(std::vector{ bad, bad }, 1000.0) == 0.0);
	CHECK(std::isfinite(spectral_arc_length(std::vector{ bad, 1.0, 2.0, 1e300, 1.0 }, 1000.0)));
}
