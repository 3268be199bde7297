#include "gesture/motion_elements.h"

#include "gesture/reference_curve.h"
#include "gesture/task.h"
#include "hmm/viterbi.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steadyhand {
namespace {

/// Value and slope (per phase) at one end of an element.
struct End {
	double value = 0.0;
	double slope = 0.0;
};

/// Adds the cubic that changes value and slope at an element's ends by these (Hermite basis on [0, 1]).
void move_ends(const End &begin, const End &end, PrimitiveMotionElement &r_element) {
	const double length = r_element.phase_end - r_element.phase_begin;
	const double m0 = begin.slope * length, m1 = end.slope * length;
	auto &c = r_element.curve.coefficients;
	c[0] += begin.value;
	c[1] += m0;
	c[2] += 3.0 * (end.value - begin.value) - 2.0 * m0 - m1;
	c[3] += 2.0 * (begin.value - end.value) + m0 + m1;
}

/// The slope with the smaller magnitude; 0 if the signs differ. Lines joined with it have no overshoot.
double gentler(double a, double b) {
	return a * b > 0.0 ? std::copysign(std::min(std::abs(a), std::abs(b)), a) : 0.0;
}

/// Joins pieces that were fitted separately. At a joint, value and slope become the mean of both pieces, or
/// the slope becomes the gentler one.
void join(std::vector<PrimitiveMotionElement> &r_elements, bool is_gentle) {
	const auto at = [](const PrimitiveMotionElement &element, double s) {
		const Polynomial::Point point = element.curve.evaluate(s);
		return End{ point.value, point.first / (element.phase_end - element.phase_begin) };
	};
	std::vector<End> joints{ { 0.0, 0.0 } };
	for (std::size_t i = 0; i + 1 < r_elements.size(); ++i) {
		const End left = at(r_elements[i], 1.0), right = at(r_elements[i + 1], 0.0);
		const double slope = is_gentle ? gentler(left.slope, right.slope) : 0.5 * (left.slope + right.slope);
		joints.push_back({ 0.5 * (left.value + right.value), slope });
	}
	joints.push_back({ 1.0, at(r_elements.back(), 1.0).slope });
	for (std::size_t i = 0; i < r_elements.size(); ++i) {
		const End begin = at(r_elements[i], 0.0), end = at(r_elements[i], 1.0);
		move_ends({ joints[i].value - begin.value, joints[i].slope - begin.slope },
				{ joints[i + 1].value - end.value, joints[i + 1].slope - end.slope }, r_elements[i]);
	}
}

/// A curve may leave the range of its piece by this much: the tolerance of a gesture's end.
constexpr double NEAR = 1.0 - END_LEVEL;

/// Whether the curve stays within NEAR of the reference's range in the element, with the neighbouring points.
/// reference: CURVE_POINTS values.
bool stays_near(const PrimitiveMotionElement &element, const Eigen::VectorXd &reference) {
	constexpr double LAST = static_cast<double>(CURVE_POINTS - 1);
	constexpr int PARTS = 200;
	const auto first = static_cast<Eigen::Index>(std::floor(element.phase_begin * LAST));
	const auto last = static_cast<Eigen::Index>(std::ceil(std::min(element.phase_end, 1.0) * LAST));
	const auto points = reference.segment(first, last - first + 1);
	const double lowest = points.minCoeff() - NEAR, highest = points.maxCoeff() + NEAR;
	for (int i = 0; i <= PARTS; ++i) {
		const double value = element.curve.value(static_cast<double>(i) / PARTS);
		const bool is_within = value >= lowest && value <= highest; // false for NaN
		if (!is_within) {
			return false;
		}
	}
	return true;
}

/// Polynomial fit of the reference within the element, over the element's own time.
Polynomial fitted(
		const PrimitiveMotionElement &element, const Eigen::VectorXd &reference, std::size_t degree) {
	std::vector<double> s, y;
	for (Eigen::Index k = 0; k < CURVE_POINTS; ++k) {
		const double at = static_cast<double>(k) / static_cast<double>(CURVE_POINTS - 1);
		const double local = (at - element.phase_begin) / (element.phase_end - element.phase_begin);
		if (local >= 0.0 && local <= 1.0) {
			s.push_back(local);
			y.push_back(reference(k));
		}
	}
	return fit_polynomial(s, y, degree).polynomial;
}

/// The straight line between the reference's values at the element's ends.
Polynomial chord(const PrimitiveMotionElement &element, const Eigen::VectorXd &reference) {
	const auto at = [&](double phase) {
		const double place = phase * static_cast<double>(CURVE_POINTS - 1);
		const auto before = std::min(static_cast<Eigen::Index>(place), CURVE_POINTS - 2);
		const double share = place - static_cast<double>(before);
		return (1.0 - share) * reference(before) + share * reference(before + 1);
	};
	Polynomial line;
	line.coefficients[0] = at(element.phase_begin);
	line.coefficients[1] = at(element.phase_end) - line.coefficients[0];
	return line;
}

/// Fits all elements with the highest degree at which all stay near their pieces, and returns it. If lines do
/// not, the elements become chords with gentle joints, which are monotone between their ends (Fritsch,
/// Carlson 1980, doi:10.1137/0717021); the result is 0.
std::size_t fit_curves(const Eigen::VectorXd &reference, std::size_t degree,
		std::vector<PrimitiveMotionElement> &r_elements) {
	const auto all_stay_near = [&] {
		return std::all_of(r_elements.begin(), r_elements.end(),
				[&](const PrimitiveMotionElement &element) { return stays_near(element, reference); });
	};
	for (; degree > 0; --degree) {
		for (PrimitiveMotionElement &element : r_elements) {
			element.curve = fitted(element, reference, degree);
		}
		join(r_elements, false);
		if (all_stay_near()) {
			return degree;
		}
	}
	for (PrimitiveMotionElement &element : r_elements) {
		element.curve = chord(element, reference);
	}
	join(r_elements, true);
	return 0;
}

} // namespace

