#include "strokes/stroke_finder.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// Longer than ObservationWindow's: a tracker's slow error moves by a centimetre in a tenth of a second.
constexpr double WINDOW_S = 0.1;
constexpr double ONSET_SHARE = 0.25; ///< of the peak speed
constexpr double END_SHARE = 0.25;
constexpr double SLOWEST_M_S = 1e-3;
/// Slopes that trembling may make, smallest strokes a second.
constexpr double STILL_PER_S = 6.5;
/// A hand that comes into view is on its way once it has gone so many smallest strokes, and times the
/// tracker's noise.
constexpr double ENTERS = 3.0;
constexpr double TREMBLES = 10.0;
constexpr double ENTERED_S = 0.2; ///< that is known by then
constexpr double LOSS_S = 0.15;
constexpr double UNSEEN_S = 0.3; ///< a hand that is lost for longer may have been anywhere meanwhile
constexpr double PIECE_S = WayKnots::APART_S; ///< of the way
constexpr double LONGEST_GAP_S = 1.0;
constexpr double LEAST_LEAP_M = 0.005; ///< what a tracker takes back slowly is none
/// Before a slow stroke the hand is watched for this share of the stroke's own time, or so long.
constexpr double WATCH_SHARE = 0.8;
constexpr double LONGEST_WATCH_S = 1.5;
/// Between two halves of one gesture the hand rests no longer than this.
constexpr double HESITATION_S = 1.0;

} // namespace

/// is_news: the place is another than the last one; one that is shown on and on is none of where the hand is.
void StrokeFinder::restart(double t_s, const FeaturePlace &place_m, bool is_news) {
	newest_ = { .t_s = t_s, .place_m = scale_.cwiseProduct(place_m), .seen_m = place_m };
	places_.clear();
	places_.push(t_s, newest_.place_m, WINDOW_S);
	slow_moments_.clear();
	piece_ = newest_;
	knots_.restart(t_s, newest_.place_m);
	if (is_news) {
		pose_.show(t_s, place_m);
	}
	steps_.restart();
	leapt_m_ = FeaturePlace::Zero();
	leaps_ = 0;
	for (const TrackerSteps::Passed &passed : steps_.push(t_s, place_m)) {
		remember(passed);
	}
	trembles_.restart();
	trembles_.push({ t_s, newest_.place_m, place_m }, WINDOW_S, 0.0);
	speed_m_s_ = 0.0;
	onset_.reset();
	begin_anew(newest_);
	entry_ = newest_;
	earlier_count_ = 0;
}

Stroke StrokeFinder::between(const Sample &onset, const Sample &now, double peak_m_s) {
	Stroke stroke{ .onset_s = onset.t_s,
		.now_s = now.t_s,
		.moved_s = now.t_s,
		.from = onset.place_m,
		.to = now.place_m,
		.middle = now.place_m,
		.peak_m_s = peak_m_s,
		.seen_from = onset.seen_m,
		.seen_to = now.seen_m,
		.leaps = now.leaps - onset.leaps,
		.way_m = std::max(now.way_m - onset.way_m, (now.place_m - onset.place_m).norm()),
		.unrest_m = onset.unrest_m,
		.watched_s = onset.watched_s };
	// A way falls again where the hand trembles, and may come to nothing since the onset.
	const double gone_m = now.way_m - onset.way_m, length_m = (now.place_m - onset.place_m).norm();
	if (gone_m < 0.5 * length_m) {
		stroke.middle = 0.5 * (onset.place_m + now.place_m);
	} else if (gone_m > 0.0) {
		stroke.middle = (now.sum - onset.sum) / gone_m;
	}
	return stroke;
}

void StrokeFinder::push(double t_s, const FeaturePlace &place_m) {
	if (lost_) {
		lost_.reset();
		--stroke_count_;
	}
	if (place_m.allFinite()) {
		see(t_s, place_m);
	}
	if (stroke_count_ == 0) {
		lost_.reset();
	} else if (lost_) {
		strokes_[stroke_count_++] = *lost_;
	}
}

void StrokeFinder::forget_since(const StrokeFinder &before) {
	const double smallest_m = smallest_m_;
	const Ring<GivenFrame, PAST> past = past_;
	*this = before;
	smallest_m_ = smallest_m;
	past_ = past;
}

