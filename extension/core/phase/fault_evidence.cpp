#include "phase/fault_evidence.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace steadyhand {
namespace {

// As in phase_estimator.cpp.
/// A fault's likelihood where the tracker is right, against it erring.
constexpr double FAULT_LOG_RATIO = 6.0;
/// Trackers lose hands as often as is in proportion to their speed and this, amplitudes a second,
constexpr double STILL_PER_S = 0.3;
/// and a hand at rest so much less often, in nats, than those that have begun.
constexpr double AT_REST_LOG_RATIO = 0.5;
/// Of a tracker that errs, at the end of the way: to see none speaks against it.
constexpr double FAULTS_PER_S = 2.4;
/// The same of one that shows a hand as staying which has gone on, for each amplitude that it has gone
/// further
constexpr double STAYS_PER_S = 300.0;
constexpr double STAYS_TO = 0.1;      ///< than this,
constexpr double STAYS_LATE_S = 0.05; ///< so long ago: trackers that err are late

/// How far it has come, 0..1, near enough.
double way_at(const HypothesisGroup::Course &course, double t_s) {
	return minimum_jerk((t_s - course.onset_s) * course.rate_per_s).value;
}

/// Logarithm of how often trackers lose a hand that is on its way like that, against one that goes an
/// amplitude a second.
double log_losses(const HypothesisGroup::Course &course, double lost_s) {
	const double per_phase = minimum_jerk((lost_s - course.onset_s) * course.rate_per_s).first;
	return std::log((STILL_PER_S + per_phase * course.rate_per_s) / (STILL_PER_S + 1.0));
}

/// Of those that are judged; the others keep their share against them.
template <typename IsJudged, typename LogLikelihood>
void weigh(HypothesisBank &r_bank, IsJudged is_judged, LogLikelihood log_likelihood) {
	double before = 0.0, after = 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		if (is_judged(i)) {
			before += std::exp(r_bank.log_weight(i));
			r_bank.weigh(i, log_likelihood(i));
			after += std::exp(r_bank.log_weight(i));
		}
	}
	const double kept = after > 0.0 ? std::log(after / before) : 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		r_bank.weigh(i, is_judged(i) ? 0.0 : kept);
	}
}

/// log_ratio: against a tracker that is right.
void weigh_erring(HypothesisBank &r_bank, double t_s, double log_ratio, bool is_jump) {
	if (log_ratio == 0.0) {
		return;
	}
	std::array<bool, HypothesisBank::CAPACITY> is_judged;
	double right = 0.0, erring = 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		const bool errs = r_bank.regime(i) == Regime::UNSOUND;
		is_judged[i] = r_bank.on_its_way(i) &&
				(!r_bank.is_over(i, t_s) || (is_jump && r_bank.regime(i) != Regime::FREE));
		if (is_judged[i]) {
			(errs ? erring : right) += std::exp(r_bank.log_weight(i));
		}
	}
	const double before = right + erring, after = right * std::exp(-log_ratio) + erring;
	const double kept = after > 0.0 ? std::log(after / before) : 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		const double judged = r_bank.regime(i) == Regime::UNSOUND ? 0.0 : -log_ratio;
		r_bank.weigh(i, is_judged[i] ? judged : kept);
	}
}

} // namespace

void count_loss(HypothesisBank &r_bank, double t_s, double lost_s, double loss) {
	if (loss == 0.0) {
		return;
	}
	weigh(
			r_bank,
			[&](std::size_t i) {
				return r_bank.on_its_way(i) && r_bank.regime(i) != Regime::FREE && !r_bank.is_over(i, t_s);
			},
			[&](std::size_t i) { return loss * log_losses(r_bank.course(i), lost_s); });
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		if (r_bank.regime(i) == Regime::REST) {
			r_bank.weigh(i, -AT_REST_LOG_RATIO * loss);
		}
	}
}

void count_fault(HypothesisBank &r_bank, double t_s, double fault, bool is_jump) {
	weigh_erring(r_bank, t_s, FAULT_LOG_RATIO * fault, is_jump);
}

void count_erring(HypothesisBank &r_bank, double t_s, double log_ratio) {
	weigh_erring(r_bank, t_s, log_ratio, false);
}

void count_errorless(HypothesisBank &r_bank, double dt_s, double x) {
	const double no_fault = FAULTS_PER_S * dt_s * std::clamp(x, 0.0, 1.0);
	for (std::size_t i = 1; i < r_bank.size(); ++i) {
		if (r_bank.regime(i) == Regime::UNSOUND) {
			r_bank.weigh(i, -no_fault);
		}
	}
}

void count_stay(HypothesisBank &r_bank, double t_s, double dt_s, double since_s) {
	for (std::size_t i = 1; i < r_bank.size(); ++i) {
		if (r_bank.regime(i) == Regime::UNSOUND) {
			const HypothesisGroup::Course course = r_bank.course(i);
			const double gone = way_at(course, t_s - STAYS_LATE_S) - way_at(course, since_s);
			r_bank.weigh(i, -STAYS_PER_S * dt_s * std::max(gone - STAYS_TO, 0.0));
		}
	}
}

} // namespace steadyhand
