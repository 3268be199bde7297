#include "metrics/curve_comparison.h"
#include "metrics/recognition.h"
#include "metrics/spectral_arc_length.h"
#include "metrics/summary.h"
#include "near.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

using namespace steadyhand;

namespace {

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
const UniformGrid GRID{ 10.0, 1000.0 };
const GestureSpan SPAN{ 11.0, 12.0 }; // in a record of 3 s

/// A curve over the record's 3 s, from a function of the time since start_s.
template <class Function> std::vector<double> curve(Function function) {
	std::vector<double> samples;
	for (std::size_t i = 0; i <= 3000; ++i) {
		samples.push_back(function(GRID.time_s(i) - SPAN.start_s));
	}
	return samples;
}

double ramp(double t_s) {
	return std::clamp(t_s, 0.0, 1.0);
}

double minimum_jerk(double t_s) {
	const double s = ramp(t_s);
	return s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
}

bool is_finite(const CurveComparison &result) {
	return std::isfinite(result.r2) && std::isfinite(result.r2_zero) && std::isfinite(result.lag_s) &&
			std::isfinite(result.t_diff_s) && std::isfinite(result.sparc);
}

} // namespace

TEST_CASE("a shifted curve fits at the shift, positive when late") {
	const auto reference = curve(minimum_jerk);
	for (const int shift_ms : { -500, -120, -1, 0, 1, 37, 500 }) {
		CAPTURE(shift_ms);
		const auto x = curve([&](double t_s) { return minimum_jerk(t_s - 0.001 * shift_ms); });
		const CurveComparison result = compare_curves(reference, x, GRID, SPAN);
		CHECK(result.r2 == test::near(1.0).epsilon(1e-12));
		CHECK(result.lag_s == test::near(0.001 * shift_ms));
		CHECK(result.t_diff_s == test::near(-0.001 * shift_ms).epsilon(1e-6));
		CHECK_FALSE(result.missed);
		CHECK((shift_ms == 0 ? result.r2_zero == 1.0 : result.r2_zero < 1.0));
	}
	// Beyond half a second the best shift is no longer to be found.
	const auto x = curve([](double t_s) { return minimum_jerk(t_s - 0.6); });
	const CurveComparison result = compare_curves(reference, x, GRID, SPAN);
	CHECK(result.lag_s == test::near(0.5));
	CHECK(result.r2 < 0.999);
}

TEST_CASE("R2 is that of its definition, summed in the plain way over every lag") {
	const auto reference = curve(minimum_jerk);
	const auto x =
			curve([](double t_s) { return 0.9 * minimum_jerk(t_s - 0.08) + 0.05 * std::sin(9.0 * t_s); });
	double best = -1e9;
	double zero = 0.0;
	int best_lag = 0;
	for (int lag = -500; lag <= 500; ++lag) {
		double residual = 0.0;
		double sum = 0.0;
		double sum_of_squares = 0.0;
		int count = 0;
		for (std::ptrdiff_t i = 750; i <= 2250; ++i) { // 11 s - 0.25 s to 12 s + 0.25 s
			const double ref = reference[static_cast<std::size_t>(i)];
			const double shifted = x[static_cast<std::size_t>(i + lag)];
			residual += (ref - shifted) * (ref - shifted);
			sum += ref;
			sum_of_squares += ref * ref;
			++count;
		}
		const double r2 = 1.0 - residual / (sum_of_squares - sum * sum / count);
		zero = lag == 0 ? r2 : zero;
		if (r2 > best) {
			best = r2;
			best_lag = lag;
		}
	}
	const CurveComparison result = compare_curves(reference, x, GRID, SPAN);
	CHECK(result.r2 == test::near(best).epsilon(1e-12));
	CHECK(result.r2_zero == test::near(zero).epsilon(1e-12));
	CHECK(result.lag_s == test::near(0.001 * best_lag));
}

TEST_CASE("a constant offset of a ramp costs what the sums say") {
	// Over 0..1 s and 0.25 s on either side. At no lag the residual is d everywhere: R2 = 1 - d^2 / variance,
	// that of the clipped ramp being (1/3 + 0.25) / 1.5 - 1/4. At a lag of -m its derivative is y^2 - 2 (1 -
	// d) y + d^2 = 0 with y = m - d: the best shift is a little more than d.
	const auto reference = curve(ramp);
	const double offset = 0.1;
	const auto x = curve([&](double t_s) { return ramp(t_s) + offset; });
	const CurveComparison result = compare_curves(reference, x, GRID, SPAN);
	const double variance = (1.0 / 3.0 + 0.25) / 1.5 - 0.25;
	CHECK(result.r2_zero == test::near(1.0 - offset * offset / variance).epsilon(1e-3));
	const double excess = (1.0 - offset) - std::sqrt((1.0 - offset) * (1.0 - offset) - offset * offset);
	CHECK(std::abs(result.lag_s + offset + excess) <= 0.0006);
	CHECK(result.t_diff_s == test::near(offset).epsilon(1e-9));
	CHECK(result.r2 > result.r2_zero);
}

