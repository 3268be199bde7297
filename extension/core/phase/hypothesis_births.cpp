#include "phase/hypothesis_births.h"

#include "signal/minimum_jerk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steadyhand {
namespace {

// As in phase_estimator.cpp.
/// Durations are log-normal about the model's mean, never narrower than this: people differ from recordings.
constexpr double SMALLEST_SPREAD = 0.5;
constexpr double WIDEST = 2.2; ///< the durations cover +- so many deviations

constexpr double ONSETS_PER_S = 2.8; ///< how soon a hand at rest begins
constexpr double FREED_PER_S = 0.02; ///< how soon a hand does something else
constexpr double LEAVES_PER_S = 1.0; ///< how soon one that has made the gesture leaves its end
constexpr double STANDS_PER_S = 2.0; ///< how soon a hand stands
constexpr double STANDS_FROM = 0.08; ///< where one has stayed for STAYS_S, else from NEAR_START on
constexpr double STAYS_S = 0.3;
constexpr double STANDS_TO = 0.7;      ///< one that is shown further may be about to come to the end,
constexpr double STANDS_BEYOND = 1.1;  ///< and one so much further is not, where any length may come
constexpr double SLOW_PER_S = 0.85;    ///< slower than this, as a tracker that wanders shows it
constexpr double AT_REST_PER_S = 2.0;  ///< how soon one that is free is at rest where it started
constexpr double STANDS_AT_REST = 0.5; ///< probability that one which stands as near is
constexpr double ENDED_PER_S = 2.0;    ///< how soon one that is at the end has made the gesture
constexpr double ENDED_PHASE = 2.0;    ///< over for long
constexpr double LONGEST_S = 8.0;      ///< that a hand which was not seen may have been free
constexpr double UNSOUND_PRIOR = 0.2;  ///< of the regime UNSOUND where nothing wrong has been seen
constexpr double SEED_SPREAD = 0.2;    ///< of the onset, in durations
constexpr double UNSEEN_PHASE = 0.12;  ///< up to this a movement looks like rest
constexpr double SEEN_S = 0.096;       ///< how strongly a frame at rest speaks against an earlier onset
/// Of a hand at rest its tracker shakes, and of one that shakes it is calm again, with at least such a
/// probability.
constexpr double SHAKES = 0.003, CALMS = 0.1;
/// Logarithm of the probability that frames at rest before a jump tell nothing, because the tracker trembled
/// about where it had lost the hand.
constexpr double STALE_NEWS = -3.0;
/// And of all that was seen before a jump or a return having been the tracker's error, beside what it speaks
/// for.
constexpr double LED_ASTRAY = -4.0;

/// Of a hand that begins now.
double probability(Regime regime, const TrackingSoundness &soundness) {
	const double odds = UNSOUND_PRIOR / (1.0 - UNSOUND_PRIOR) * std::exp(soundness.log_ratio());
	const double sound = (1.0 - soundness.unsoundness()) / (1.0 + odds);
	return regime == Regime::UNSOUND ? 1.0 - sound : sound;
}

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

/// AT_REST if there is none that is not free.
std::size_t likeliest_on_its_way(const HypothesisBank &bank) {
	return likeliest(
			bank, [&](std::size_t i) { return bank.on_its_way(i) && bank.regime(i) != Regime::FREE; });
}

/// Of the hand, near enough; of one on its way.
double place(const HypothesisBank &bank, std::size_t i, double t_s) {
	const HypothesisGroup::Course course = bank.course(i);
	const double gone = minimum_jerk(course.phase(t_s)).value;
	return course.gain * gone + bank.hand_deviation(i);
}

/// A tracker that is displaced shows a hand at rest elsewhere: gestures begin from the likeliest.
void choose_rest(HypothesisBank &r_bank) {
	for (std::size_t i = 1; i < r_bank.size(); ++i) {
		if (r_bank.regime(i) == Regime::REST &&
				r_bank.log_weight(i) > r_bank.log_weight(HypothesisBank::AT_REST)) {
			r_bank.swap(i, HypothesisBank::AT_REST);
		}
	}
}

/// The tracker of a hand at rest may begin to shake, or be calm again, at any time.
void doubt_calm(HypothesisBank &r_bank) {
	if (r_bank.log_weight(HypothesisBank::AT_REST) == -INFINITY) {
		return;
	}
	const bool shakes = r_bank.error(HypothesisBank::AT_REST) == TrackerError::SHAKING;
	const TrackerError other = shakes ? TrackerError::SLIGHT : TrackerError::SHAKING;
	GestureHypothesis doubted = r_bank.hypothesis(HypothesisBank::AT_REST).before(other);
	doubted.log_weight += std::log(shakes ? CALMS : SHAKES);
	const std::size_t held = likeliest(r_bank,
			[&](std::size_t i) { return r_bank.regime(i) == Regime::REST && r_bank.error(i) == other; });
	if (held == HypothesisBank::AT_REST) {
		r_bank.add(doubted);
	} else if (r_bank.log_weight(held) < doubted.log_weight) {
		r_bank.set(held, doubted);
	}
}

} // namespace

