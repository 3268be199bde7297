#pragma once

#include <span>

namespace steadyhand {

/// Smoothness of a movement from its speed profile (Balasubramanian, Melendez-Calderon, Roby-Brami, Burdet
/// 2015, DOI 10.1186/s12984-015-0090-9): minus the arc length of the amplitude spectrum, normalised by its
/// value at 0 Hz, up to the last frequency below 10 Hz at which it is at least 0.05. Zero padding to 16 times
/// the next power of two. The authors' published code has these same defaults (the article's text says 20
/// Hz).
///
/// The nearer to 0, the smoother; a minimum-jerk movement has -1.40. 0 is returned where there is no
/// movement. Unusable samples count as speed 0. Time grows with the square of the profile's length: 1 ms for
/// 2 s at 1 kHz.
[[nodiscard]] double spectral_arc_length(std::span<const double> speed, double rate_hz);

} // namespace steadyhand