TEST_CASE("ends are where both curves reach the same level, between samples") {
	const auto reference = curve(ramp);                                                   // 0.95 at 0.95 s
	const auto slow = curve([](double t_s) { return std::clamp(t_s / 1.3, 0.0, 0.97); }); // at 1.235 s
	CHECK(compare_curves(reference, slow, GRID, SPAN).t_diff_s == test::near(0.95 - 1.235).epsilon(1e-9));
	const auto fast = curve([](double t_s) { return std::clamp(t_s / 0.7001, 0.0, 2.0); }); // at 0.665095 s
	CHECK(compare_curves(reference, fast, GRID, SPAN).t_diff_s == test::near(0.95 - 0.665095).epsilon(1e-9));
	// Twice as long a movement has its end at 1.9, for x as well.
	const auto twice = curve([](double t_s) { return 2.0 * ramp(t_s); });
	CHECK(compare_curves(twice, twice, GRID, SPAN).t_diff_s == 0.0);
	CHECK(compare_curves(twice, reference, GRID, SPAN).missed);
	// There already before the start: its end is the start.
	const auto ahead = curve([](double) { return 1.0; });
	CHECK(compare_curves(reference, ahead, GRID, SPAN).t_diff_s == test::near(0.95).epsilon(1e-9));
	// What happened before start_s does not count.
	const auto restless = curve([](double t_s) { return t_s < -0.01 ? 1.0 : ramp(t_s); });
	CHECK(compare_curves(reference, restless, GRID, SPAN).t_diff_s == test::near(0.0));
}

TEST_CASE("a curve that never arrives is missed, with the bound that the record gives") {
	const auto reference = curve(ramp);
	const auto x = curve([](double t_s) { return 0.94 * ramp(t_s); });
	const CurveComparison result = compare_curves(reference, x, GRID, SPAN);
	CHECK(result.missed);
	CHECK(result.t_diff_s == test::near(0.95 - 2.0).epsilon(1e-9));
	// A reference that has gone nowhere, or backwards, has no end to compare with.
	for (const double slope : { 0.0, -1.0 }) {
		const auto backwards = curve([&](double t_s) { return slope * ramp(t_s); });
		const CurveComparison none = compare_curves(backwards, reference, GRID, SPAN);
		CHECK(none.missed);
		CHECK(none.t_diff_s == test::near(1.0 - 2.0).epsilon(1e-9));
	}
}

TEST_CASE("outside the record x keeps its first and last value, and the window is cut to the record") {
	// The record is the gesture itself. A ramp that is 0.2 s late shows 80 % of itself; what is held fits the
	// rest at the lag of 0.2 s where the reference has not risen above 0.8.
	std::vector<double> reference;
	std::vector<double> x;
	for (int i = 0; i <= 1000; ++i) {
		reference.push_back(ramp(0.001 * i));
		x.push_back(ramp(0.001 * i - 0.2));
	}
	const CurveComparison result = compare_curves(reference, x, { 0.0, 1000.0 }, { 0.0, 1.0 });
	// By hand for a lag of 0.2 s: residual integral of (t - 0.8)^2 from 0.8 to 1 = 0.2^3 / 3, total 1/12.
	CHECK(result.r2 >= 1.0 - 0.2 * 0.2 * 0.2 / 3.0 * 12.0 - 1e-3);
	CHECK(result.lag_s >= 0.2);
	CHECK(result.missed);
}

TEST_CASE("of equally good lags the smallest wins") {
	const auto reference = curve(ramp);
	const auto flat = curve([](double) { return 0.3; });
	CHECK(compare_curves(reference, flat, GRID, SPAN).lag_s == 0.0);
}

