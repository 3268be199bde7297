// Log likelihood ratios of strokes.

#include "near.h"
#include "strokes/path_densities.h"
#include "strokes/stroke_evidence.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace steadyhand;

namespace {

Stroke straight(double length_m) {
	Stroke stroke;
	stroke.now_s = 1.0;
	stroke.to = FeaturePlace(length_m, 0.0, 0.0, 0.0);
	stroke.middle = 0.5 * stroke.to;
	stroke.path_m = length_m;
	stroke.tracked_before_s = parameters::strokes::REST_S;
	return stroke;
}

StrokeEvidence evidence(const Stroke &stroke) {
	return stroke_evidence(stroke, FeaturePlace::UnitX(), { .amplitude_m = 0.2, .duration_s = 1.0 });
}

/// The null model's density of detours.
double other_detour(double detour) {
	return 2.0 / 1.7 * std::pow(1.0 + detour / 1.7, -3.0);
}

/// Integral of f over 0 .. to, by the midpoint rule.
double integral(const std::function<double(double)> &f, double to) {
	constexpr int STEPS = 20000;
	double sum = 0.0;
	for (int i = 0; i < STEPS; ++i) {
		sum += f(to * (i + 0.5) / STEPS) * to / STEPS;
	}
	return sum;
}

} // namespace

TEST_CASE("the evidence of a stroke is the ratio of its densities") {
	// The integral of the gesture's density is 1. The null model's densities are those of stroke_evidence.h.
	constexpr double BOW = 0.18, LARGEST_BOW = 0.5;
	const double straightness = std::log(LARGEST_BOW / (BOW * std::tgamma(1.25)));
	const auto directions = [&](double angle) {
		Stroke turned = straight(0.2);
		turned.to = 0.2 * FeaturePlace(std::cos(angle), std::sin(angle), 0.0, 0.0);
		turned.middle = 0.5 * turned.to;
		CHECK(evidence(turned).size == test::near(evidence(straight(0.2)).size));
		return std::exp(evidence(turned).path - straightness) * 0.5 * std::sin(angle);
	};
	CHECK(integral(directions, std::numbers::pi) == test::near(1.0).epsilon(1e-3));
	const auto bows = [&](double bow) {
		Stroke bent = straight(0.2);
		bent.middle.y() += 0.2 * bow;
		return std::exp(evidence(bent).path - evidence(straight(0.2)).path + straightness) / LARGEST_BOW;
	};
	CHECK(integral(bows, 1.0) == test::near(1.0).epsilon(1e-3));
	const auto detours = [](double detour) {
		Stroke winding = straight(0.2);
		winding.path_m = (1.0 + detour) * 0.2;
		return std::exp(evidence(winding).detour) * other_detour(detour);
	};
	CHECK(integral(detours, 10.0) == test::near(1.0).epsilon(1e-3));
	const auto unrest = [](double amplitudes) {
		Stroke stroke = straight(0.2);
		stroke.motion_before_m = 0.2 * amplitudes;
		const double deviation = std::hypot(0.07 + 0.002 / 0.2, 1.5 * 0.5);
		const double z = amplitudes / deviation;
		return std::exp(evidence(stroke).rest - 0.5 * z * z) * std::sqrt(2.0 / std::numbers::pi) / deviation;
	};
	CHECK(integral(unrest, 10.0) == test::near(1.0).epsilon(1e-3));
}

TEST_CASE("evidence grows with the tracked rest before a stroke") {
	const auto rest = [](double tracked_before_s) {
		Stroke stroke = straight(0.2);
		stroke.tracked_before_s = tracked_before_s;
		return evidence(stroke).rest;
	};
	CHECK(rest(0.0) < -std::log(3.0));
	for (const double tracked_before_s : { 0.1, 0.2, 0.3, 0.4, 0.5 }) {
		CAPTURE(tracked_before_s);
		CHECK(rest(tracked_before_s) > rest(tracked_before_s - 0.1) + 0.3);
	}
	CHECK(rest(0.5) > std::log(5.0));
}

TEST_CASE("a stroke of length 0, infinite length or no duration is rejected") {
	CHECK(evidence(straight(0.0)).sum() < -100.0);
	CHECK(evidence(straight(INFINITY)).sum() < -100.0);
	Stroke instant = straight(0.2);
	instant.now_s = instant.onset_s;
	CHECK(evidence(instant).sum() < -100.0);
	Stroke endless = straight(0.2);
	endless.path_m = 1e9;
	CHECK(std::isfinite(evidence(endless).sum()));
	CHECK(evidence(endless).sum() < -100.0);
}

TEST_CASE("the direction density has mean 1 over the sphere") {
	for (const double width : { 0.35, 0.42, 0.8, 1.2, 1.6 }) {
		CAPTURE(width);
		// Even over the sphere: the cosine is (Archimedes).
		constexpr int STEPS = 100000;
		double sum = 0.0;
		for (int i = 0; i < STEPS; ++i) {
			const double cosine = -1.0 + 2.0 * (i + 0.5) / STEPS;
			sum += std::exp(log_direction_ratio(std::sqrt(2.0 - 2.0 * cosine), width));
		}
		CHECK(sum / STEPS == test::near(1.0).epsilon(0.01));
	}
}

TEST_CASE("a density as wide as the sphere favours no direction") {
	CHECK(log_direction_ratio(0.0, 1e3) == 0.0);
	CHECK(log_direction_ratio(2.0, 1e3) == test::near(0.0).epsilon(1e-9));
}
