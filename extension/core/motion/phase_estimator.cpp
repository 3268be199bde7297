#include "motion/phase_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace steadyhand {
namespace {

// Values in amplitudes. Set on synthetic subjects of the tuning population and on other recordings than those
// that are evaluated (docs/method.md).
constexpr double ONSETS_PER_S = 2.8;  ///< how soon a hand at rest begins
constexpr double FREED_PER_S = 0.02;  ///< how soon a hand does something else
constexpr double LEAVES_PER_S = 1.0;  ///< how soon one that has made the gesture leaves its end
constexpr double AT_REST_PER_S = 2.0; ///< how soon one that did so is at rest where it started
constexpr double AT_START = 0.15;     ///< where it started
constexpr double BLIND_S = 0.05;  ///< without news of the hand nothing branches off: what it begins is seeded
constexpr double LONGEST_S = 8.0; ///< an onset before that no longer matters
/// Durations are log-normal about the model's mean, never narrower than this: people differ from recordings.
constexpr double SMALLEST_SPREAD = 0.5;
constexpr double WIDEST = 2.2; ///< the durations cover +- so many deviations

constexpr double UNSOUND_PRIOR = 0.16;     ///< of the regime UNSOUND where nothing wrong has been seen
constexpr double UNSOUND_AT_LEAST = 0.013; ///< and among all on their way, at any time: trackers start to err
constexpr double FREE_AT_LEAST =
		0.0038; ///< the same of FREE while the tracker is right: hands change their minds
constexpr double FAULT_LOG_RATIO =
		6.0; ///< a fault's likelihood where the tracker is right, against it erring

constexpr double FAULTS_PER_S =
		2.4; ///< of a tracker that errs, at the end of the way: to see none speaks against it

constexpr double OUTLIERS = 0.011;
constexpr double DISPLACED = 0.4; ///< probability that a jump leads away from the hand, and not back to it
constexpr double DISPLACED_BY = 0.15; ///< standard deviation
constexpr double LIKELY = 0.001;      ///< weight, from which on both are looked at
/// Errors of frames this close together are alike, and count as one: a power of the likelihood, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
constexpr double ALIKE_S = 0.013;
constexpr double LONGEST_STEP_S = 0.1; ///< a frame after a longer gap counts as one after this

constexpr double SEEDED_FROM = 0.08; ///< nearer to the start than that, a hand at rest explains it as well
constexpr double SEEDED_TO = 0.97;
constexpr double SEED_SPREAD = 0.2;   ///< of the onset, in durations
constexpr double UNSEEN_PHASE = 0.12; ///< up to this a movement looks like rest
constexpr double SEEN_S = 0.096;      ///< how strongly a frame at rest speaks against an earlier onset

/// A tracker that has erred is late as a whole, beside what a hypothesis can see of it.
constexpr double ERRING_LATENCY_S = 0.037;
constexpr double ERRING_SETTLING_S = 0.15;

constexpr double BLEND_RATE_PER_S = 100.0; ///< 1 / 10 ms

} // namespace

PhaseEstimator::PhaseEstimator(const GestureModel &model, const PhaseEffort &effort, double latency_s) :
		model_(&model), effort_(effort), curve_(model), latency_s_(latency_s), bank_(effort) {
	const double relative = model.duration_deviation_s / model.duration_mean_s;
	const double spread = std::max(std::sqrt(std::log1p(relative * relative)), SMALLEST_SPREAD);
	const double centre = std::log(model.duration_mean_s) - 0.5 * spread * spread;
	const double step = 2.0 * WIDEST / static_cast<double>(effort.durations - 1);
	log_duration_deviation_ = 0.6 * step * spread;
	double total = 0.0;
	for (std::size_t k = 0; k < effort_.durations; ++k) {
		const double z = step * static_cast<double>(k) - WIDEST;
		log_durations_[k] = centre + spread * z;
		log_prior_[k] = -0.5 * z * z;
		total += std::exp(log_prior_[k]);
	}
	for (double &log_prior : log_prior_) {
		log_prior -= std::log(total);
	}
}

void PhaseEstimator::begin(double t_s, double d) {
	bank_.start(GestureHypothesis::resting(d));
	seen_s_ = t_s;
	filtered_s_ = t_s;
	look(t_s);
	next_branch_s_ = t_s + effort_.branch_period_s;
}

