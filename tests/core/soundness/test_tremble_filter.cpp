// Trembling of a tracker: how much there is, and strokes without it.

#include "minimum_jerk_drag.h"
#include "near.h"
#include "soundness/tremble_filter.h"
#include "strokes/stroke_finder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace steadyhand;

namespace {

constexpr double SLOPE_S = 0.1;
const test::Drag DRAG{ .onset_s = 1.5, .duration_s = 1.0, .amplitude_m = 0.2 };

using Way = std::function<double(double t_s)>;

class Trembling {
public:
	explicit Trembling(double deviation_m) : deviation_m_(deviation_m) {}
	FeaturePlace operator()(double x_m) {
		const double x = normal_(random_), y = normal_(random_), z = normal_(random_);
		return { x_m + deviation_m_ * x, deviation_m_ * y, deviation_m_ * z, 0.0 };
	}

private:
	double deviation_m_;
	std::mt19937_64 random_{ 3 };
	std::normal_distribution<double> normal_;
};

/// The noise found in a way along x that trembles in x, y and z, mean over its last second.
double found_noise_m(const Way &way, double rate_hz, double length_s, double deviation_m) {
	TrembleFilter filter;
	Trembling trembling(deviation_m);
	double sum_m = 0.0;
	int n = 0;
	for (int i = 0; i < static_cast<int>(length_s * rate_hz); ++i) {
		const FeaturePlace place = trembling(way(i / rate_hz));
		filter.push({ i / rate_hz, place, place }, SLOPE_S, 0.0);
		if (i / rate_hz > length_s - 1.0) {
			sum_m += filter.noise_m();
			++n;
		}
	}
	return sum_m / n;
}

} // namespace

TEST_CASE("the noise of a trembling tracker is found at any rate, whatever the hand does") {
	const Way rest = [](double) { return 0.0; };
	const Way drag = [](double t_s) { return DRAG.x_m(t_s); };
	for (const double rate_hz : { 30.0, 79.0, 240.0, 1000.0 }) {
		for (const double deviation_m : { 1e-4, 1e-3, 5e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(deviation_m);
			const double noise_m = 1.42 * deviation_m;
			CHECK(found_noise_m(rest, rate_hz, 6.0, deviation_m) == test::near(noise_m).epsilon(0.15));
			if (deviation_m > 5e-4) {
				CHECK(found_noise_m(drag, rate_hz, 2.5, deviation_m) == test::near(noise_m).epsilon(0.3));
			}
		}
		CHECK(found_noise_m(drag, rate_hz, 2.5, 0.0) < 1e-4);
	}
}

TEST_CASE("a tracker that jumps now and then does not tremble") {
	const Way jumping = [](double t_s) { return std::fmod(t_s, 1.0) < 0.05 ? 0.05 : 0.0; };
	CHECK(found_noise_m(jumping, 110.0, 8.0, 1e-4) < 1.5e-3);
}

TEST_CASE("where little trembles frames pass as they are, and else as means that are as still as was asked") {
	constexpr double RATE_HZ = 80.0, STILL_M_S = 0.39 * 0.15; // of taps, the smallest that ship
	for (const double deviation_m : { 1e-4, 1e-3, 2.5e-3, 4e-3, 6e-3 }) {
		CAPTURE(deviation_m);
		TrembleFilter filter;
		Trembling trembling(deviation_m);
		// Slopes over SLOPE_S of what comes out, by least squares.
		std::vector<TrembleFilter::Place> out;
		double sum = 0.0;
		int slopes = 0;
		bool is_as_given = true;
		for (int i = 0; i < 3000; ++i) {
			const double t_s = i / RATE_HZ;
			const FeaturePlace place = trembling(0.0);
			out.push_back(filter.push({ t_s, place, place }, SLOPE_S, STILL_M_S));
			is_as_given = is_as_given && out.back().place_m == place && out.back().t_s == t_s;
			if (i < 300) {
				continue;
			}
			double mean_t = 0.0, variance = 0.0;
			FeaturePlace mean_m = FeaturePlace::Zero(), covariance = FeaturePlace::Zero();
			constexpr int N = 9;
			for (int k = i - N + 1; k <= i; ++k) {
				mean_t += out[static_cast<std::size_t>(k)].t_s / N;
				mean_m += out[static_cast<std::size_t>(k)].place_m / N;
			}
			for (int k = i - N + 1; k <= i; ++k) {
				const double dt = out[static_cast<std::size_t>(k)].t_s - mean_t;
				variance += dt * dt;
				covariance += dt * (out[static_cast<std::size_t>(k)].place_m - mean_m);
			}
			sum += (covariance / variance).squaredNorm();
			++slopes;
		}
		const double slope_m_s = std::sqrt(sum / slopes);
		CHECK(is_as_given == (deviation_m < 3e-3));
		CHECK(slope_m_s < 1.3 * STILL_M_S);
		if (!is_as_given) {
			CHECK(slope_m_s > 0.5 * STILL_M_S);
		}
	}
}

TEST_CASE("before a tracker that trembles by 2 mm strokes are as new as its frames") {
	constexpr double SMALLEST_M = 0.009; // of taps
	struct Tracker {
		double rate_hz, deviation_m;
	};
	for (const auto &[rate_hz, deviation_m] :
			{ Tracker{ 60.0, 2e-3 }, { 80.0, 2.3e-3 }, { 110.0, 2.6e-3 } }) {
		CAPTURE(rate_hz);
		StrokeFinder finder(FeaturePlace::Ones(), SMALLEST_M);
		Trembling trembling(deviation_m);
		int shown = 0;
		for (int i = 0; i < static_cast<int>(3.0 * rate_hz); ++i) {
			const double t_s = i / rate_hz;
			finder.push(t_s, trembling(DRAG.x_m(t_s)));
			if (t_s > DRAG.onset_s && !finder.strokes().empty()) {
				CHECK(finder.strokes().front().now_s == t_s);
				++shown;
			}
		}
		CHECK(shown / rate_hz > 0.7 * DRAG.duration_s);
	}
}

TEST_CASE("a stroke is one stroke however much the tracker trembles, and as long as the hand's") {
	for (const double rate_hz : { 30.0, 79.0, 240.0 }) {
		for (const double deviation_m : { 1e-4, 2e-3, 5e-3 }) {
			CAPTURE(rate_hz);
			CAPTURE(deviation_m);
			StrokeFinder finder(FeaturePlace::Ones(), 0.009);
			Trembling trembling(deviation_m);
			Stroke longest;
			int shown = 0;
			for (int i = 0; i < static_cast<int>(3.2 * rate_hz); ++i) {
				const double t_s = i / rate_hz;
				finder.push(t_s, trembling(DRAG.x_m(t_s)));
				if (!finder.strokes().empty()) {
					const Stroke &stroke = finder.strokes().front();
					const double length_m = (stroke.to - stroke.from).norm();
					shown += t_s < DRAG.onset_s && length_m > 0.02 ? 1 : 0;
					longest = length_m > (longest.to - longest.from).norm() ? stroke : longest;
				}
			}
			CHECK(shown == 0);
			CHECK((longest.to - longest.from).norm() == test::near(0.2).epsilon(0.1));
			CHECK(longest.way_m == test::near(0.2).epsilon(0.15));
			// A quarter of the peak speed is passed at 0.146 of the duration, where the hand speeds up
			// by 1.06 m/s^2: slopes that are 0.034 m/s off, four times over, and half of the window that they
			// are from.
			CHECK(std::abs(longest.onset_s - 1.646) <
					0.05 + (deviation_m > 1e-3 ? 4.0 * 0.034 / 1.06 : 0.02));
		}
	}
}
