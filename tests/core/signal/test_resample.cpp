#include "near.h"
#include "signal/resample.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <vector>

using steadyhand::resample_hold;
using steadyhand::resample_linear;
using steadyhand::UniformGrid;

namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
const UniformGrid QUARTERS{ 0.0, 4.0 };

} // namespace

TEST_CASE("a hold shows the last sample stamped at or before the instant") {
	const std::vector<double> times_s{ 0.25, 0.6, 1.0 };
	const std::vector<double> values{ 1.0, 2.0, 3.0 };
	std::array<double, 6> out{};
	resample_hold(times_s, values, -1.0, QUARTERS, out);
	CHECK(out == std::array{ -1.0, 1.0, 1.0, 2.0, 3.0, 3.0 });
}

TEST_CASE("a hold does not change when the future is cut off") {
	const std::vector<double> times_s{ 0.1, 0.3, 0.55, 0.8 };
	const std::vector<double> values{ 1.0, 2.0, 3.0, 4.0 };
	std::array<double, 5> whole{};
	resample_hold(times_s, values, 0.0, QUARTERS, whole);
	for (std::size_t kept = 0; kept <= times_s.size(); ++kept) {
		std::array<double, 5> cut{};
		resample_hold(std::span(times_s).first(kept), std::span(values).first(kept), 0.0, QUARTERS, cut);
		for (std::size_t i = 0; i < cut.size(); ++i) {
			if (kept == times_s.size() || QUARTERS.time_s(i) < times_s[kept]) {
				CHECK(cut[i] == whole[i]);
			}
		}
	}
}

TEST_CASE("linear interpolation gives a ramp back and holds its ends") {
	const std::vector<double> times_s{ 0.3, 0.5, 0.9, 1.1 };
	const std::vector<double> values{ 0.6, 1.0, 1.8, 2.2 };
	std::array<double, 6> out{};
	resample_linear(times_s, values, QUARTERS, out);
	const std::array expected{ 0.6, 0.6, 1.0, 1.5, 2.0, 2.2 };
	for (std::size_t i = 0; i < out.size(); ++i) {
		CHECK(out[i] == steadyhand::test::near(expected[i]).epsilon(1e-14));
	}
}

TEST_CASE("resampling leaves out late and unusable samples, and of several at one instant takes the last") {
	const std::vector<double> times_s{ 0.0, NOT_A_NUMBER, 0.5, 0.25, 0.75, 1.0, 1.0 };
	const std::vector<double> values{ 0.0, 9.0, 2.0, 9.0, NOT_A_NUMBER, 4.0, 5.0 };
	std::array<double, 5> held{};
	resample_hold(times_s, values, 0.0, QUARTERS, held);
	CHECK(held == std::array{ 0.0, 0.0, 2.0, 2.0, 5.0 });
	std::array<double, 5> linear{};
	resample_linear(times_s, values, QUARTERS, linear);
	CHECK(linear == std::array{ 0.0, 1.0, 2.0, 3.0, 5.0 });
}

TEST_CASE("resampling nothing gives what is said for nothing") {
	std::array<double, 3> out{ 7.0, 7.0, 7.0 };
	resample_hold({}, {}, 0.5, QUARTERS, out);
	CHECK(out == std::array{ 0.5, 0.5, 0.5 });
	resample_linear({}, {}, QUARTERS, out);
	CHECK(out == std::array{ 0.0, 0.0, 0.0 });
}
