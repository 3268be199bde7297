#include "phase/phase_estimator.h"

#include "phase/tracker_jump.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace steadyhand {
namespace {

// Values in amplitudes. Set on synthetic subjects of the tuning population and on other recordings than those
// that are evaluated (docs/evidence.md).
/// Durations are log-normal about the model's mean, never narrower than this: people differ from recordings.
constexpr double SMALLEST_SPREAD = 0.5;
constexpr double WIDEST = 2.2; ///< the durations cover +- so many deviations

/// Share of the regime UNSOUND among all on their way, at any time: trackers start to err.
constexpr double UNSOUND_AT_LEAST = 0.03;
/// The same of FREE while the tracker is right: hands change their minds.
constexpr double FREE_AT_LEAST = 0.0038;
/// A fault's likelihood where the tracker is right, against it erring.
constexpr double FAULT_LOG_RATIO = 6.0;
/// Of a tracker that errs, at the end of the way: to see none speaks against it.
constexpr double FAULTS_PER_S = 2.4;
/// The same of one that errs half-way: to show a hand as standing that goes on.
constexpr double STANDS_PER_S = 30.0;

constexpr double OUTLIERS = 0.011;
/// Errors of frames this close together are alike, and count as one: a power of the likelihood, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
constexpr double ALIKE_S = 0.013;
constexpr double LONGEST_STEP_S = 0.1; ///< a frame after a longer gap counts as one after this

/// A hand stands that has been slow for so long, as a tracker sees it that has neither erred of late nor
/// shakes; as another one sees it.
constexpr double HALTED_S = 0.02;
constexpr double HALTED_UNSURE_S = 0.1;
constexpr double HALTED_FROM = 0.1; ///< one that is no further may not have begun
constexpr double ERRED = 0.2;       ///< unsoundness from which on it has
constexpr double SHAKES = 0.003;    ///< jitter from which on it does
constexpr double MOVES_S = 0.05;    ///< a hand that moves so soon after a fault moved all the while

/// A tracker that has erred is late as a whole, beside what a hypothesis can see of it.
constexpr double ERRING_LATENCY_S = 0.037;
constexpr double ERRING_SETTLING_S = 0.15;

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
	seen_s_ = told_s_ = t_s;
	filtered_s_ = t_s;
	absorbed_s_ = -std::numeric_limits<double>::infinity();
	back_s_ = INFINITY;
	next_branch_s_ = t_s + effort_.branch_period_s;
}

void PhaseEstimator::restart(double t_s) {
	if (bank_.empty()) {
		return;
	}
	const PhaseEstimate before = at(t_s), hand = outlook_.at(curve_, filtered_s_);
	begin(filtered_s_, hand.value);
	bank_.add(GestureHypothesis::leaving(hand.value, hand.velocity));
	prune();
	look(filtered_s_);
	blend_from(before, t_s);
}

void PhaseEstimator::prune() {
	const double sound = 1.0 - soundness_.unsoundness();
	bank_.prune(filtered_s_, UNSOUND_AT_LEAST, FREE_AT_LEAST * sound * sound);
}