MeanAndDeviation mean_and_deviation(std::span<const double> values) {
	const Eigen::Map<const Eigen::VectorXd> v(values.data(), static_cast<Eigen::Index>(values.size()));
	const double n = static_cast<double>(values.size());
	const double mean = n > 0.0 ? v.mean() : 0.0;
	return { mean, n > 1.0 ? std::sqrt((v.array() - mean).square().sum() / (n - 1.0)) : 0.0 };
}

std::size_t cut_into_elements(std::span<const SymbolSequence> sequences, std::span<const double> durations_s,
		std::size_t degree, GestureModel &r_model) {
	const auto states = static_cast<std::size_t>(r_model.hmm.states());
	std::vector<std::vector<double>> state_s(states);
	std::vector<double> share(states, 0.0);
	double aligned = 0.0;
	for (std::size_t r = 0; r < sequences.size(); ++r) {
		if (sequences[r].empty()) {
			continue; // the movement is shorter than one period of the symbol clock
		}
		const ViterbiPath path = viterbi(r_model.hmm, sequences[r]);
		aligned += 1.0;
		std::vector<double> frames(states, 0.0);
		for (const int state : path.states) {
			frames[static_cast<std::size_t>(state)] += 1.0;
		}
		for (std::size_t i = 0; i < states; ++i) {
			const double part = frames[i] / static_cast<double>(path.states.size());
			share[i] += part;
			state_s[i].push_back(part * durations_s[r]);
		}
	}

	// A state that no best path visits still needs at least two points of the curve.
	constexpr double SMALLEST = 2.0 / static_cast<double>(CURVE_POINTS - 1);
	double total = 0.0;
	for (double &part : share) {
		part = std::max(part / std::max(aligned, 1.0), SMALLEST);
		total += part;
	}
	double phase = 0.0;
	for (std::size_t i = 0; i < states; ++i) {
		PrimitiveMotionElement element;
		element.phase_begin = phase;
		element.phase_end = i + 1 < states ? phase + share[i] / total : 1.0;
		const MeanAndDeviation duration = mean_and_deviation(state_s[i]);
		element.duration_mean_s = std::max(duration.mean, SMALLEST * r_model.duration_mean_s);
		element.duration_deviation_s = duration.deviation;

		double deviation_sum = 0.0;
		int points = 0;
		for (Eigen::Index k = 0; k < CURVE_POINTS; ++k) {
			const double at = static_cast<double>(k) / static_cast<double>(CURVE_POINTS - 1);
			const double local = (at - element.phase_begin) / (element.phase_end - element.phase_begin);
			if (local >= 0.0 && local <= 1.0) {
				deviation_sum += r_model.reference_deviation(k);
				++points;
			}
		}
		element.deviation = points == 0 ? 0.0 : deviation_sum / points;
		phase = element.phase_end;
		r_model.elements.push_back(element);
	}
	return fit_curves(r_model.reference_mean, degree, r_model.elements);
}

} // namespace steadyhand
