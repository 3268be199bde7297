#include "soundness/tracking_soundness.h"

#include "soundness/hands.h"

#include <algorithm>

namespace steadyhand {
namespace {

constexpr double MEMORY_S = 1.0;
constexpr double LASTING_MEMORY_S = 5.0;
/// Trackers double or triple an interval every second or so while all is well (1-3 % of intervals).
constexpr double SKIPPED_PERIODS = 1.5, GAP_PERIODS = 4.0;
constexpr double FULL_GAP_S = 0.061; ///< a gap of so much more than two periods is as bad as a jump
/// Amplitudes: a 0.15 s drag, the fastest that is studied, peaks at 1.875 / 0.15.
constexpr double FASTEST_PER_S = 12.5;
constexpr double SMALLEST_JUMP = 0.03;
/// And speeds up by at most 5.77 / 0.15^2 (Flash & Hogan 1985).
constexpr double SHARPEST_PER_S2 = 250.0;
constexpr double SMALLEST_BEND = 0.02;  ///< of a jump; less is the tracker's shaking
constexpr double SMALLEST_STRAY = 0.06; ///< in any direction: hands are not held to the way
/// What shakes further is judged by its own noise, in standard deviations: that of a bend is 2.4, of a
/// step 1.4. A stray counts for long: not even the tails of a circle's radius, whose noise is the
/// posture's, are to be one.
constexpr double SHAKEN_BEND = 8.0;
constexpr double SHAKEN_STRAY = 40.0;
constexpr double SHAKEN_STEP = 6.0;
/// A tracker that bends the way in space further than hands do, whichever way, has erred; where the step
/// along the way is none of a tracker's alone, it counts so much: along the way it may be right.
constexpr double STRAY_FAULT = 0.3;
/// What takes something else for the hand for some frames need not be late afterwards, as what loses it is:
/// share of such a fault in lateness().
constexpr double LATE_BY_JUMP = 0.3;
/// A frame off the way is an outlier where the next one is so much nearer to that way than to it.
constexpr double NEARER = 0.5;
constexpr double BLIND_STEP = 0.04;
constexpr double FROZEN_FRAME = 0.5;
/// A tracker that repeated itself no further from the start than STILL_AT_START, and then shows the hand
/// where it was, has lost nothing: a hand at rest need not tremble. One that showed none meanwhile has, but
/// of a hand at rest nothing tells that it is late.
constexpr double STILL_AT_START = 0.05;
constexpr double STILL_THERE = 0.01;
/// White noise of deviation s bends frames by 2 s sqrt(3 / pi) in the mean.
constexpr double JITTER_PER_BEND = 0.5117;
constexpr double JITTER_SHARE = 0.05;                         ///< a frame's
constexpr double FIRST_PERIOD_S = 0.004, LAST_PERIOD_S = 0.1; ///< what the first interval may say

/// The hand's size is measured, and not where it is.
bool is_size(const FeaturePlace &place) {
	return place[3] != 0.0;
}

/// A hand whose size is measured is held to no way; nor is one that has no place.
bool is_on_way_in_space(const FeaturePlace &place) {
	return !is_size(place) && !place.isZero(0.0);
}

bool is_still_at_start(double before, double now) {
	return std::abs(before) < STILL_AT_START && std::abs(now - before) < STILL_THERE;
}

double size(double step) {
	return std::abs(step);
}

double size(const FeaturePlace &step) {
	return step.norm();
}

} // namespace

void TrackingSoundness::push(double t_s, double x, const FeaturePlace &place) {
	fault_ = {};
	forgotten_since_s_ = INFINITY;
	loss_ = 0.0;
	if (returned_) {
		news_s_ = t_s_;
	}
	jumped_ = returned_ = strayed_ = false;
	const double frame_s = std::max(t_s - t_s_, TrackerSilence::SHORTEST_FRAME_S),
				 log_ratio_before = log_ratio();
	t_s_ = t_s;
	if (frames_ > 0) {
		weigh(frame_s, x, place);
	} else {
		silence_.start(t_s);
		standstill_.start(t_s, x);
		news_s_ = way_s_ = t_s;
		x_ = x;
		place_ = place;
	}
	frames_ = std::min(frames_ + 1, 2);
	if (told() && !leapt() && is_on_way_in_space(place)) {
		way_shape_.push(x, place, jitter_);
	}
	log_ratio_news_ = log_ratio() - log_ratio_before;
}

double TrackingSoundness::gap_fault(double frame_s) const {
	return frame_s > GAP_PERIODS * period_s_ ? std::min(1.0, (frame_s - 2.0 * period_s_) / FULL_GAP_S) : 0.0;
}

/// By how much a step differs from going on.
template <typename Step>
double TrackingSoundness::bend_of(const Way<Step> &way, const Step &step, double dt_s) const {
	return frames_ < 2
			? 0.0
			: std::min(size(Step(step - way.before_leap * dt_s)), size(Step(step - way.latest * dt_s)));
}

void TrackingSoundness::weigh(double frame_s, double x, const FeaturePlace &place) {
	if (frames_ == 1) {
		period_s_ = std::clamp(frame_s, FIRST_PERIOD_S, LAST_PERIOD_S);
		silence_.expect(period_s_);
	}
	loss_ = gap_fault(frame_s);
	if (loss_ == 0.0) {
		skipped_.push(frame_s > SKIPPED_PERIODS * period_s_);
	}
	const bool repeats = x == x_ && place == place_;
	const bool is_still = is_still_at_start(x_, x) && size(FeaturePlace(place - place_)) < STILL_AT_START;
	bool stands = repeats || standstill_.stands(t_s_, x, jitter_);
	const Evidence of_leap = leapt_ ? leap_.fault : Evidence{};
	const bool is_back = !repeats && forget_elsewhere(x, place, stands);
	if (is_back) {
		stands = x == x_ && place == place_;
	}
	if (stands) {
		stand(repeats);
	} else {
		follow(x, place);
	}
	count_fault(repeats, is_still);
	taken_back_ = is_back ? of_leap : Evidence{};
	fault_.add(taken_back_, -1.0);
	evidence_.fade(frame_s);
	freeze_.fade(frame_s);
	evidence_.add(fault_);
	evidence_.add(needless_of_freeze(x), -1.0);
	evidence_ = { std::max(evidence_.now, 0.0), std::max(evidence_.lasting, 0.0),
		std::max(evidence_.late, 0.0) };
	period_s_ = TrackerSilence::followed(period_s_, frame_s);
}

/// What the frame says by itself.
void TrackingSoundness::count_fault(bool repeats, bool is_still) {
	const double late_gap = is_still ? 0.0 : loss_;
	const double freeze = silence_.is_frozen() ? FROZEN_FRAME : 0.0;
	loss_ += freeze;
	const double jump = strayed_ ? 1.0 : fault_.now;
	fault_.now += loss_;
	fault_.lasting = strayed_ ? std::max(fault_.now, 1.0) : fault_.now;
	fault_.late = late_gap + freeze + LATE_BY_JUMP * jump;
	if (!repeats) {
		leap_.fault = fault_;
	}
}

void TrackingSoundness::Evidence::fade(double dt_s) {
	const double lasts = std::exp(-dt_s / LASTING_MEMORY_S);
	now *= std::exp(-dt_s / MEMORY_S);
	lasting *= lasts;
	late *= lasts;
}

void TrackingSoundness::Evidence::add(const Evidence &other, double sign) {
	now += sign * other.now;
	lasting += sign * other.lasting;
	late += sign * other.late;
}

/// What is left of a freeze's evidence when it is over and was no loss; leap_ is the frame that it repeated.
TrackingSoundness::Evidence TrackingSoundness::needless_of_freeze(double x) {
	Evidence needless;
	if (frozen()) {
		freeze_.add(fault_);
	} else if (told()) {
		if (is_still_at_start(leap_.x, x)) {
			needless = freeze_;
		}
		freeze_ = {};
	}
	return needless;
}

/// A frame that shows the place of the last one, to the last bit if it repeats it.
void TrackingSoundness::stand(bool repeats) {
	if (repeats) {
		standstill_.repeat();
	}
	silence_.repeat(t_s_);
	if (silence_.is_silent()) {
		rest();
	}
}

/// The value stands for a hand, or a tracker, that does not move.
void TrackingSoundness::rest() {
	if (!silence_.is_frozen()) {
		noise_.push(0.0);
		place_noise_.push(0.0);
		if (!held_ || held_->x != x_ || held_->place != place_) {
			held_ = { t_s_, x_, place_, silence_, standstill_ };
		}
		held_->shown_s = t_s_;
	}
	step_way_.go(0.0, false);
	place_way_.go(FeaturePlace::Zero(), false);
	way_s_ = t_s_;
	leapt_ = false;
}

/// Whether the frame shows the hand where it had been before the tracker showed it elsewhere, which is then
/// as if it had not been. stands: it shows the place of the last one.
bool TrackingSoundness::forget_elsewhere(double x, const FeaturePlace &place, bool stands) {
	const Held *const held = held_of_late();
	if (held != nullptr && x == held->x && place == held->place) {
		forgotten_since_s_ = held->shown_s;
		forget_all_since(*held);
		return true;
	}
	if (!stands && leapt_ && was_outlier(x, place)) {
		forgotten_since_s_ = leap_.t_s;
		forget_outlier();
		return true;
	}
	return false;
}

/// The frame before was the only one off the way.
bool TrackingSoundness::was_outlier(double x, const FeaturePlace &place) const {
	const double dt_s = t_s_ - leap_.t_s;
	const FeaturePlace place_off = place - leap_.place - place_way_.before_leap * dt_s;
	const double off = std::hypot(x - leap_.x - step_way_.before_leap * dt_s, place_off.norm());
	return off < NEARER * std::hypot(x - x_, (place - place_).norm());
}

/// It is as if it had not been.
void TrackingSoundness::forget_outlier() {
	x_ = leap_.x;
	place_ = leap_.place;
	way_s_ = leap_.t_s;
	step_way_.latest = step_way_.before_leap;
	place_way_.latest = place_way_.before_leap;
	standstill_.forget();
	silence_ = leap_.silence;
	leapt_ = false;
}

/// The tracker shows the hand again where it had shown it at rest, to the last bit.
void TrackingSoundness::forget_all_since(const Held &held) {
	x_ = held.x;
	place_ = held.place;
	silence_ = held.silence;
	standstill_ = held.standstill;
	step_way_ = { 0.0, 0.0 };
	place_way_ = { FeaturePlace::Zero(), FeaturePlace::Zero() };
	way_s_ = t_s_;
	leapt_ = false;
}

void TrackingSoundness::follow(double x, const FeaturePlace &place) {
	const double dt_s = std::max(t_s_ - way_s_, TrackerSilence::SHORTEST_FRAME_S);
	const double step = x - x_;
	const FeaturePlace place_step = place - place_;
	judge(dt_s, step, place_step);
	leap_.t_s = way_s_;
	leap_.x = x_;
	leap_.place = place_;
	leap_.silence = silence_;
	step_way_.go(step / dt_s, jumped_ || returned_);
	place_way_.go(place_step / dt_s, strayed_ || returned_);
	way_s_ = t_s_;
	if (!jumped_) {
		news_s_ = returned_ ? news_s_ : t_s_;
	}
	if (leapt_) {
		silence_.look(t_s_, x);
	} else {
		silence_.change(t_s_, x, step, place_step);
	}
	standstill_.tell(t_s_, x, jitter_);
	x_ = x;
	place_ = place;
}

/// Steps: in dt_s.
void TrackingSoundness::judge(double dt_s, double step, const FeaturePlace &place_step) {
	const double bend = bend_of(step_way_, step, dt_s);
	const double stray = bend_of(place_way_, place_step, dt_s);
	if (frames_ > 1) {
		noise_.push(step - step_way_.latest * dt_s);
		place_noise_.push(place_step[0] - place_way_.latest[0] * dt_s);
	}
	const bool may_shake = bend > SMALLEST_BEND || stray > SMALLEST_STRAY;
	const double noise = may_shake ? noise_.deviation() : 0.0;
	// A hand that shakes as a whole changes no size.
	const bool has_own_noise = may_shake && is_size(place_);
	const double place_noise = has_own_noise ? std::max(noise, place_noise_.deviation()) : noise;
	const double sharpest = SHARPEST_PER_S2 * dt_s * dt_s;
	jumped_ = bend > sharpest + std::max(SMALLEST_BEND, SHAKEN_BEND * noise);
	strayed_ = stray > sharpest + std::max(SMALLEST_STRAY, SHAKEN_STRAY * place_noise);
	leapt_ = jumped_ || strayed_;
	returned_ = t_s_ - news_s_ > BLIND_S && std::abs(step) > std::max(BLIND_STEP, SHAKEN_STEP * noise);
	if (frames_ > 1) {
		const double shake = std::min(bend, std::max(SMALLEST_BEND, SHAKEN_STEP * noise));
		jitter_ += JITTER_SHARE * (JITTER_PER_BEND * shake - jitter_);
	}
	if (std::abs(step) > FASTEST_PER_S * dt_s + std::max(SMALLEST_JUMP, SHAKEN_STEP * noise)) {
		fault_.now += 1.0;
	} else if (strayed_) {
		fault_.now += STRAY_FAULT;
	}
}

} // namespace steadyhand
