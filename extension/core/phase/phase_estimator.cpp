#include "phase/phase_estimator.h"

#include "phase/tracker_jump.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// Values in amplitudes. Set on synthetic subjects of the tuning population and on other recordings than those
// that are evaluated (docs/evidence.md).
/// Share of the regime UNSOUND among all on their way, at any time: trackers start to err.
constexpr double UNSOUND_AT_LEAST = 0.03;
/// The same of FREE: hands change their minds.
constexpr double FREE_AT_LEAST = 0.005;
constexpr double OUTLIERS = 0.011;
/// Errors of frames this close together are alike, and count as one: a power of the likelihood, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
constexpr double ALIKE_S = 0.013;
constexpr double LONGEST_STEP_S = 0.1; ///< a frame after a longer gap counts as one after this

/// Without news of the hand for so long nothing branches off: what it begins is seeded.
constexpr double BLIND_S = 0.05;
constexpr double SPARSE_S = 0.015; ///< closer frames see every hand set out
constexpr double LONGEST_S = 8.0;  ///< what branched off before that no longer matters

/// A tracker that has erred is late as a whole, beside what a hypothesis can see of it.
constexpr double ERRING_LATENCY_S = 0.03;
constexpr double ERRING_SETTLING_S = 0.15;

} // namespace

PhaseEstimator::PhaseEstimator(
		const GestureModel &model, const PhaseEffort &effort, double latency_s, double gain_spread) :
		curve_(model),
		births_(model, effort, gain_spread), branch_period_s_(effort.branch_period_s), latency_s_(latency_s),
		bank_(effort) {}

/// A hand that moves, or is elsewhere than at the start, may be about something else than to rest there.
void PhaseEstimator::begin(double t_s, double d, double velocity) {
	bank_.start(GestureHypothesis::resting(d));
	if (velocity != 0.0 || std::abs(d) > NEAR_START) {
		bank_.add(GestureHypothesis::leaving(d, velocity));
	}
	seen_s_ = told_s_ = branched_s_ = t_s;
	told_x_ = branched_x_ = d;
	halted_.start(t_s, d);
	filtered_s_ = t_s;
	back_s_ = INFINITY;
	next_branch_s_ = t_s + branch_period_s_;
}

void PhaseEstimator::restart(double t_s, double shift) {
	if (bank_.empty()) {
		return;
	}
	const PhaseEstimate before = at(t_s), hand = outlook_.at(curve_, filtered_s_);
	if (shift != 0.0) {
		const double absorbed_s = absorbed_s_;
		reset();
		absorbed_s_ = absorbed_s;
	}
	begin(filtered_s_, hand.value + shift, hand.velocity);
	prune();
	look(filtered_s_);
	blend_from(before, t_s);
}

void PhaseEstimator::prune() {
	bank_.prune(filtered_s_, UNSOUND_AT_LEAST, FREE_AT_LEAST);
}

void PhaseEstimator::wait(double t_s) {
	if (bank_.empty()) {
		return;
	}
	outlook_.go_on(curve_, t_s + ahead_s());
	const double missing = soundness_.missing(t_s);
	if (halted_.is_halted() || missing <= missing_) {
		return;
	}
	const PhaseEstimate before = at(t_s);
	count_loss(bank_, filtered_s_, told_s_, loss_.new_of(missing - missing_));
	count_fault(bank_, filtered_s_, missing - missing_, false);
	missing_ = missing;
	prune();
	look(filtered_s_);
	blend_from(before, t_s);
}

/// All that is due by t_s. What branches off says nothing new of the hand before a frame comes.
void PhaseEstimator::branch_until(double t_s) {
	next_branch_s_ = std::max(next_branch_s_, t_s - LONGEST_S);
	for (; next_branch_s_ <= t_s; next_branch_s_ += branch_period_s_) {
		if (next_branch_s_ - told_s_ <= BLIND_S) {
			births_.branch(bank_, soundness_, next_branch_s_);
			if (told_s_ > branched_s_) {
				births_.stand(
						bank_, next_branch_s_, told_x_, (told_x_ - branched_x_) / (told_s_ - branched_s_));
				branched_x_ = told_x_;
				branched_s_ = told_s_;
			}
			prune();
		}
	}
}

