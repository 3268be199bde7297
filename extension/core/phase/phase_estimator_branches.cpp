#include "phase/phase_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Which hypotheses branch off, and from which.

namespace steadyhand {
namespace {

// As in phase_estimator.cpp.
constexpr double ONSETS_PER_S = 2.8;  ///< how soon a hand at rest begins
constexpr double FREED_PER_S = 0.02;  ///< how soon a hand does something else
constexpr double LEAVES_PER_S = 1.0;  ///< how soon one that has made the gesture leaves its end
constexpr double AT_REST_PER_S = 2.0; ///< how soon one that did so is at rest where it started
constexpr double ENDED_PER_S = 2.0;   ///< how soon one that is at the end has made the gesture
constexpr double ENDED_PHASE = 2.0;   ///< over for long
constexpr double BLIND_S = 0.05;  ///< without news of the hand nothing branches off: what it begins is seeded
constexpr double LONGEST_S = 8.0; ///< an onset before that no longer matters
constexpr double UNSOUND_PRIOR = 0.16; ///< of the regime UNSOUND where nothing wrong has been seen
constexpr double SEEDED_FROM = 0.08;   ///< nearer to the start than that, a hand at rest explains it as well
constexpr double SEEDED_TO = 0.97;
constexpr double SEED_SPREAD = 0.2;   ///< of the onset, in durations
constexpr double UNSEEN_PHASE = 0.12; ///< up to this a movement looks like rest
constexpr double SEEN_S = 0.096;      ///< how strongly a frame at rest speaks against an earlier onset
/// Logarithm of the probability that frames at rest before a jump tell nothing, because the tracker trembled
/// about where it had lost the hand.
constexpr double STALE_NEWS = -3.0;
/// And of all that was seen before a jump or a return having been the tracker's error, beside what it speaks
/// for.
constexpr double LED_ASTRAY = -4.0;

/// Of the others than the one at rest; AT_REST if there is none.
template <class Predicate> std::size_t likeliest(const HypothesisBank &bank, Predicate is_candidate) {
	std::size_t likeliest = HypothesisBank::AT_REST;
	for (std::size_t i = 1; i < bank.size(); ++i) {
		if (is_candidate(i) &&
				(likeliest == HypothesisBank::AT_REST || bank.log_weight(i) > bank.log_weight(likeliest))) {
			likeliest = i;
		}
	}
	return likeliest;
}

} // namespace

/// All that is due by t_s. What branches off says nothing new of the hand before a frame comes.
void PhaseEstimator::branch_until(double t_s) {
	next_branch_s_ = std::max(next_branch_s_, t_s - LONGEST_S);
	for (; next_branch_s_ <= t_s; next_branch_s_ += effort_.branch_period_s) {
		if (next_branch_s_ - told_s_ <= BLIND_S) {
			branch(next_branch_s_);
		}
	}
}

double PhaseEstimator::probability(Regime regime) const {
	const double unsound = UNSOUND_PRIOR + (1.0 - UNSOUND_PRIOR) * soundness_.unsoundness();
	return regime == Regime::UNSOUND ? unsound : 1.0 - unsound;
}

void PhaseEstimator::branch(double t_s) {
	come_to_rest();
	come_to_end(t_s);
	choose_rest();
	set_free(t_s);
	const GestureHypothesis at_rest = bank_.hypothesis(HypothesisBank::AT_REST);
	const double starts = ONSETS_PER_S * effort_.branch_period_s;
	for (const Regime regime : { Regime::SOUND, Regime::UNSOUND }) {
		const double log_probability = std::log(starts * probability(regime));
		for (std::size_t k = 0; k < effort_.durations; ++k) {
			if (!bank_.is_hopeless(regime, at_rest.log_weight + log_probability + log_prior_[k])) {
				start(at_rest, k, regime, t_s - 0.5 * effort_.branch_period_s, 0.6 * effort_.branch_period_s,
						log_probability);
			}
		}
	}
	bank_.weigh(HypothesisBank::AT_REST, std::log1p(-starts));
	prune();
}

void PhaseEstimator::start(const GestureHypothesis &at_rest, std::size_t duration, Regime regime,
		double onset_s, double onset_deviation_s, double log_probability) {
	const GestureHypothesis started = at_rest.begun(
			regime, onset_s, onset_deviation_s, log_durations_[duration], log_duration_deviation_);
	bank_.add(started, log_probability + log_prior_[duration]);
}

/// A hand that wandered off and came back is at rest again.
void PhaseEstimator::come_to_rest() {
	const double log_probability = std::log(AT_REST_PER_S * effort_.branch_period_s);
	for (std::size_t i = 1; i < bank_.size(); ++i) {
		const double log_weight = bank_.log_weight(i) + log_probability;
		if (!bank_.on_its_way(i) && std::abs(bank_.hand_deviation(i)) < AT_START &&
				log_weight > bank_.log_weight(HypothesisBank::AT_REST)) {
			GestureHypothesis rested = bank_.hypothesis(i).in(Regime::REST);
			rested.log_weight = log_weight;
			bank_.set(HypothesisBank::AT_REST, rested);
		}
	}
}

/// A hand that went its own way, in two halves, say, and comes to the end has made the gesture.
void PhaseEstimator::come_to_end(double t_s) {
	const std::size_t there = likeliest(bank_, [this](std::size_t i) {
		return !bank_.on_its_way(i) && std::abs(bank_.hand_deviation(i) - 1.0) < AT_END;
	});
	if (there != HypothesisBank::AT_REST) {
		const double log_duration = log_durations_[effort_.durations / 2];
		bank_.add(bank_.hypothesis(there).at_end(t_s - ENDED_PHASE * std::exp(log_duration), log_duration),
				std::log(ENDED_PER_S * effort_.branch_period_s));
	}
}

/// AT_REST if there is none that is not free.
std::size_t PhaseEstimator::likeliest_on_its_way() const {
	return likeliest(
			bank_, [this](std::size_t i) { return bank_.on_its_way(i) && bank_.regime(i) != Regime::FREE; });
}

/// The hand of the likeliest one on its way, and the one at rest, may do something else from now on. Where
/// the tracker errs that is less likely to be what is seen, but of a hand that has made the gesture.
void PhaseEstimator::set_free(double t_s) {
	const double sound = 1.0 - soundness_.unsoundness();
	const double log_probability = std::log(
			FREED_PER_S * effort_.branch_period_s * sound * sound + std::numeric_limits<double>::min());
	const std::size_t likeliest = likeliest_on_its_way();
	if (bank_.is_over(likeliest, t_s)) {
		bank_.add(
				bank_.hypothesis(likeliest).leaving_end(), std::log(LEAVES_PER_S * effort_.branch_period_s));
	} else if (likeliest != HypothesisBank::AT_REST) {
		bank_.add(bank_.hypothesis(likeliest).in(Regime::FREE), log_probability);
	}
	if (!bank_.is_hopeless(Regime::FREE, bank_.log_weight(HypothesisBank::AT_REST) + log_probability)) {
		bank_.add(bank_.hypothesis(HypothesisBank::AT_REST).in(Regime::FREE), log_probability);
	}
}

/// A hand that had made the gesture may have left since it was last seen.
void PhaseEstimator::set_free_unseen(double t_s) {
	const std::size_t likeliest = likeliest_on_its_way();
	const double unseen_s = std::min(t_s - soundness_.news_s(), LONGEST_S);
	if (bank_.is_over(likeliest, t_s) && unseen_s > 0.0) {
		bank_.add(bank_.hypothesis(likeliest).leaving_end().free_for(unseen_s),
				std::log(-std::expm1(-LEAVES_PER_S * unseen_s)));
	}
}

/// The tracker may have been astray until now, and the hand at rest: where that had been given up for what
/// the tracker showed, gestures and rest begin with it again.
void PhaseEstimator::rest_anew(double x) {
	const double log_weight = bank_.greatest_log_weight() + LED_ASTRAY;
	if (bank_.log_weight(HypothesisBank::AT_REST) < log_weight) {
		GestureHypothesis at_rest = GestureHypothesis::resting(std::abs(x) < AT_START ? x : 0.0);
		at_rest.log_weight = log_weight;
		bank_.set(HypothesisBank::AT_REST, at_rest);
	}
}

/// Hypotheses that began since the hand was last seen and have come as far as x.
void PhaseEstimator::seed(double t_s, double x) {
	if (x < SEEDED_FROM) {
		return;
	}
	const GestureHypothesis at_rest = bank_.hypothesis(HypothesisBank::AT_REST);
	const double phase = phase_of_value(*model_, std::min(x, SEEDED_TO));
	for (std::size_t k = 0; k < effort_.durations; ++k) {
		const double duration_s = std::exp(log_durations_[k]);
		for (const Regime regime : { Regime::SOUND, Regime::UNSOUND }) {
			const double onset_s = t_s - duration_s * phase - regime_numbers(regime).lag_s * std::min(x, 1.0);
			const double too_early =
					std::max(soundness_.news_s() - onset_s - UNSEEN_PHASE * duration_s, 0.0) / SEEN_S;
			const double deviation_s = SEED_SPREAD * duration_s;
			// The mass of a Gaussian of this deviation is sqrt(2 pi) times its height.
			const double starts = ONSETS_PER_S * std::sqrt(2.0 * std::numbers::pi) * deviation_s;
			start(at_rest, k, regime, onset_s, deviation_s,
					std::log(starts * probability(regime)) +
							std::max(-0.5 * too_early * too_early, STALE_NEWS));
		}
	}
}

/// A tracker that is displaced shows a hand at rest elsewhere: gestures begin from the likeliest.
void PhaseEstimator::choose_rest() {
	for (std::size_t i = 1; i < bank_.size(); ++i) {
		if (bank_.regime(i) == Regime::REST && bank_.error(i) != TrackerError::SLIDING_BACK &&
				bank_.log_weight(i) > bank_.log_weight(HypothesisBank::AT_REST)) {
			bank_.swap(i, HypothesisBank::AT_REST);
		}
	}
}

} // namespace steadyhand
