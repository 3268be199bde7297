#include "phase/fault_evidence.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// As in phase_estimator.cpp.
/// A fault's likelihood where the tracker is right, against it erring.
constexpr double FAULT_LOG_RATIO = 6.0;
/// Of a tracker that errs, at the end of the way: to see none speaks against it.
constexpr double FAULTS_PER_S = 2.4;
/// The same of one that errs half-way: to show a hand as standing that goes on.
constexpr double STANDS_PER_S = 30.0;

} // namespace

void count_fault(HypothesisBank &r_bank, double t_s, double fault, bool is_jump) {
	if (fault == 0.0) {
		return;
	}
	const auto is_judged = [&](std::size_t i) {
		return r_bank.on_its_way(i) &&
				(!r_bank.is_over(i, t_s) || (is_jump && r_bank.regime(i) != Regime::FREE));
	};
	double before = 0.0, after = 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		if (is_judged(i)) {
			before += std::exp(r_bank.log_weight(i));
			r_bank.weigh(i, r_bank.regime(i) == Regime::UNSOUND ? 0.0 : -FAULT_LOG_RATIO * fault);
			after += std::exp(r_bank.log_weight(i));
		}
	}
	const double kept = after > 0.0 ? std::log(after / before) : 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		r_bank.weigh(i, is_judged(i) ? 0.0 : kept);
	}
}

void count_errorless(HypothesisBank &r_bank, double t_s, double dt_s, double x, bool is_standing) {
	const double no_fault = FAULTS_PER_S * dt_s * std::clamp(x, 0.0, 1.0);
	const double standing = is_standing ? STANDS_PER_S * dt_s : 0.0;
	for (std::size_t i = 1; i < r_bank.size(); ++i) {
		if (r_bank.regime(i) == Regime::UNSOUND) {
			r_bank.weigh(i, -no_fault - (r_bank.is_over(i, t_s) ? 0.0 : standing));
		}
	}
}

} // namespace steadyhand
