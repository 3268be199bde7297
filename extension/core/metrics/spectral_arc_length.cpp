#include "metrics/spectral_arc_length.h"

#include "signal/sample_clock.h"

#include <Eigen/Core>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace steadyhand {

namespace {

constexpr std::size_t PADDING = 16; // 2^4, "padlevel 4"
constexpr double CUTOFF_HZ = 10.0;
constexpr double AMPLITUDE_THRESHOLD = 0.05;

/// |DFT| of the samples at 0, step, 2 step, ... (radians a sample). Directly: the bins below 10 Hz are one in
/// a hundred of those that an FFT would make.
Eigen::ArrayXd amplitudes(std::span<const double> samples, Eigen::Index bins, double step) {
	const Eigen::ArrayXd angles = Eigen::ArrayXd::LinSpaced(bins, 0.0, step * static_cast<double>(bins - 1));
	const Eigen::ArrayXd turn_cos = angles.cos();
	const Eigen::ArrayXd turn_sin = angles.sin();
	Eigen::ArrayXd cosine = Eigen::ArrayXd::Ones(bins);
	Eigen::ArrayXd sine = Eigen::ArrayXd::Zero(bins);
	Eigen::ArrayXd real = Eigen::ArrayXd::Zero(bins);
	Eigen::ArrayXd imaginary = Eigen::ArrayXd::Zero(bins);
	Eigen::ArrayXd turned(bins);
	for (const double sample : samples) {
		const double speed = is_usable(sample) ? std::abs(sample) : 0.0;
		real += speed * cosine;
		imaginary += speed * sine;
		turned = cosine * turn_cos - sine * turn_sin;
		sine = sine * turn_cos + cosine * turn_sin;
		cosine.swap(turned);
	}
	return (real.square() + imaginary.square()).sqrt();
}

} // namespace

double spectral_arc_length(std::span<const double> speed, double rate_hz) {
	if (speed.empty() || !is_usable(rate_hz) || rate_hz <= 0.0) {
		return 0.0;
	}
	const auto length = static_cast<double>(PADDING * std::bit_ceil(speed.size()));
	const double cutoff_hz = std::min(CUTOFF_HZ, rate_hz / 2.0);
	const auto bins = static_cast<Eigen::Index>(std::floor(cutoff_hz * length / rate_hz)) + 1;
	Eigen::ArrayXd spectrum = amplitudes(speed, bins, 2.0 * std::numbers::pi / length);
	// Speeds are not negative: none of the amplitudes is larger than the first.
	if (!(spectrum[0] > 0.0)) {
		return 0.0;
	}
	spectrum /= spectrum[0];
	Eigen::Index last = bins - 1;
	while (spectrum[last] < AMPLITUDE_THRESHOLD) {
		--last;
	}
	double arc = 0.0;
	for (Eigen::Index i = 1; i <= last; ++i) {
		arc += std::hypot(1.0 / static_cast<double>(last), spectrum[i] - spectrum[i - 1]);
	}
	return -arc;
}

} // namespace steadyhand
