#include "phase/phase_estimator.h"

#include "phase/tracker_jump.h"
#include "soundness/hands.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// Values in amplitudes. Set on synthetic subjects of the tuning population and on other recordings than those
// that are evaluated (docs/evidence.md).
/// Share of the regime UNSOUND beside those on their way whose tracker is right, at any time: trackers start
/// to err.
constexpr double UNSOUND_AT_LEAST = 0.03;
/// The same of FREE: hands change their minds.
constexpr double FREE_AT_LEAST = 0.005;
constexpr double OUTLIERS = 0.011;
/// Errors of frames this close together are alike, and count as one: a power of the likelihood, "coarsened
/// posterior" (Miller & Dunson 2019, doi:10.1080/01621459.2018.1469995).
constexpr double ALIKE_S = 0.013;
constexpr double LONGEST_STEP_S = 0.1; ///< a frame after a longer gap counts as one after this

constexpr double MATTERS_S = 8.0; ///< what branched off before that no longer matters

/// A tracker that jumps away from the hand and, so soon, back to it: within this share of the jump back from
/// where that was foretold to be.
constexpr double AWAY_S = 0.2;
constexpr double NEARER = 0.25;
/// One that was away for so long has erred as much as one that stays away; for less, in proportion.
constexpr double ERRED_AWAY_S = 0.1;

/// A tracker that has erred is late as a whole, beside what a hypothesis can see of it.
constexpr double ERRING_LATENCY_S = 0.03;
constexpr double ERRING_SETTLING_S = 0.15;

/// A hand that is shown no further than so many deviations of what it was until then may be at rest still: in
/// this time it may have set out.
constexpr double WANDERS = 2.0;
constexpr double SETS_OUT_S = 0.3;

} // namespace

PhaseEstimator::PhaseEstimator(const GestureModel &model, const PhaseEffort &effort, double latency_s,
		double gain_spread, bool knows_end) :
		curve_(model),
		births_(model, effort, gain_spread, knows_end), branch_period_s_(effort.branch_period_s),
		latency_s_(latency_s), knows_end_(knows_end), now_{ .bank = HypothesisBank(effort) } {}

/// A hand that moves, or is elsewhere than at the start, may be about something else than to rest there.
void PhaseEstimator::begin(double t_s, double d, double velocity) {
	now_.bank.start(GestureHypothesis::resting(d));
	if (velocity != 0.0 || std::abs(d) > NEAR_START) {
		now_.bank.add(GestureHypothesis::leaving(d, velocity));
	}
	now_.seen_s = now_.told_s = now_.branched_s = t_s;
	now_.told_x = now_.branched_x = d;
	now_.halted.start(t_s, d);
	now_.filtered_s = t_s;
	now_.back_s = INFINITY;
	now_.next_branch_s = t_s + branch_period_s_;
}

void PhaseEstimator::restart(double t_s, double shift) {
	if (now_.bank.empty()) {
		return;
	}
	const PhaseEstimate before = at(t_s), hand = outlook_.at(curve_, now_.filtered_s);
	before_leap_.leap_s = NEVER_S;
	if (shift != 0.0) {
		const double absorbed_s = absorbed_s_;
		reset();
		absorbed_s_ = absorbed_s;
	}
	begin(now_.filtered_s, hand.value + shift, hand.velocity);
	prune();
	look(now_.filtered_s);
	blend_from(before, t_s);
}

void PhaseEstimator::prune() {
	now_.bank.prune(now_.filtered_s, UNSOUND_AT_LEAST, FREE_AT_LEAST);
}

void PhaseEstimator::wait(double t_s) {
	if (now_.bank.empty()) {
		return;
	}
	outlook_.go_on(curve_, t_s + ahead_s());
	const double missing = soundness_.missing(t_s);
	if (now_.halted.is_halted() || missing <= now_.missing) {
		return;
	}
	const PhaseEstimate before = at(t_s);
	count_loss(now_.bank, now_.filtered_s, now_.told_s, now_.loss.new_of(missing - now_.missing));
	count_fault(now_.bank, now_.filtered_s, missing - now_.missing, false);
	now_.missing = missing;
	prune();
	look(now_.filtered_s);
	blend_from(before, t_s);
}

/// All that is due by t_s. What branches off says nothing new of the hand before a frame comes.
void PhaseEstimator::branch_until(double t_s) {
	now_.next_branch_s = std::max(now_.next_branch_s, t_s - MATTERS_S);
	for (; now_.next_branch_s <= t_s; now_.next_branch_s += branch_period_s_) {
		// What a hand begins unseen is seeded.
		if (now_.next_branch_s - now_.told_s <= BLIND_S) {
			births_.branch(now_.bank, soundness_, now_.next_branch_s);
			if (now_.told_s > now_.branched_s) {
				births_.stand(now_.bank, now_.next_branch_s, now_.told_x,
						(now_.told_x - now_.branched_x) / (now_.told_s - now_.branched_s),
						now_.next_branch_s - now_.halted.stays_since_s());
				now_.branched_x = now_.told_x;
				now_.branched_s = now_.told_s;
			}
			prune();
		}
	}
}