HypothesisBirths::HypothesisBirths(
		const GestureModel &model, const PhaseEffort &effort, double gain_spread, bool knows_end) :
		model_(&model),
		period_s_(effort.branch_period_s), gain_spread_(gain_spread), knows_end_(knows_end),
		durations_(effort.durations) {
	const double relative = model.duration_deviation_s / model.duration_mean_s;
	const double spread = std::max(std::sqrt(std::log1p(relative * relative)), SMALLEST_SPREAD);
	const double centre = std::log(model.duration_mean_s) - 0.5 * spread * spread;
	const double step = 2.0 * WIDEST / static_cast<double>(durations_ - 1);
	log_duration_deviation_ = 0.8 * step * spread;
	double total = 0.0;
	for (std::size_t k = 0; k < durations_; ++k) {
		const double z = step * static_cast<double>(k) - WIDEST;
		log_durations_[k] = centre + spread * z;
		log_prior_[k] = -0.5 * z * z;
		total += std::exp(log_prior_[k]);
	}
	for (double &log_prior : log_prior_) {
		log_prior -= std::log(total);
	}
}

void HypothesisBirths::branch(HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s) const {
	come_to_rest(r_bank, t_s);
	come_to_end(r_bank, t_s);
	choose_rest(r_bank);
	doubt_calm(r_bank);
	set_free(r_bank, t_s);
	begin(r_bank, soundness, t_s);
}

void HypothesisBirths::begin(HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s) const {
	if (std::abs(r_bank.hand_deviation(HypothesisBank::AT_REST)) > NEAR_START) {
		return; // no gesture begins from elsewhere
	}
	const GestureHypothesis at_rest = r_bank.hypothesis(HypothesisBank::AT_REST);
	const double starts = ONSETS_PER_S * period_s_;
	for (const Regime regime : { Regime::SOUND, Regime::UNSOUND }) {
		const double log_probability = std::log(starts * probability(regime, soundness));
		for (std::size_t k = 0; k < durations_; ++k) {
			if (!r_bank.is_hopeless(regime, at_rest.log_weight + log_probability + log_prior_[k])) {
				start(r_bank, at_rest, k, regime, t_s - 0.5 * period_s_, 0.6 * period_s_, log_probability);
			}
		}
	}
	r_bank.weigh(HypothesisBank::AT_REST, std::log1p(-starts));
}

void HypothesisBirths::start(HypothesisBank &r_bank, const GestureHypothesis &at_rest, std::size_t duration,
		Regime regime, double onset_s, double onset_deviation_s, double log_probability) const {
	const GestureHypothesis started = at_rest.begun(regime, onset_s, onset_deviation_s,
			log_durations_[duration], log_duration_deviation_, gain_spread_);
	r_bank.add(started, log_probability + log_prior_[duration]);
}

/// A hand that wandered off and came back is at rest again; so is one that stands as near.
void HypothesisBirths::come_to_rest(HypothesisBank &r_bank, double t_s) const {
	const double log_free = std::log(AT_REST_PER_S * period_s_), log_standing = std::log(STANDS_AT_REST);
	for (std::size_t i = 1; i < r_bank.size(); ++i) {
		const bool stands = r_bank.is_standing(i);
		const double x = stands ? place(r_bank, i, t_s) : r_bank.hand_deviation(i);
		const double log_weight = r_bank.log_weight(i) + (stands ? log_standing : log_free);
		if ((stands || !r_bank.on_its_way(i)) && std::abs(x) < NEAR_START &&
				log_weight > r_bank.log_weight(HypothesisBank::AT_REST)) {
			GestureHypothesis rested =
					stands ? GestureHypothesis::resting(x) : r_bank.hypothesis(i).in(Regime::REST);
			rested.log_weight = log_weight;
			r_bank.set(HypothesisBank::AT_REST, rested);
		}
	}
}