void StrokeFinder::see(double t_s, const FeaturePlace &place_m) {
	const bool is_news = places_.empty() || pose_.is_news(place_m);
	const double since_s = past_.empty() ? INFINITY : t_s - past_.newest().t_s;
	if (since_s > LONGEST_GAP_S) {
		seen_since_s_ = t_s;
	}
	if (since_s >= LEAST_FRAME_S || (is_news && t_s - pose_.first_shown_s() >= LEAST_FRAME_S)) {
		const bool repeats = !past_.empty() && place_m == past_.newest().place_m;
		past_.push({ t_s, place_m, repeats ? past_.newest().step_m : FeaturePlace::Constant(NAN) });
	}
	if (ended_) {
		begin_anew(end_);
	}
	const bool is_at_rest = !places_.empty() && rests();
	const double unseen_s = is_at_rest ? since_s : t_s - newest_.t_s; // a frozen tracker shows hands at rest
	if (is_news && unseen_s > UNSEEN_S) {
		lost_since_s_ = t_s - unseen_s;
		found_s_ = t_s;
	}
	double rest_shown_s = HeldPose::NEVER_S;
	if (!is_news) {
		pose_.repeat(t_s);
	} else if (is_at_rest) {
		rest_shown_s = pose_.rest_shown_s();
		const double rested_s = pose_.rested_until_s(t_s);
		if (rested_s - pose_.first_shown_s() >= LEAST_FRAME_S) {
			take(rested_s, pose_.place_m(), HeldPose::NEVER_S, false);
		}
	}
	const bool stays = !is_news && is_at_rest;
	if (places_.empty() || since_s > LONGEST_GAP_S || (!stays && t_s - newest_.t_s > LONGEST_GAP_S)) {
		restart(t_s, place_m, is_news);
	} else if (!is_news) {
		follow(steps_.stay(t_s, stays), false);
	} else if (t_s - pose_.first_shown_s() >= LEAST_FRAME_S) {
		take(t_s, place_m, rest_shown_s, true);
	}
}

/// A frame that is news, or the moment until which the last pose held; rest_shown_s: HeldPose::rest_shown_s
/// of the place before.
void StrokeFinder::take(double t_s, const FeaturePlace &place_m, double rest_shown_s, bool may_end) {
	pose_.show(t_s, place_m);
	follow(steps_.push(t_s, place_m, rest_shown_s), may_end);
}

void StrokeFinder::follow(std::span<const TrackerSteps::Passed> passed, bool may_end) {
	for (const TrackerSteps::Passed &frame : passed) {
		remember(frame);
		follow(trembles_.push({ frame.t_s, scale_.cwiseProduct(frame.place_m), frame.seen_m }, WINDOW_S,
					   STILL_PER_S * smallest_m_),
				may_end && &frame == &passed.back());
	}
}

void StrokeFinder::remember(const TrackerSteps::Passed &passed) {
	pose_.follow(passed.t_s, passed.place_m);
	leaps_ += (passed.step_m() - leapt_m_).norm() > LEAST_LEAP_M ? 1 : 0;
	leapt_m_ = passed.step_m();
	for (std::size_t i = past_.size(); i > 0 && past_[i - 1].t_s >= passed.t_s; --i) {
		if (past_[i - 1].t_s == passed.t_s) {
			past_[i - 1].step_m = passed.step_m();
		}
	}
}

/// No stroke is under way.
bool StrokeFinder::rests() const {
	return !onset_ || (newest_.place_m - onset_->place_m).norm() <= smallest_m_;
}

/// may_end: false where another frame follows at once.
void StrokeFinder::follow(const TrembleFilter::Place &place, bool may_end) {
	const double dt_s = place.t_s - newest_.t_s;
	const bool has_turned = dt_s > PIECE_S && turned_unseen(place.place_m);
	if ((dt_s > LOSS_S || has_turned) && stroke_count_ > 0) {
		lost_ = strokes_[0]; // as it was known until now
		lost_->unrest_m = unrest_m(*lost_);
		lost_->is_lost = true;
	}
	if (has_turned) {
		begin_anew(newest_);
	}
	Sample now{ .t_s = place.t_s, .place_m = place.place_m, .seen_m = place.seen_m, .leaps = leaps_ };
	// A slope is that of half a window ago.
	now.speed_s = place.t_s - 0.5 * std::max(WINDOW_S, dt_s);
	measure_way(now);
	now.sum = newest_.sum + 0.5 * (now.way_m - newest_.way_m) * (newest_.place_m + now.place_m);
	// Where the hand turned unseen, it was last seen nearest to where.
	end_ = dt_s > PIECE_S ? newest_ : now;
	newest_ = now;
	places_.push(now.t_s, now.place_m, WINDOW_S);
	const FeaturePlace velocity_m_s = places_.slope();
	speed_m_s_ = velocity_m_s.norm();
	now.speed_m_s = std::max(speed_m_s_, SLOWEST_M_S);

	if (now.speed_m_s > peak_m_s_) {
		peak_m_s_ = now.speed_m_s;
		find_onset();
	}
	slow_moments_.push(now);
	const bool is_slow = now.speed_m_s < END_SHARE * peak_m_s_;
	list_strokes(now);
	if (stroke_count_ > 0) {
		ended_ = may_end && (is_slow || velocity_m_s.dot(now.place_m - strokes_[0].from) < 0.0);
	} else if (is_slow) {
		begin_anew(now);
	}
}

/// Since the last frame, going back to place_m: it may have passed the onset by now.
bool StrokeFinder::turned_unseen(const FeaturePlace &place_m) const {
	if (!onset_) {
		return false;
	}
	const FeaturePlace seen_m = newest_.place_m - onset_->place_m, unseen_m = place_m - newest_.place_m;
	return seen_m.norm() > smallest_m_ && unseen_m.norm() > smallest_m_ && seen_m.dot(unseen_m) < 0.0;
}

