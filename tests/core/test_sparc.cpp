#include "metrics/spectral_arc_length.h"

#include <doctest/doctest.h>

#include <cmath>
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

} // namespace

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
	CHECK(spectral_arc_length(speed, 1000.0) == doctest::Approx(unit).epsilon(1e-12));
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