void PhaseEstimator::restart() {
	if (bank_.empty()) {
		return;
	}
	const PhaseEstimate before = at(filtered_s_), hand = outlook_.at(curve_, filtered_s_);
	begin(filtered_s_, hand.value);
	bank_.add(GestureHypothesis::leaving(hand.value, hand.velocity));
	prune();
	look(filtered_s_);
	blend_from(before, filtered_s_);
}

/// All that is due by t_s. What branches off says nothing new of the hand before a frame comes.
void PhaseEstimator::branch_until(double t_s) {
	next_branch_s_ = std::max(next_branch_s_, t_s - LONGEST_S);
	for (; next_branch_s_ <= t_s; next_branch_s_ += effort_.branch_period_s) {
		if (next_branch_s_ - seen_s_ <= BLIND_S) {
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
	add(started, log_probability + log_prior_[duration]);
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

/// AT_REST if there is none that is not free.
std::size_t PhaseEstimator::likeliest_on_its_way() const {
	std::size_t likeliest = HypothesisBank::AT_REST;
	for (std::size_t i = 1; i < bank_.size(); ++i) {
		if (bank_.on_its_way(i) && bank_.regime(i) != Regime::FREE &&
				(likeliest == HypothesisBank::AT_REST || bank_.log_weight(i) > bank_.log_weight(likeliest))) {
			likeliest = i;
		}
	}
	return likeliest;
}

/// The hand of the likeliest one on its way, and the one at rest, may do something else from now on. Where
/// the tracker errs that is less likely to be what is seen, but of a hand that has made the gesture.
void PhaseEstimator::set_free(double t_s) {
	const double sound = 1.0 - soundness_.unsoundness();
	const double log_probability = std::log(
			FREED_PER_S * effort_.branch_period_s * sound * sound + std::numeric_limits<double>::min());
	const std::size_t likeliest = likeliest_on_its_way();
	if (bank_.is_over(likeliest, t_s)) {
		add(bank_.hypothesis(likeliest).leaving_end(), std::log(LEAVES_PER_S * effort_.branch_period_s));
	} else if (likeliest != HypothesisBank::AT_REST) {
		add(bank_.hypothesis(likeliest).in(Regime::FREE), log_probability);
	}
	if (!bank_.is_hopeless(Regime::FREE, bank_.log_weight(HypothesisBank::AT_REST) + log_probability)) {
		add(bank_.hypothesis(HypothesisBank::AT_REST).in(Regime::FREE), log_probability);
	}
}

/// A hand that had made the gesture may have left since it was last seen.
void PhaseEstimator::set_free_unseen(double t_s) {
	const std::size_t likeliest = likeliest_on_its_way();
	const double unseen_s = std::min(t_s - soundness_.news_s(), LONGEST_S);
	if (bank_.is_over(likeliest, t_s) && unseen_s > 0.0) {
		add(bank_.hypothesis(likeliest).leaving_end().free_for(unseen_s), std::log(LEAVES_PER_S * unseen_s));
	}
}

void PhaseEstimator::add(GestureHypothesis hypothesis, double log_probability) {
	hypothesis.log_weight += log_probability;
	bank_.add(hypothesis);
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
					std::log(starts * probability(regime)) - 0.5 * too_early * too_early);
		}
	}
}

/// A jump is the tracker's: it leads away from where the hand is, or back to it; back to a free hand that is
/// on no way, which could be anywhere and move against any error.
void PhaseEstimator::displace() {
	const std::size_t count = bank_.size();
	for (std::size_t i = 0; i < count; ++i) {
		GestureHypothesis back = bank_.hypothesis(i);
		const bool is_anywhere = bank_.regime(i) == Regime::FREE && !bank_.on_its_way(i);
		if (bank_.weight(i) > LIKELY && !is_anywhere) {
			add(back.displaced(DISPLACED_BY), std::log(DISPLACED));
		}
		back.forget_error();
		back.log_weight += std::log1p(-DISPLACED);
		bank_.set(i, back);
	}
}

/// A tracker that is displaced shows a hand at rest elsewhere: gestures begin from the likeliest.
void PhaseEstimator::choose_rest() {
	for (std::size_t i = 1; i < bank_.size(); ++i) {
		if (bank_.regime(i) == Regime::REST &&
				bank_.log_weight(i) > bank_.log_weight(HypothesisBank::AT_REST)) {
			bank_.swap(i, HypothesisBank::AT_REST);
		}
	}
}

