#include "signal/slope_window.h"

#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace steadyhand;

TEST_CASE("a full ring keeps the newest in order") {
	Ring<int, 4> ring;
	for (int i = 0; i < 7; ++i) {
		ring.push(i);
	}
	ring.drop_newest();
	ring.push(60);
	REQUIRE(ring.size() == 4);
	CHECK(ring[0] == 3);
	CHECK(ring[1] == 4);
	CHECK(ring[2] == 5);
	CHECK(ring.newest() == 60);
	ring.drop_oldest();
	CHECK(ring[0] == 4);
	ring.clear();
	CHECK(ring.empty());
}

TEST_CASE("the slope is that of Eigen's least squares over the window, late and far from the origin") {
	std::mt19937 random(5);
	std::uniform_real_distribution<double> step_s(0.001, 0.02), place_m(-0.1, 0.1);
	constexpr double WINDOW_S = 0.1, FIRST_S = 3600.0;
	SlopeWindow<Eigen::Vector2d, 64> window;
	CHECK(window.slope().isZero(0.0));
	Eigen::VectorXd t_s(200);
	Eigen::MatrixX2d x_m(200, 2);
	double now_s = FIRST_S;
	for (Eigen::Index i = 0; i < t_s.size(); ++i) {
		now_s += step_s(random);
		t_s(i) = now_s;
		x_m.row(i) << place_m(random), 10.0 + place_m(random);
		window.push(now_s, x_m.row(i).transpose(), WINDOW_S);
		if (i == 0) {
			CHECK(window.slope().isZero(0.0));
			continue;
		}
		Eigen::Index first = 0;
		while (first < i - 1 && now_s - t_s(first) > WINDOW_S) {
			++first;
		}
		const Eigen::Index count = i + 1 - first;
		REQUIRE(window.size() == static_cast<std::size_t>(count));
		Eigen::MatrixX2d line(count, 2);
		line << (t_s.segment(first, count).array() - now_s).matrix(), Eigen::VectorXd::Ones(count);
		const Eigen::Matrix2d fit = line.colPivHouseholderQr().solve(x_m.middleRows(first, count));
		const double error = (window.slope() - fit.row(0).transpose()).norm();
		CHECK(error < 1e-8 * std::max(1.0, fit.row(0).norm()));
	}
}
