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
/// Likelihood of a frame off the way where the tracker shakes, in nats, against a single one.
constexpr double LEAP_LOG_RATIO = 2.0;
/// Of a tracker that errs, at the end of the way: to see none speaks against it.
constexpr double FAULTS_PER_S = 2.4;
/// The same of one that shows a hand as staying which has gone on, for each amplitude that it has gone
/// further
constexpr double STAYS_PER_S = 300.0;
constexpr double STAYS_TO = 0.1;      ///< than this,
constexpr double STAYS_LATE_S = 0.05; ///< so long ago: trackers that err are late

/// Of the way, near enough.
Polynomial::Point movement_at(const HypothesisGroup::Course &course, double t_s) {
	return minimum_jerk(course.phase(t_s));
}

/// Logarithm of how often trackers lose a hand that is on its way like that, against one that goes an
/// amplitude a second.
double log_losses(const HypothesisGroup::Course &course, double lost_s) {
	const double per_s = movement_at(course, lost_s).first * course.rate_per_s;
	return std::log((STILL_PER_S + per_s) / (STILL_PER_S + 1.0));
}

struct Likelihood {
	double log, value; ///< value: exp(log)
};

/// Of those that are judged; the others keep their share against them.
template <typename IsJudged, typename LikelihoodOf>
void weigh(HypothesisBank &r_bank, IsJudged is_judged, LikelihoodOf likelihood_of) {
	std::array<bool, HypothesisBank::CAPACITY> judged;
	double before = 0.0, after = 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		judged[i] = is_judged(i);
		if (judged[i]) {
			const Likelihood likelihood = likelihood_of(i);
			const double weight = std::exp(r_bank.log_weight(i));
			before += weight;
			after += weight * likelihood.value;
			r_bank.weigh(i, likelihood.log);
		}
	}
	const double kept = after > 0.0 ? std::log(after / before) : 0.0;
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		r_bank.weigh(i, judged[i] ? 0.0 : kept);
	}
}

/// log_ratio: against a tracker that is right.
void weigh_erring(HypothesisBank &r_bank, double t_s, double log_ratio, bool is_jump) {
	if (log_ratio == 0.0) {
		return;
	}
	const Likelihood right{ -log_ratio, std::exp(-log_ratio) }, erring{ 0.0, 1.0 };
	weigh(
			r_bank,
			[&](std::size_t i) { return r_bank.on_its_way(i) && (is_jump || !r_bank.is_over(i, t_s)); },
			[&](std::size_t i) { return r_bank.regime(i) == Regime::UNSOUND ? erring : right; });
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
			[&](std::size_t i) {
				const double log = loss * log_losses(r_bank.course(i), lost_s);
				return Likelihood{ log, std::exp(log) };
			});
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

void count_leap(HypothesisBank &r_bank) {
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		if (r_bank.error(i) == TrackerError::SHAKING) {
			r_bank.weigh(i, LEAP_LOG_RATIO);
		}
	}
}

void count_errorless(HypothesisBank &r_bank, double dt_s, double x) {
	const double no_fault = FAULTS_PER_S * dt_s * std::clamp(x, 0.0, 1.0);
	for (std::size_t i = 1; i < r_bank.size(); ++i) {
		if (r_bank.regime(i) == Regime::UNSOUND && !r_bank.is_standing(i)) {
			r_bank.weigh(i, -no_fault);
		}
	}
}

void count_stay(HypothesisBank &r_bank, double t_s, double dt_s, double since_s) {
	const double late_s = t_s - STAYS_LATE_S;
	for (std::size_t i = 1; i < r_bank.size() && since_s < late_s; ++i) {
		if (r_bank.regime(i) == Regime::UNSOUND) {
			const HypothesisGroup::Course course = r_bank.course(i);
			const double gone = movement_at(course, late_s).value - movement_at(course, since_s).value;
			r_bank.weigh(i, -STAYS_PER_S * dt_s * std::max(gone - STAYS_TO, 0.0));
		}
	}
}

} // namespace steadyhand