void PhaseEstimator::prune() {
	const double sound = 1.0 - soundness_.unsoundness();
	bank_.prune(filtered_s_, UNSOUND_AT_LEAST, FREE_AT_LEAST * sound * sound);
}

/// A fault speaks against a tracker that is right, and says nothing of whether the hand has begun, or of one
/// that has left the gesture's end: those keep their share.
void PhaseEstimator::count_fault(double fault) {
	if (fault == 0.0) {
		return;
	}
	const auto is_judged = [&](std::size_t i) {
		return bank_.on_its_way(i) && !(bank_.regime(i) == Regime::FREE && bank_.is_over(i, filtered_s_));
	};
	double before = 0.0, after = 0.0;
	for (std::size_t i = 0; i < bank_.size(); ++i) {
		if (is_judged(i)) {
			before += std::exp(bank_.log_weight(i));
			bank_.weigh(i, bank_.regime(i) == Regime::UNSOUND ? 0.0 : -FAULT_LOG_RATIO * fault);
			after += std::exp(bank_.log_weight(i));
		}
	}
	const double kept = after > 0.0 ? std::log(after / before) : 0.0;
	for (std::size_t i = 0; i < bank_.size(); ++i) {
		bank_.weigh(i, is_judged(i) ? 0.0 : kept);
	}
}

void PhaseEstimator::wait(double t_s) {
	const double missing = soundness_.missing(t_s);
	if (bank_.empty() || missing <= missing_) {
		return;
	}
	const PhaseEstimate before = at(t_s);
	count_fault(missing - missing_);
	missing_ = missing;
	prune();
	look(filtered_s_);
	blend_from(before, t_s);
}

void PhaseEstimator::absorb(double t_s, double x) {
	const double dt_s = std::min(std::max(t_s - filtered_s_, 0.0), LONGEST_STEP_S);
	const HypothesisGroup::Trust trust{ OUTLIERS, soundness_.jitter(), dt_s / (dt_s + ALIKE_S) };
	const double step_s = std::max(t_s - filtered_s_, 0.0);
	filtered_s_ = t_s;
	bank_.predict(curve_, t_s, passages(step_s));
	if (soundness_.returned()) {
		set_free_unseen(t_s);
	}
	if (soundness_.jumped()) {
		displace();
	}
	seen_s_ = soundness_.frozen() ? seen_s_ : t_s;
	const double no_fault = FAULTS_PER_S * dt_s * std::clamp(x, 0.0, 1.0);
	if (soundness_.jumped() || soundness_.returned()) {
		seed(t_s, x);
	}
	count_fault(soundness_.fault() - missing_);
	missing_ = 0.0;
	for (std::size_t i = 1; i < bank_.size(); ++i) {
		bank_.weigh(i, bank_.regime(i) == Regime::UNSOUND ? -no_fault : 0.0);
	}
	if (soundness_.told()) {
		bank_.absorb(curve_, t_s, x, trust);
	}
}

void PhaseEstimator::push(double t_s, double x, const FeaturePlace &place) {
	if (bank_.empty()) {
		begin(t_s, x);
	}
	const PhaseEstimate before = at(t_s);
	recall(t_s, x, place);
	look(t_s);
	blend_from(before, t_s);
}

void PhaseEstimator::recall(double t_s, double x, const FeaturePlace &place) {
	if (bank_.empty()) {
		begin(t_s, x);
	}
	branch_until(t_s);
	soundness_.push(t_s, x, place);
	falling_behind_s_ += (ERRING_LATENCY_S * soundness_.lasting_unsoundness() - falling_behind_s_) *
			-std::expm1((filtered_s_ - t_s) / ERRING_SETTLING_S);
	absorb(t_s, x);
	prune();
}

PhaseEstimate PhaseEstimator::at(double t_s) const {
	if (bank_.empty()) {
		return {};
	}
	PhaseEstimate estimate = expected(t_s);
	const CriticallyDamped missing = blend_.at(t_s);
	estimate.value += missing.value;
	estimate.velocity += missing.velocity;
	estimate.acceleration += missing.acceleration;
	return estimate;
}

PhaseEstimate PhaseEstimator::expected(double t_s) const {
	return outlook_.at(curve_, t_s + ahead_s());
}

void PhaseEstimator::blend_from(const PhaseEstimate &before, double t_s) {
	const PhaseEstimate now = expected(t_s);
	blend_.start(t_s, before.value - now.value, before.velocity - now.velocity, BLEND_RATE_PER_S);
}

} // namespace steadyhand