/// A fault speaks against a tracker that is right, and says nothing of whether the hand has begun, or of one
/// that has left the gesture's end: those keep their share. Where the gesture is over, only a jump says where
/// the hand is.
void PhaseEstimator::count_fault(double fault, bool jumped) {
	if (fault == 0.0) {
		return;
	}
	const auto is_judged = [&](std::size_t i) {
		return bank_.on_its_way(i) &&
				(!bank_.is_over(i, filtered_s_) || (jumped && bank_.regime(i) != Regime::FREE));
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
	if (bank_.empty() || is_halted_ || missing <= missing_) {
		return;
	}
	const PhaseEstimate before = at(t_s);
	count_fault(missing - missing_, false);
	missing_ = missing;
	prune();
	look(filtered_s_);
	blend_from(before, t_s);
}

/// On its way the hand has been seen slow for longer than for_s.
bool PhaseEstimator::stands(double x, double for_s) const {
	return soundness_.told() && soundness_.slow_for_s() > for_s && x > HALTED_FROM && x < 1.0 - AT_END;
}

void PhaseEstimator::look_for_halt(double x) {
	if (soundness_.told() && soundness_.fault() == 0.0) {
		const bool is_sure = soundness_.unsoundness() < ERRED && soundness_.jitter() < SHAKES;
		is_halted_ = stands(x, is_sure ? HALTED_S : HALTED_UNSURE_S);
	}
}

/// That a tracker errs from now on says nothing of whether a hand that had halted has gone on; that it then
/// jumps to the end does, or that it finds a hand which moves.
void PhaseEstimator::judge_fault(double t_s, double x) {
	const double fault = soundness_.fault() - missing_;
	missing_ = 0.0;
	const bool is_at_end = soundness_.jumped() && std::abs(x - 1.0) < AT_END;
	if (is_halted_ && !is_at_end) {
		withheld_ = std::max(withheld_ + fault, 0.0);
		withheld_s_ = fault > 0.0 ? t_s : withheld_s_;
		return;
	}
	const double withheld = t_s - withheld_s_ < MOVES_S ? withheld_ : 0.0;
	withheld_ = 0.0;
	count_fault(fault + withheld, soundness_.jumped());
}

void PhaseEstimator::absorb(double t_s, double x) {
	look_for_halt(x);
	if (is_halted_ && !soundness_.told()) {
		return; // it stays where it was seen
	}
	const double dt_s = std::min(std::max(t_s - filtered_s_, 0.0), LONGEST_STEP_S);
	const HypothesisGroup::Trust trust{ OUTLIERS, soundness_.jitter(), dt_s / (dt_s + ALIKE_S) };
	const double step_s = std::max(t_s - filtered_s_, 0.0);
	filtered_s_ = t_s;
	bank_.predict(curve_, t_s, passages(step_s));
	if (soundness_.returned()) {
		set_free_unseen(t_s);
	}
	if (soundness_.jumped()) {
		branch_at_jump(bank_);
		back_s_ = t_s + SLIDES_FOR_S;
	}
	seen_s_ = soundness_.frozen() ? seen_s_ : t_s;
	told_s_ = soundness_.told() ? t_s : told_s_;
	if (soundness_.jumped() || soundness_.returned()) {
		rest_anew(x);
		seed(t_s, x);
	}
	judge_fault(t_s, x);
	const double no_fault = FAULTS_PER_S * dt_s * std::clamp(x, 0.0, 1.0);
	const double standing = stands(x, HALTED_UNSURE_S) ? STANDS_PER_S * dt_s : 0.0;
	for (std::size_t i = 1; i < bank_.size(); ++i) {
		if (bank_.regime(i) == Regime::UNSOUND) {
			bank_.weigh(i, -no_fault - (bank_.is_over(i, t_s) ? 0.0 : standing));
		}
	}
	if (soundness_.told()) {
		bank_.absorb(curve_, t_s, x, trust);
	}
}

void PhaseEstimator::push(double t_s, double x, const FeaturePlace &place) {
	if (bank_.empty()) {
		begin(t_s, x);
		look(t_s);
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
	if (t_s >= back_s_) {
		arrive_from_jump(bank_);
		back_s_ = INFINITY;
	}
	if (t_s - absorbed_s_ < LEAST_FRAME_S) {
		return;
	}
	const double frame_s = t_s - std::max(absorbed_s_, filtered_s_);
	absorbed_s_ = t_s;
	branch_until(t_s);
	soundness_.push(t_s, x, place);
	falling_behind_s_ += (ERRING_LATENCY_S * soundness_.lasting_unsoundness() - falling_behind_s_) *
			-std::expm1(-frame_s / ERRING_SETTLING_S);
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
	estimate.correction = missing.acceleration - acceleration_step_ * blend_.share_left(t_s);
	return estimate;
}

PhaseEstimate PhaseEstimator::expected(double t_s) const {
	return outlook_.at(curve_, t_s + ahead_s());
}

void PhaseEstimator::blend_from(const PhaseEstimate &before, double t_s) {
	const PhaseEstimate now = expected(t_s);
	acceleration_step_ = before.acceleration - before.correction - now.acceleration;
	blend_.start(t_s, before.value - now.value, before.velocity - now.velocity, BLEND_RATE_PER_S);
}

} // namespace steadyhand
