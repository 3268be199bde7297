// The reference curve from recordings, and its motion elements.

#include "gesture/motion_elements.h"
#include "gesture/reference_curve.h"
#include "minimum_jerk_drag.h"
#include "near.h"
#include "signal/minimum_jerk.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace steadyhand;

namespace {

constexpr double NEVER = -std::numeric_limits<double>::infinity();

RecordedCurve recorded(const std::function<double(double)> &x_m, double from_s, double to_s) {
	RecordedCurve curve;
	for (int i = 0; from_s + i / 240.0 <= to_s; ++i) {
		curve.t_s.push_back(from_s + i / 240.0);
		curve.x_m.push_back(x_m(curve.t_s.back()));
	}
	return curve;
}

/// State k emits symbol k only. No earlier state may follow it.
GestureModel model_of_states(Eigen::Index states) {
	GestureModel model;
	model.hmm.log_pi = Eigen::VectorXd::Constant(states, NEVER);
	model.hmm.log_pi(0) = 0.0;
	model.hmm.log_a = Eigen::MatrixXd::Constant(states, states, NEVER);
	model.hmm.log_b = Eigen::MatrixXd::Constant(states, states, NEVER);
	for (Eigen::Index i = 0; i < states; ++i) {
		model.hmm.log_a.row(i).tail(states - i).setConstant(-std::log(states - i));
		model.hmm.log_b(i, i) = 0.0;
	}
	model.reference_mean.resize(CURVE_POINTS);
	model.reference_deviation = Eigen::VectorXd::LinSpaced(CURVE_POINTS, 0.0, 1.0);
	for (Eigen::Index k = 0; k < CURVE_POINTS; ++k) {
		model.reference_mean(k) = minimum_jerk(static_cast<double>(k) / (CURVE_POINTS - 1)).value;
	}
	return model;
}

SymbolSequence runs(const std::vector<std::size_t> &lengths) {
	SymbolSequence sequence;
	for (std::size_t k = 0; k < lengths.size(); ++k) {
		sequence.insert(sequence.end(), lengths[k], static_cast<Symbol>(k));
	}
	return sequence;
}

} // namespace

TEST_CASE("a movement's onset does not depend on direction, size or position") {
	const test::Drag drag{ .onset_s = 0.6, .duration_s = 1.0, .amplitude_m = 0.2 };
	const auto span = [&](double factor, double offset_m) {
		return movement_span(
				recorded([&](double t_s) { return offset_m + factor * drag.x_m(t_s); }, 0.0, 2.0), 0.3, 1.6);
	};
	const double onset_s = span(1.0, 0.0).onset_s;
	CHECK(onset_s == test::near(0.6594).epsilon(0.01));
	for (const double factor : { -1.0, 0.01, -7.0 }) {
		CHECK(span(factor, 0.0).onset_s == onset_s);
		CHECK(span(factor, 5.0).onset_s == onset_s);
	}
	CHECK(span(0.0, 1.0).onset_s == 0.3);
	const auto still = recorded([](double) { return 1.0; }, 0.0, 2.0);
	CHECK(normalised_curve(still, { 0.3, 1.6 }).isZero(0.0));
}

TEST_CASE("a movement begins at the last rest before its half") {
	const test::Drag first{ .onset_s = 0.5, .duration_s = 0.6, .amplitude_m = 1.0 },
			second{ .onset_s = 1.5, .duration_s = 0.6, .amplitude_m = 1.0 };
	const auto onset_s = [&](double share) {
		const auto x_m = [&](double t_s) { return share * first.x_m(t_s) + (1.0 - share) * second.x_m(t_s); };
		return movement_span(recorded(x_m, 0.0, 2.5), 0.2, 2.1).onset_s;
	};
	CHECK(onset_s(0.7) == test::near(0.5 + 0.6 * 0.0594).epsilon(0.02));
	CHECK(onset_s(0.3) == test::near(1.5 + 0.6 * 0.0594).epsilon(0.02));
}

TEST_CASE("a recording is constant before its first and after its last sample") {
	const auto ramp = recorded([](double t_s) { return 3.0 + t_s; }, 1.0, 2.0);
	const Eigen::VectorXd curve = normalised_curve(ramp, { 0.5, 2.5 });
	for (Eigen::Index i = 0; i < CURVE_POINTS; ++i) {
		const double t_s = 0.5 + 2.0 * static_cast<double>(i) / (CURVE_POINTS - 1);
		CHECK(curve(i) == test::near(std::clamp(t_s - 1.0, 0.0, 1.0)).epsilon(1e-9));
	}
}

