#include "gesture/motion_elements.h"

#include "gesture/reference_curve.h"
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

/// Adds the cubic that moves an element's ends by these (Hermite's basis on [0, 1]).
void move_ends(const End &begin, const End &end, PrimitiveMotionElement &r_element) {
	const double length = r_element.phase_end - r_element.phase_begin;
	const double m0 = begin.slope * length, m1 = end.slope * length;
	auto &c = r_element.curve.coefficients;
	c[0] += begin.value;
	c[1] += m0;
	c[2] += 3.0 * (end.value - begin.value) - 2.0 * m0 - m1;
	c[3] += 2.0 * (begin.value - end.value) + m0 + m1;
}

/// The pieces are fitted apart; at a joint each moves half of the way.
void join(std::vector<PrimitiveMotionElement> &r_elements) {
	const auto at = [](const PrimitiveMotionElement &element, double s) {
		const Polynomial::Point point = element.curve.evaluate(s);
		return End{ point.value, point.first / (element.phase_end - element.phase_begin) };
	};
	std::vector<End> joints{ { 0.0, 0.0 } };
	for (std::size_t i = 0; i + 1 < r_elements.size(); ++i) {
		const End left = at(r_elements[i], 1.0), right = at(r_elements[i + 1], 0.0);
		joints.push_back({ 0.5 * (left.value + right.value), 0.5 * (left.slope + right.slope) });
	}
	joints.push_back({ 1.0, at(r_elements.back(), 1.0).slope });
	for (std::size_t i = 0; i < r_elements.size(); ++i) {
		const End begin = at(r_elements[i], 0.0), end = at(r_elements[i], 1.0);
		move_ends({ joints[i].value - begin.value, joints[i].slope - begin.slope },
				{ joints[i + 1].value - end.value, joints[i + 1].slope - end.slope }, r_elements[i]);
	}
}

} // namespace

MeanAndDeviation mean_and_deviation(std::span<const double> values) {
	const Eigen::Map<const Eigen::VectorXd> v(values.data(), static_cast<Eigen::Index>(values.size()));
	const double n = static_cast<double>(values.size());
	const double mean = n > 0.0 ? v.mean() : 0.0;
	return { mean, n > 1.0 ? std::sqrt((v.array() - mean).square().sum() / (n - 1.0)) : 0.0 };
}

void cut_into_elements(std::span<const SymbolSequence> sequences, std::span<const double> durations_s,
		std::size_t degree, GestureModel &r_model) {
	const auto states = static_cast<std::size_t>(r_model.hmm.states());
	std::vector<std::vector<double>> state_s(states);
	std::vector<double> share(states, 0.0);
	double aligned = 0.0;
	for (std::size_t r = 0; r < sequences.size(); ++r) {
		if (sequences[r].empty()) {
			continue; // shorter than one period of the symbol clock
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

	// A state that the best paths skip still needs a piece of the curve: at least two points of it.
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

		std::vector<double> s, y;
		double deviation_sum = 0.0;
		for (Eigen::Index k = 0; k < CURVE_POINTS; ++k) {
			const double at = static_cast<double>(k) / static_cast<double>(CURVE_POINTS - 1);
			const double local = (at - element.phase_begin) / (element.phase_end - element.phase_begin);
			if (local >= 0.0 && local <= 1.0) {
				s.push_back(local);
				y.push_back(r_model.reference_mean(k));
				deviation_sum += r_model.reference_deviation(k);
			}
		}
		element.curve = fit_polynomial(s, y, degree).polynomial;
		element.deviation = s.empty() ? 0.0 : deviation_sum / static_cast<double>(s.size());
		phase = element.phase_end;
		r_model.elements.push_back(element);
	}
	join(r_model.elements);
}

} // namespace steadyhand