/// Whether a jump leads back to where the hand was foretold to be before one that led away.
bool PhaseEstimator::jumps_back(double t_s, double x) const {
	if (!soundness_.jumped() || t_s - before_leap_.leap_s >= AWAY_S) {
		return false;
	}
	const Belief &then = before_leap_.belief;
	MotionOutlook outlook;
	outlook.look(then.bank, curve_, then.filtered_s, t_s - then.filtered_s, then.seen_s, mistaken(),
			then.halted.is_halted());
	return std::abs(x - outlook.at(curve_, t_s).value) < NEARER * std::abs(x - now_.told_x);
}

/// Takes in the newest frame of soundness_.
void PhaseEstimator::weigh(double t_s, double x) {
	const bool was_elsewhere = before_leap_.leap_s > soundness_.forgotten_since_s();
	if (was_elsewhere || jumps_back(t_s, x)) {
		const double share = std::min((t_s - before_leap_.leap_s) / ERRED_AWAY_S, 1.0);
		const double fault = was_elsewhere ? soundness_.fault() + soundness_.taken_back()
										   : share * (soundness_.fault() + before_leap_.fault);
		now_ = before_leap_.belief;
		before_leap_.leap_s = NEVER_S;
		branch_until(t_s);
		absorb(t_s, x, fault, false);
	} else {
		const double leap = std::abs(x - now_.told_x);
		const bool may_be_back = t_s - before_leap_.leap_s < AWAY_S && leap < before_leap_.leap;
		if (soundness_.leapt() && before_leap_.leap_s <= soundness_.held_s() && !may_be_back) {
			before_leap_ = { t_s, leap, soundness_.fault(), now_ };
		}
		absorb(t_s, x, soundness_.fault(), soundness_.jumped());
	}
}

/// fault: that is counted; jumps: to where the hand had not been expected.
void PhaseEstimator::absorb(double t_s, double x, double fault, bool jumps) {
	now_.halted.look(soundness_, t_s, x);
	if (now_.halted.is_halted() && !soundness_.told()) {
		return; // it stays where it was seen
	}
	const double step_s = std::max(t_s - now_.filtered_s, 0.0), dt_s = std::min(step_s, LONGEST_STEP_S);
	// Since it was last told of the hand: a camera may be read more often than it looks.
	const double since_s = std::max(t_s - now_.told_s, 0.0), told_dt_s = std::min(since_s, LONGEST_STEP_S);
	// A tracker that was frozen meanwhile did not show that the hand stayed.
	const bool was_frozen = now_.filtered_s > now_.told_s && now_.seen_s <= now_.told_s;
	now_.filtered_s = t_s;
	if (soundness_.told() && std::abs(x) < NEAR_START && rest_.push(t_s, x)) {
		wanders_to_ = WANDERS * rest_.spread(t_s - SETS_OUT_S);
	}
	now_.bank.predict(curve_, t_s, passages(step_s));
	count_lost();
	if (soundness_.returned()) {
		births_.leave_unseen(now_.bank, soundness_, t_s);
	}
	if (jumps) {
		branch_at_jump(now_.bank, x - now_.told_x);
		now_.back_s = t_s + SLIDES_FOR_S;
	}
	now_.seen_s = soundness_.frozen() ? std::min(now_.seen_s, now_.told_s) : t_s;
	now_.told_s = soundness_.told() ? t_s : now_.told_s;
	const bool is_back = jumps || soundness_.returned();
	if (is_back) {
		HypothesisBirths::rest_anew(now_.bank, x);
	}
	if (is_back || has_set_out_unseen(since_s, x)) {
		births_.seed(now_.bank, soundness_, t_s, x);
	}
	now_.told_x = soundness_.told() ? x : now_.told_x;
	count_frame(t_s, dt_s, was_frozen ? dt_s : told_dt_s, x, fault, jumps);
	if (soundness_.told()) {
		const double before = now_.bank.greatest_log_weight();
		now_.bank.absorb(
				curve_, t_s, x, { OUTLIERS, soundness_.jitter(), told_dt_s / (told_dt_s + ALIKE_S) });
		// The likeliest gains by what it expects: where its density is above 1 / sqrt(2 pi) an amplitude,
		// which the likelihoods are without.
		now_.surprises = now_.bank.greatest_log_weight() < before ? now_.surprises + 1 : 0;
	}
}

/// By those that there were when the hand was lost: before any are seeded from where it is seen again.
void PhaseEstimator::count_lost() {
	if (!now_.halted.is_halted()) {
		count_loss(
				now_.bank, now_.filtered_s, now_.told_s, now_.loss.new_of(soundness_.loss() - now_.missing));
	}
	if (soundness_.told()) {
		now_.loss.end();
	}
}