/// A hand that went its own way, in two halves, say, and comes to the end has made the gesture.
void HypothesisBirths::come_to_end(HypothesisBank &r_bank, double t_s) const {
	const std::size_t there = likeliest(r_bank, [&](std::size_t i) {
		return !r_bank.on_its_way(i) && std::abs(r_bank.hand_deviation(i) - 1.0) < AT_END;
	});
	if (there != HypothesisBank::AT_REST) {
		const double log_duration = log_durations_[durations_ / 2];
		r_bank.add(r_bank.hypothesis(there).at_end(t_s - ENDED_PHASE * std::exp(log_duration), log_duration),
				std::log(ENDED_PER_S * period_s_));
	}
}

/// The hand of the likeliest one on its way may do something else from now on.
void HypothesisBirths::set_free(HypothesisBank &r_bank, double t_s) const {
	const std::size_t likeliest = likeliest_on_its_way(r_bank);
	if (r_bank.is_over(likeliest, t_s)) {
		r_bank.add(r_bank.hypothesis(likeliest).leaving_end(), std::log(LEAVES_PER_S * period_s_));
	} else if (likeliest != HypothesisBank::AT_REST) {
		r_bank.add(r_bank.hypothesis(likeliest).in(Regime::FREE), std::log(FREED_PER_S * period_s_));
	}
}

void HypothesisBirths::stand(
		HypothesisBank &r_bank, double t_s, double x, double per_s, double stays_s) const {
	const bool is_half_way = x >= (stays_s > STAYS_S ? STANDS_FROM : NEAR_START) && x <= STANDS_TO;
	const bool may_stand = is_half_way || (knows_end_ ? std::abs(x - 1.0) < AT_END : x >= STANDS_BEYOND);
	if (!may_stand || std::abs(per_s) > SLOW_PER_S) {
		return;
	}
	const std::size_t begun = likeliest(r_bank, [&](std::size_t i) { return r_bank.on_its_way(i); });
	const bool is_news = is_half_way || std::abs(place(r_bank, begun, t_s) - x) > AT_END;
	if (begun != HypothesisBank::AT_REST && is_news) {
		GestureHypothesis standing = GestureHypothesis::standing(x, t_s - ENDED_PHASE); // it took a second
		standing.log_weight = r_bank.log_weight(begun);
		r_bank.add(standing, std::log(STANDS_PER_S * period_s_));
	}
}

void HypothesisBirths::leave_unseen(
		HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s) const {
	const std::size_t likeliest = likeliest_on_its_way(r_bank);
	const double unseen_s = std::min(t_s - soundness.news_s(), LONGEST_S);
	if (r_bank.is_over(likeliest, t_s) && unseen_s > 0.0) {
		r_bank.add(r_bank.hypothesis(likeliest).leaving_end().free_for(unseen_s),
				std::log(-std::expm1(-LEAVES_PER_S * unseen_s)));
	}
}

void HypothesisBirths::rest_anew(HypothesisBank &r_bank, double x) {
	const double log_weight = r_bank.greatest_log_weight() + LED_ASTRAY;
	if (r_bank.log_weight(HypothesisBank::AT_REST) < log_weight) {
		GestureHypothesis at_rest = GestureHypothesis::resting(std::abs(x) < NEAR_START ? x : 0.0);
		at_rest.log_weight = log_weight;
		r_bank.set(HypothesisBank::AT_REST, at_rest);
	}
}

/// Hypotheses that began since the hand was last seen have come as far as x.
void HypothesisBirths::seed(
		HypothesisBank &r_bank, const TrackingSoundness &soundness, double t_s, double x) const {
	if (x < SEEDED_FROM) {
		return;
	}
	const GestureHypothesis at_rest = r_bank.hypothesis(HypothesisBank::AT_REST);
	const double phase = phase_of_value(*model_, x);
	for (std::size_t k = 0; k < durations_; ++k) {
		const double duration_s = std::exp(log_durations_[k]);
		for (const Regime regime : { Regime::SOUND, Regime::UNSOUND }) {
			const double onset_s = t_s - duration_s * phase -
					GestureHypothesis::expected_lag_s(regime, duration_s) * std::min(x, 1.0);
			const double too_early =
					std::max(soundness.news_s() - onset_s - UNSEEN_PHASE * duration_s, 0.0) / SEEN_S;
			const double deviation_s = SEED_SPREAD * duration_s;
			// The mass of a Gaussian of this deviation is sqrt(2 pi) times its height.
			const double starts = ONSETS_PER_S * std::sqrt(2.0 * std::numbers::pi) * deviation_s;
			start(r_bank, at_rest, k, regime, onset_s, deviation_s,
					std::log(starts * probability(regime, soundness)) +
							std::max(-0.5 * too_early * too_early, STALE_NEWS));
		}
	}
}

} // namespace steadyhand