void PhaseEstimator::absorb(double t_s, double x) {
	halted_.look(soundness_, t_s, x);
	if (halted_.is_halted() && !soundness_.told()) {
		return; // it stays where it was seen
	}
	const double step_s = std::max(t_s - filtered_s_, 0.0), dt_s = std::min(step_s, LONGEST_STEP_S);
	filtered_s_ = t_s;
	bank_.predict(curve_, t_s, passages(step_s));
	count_lost();
	if (soundness_.returned()) {
		births_.leave_unseen(bank_, soundness_, t_s);
	}
	if (soundness_.jumped()) {
		branch_at_jump(bank_);
		back_s_ = t_s + SLIDES_FOR_S;
	}
	seen_s_ = soundness_.frozen() ? std::min(seen_s_, told_s_) : t_s;
	told_s_ = soundness_.told() ? t_s : told_s_;
	const bool is_back = soundness_.jumped() || soundness_.returned();
	if (is_back) {
		HypothesisBirths::rest_anew(bank_, x);
	}
	if (is_back || sets_out_unseen(step_s, x)) {
		births_.seed(bank_, soundness_, t_s, x);
	}
	told_x_ = soundness_.told() ? x : told_x_;
	count_frame(t_s, dt_s, x);
	if (soundness_.told()) {
		bank_.absorb(curve_, t_s, x, { OUTLIERS, soundness_.jitter(), dt_s / (dt_s + ALIKE_S) });
	}
}

/// By those that there were when the hand was lost: before any are seeded from where it is seen again.
void PhaseEstimator::count_lost() {
	if (!halted_.is_halted()) {
		count_loss(bank_, filtered_s_, told_s_, loss_.new_of(soundness_.loss() - missing_));
	}
	if (soundness_.told()) {
		loss_.end();
	}
}

/// Between two frames of a slow camera a quick hand gets further than any that had just begun.
bool PhaseEstimator::sets_out_unseen(double step_s, double x) const {
	constexpr double FROM = HypothesisBirths::SEEDED_FROM;
	return soundness_.told() && step_s > SPARSE_S && told_x_ < FROM && x - told_x_ > FROM;
}

/// What a frame says by being at fault, or not.
void PhaseEstimator::count_frame(double t_s, double dt_s, double x) {
	const bool is_jump_to_end = soundness_.jumped() && std::abs(x - 1.0) < AT_END;
	// Where the hand has halted a fault says nothing of whether it has gone on, unless it shows it at the
	// end.
	const double fault = halted_.is_halted() && !is_jump_to_end ? 0.0 : soundness_.fault() - missing_;
	missing_ = 0.0;
	count_fault(bank_, t_s, fault, soundness_.jumped());
	count_erring(bank_, t_s, soundness_.log_ratio_news());
	count_errorless(bank_, dt_s, x);
	if (soundness_.told() && HaltedHand::is_on_way(x)) {
		count_stay(bank_, t_s, dt_s, halted_.stays_since_s());
	}
}

void PhaseEstimator::push(double t_s, double x, const FeaturePlace &place) {
	if (bank_.empty()) {
		begin(t_s, x, 0.0);
		look(t_s);
	}
	const PhaseEstimate before = at(t_s);
	if (recall(t_s, x, place)) {
		look(filtered_s_);
		blend_from(before, t_s);
	}
}

bool PhaseEstimator::recall(double t_s, double x, const FeaturePlace &place) {
	if (bank_.empty()) {
		begin(t_s, x, 0.0);
	}
	if (t_s >= back_s_) {
		arrive_from_jump(bank_);
		back_s_ = INFINITY;
	}
	if (t_s - absorbed_s_ < LEAST_FRAME_S) {
		return false;
	}
	const double frame_s = t_s - std::max(absorbed_s_, filtered_s_);
	absorbed_s_ = t_s;
	branch_until(t_s);
	soundness_.push(t_s, x, place);
	falling_behind_s_ += (ERRING_LATENCY_S * soundness_.lateness() - falling_behind_s_) *
			-std::expm1(-frame_s / ERRING_SETTLING_S);
	absorb(t_s, x);
	prune();
	return true;
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