TEST_CASE("the reference has the mean and standard deviation of the kept curves") {
	const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(CURVE_POINTS, 0.0, 1.0);
	const std::vector<Eigen::VectorXd> curves{ 0.8 * ramp, 0.9 * ramp, 1.3 * ramp };
	const ReferenceCurve reference = reference_curve(curves, 0.0);
	CHECK((reference.mean - ramp).cwiseAbs().maxCoeff() < 1e-12);
	// sqrt((0.2^2 + 0.1^2 + 0.3^2) / 2)
	CHECK((reference.deviation - std::sqrt(0.07) * ramp).cwiseAbs().maxCoeff() < 1e-12);
	const ReferenceCurve one = reference_curve(std::span(curves).first(1), 0.9);
	CHECK(one.deviation.isZero(0.0));
	CHECK(one.mean == curves[0]);

	// No curve is near the mean: the nearest one is kept.
	const std::vector<Eigen::VectorXd> unlike{ ramp, -ramp, 0.0 * ramp, 0.1 * ramp };
	const ReferenceCurve best = reference_curve(unlike, 0.999);
	CHECK(std::count(best.kept.begin(), best.kept.end(), true) == 1);
	// A constant curve has no R^2. The mean is 0.025 s.
	CHECK(best.r2[2] == 0.0);
	const double square = ramp.squaredNorm(), variance = (ramp.array() - 0.5).square().sum();
	CHECK(best.r2[0] == test::near(1.0 - 0.975 * 0.975 * square / variance));
	CHECK(best.r2[3] == test::near(1.0 - 0.075 * 0.075 * square / (0.01 * variance)));
}

TEST_CASE("motion elements divide the curve as states divide the recordings") {
	GestureModel model = model_of_states(3);
	model.duration_mean_s = 1.5;
	const std::vector<SymbolSequence> sequences{ runs({ 2, 3, 5 }), {}, runs({ 8, 4, 8 }) };
	const std::array durations_s{ 1.0, 9.0, 2.0 };
	cut_into_elements(sequences, durations_s, 5, model);
	REQUIRE(model.elements.size() == 3);
	const std::array ends{ 0.3, 0.55, 1.0 };       // means of 0.2 and 0.4, 0.3 and 0.2
	const std::array in_first_s{ 0.2, 0.3, 0.5 };  // of 1 s
	const std::array in_second_s{ 0.8, 0.4, 0.8 }; // of 2 s
	const std::array points{ 0.15, 0.43, 0.775 };  // the mean of those within, both ends included
	for (std::size_t i = 0; i < ends.size(); ++i) {
		CAPTURE(i);
		const PrimitiveMotionElement &element = model.elements[i];
		CHECK(element.phase_begin == test::near(i > 0 ? ends[i - 1] : 0.0));
		CHECK(element.phase_end == test::near(ends[i]));
		const double mean_s = 0.5 * (in_first_s[i] + in_second_s[i]);
		CHECK(element.duration_mean_s == test::near(mean_s));
		CHECK(element.duration_deviation_s ==
				test::near(std::sqrt(0.5) * std::abs(in_second_s[i] - in_first_s[i])));
		CHECK(std::abs(element.deviation - points[i]) < 0.006); // a point at the end may round either way
	}
	// The elements have degree 5, as the reference: the fit is exact.
	for (int percent = 0; percent <= 100; ++percent) {
		const Polynomial::Point point = minimum_jerk(0.01 * percent);
		const CurvePoint played = evaluate(model, 0.01 * percent);
		CHECK(std::abs(played.value - point.value) < 1e-9);
		CHECK(std::abs(played.slope - point.first) < 1e-8);
		CHECK(std::abs(played.curvature - point.second) < 1e-6);
	}
}