void StrokeFinder::list_strokes(const Sample &now) {
	stroke_count_ = 0;
	if (onset_) {
		list_since(*onset_, now);
	} else if (entry_) {
		list_entering(*entry_, now);
	}
}

/// The hand may not have been slow yet because it came into view on its way.
void StrokeFinder::list_entering(Sample &r_entry, const Sample &now) {
	if (r_entry.speed_m_s == 0.0 && now.t_s - r_entry.t_s >= PIECE_S) {
		r_entry.speed_m_s = now.speed_m_s;
	}
	const double gone_m = (now.place_m - r_entry.place_m).norm();
	const bool is_seen = now.t_s - r_entry.t_s >= ENTERED_S;
	if (is_seen && gone_m > std::max(ENTERS * smallest_m_, TREMBLES * noise_m())) {
		strokes_[0] = between(r_entry, now, peak_m_s_);
		strokes_[0].entry_share = r_entry.speed_m_s / peak_m_s_;
		stroke_count_ = 1;
	}
}

void StrokeFinder::list_since(const Sample &onset, const Sample &now) {
	strokes_[0] = between(onset, now, peak_m_s_);
	stroke_count_ = 1;
	const bool goes_on = (now.place_m - onset.place_m).norm() > smallest_m_;
	if ((goes_on ? onset.t_s : now.t_s) - earlier_end_s_ < HESITATION_S) {
		for (std::size_t i = earlier_count_; i > 0; --i) {
			const Earlier &earlier = earlier_[i - 1];
			Stroke &stroke = strokes_[stroke_count_++];
			stroke = between(earlier.onset, now, std::max(earlier.peak_m_s, peak_m_s_));
			stroke.is_joined = goes_on || i < earlier_count_;
			stroke.moved_s = goes_on ? now.t_s : earlier_end_s_;
		}
	}
}

void StrokeFinder::measure_way(Sample &r_sample) {
	const double piece_m = (r_sample.place_m - piece_.place_m).norm();
	r_sample.way_m = piece_.way_m + piece_m;
	if (r_sample.t_s - piece_.t_s >= PIECE_S && piece_m >= smallest_m_) {
		piece_ = r_sample;
	}
	knots_.push(r_sample.t_s, r_sample.place_m);
}

void StrokeFinder::measure_rest(Sample &r_onset) const {
	const double until_s = r_onset.speed_s, since_s = std::max(until_s - Stroke::REST_S, seen_since_s_);
	const double lost_s = std::min(found_s_, until_s) - std::max(lost_since_s_, since_s);
	r_onset.watched_s = std::max(until_s - since_s - std::max(lost_s, 0.0), 0.0);
	r_onset.unrest_m = knots_.stray_m(until_s - Stroke::REST_S, until_s);
}

double StrokeFinder::unrest_m(const Stroke &stroke) const {
	const double watch_s = std::min(WATCH_SHARE * (stroke.now_s - stroke.onset_s), LONGEST_WATCH_S);
	if (stroke.is_lost || watch_s <= Stroke::REST_S) {
		return stroke.unrest_m;
	}
	const double then_s = stroke.onset_s - 0.5 * WINDOW_S;
	const double since_s = std::max(then_s - watch_s, seen_since_s_);
	return std::max(stroke.unrest_m, knots_.stray_m(since_s, then_s));
}

/// By the peak that has just risen: it may be another stroke's than that which seemed to be under way.
void StrokeFinder::find_onset() {
	const Sample *const rest = slow_moments_.last_slower_than(ONSET_SHARE * peak_m_s_);
	if (rest == nullptr) {
		onset_.reset();
	} else if (!onset_ || rest->t_s > onset_->t_s) {
		Sample onset = *rest;
		measure_rest(onset);
		if (onset_ && (onset.place_m - onset_->place_m).norm() > smallest_m_) {
			remember_stroke(*onset_, onset);
		}
		onset_ = onset;
		entry_.reset();
	}
}

/// What comes is another stroke.
void StrokeFinder::begin_anew(const Sample &end) {
	if (onset_ && (end.place_m - onset_->place_m).norm() > smallest_m_) {
		remember_stroke(*onset_, end);
		slow_moments_.clear();
		slow_moments_.push(end);
	}
	onset_.reset();
	stroke_count_ = 0;
	entry_.reset();
	ended_ = false;
	peak_m_s_ = 0.0;
}

/// The next one begins after it. Where the hand only trembled, it may have begun before.
void StrokeFinder::remember_stroke(const Sample &onset, const Sample &end) {
	if (onset.t_s - earlier_end_s_ >= HESITATION_S) {
		earlier_count_ = 0;
	}
	if (earlier_count_ == EARLIER) {
		std::rotate(earlier_.begin(), earlier_.begin() + 1, earlier_.end());
		--earlier_count_;
	}
	earlier_[earlier_count_++] = { onset, 0.0 };
	for (std::size_t i = 0; i < earlier_count_; ++i) {
		earlier_[i].peak_m_s = std::max(earlier_[i].peak_m_s, peak_m_s_);
	}
	earlier_end_s_ = end.t_s;
}

} // namespace steadyhand
