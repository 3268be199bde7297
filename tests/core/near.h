#pragma once

#include <doctest/doctest.h>

namespace steadyhand::test {

/// doctest::Approx adds 1 to the value that its epsilon is a share of, so that 2 % of a 20 cm way would
/// be 2.4 cm. Here it adds a millionth, for what is to be 0.
inline doctest::Approx near(double value) {
	return doctest::Approx(value).scale(1e-6);
}

} // namespace steadyhand::test