TEST_CASE("a state that the recordings skip has a motion element") {
	GestureModel model = model_of_states(4);
	model.duration_mean_s = 2.0;
	cut_into_elements(std::vector<SymbolSequence>{ runs({ 5, 0, 5, 10 }) }, std::array{ 2.0 }, 5, model);
	REQUIRE(model.elements.size() == 4);
	const double smallest = 2.0 / (CURVE_POINTS - 1), total = 1.0 + smallest;
	const PrimitiveMotionElement &skipped = model.elements[1];
	CHECK(skipped.phase_begin == test::near(0.25 / total));
	CHECK(skipped.phase_end - skipped.phase_begin == test::near(smallest / total));
	CHECK(skipped.duration_mean_s == test::near(smallest * 2.0));
	CHECK(model.elements[3].phase_begin == test::near((0.5 + smallest) / total));
	CHECK(model.elements[3].phase_end == 1.0);
}

TEST_CASE("odd recordings and many states give no overshooting motion element") {
	std::mt19937_64 random(7);
	std::normal_distribution<double> odd(0.0, 0.15);
	int lowered = 0;
	for (int round = 0; round < 40; ++round) {
		CAPTURE(round);
		GestureModel model = model_of_states(15);
		model.duration_mean_s = 1.0;
		for (double &value : model.reference_mean) {
			value += odd(random);
		}
		std::vector<std::size_t> shares(15);
		for (std::size_t &share : shares) {
			share = 1 + random() % 12;
		}
		const std::size_t degree =
				cut_into_elements(std::vector<SymbolSequence>{ runs(shares) }, std::array{ 1.0 }, 5, model);
		lowered += degree < 5 ? 1 : 0;
		for (const PrimitiveMotionElement &element : model.elements) {
			double lowest = INFINITY, highest = -INFINITY;
			for (Eigen::Index k = 0; k < CURVE_POINTS; ++k) {
				const double phase = static_cast<double>(k) / (CURVE_POINTS - 1);
				if (phase > element.phase_begin - 0.0101 && phase < element.phase_end + 0.0101) {
					lowest = std::min(lowest, model.reference_mean(k));
					highest = std::max(highest, model.reference_mean(k));
				}
			}
			for (int i = 0; i <= 100; ++i) {
				REQUIRE(element.curve.value(0.01 * i) > std::min(lowest, 0.0) - 0.1);
				REQUIRE(element.curve.value(0.01 * i) < std::max(highest, 1.0) + 0.1);
			}
		}
	}
	CHECK(lowered > 0);
}

TEST_CASE("motion elements of low degree join, from 0 at rest to 1") {
	GestureModel model = model_of_states(3);
	model.duration_mean_s = 1.0;
	cut_into_elements(std::vector<SymbolSequence>{ runs({ 4, 3, 3 }) }, std::array{ 1.0 }, 1, model);
	CHECK(evaluate(model, 0.0).value == test::near(0.0));
	CHECK(evaluate(model, 0.0).slope == test::near(0.0));
	CHECK(evaluate(model, 1.0).value == test::near(1.0));
	for (const std::size_t i : { 0U, 1U }) {
		const double joint = model.elements[i].phase_end;
		// Lines through the reference that do not meet.
		const auto line = [&](double from, double to) {
			std::vector<double> s, y;
			for (Eigen::Index k = 0; k < CURVE_POINTS; ++k) {
				const double phase = static_cast<double>(k) / (CURVE_POINTS - 1);
				if (phase >= from - 1e-12 && phase <= to + 1e-12) {
					s.push_back(phase);
					y.push_back(model.reference_mean(k));
				}
			}
			const auto n = static_cast<double>(s.size());
			double sum_s = 0.0, sum_y = 0.0, sum_ss = 0.0, sum_sy = 0.0;
			for (std::size_t k = 0; k < s.size(); ++k) {
				sum_s += s[k];
				sum_y += y[k];
				sum_ss += s[k] * s[k];
				sum_sy += s[k] * y[k];
			}
			const double slope = (n * sum_sy - sum_s * sum_y) / (n * sum_ss - sum_s * sum_s);
			return CurvePoint{ (sum_y - slope * sum_s) / n + slope * joint, slope, 0.0 };
		};
		const CurvePoint left = line(model.elements[i].phase_begin, joint),
						 right = line(joint, model.elements[i + 1].phase_end);
		for (const double at : { joint - 1e-9, joint + 1e-9 }) {
			const CurvePoint met = evaluate(model, at);
			CHECK(met.value == test::near(0.5 * (left.value + right.value)).epsilon(1e-6));
			CHECK(met.slope == test::near(0.5 * (left.slope + right.slope)).epsilon(1e-6));
		}
	}
}