/// Between two frames of a slow camera a quick hand gets further than any that had just begun; and errors
/// right at the onset may leave it at rest, for all that is held, while each frame shows it elsewhere.
bool PhaseEstimator::has_set_out_unseen(double step_s, double x) const {
	constexpr double FROM = HypothesisBirths::SEEDED_FROM;
	const bool is_sparse = step_s > SPARSE_S && now_.told_x < FROM && x - now_.told_x > FROM;
	const bool was_missed = now_.surprises > 1 && now_.bank.weight(HypothesisBank::AT_REST) > 0.5;
	return soundness_.told() && (is_sparse || was_missed);
}

/// What a frame says by being at fault, or not.
void PhaseEstimator::count_frame(
		double t_s, double dt_s, double shown_dt_s, double x, double fault, bool jumps) {
	const bool is_jump_to_end = jumps && std::abs(x - 1.0) < AT_END;
	// Where the hand has halted a fault says nothing of whether it has gone on, unless it shows it at the
	// end.
	const bool says_nothing = now_.halted.is_halted() && !is_jump_to_end;
	count_fault(now_.bank, t_s, says_nothing ? 0.0 : fault - now_.missing, jumps);
	now_.missing = 0.0;
	if (soundness_.leapt()) {
		count_leap(now_.bank);
	}
	count_erring(now_.bank, t_s, soundness_.log_ratio_news());
	count_errorless(now_.bank, dt_s, x);
	if (soundness_.told() && HaltedHand::is_on_way(x)) {
		count_stay(now_.bank, t_s, shown_dt_s, now_.halted.stays_since_s());
	}
}

void PhaseEstimator::push(double t_s, double x, const FeaturePlace &place) {
	if (now_.bank.empty()) {
		const double step_s = t_s - now_.told_s;
		begin(t_s, x, step_s > 0.0 && step_s < LONGEST_STEP_S ? (x - now_.told_x) / step_s : 0.0);
		look(t_s);
	}
	release(t_s);
	const FrameBursts::Frame frame{ t_s, x, place };
	if (!bursts_.holds(frame, absorbed_s_)) {
		use(frame, t_s);
	}
}

void PhaseEstimator::release(double t_s) {
	if (bursts_.is_holding() && t_s >= bursts_.due_s()) {
		const double due_s = bursts_.due_s();
		use(bursts_.take(), due_s);
	}
}

/// t_s: by when its news are put out.
void PhaseEstimator::use(const FrameBursts::Frame &frame, double t_s) {
	const PhaseEstimate before = at(t_s);
	if (recall(frame.t_s, frame.x, frame.place)) {
		look(now_.filtered_s);
		blend_from(before, t_s);
	}
}

bool PhaseEstimator::recall(double t_s, double x, const FeaturePlace &place) {
	if (now_.bank.empty()) {
		begin(t_s, x, 0.0);
	}
	if (t_s >= now_.back_s) {
		arrive_from_jump(now_.bank);
		now_.back_s = INFINITY;
	}
	if (t_s - absorbed_s_ < LEAST_FRAME_S) {
		return false;
	}
	branch_until(t_s);
	judge(t_s, x, place);
	weigh(t_s, x);
	prune();
	return true;
}

void PhaseEstimator::judge(double t_s, double x, const FeaturePlace &place) {
	const double frame_s = absorbed_s_ > NEVER_S ? t_s - absorbed_s_ : 0.0;
	absorbed_s_ = t_s;
	soundness_.push(t_s, x, place);
	falling_behind_s_ += (ERRING_LATENCY_S * soundness_.lateness() - falling_behind_s_) *
			-std::expm1(-frame_s / ERRING_SETTLING_S);
}

void PhaseEstimator::doze(double t_s, double x, const FeaturePlace &place) {
	if (!now_.bank.empty()) {
		forget_hand();
	}
	if (t_s - absorbed_s_ >= LEAST_FRAME_S) {
		judge(t_s, x, place);
		now_.told_s = t_s;
		now_.told_x = x;
	}
}

void PhaseEstimator::forget_hand() {
	now_.bank.clear();
	now_.told_s = NEVER_S;
	now_.halted = {};
	now_.loss = {};
	now_.missing = 0.0;
	before_leap_.leap_s = NEVER_S;
	blend_ = {};
	acceleration_step_ = 0.0;
	bursts_.forget();
}

PhaseEstimate PhaseEstimator::at(double t_s) const {
	PhaseEstimate estimate = expected(t_s);
	const CriticallyDamped missing = blend_.at(t_s);
	estimate.value += missing.value;
	estimate.velocity += missing.velocity;
	estimate.acceleration += missing.acceleration;
	estimate.correction = missing.acceleration - acceleration_step_ * blend_.share_left(t_s);
	return estimate;
}

PhaseEstimate PhaseEstimator::expected(double t_s) const {
	return now_.bank.empty() ? PhaseEstimate{} : outlook_.at(curve_, t_s + ahead_s());
}

void PhaseEstimator::blend_from(const PhaseEstimate &before, double t_s) {
	const PhaseEstimate now = expected(t_s);
	acceleration_step_ = before.acceleration - before.correction - now.acceleration;
	blend_.start(t_s, before.value - now.value, before.velocity - now.velocity, BLEND_RATE_PER_S);
}

} // namespace steadyhand