TEST_CASE("constant curves give finite figures") {
	const auto constant = curve([](double) { return 0.1; });
	CHECK(compare_curves(constant, constant, GRID, SPAN).r2 == 1.0);
	CHECK(compare_curves(constant, constant, GRID, SPAN).sparc == 0.0);
	const CurveComparison other = compare_curves(constant, curve(ramp), GRID, SPAN);
	CHECK(is_finite(other));
	CHECK(other.r2_zero == 0.0);
	const CurveComparison flat = compare_curves(curve(ramp), constant, GRID, SPAN);
	CHECK(is_finite(flat));
	CHECK(flat.missed);
	CHECK(flat.r2 < 0.0);
}

TEST_CASE("no input makes a figure that is not finite") {
	const UniformGrid coarse{ GRID.t0_s, 100.0 };
	std::vector<double> reference;
	for (std::size_t i = 0; i <= 300; ++i) {
		reference.push_back(ramp(coarse.time_s(i) - SPAN.start_s));
	}
	const std::vector<double> nothing;
	const std::vector<double> one{ 0.5 };
	const std::vector<double> bad(reference.size(), NOT_A_NUMBER);
	const double infinity = std::numeric_limits<double>::infinity();

	CHECK(compare_curves(nothing, nothing, GRID, SPAN).missed);
	for (const GestureSpan &span : { SPAN, GestureSpan{ 12.0, 11.0 }, GestureSpan{ 11.5, 11.5 },
				 GestureSpan{ 50.0, 60.0 }, GestureSpan{ -50.0, -60.0 }, GestureSpan{ NOT_A_NUMBER, 12.0 },
				 GestureSpan{ 11.0, infinity }, GestureSpan{ -1e99, 1e99 } }) {
		for (const UniformGrid &grid :
				{ coarse, GRID, UniformGrid{ 10.0, 0.0 }, UniformGrid{ NOT_A_NUMBER, 1000.0 },
						UniformGrid{ 10.0, -5.0 }, UniformGrid{ 10.0, 1e90 }, UniformGrid{ 10.0, 0.5 } }) {
			CHECK(is_finite(compare_curves(reference, reference, grid, span)));
			CHECK(is_finite(compare_curves(bad, reference, grid, span)));
			CHECK(is_finite(compare_curves(reference, bad, grid, span)));
			CHECK(is_finite(compare_curves(one, one, grid, span)));
		}
	}
	// Magnitudes far apart.
	const auto tiny = curve([](double t_s) { return 1e-150 * ramp(t_s); });
	const auto huge = curve([](double t_s) { return 1e99 * ramp(t_s); });
	CHECK(is_finite(compare_curves(tiny, huge, GRID, SPAN)));
	CHECK(is_finite(compare_curves(huge, tiny, GRID, SPAN)));
}

TEST_CASE("a sample that is no number counts as the one before it") {
	const auto reference = curve(minimum_jerk);
	auto holed = reference;
	auto held = reference;
	for (std::size_t i = 1300; i < 1400; ++i) {
		holed[i] = NOT_A_NUMBER;
		held[i] = reference[1299];
	}
	const CurveComparison result = compare_curves(reference, holed, GRID, SPAN);
	const CurveComparison expected = compare_curves(reference, held, GRID, SPAN);
	CHECK(result.r2 == expected.r2);
	CHECK(result.t_diff_s == expected.t_diff_s);
	CHECK(result.sparc == expected.sparc);
}

TEST_CASE("before the first sample that is a number counts that one") {
	const auto reference = curve([](double t_s) { return 0.4 + minimum_jerk(t_s); });
	auto unseen = reference;
	std::fill_n(unseen.begin(), 900, NOT_A_NUMBER);
	const CurveComparison result = compare_curves(reference, unseen, GRID, SPAN);
	CHECK(result.r2_zero == 1.0);
	CHECK(result.t_diff_s == 0.0);
	CHECK(compare_curves(unseen, reference, GRID, SPAN).r2_zero == 1.0);
}

TEST_CASE("instants on the grid count although their times are rounded") {
	// Whether t0 + i / rate comes out a little before or after the sample: the window holds it.
	const UniformGrid grid{ 0.1, 30.0 };
	std::vector<double> reference, x;
	for (std::size_t i = 0; i < 90; ++i) {
		const double t_s = grid.time_s(i);
		reference.push_back(ramp(t_s - 1.1));
		x.push_back(ramp(t_s - 1.1) + 0.1 * std::sin(20.0 * t_s));
	}
	for (std::size_t first = 20; first < 40; ++first) {
		const GestureSpan span{ grid.time_s(first), grid.time_s(first + 31) };
		const CurveComparison exact = compare_curves(reference, x, grid, span);
		for (const double off_s : { -1e-9, 1e-9 }) {
			const GestureSpan rounded{ span.start_s + off_s, span.end_s - off_s };
			CHECK(compare_curves(reference, x, grid, rounded).sparc == exact.sparc);
		}
	}
}

TEST_CASE("a span that leaves the record is compared within it, the speed by what is next to it") {
	// The record ends with the gesture: the speed is that of one step there, of two elsewhere.
	const UniformGrid grid{ 0.0, 100.0 };
	std::vector<double> x, speed;
	for (int i = 0; i <= 100; ++i) {
		x.push_back(minimum_jerk(0.01 * i) + 0.01 * i * i * 0.01);
	}
	for (std::size_t i = 0; i < x.size(); ++i) {
		const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, x.size() - 1);
		speed.push_back(100.0 * std::abs(x[after] - x[before]) / static_cast<double>(after - before));
	}
	for (const GestureSpan &span : { GestureSpan{ 0.0, 1.0 }, GestureSpan{ -0.5, 1.5 } }) {
		CHECK(compare_curves(x, x, grid, span).sparc ==
				test::near(spectral_arc_length(speed, 100.0)).epsilon(1e-12));
	}
	// Within the record the samples beside the span count.
	const std::vector<double> inner(speed.begin() + 20, speed.begin() + 71);
	CHECK(compare_curves(x, x, grid, { 0.2, 0.7 }).sparc ==
			test::near(spectral_arc_length(inner, 100.0)).epsilon(1e-12));
	CHECK(compare_curves(x, x, grid, { 1.2, 1.5 }).missed);
	CHECK(compare_curves(x, x, grid, { -0.5, -0.2 }).missed);
	// What is there at the last instant or before the record has arrived.
	const CurveComparison late = compare_curves(x, x, grid, { 1.0, 1.0 });
	CHECK_FALSE(late.missed);
	CHECK(late.t_diff_s == 0.0);
	const std::vector<double> there(x.size(), 3.0);
	CHECK(compare_curves(x, there, grid, { -0.5, 1.0 }).t_diff_s ==
			compare_curves(x, there, grid, { 0.0, 1.0 }).t_diff_s);
}

TEST_CASE("smoothness is that of the speed over the gesture's span") {
	// The speed's own figure for a minimum-jerk second (test_sparc.cpp); central differences change the 5th
	// digit.
	const CurveComparison result = compare_curves(curve(minimum_jerk), curve(minimum_jerk), GRID, SPAN);
	CHECK(std::abs(result.sparc - -1.402426) < 1e-4);
}

TEST_CASE("percentiles are NumPy's") {
	// numpy.percentile([...], [0, 2.5, 5, 50, 97.5, 100])
	const std::vector<double> values{ 0.3, -1.0, 2.0, 5.5, 0.1, 9.0, 4.0 };
	CHECK(percentile(values, 0.0) == -1.0);
	CHECK(percentile(values, 2.5) == test::near(-0.835));
	CHECK(percentile(values, 5.0) == test::near(-0.67));
	CHECK(percentile(values, 50.0) == 2.0);
	CHECK(percentile(values, 97.5) == test::near(8.475));
	CHECK(percentile(values, 100.0) == 9.0);
	CHECK(percentile(values, -10.0) == -1.0);
	CHECK(percentile(values, 120.0) == 9.0);
	CHECK(mean(values) == test::near(19.9 / 7.0));
	CHECK(mean(std::vector{ 1.0, NOT_A_NUMBER, 3.0 }) == 2.0);
	CHECK(mean({}) == 0.0);
	CHECK(percentile({}, 50.0) == 0.0);
	CHECK(percentile(values, NOT_A_NUMBER) == 0.0);
}

TEST_CASE("a confusion table counts every trial") {
	ConfusionTable table(2);
	table.add(0, 0);
	table.add(0, 0);
	table.add(0, 1);
	table.add(0, table.none());
	table.add(table.none(), 1);
	table.add(99, 99); // unknown: none
	CHECK(table.count(0, 0) == 2);
	CHECK(table.trials(0) == 4);
	CHECK(table.rate(0, 0) == 0.5);
	CHECK(table.rate(0, 1) == 0.25);
	CHECK(table.rate(1, 1) == 0.0);
	CHECK(table.count(table.none(), table.none()) == 1);
	CHECK(false_alarms_per_minute(3, 90.0) == test::near(2.0));
	CHECK(false_alarms_per_minute(3, 0.0) == 0.0);
}
