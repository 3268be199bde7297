#include "motion/stroke_finder.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// Longer than ObservationWindow's: a tracker's slow error moves by a centimetre in a tenth of a second.
constexpr double WINDOW_S = 0.1;
constexpr double ONSET_SHARE = 0.25; ///< of the peak speed
constexpr double END_SHARE = 0.25;
constexpr double SLOWEST_M_S = 1e-3;
constexpr double SPEED_RATIO = 1.1;
constexpr double LOSS_S = 0.15;
constexpr double PIECE_S = 0.05; ///< of the way
constexpr double LONGEST_GAP_S = 1.0;
/// A hand turns at 40 m/s^2 at most; what a frame is further off than this from where it was bound is a step
/// of the tracker's.
constexpr double LARGEST_ACCELERATION_M_S2 = 40.0;
constexpr double SMALLEST_STEP_M = 0.008;
/// Between two halves of one gesture the hand rests no longer than this, and does not turn by more than 37
/// degrees.
constexpr double HESITATION_S = 0.6;
constexpr double HESITATION_COSINE = 0.8;

} // namespace

void StrokeFinder::restart(double t_s, const FeaturePlace &place_m) {
	first_ = count_ = rest_count_ = 0;
	frames_[0] = { .t_s = t_s, .place_m = place_m, .seen_m = place_m };
	count_ = 1;
	knots_[0] = frames_[0];
	knot_count_ = 1;
	last_m_ = place_m;
	step_m_ = velocity_m_s_ = FeaturePlace::Zero();
	speed_m_s_ = 0.0;
	begin_anew(frames_[0]);
	earlier_onset_.reset();
}

void StrokeFinder::remember_frame(double t_s, const FeaturePlace &place_m) {
	if (past_count_ == PAST) {
		past_first_ = (past_first_ + 1) % PAST;
		--past_count_;
	}
	past_[(past_first_ + past_count_++) % PAST] = { t_s, place_m };
}

void StrokeFinder::measure_velocity() {
	const Sample &newest = frame(count_ - 1);
	double mean_t = 0.0;
	FeaturePlace mean_m = FeaturePlace::Zero();
	for (std::size_t i = 0; i < count_; ++i) {
		mean_t += frame(i).t_s - newest.t_s;
		mean_m += frame(i).place_m - newest.place_m;
	}
	const double n = static_cast<double>(count_);
	mean_t /= n;
	mean_m /= n;
	FeaturePlace covariance = FeaturePlace::Zero();
	double variance = 0.0;
	for (std::size_t i = 0; i < count_; ++i) {
		const double dt = frame(i).t_s - newest.t_s - mean_t;
		covariance += dt * (frame(i).place_m - newest.place_m - mean_m);
		variance += dt * dt;
	}
	velocity_m_s_ = FeaturePlace::Zero();
	if (variance > 0.0) {
		velocity_m_s_ = covariance / variance;
	}
	speed_m_s_ = velocity_m_s_.norm();
}

void StrokeFinder::keep(const Sample &sample) {
	if (count_ == FRAMES) {
		first_ = (first_ + 1) % FRAMES;
		--count_;
	}
	frames_[(first_ + count_) % FRAMES] = sample;
	++count_;
	while (count_ > 2 && sample.t_s - frame(0).t_s > WINDOW_S) {
		first_ = (first_ + 1) % FRAMES;
		--count_;
	}
}

void StrokeFinder::remember_rest(const Sample &sample) {
	while (rest_count_ > 0 && rests_[rest_count_ - 1].speed_m_s >= sample.speed_m_s) {
		--rest_count_;
	}
	const bool is_faster =
			rest_count_ == 0 || sample.speed_m_s > SPEED_RATIO * rests_[rest_count_ - 1].speed_m_s;
	if (is_faster && rest_count_ < RESTS) {
		rests_[rest_count_++] = sample;
	}
}

const StrokeFinder::Sample *StrokeFinder::last_slower_than(double speed_m_s) const {
	for (std::size_t i = rest_count_; i > 0; --i) {
		if (rests_[i - 1].speed_m_s < speed_m_s) {
			return &rests_[i - 1];
		}
	}
	return nullptr;
}

Stroke StrokeFinder::since(const Sample &onset, const Sample &now) const {
	Stroke stroke{ onset.t_s, now.t_s, onset.place_m, now.place_m, now.place_m, peak_m_s_, onset.seen_m,
		std::max(now.way_m - onset.way_m, (now.place_m - onset.place_m).norm()), onset.unrest_m,
		onset.watched_s };
	if (now.t_s > onset.t_s) {
		stroke.middle = (now.sum - onset.sum) / (now.t_s - onset.t_s);
	}
	return stroke;
}

void StrokeFinder::push(double t_s, FeaturePlace place_m) {
	lost_.reset();
	if (!place_m.allFinite()) {
		return;
	}
	if (past_count_ == 0 || t_s - past_[(past_first_ + past_count_ - 1) % PAST].t_s > LONGEST_GAP_S) {
		seen_since_s_ = t_s;
	}
	remember_frame(t_s, place_m);
	if (count_ == 0 || t_s - frame(count_ - 1).t_s > LONGEST_GAP_S) {
		restart(t_s, place_m);
		return;
	}
	if (ended_) {
		begin_anew(frame(count_ - 1));
	}
	if (place_m == last_m_) {
		return;
	}
	const Sample last = frame(count_ - 1);
	const double dt_s = t_s - last.t_s;
	const FeaturePlace way_m = place_m - last_m_, expected_m = velocity_m_s_ * dt_s;
	const double largest_m = SMALLEST_STEP_M + LARGEST_ACCELERATION_M_S2 * dt_s * dt_s;
	// Both, because the velocity is wrong itself where a frozen tracker has just caught up.
	if (count_ > 2 && way_m.norm() > largest_m && (way_m - expected_m).norm() > largest_m) {
		step_m_ += way_m - expected_m;
	}
	last_m_ = place_m;
	place_m -= step_m_;
	Sample now{ .t_s = t_s,
		.place_m = place_m,
		.sum = last.sum + 0.5 * dt_s * (last.place_m + place_m),
		.seen_m = last_m_ };
	measure_way(now);
	if (dt_s > LOSS_S) {
		lost_ = stroke_;
	}
	keep(now);
	measure_velocity();
	now.speed_m_s = std::max(speed_m_s_, SLOWEST_M_S);

	if (now.speed_m_s > peak_m_s_) {
		peak_m_s_ = now.speed_m_s;
		const Sample *rest = last_slower_than(ONSET_SHARE * peak_m_s_);
		onset_ = rest != nullptr ? std::optional(*rest) : std::nullopt;
	}
	remember_rest(now);
	if (!onset_) {
		return;
	}
	stroke_ = since(*onset_, now);
	joined_.reset();
	if (earlier_onset_ && onset_->t_s - earlier_end_s_ < HESITATION_S) {
		const FeaturePlace before = onset_->place_m - earlier_onset_->place_m,
						   after = now.place_m - onset_->place_m;
		if (before.dot(after) > HESITATION_COSINE * before.norm() * after.norm()) {
			joined_ = since(*earlier_onset_, now);
		}
	}
	ended_ = now.speed_m_s < END_SHARE * peak_m_s_ || velocity_m_s_.dot(now.place_m - onset_->place_m) < 0.0;
}

/// For the next stroke's onset too, should it be here.
void StrokeFinder::measure_way(Sample &r_sample) {
	const Sample &knot = knots_[(knot_count_ - 1) % KNOTS];
	r_sample.way_m = knot.way_m + (r_sample.place_m - knot.place_m).norm();
	// The speed by which an onset is found is that of half a window ago.
	const double then_s = r_sample.t_s - 0.5 * WINDOW_S;
	r_sample.watched_s = std::clamp(then_s - seen_since_s_, 0.0, Stroke::REST_S);
	const Sample *still = nullptr;
	for (std::size_t i = knot_count_; i > 0 && i + KNOTS > knot_count_; --i) {
		const Sample &before = knots_[(i - 1) % KNOTS];
		if (then_s - before.t_s > Stroke::REST_S) {
			break;
		}
		if (then_s >= before.t_s) {
			still = still != nullptr ? still : &before;
			r_sample.unrest_m = std::max(r_sample.unrest_m, (still->place_m - before.place_m).norm());
		}
	}
	if (r_sample.t_s - knot.t_s >= PIECE_S) {
		knots_[knot_count_++ % KNOTS] = r_sample;
	}
}

/// What comes is another stroke. Places of rest are kept: one deeper than this end was may be where the next
/// stroke, or all of them, began.
void StrokeFinder::begin_anew(const Sample &end) {
	earlier_onset_ = onset_;
	earlier_end_s_ = end.t_s;
	onset_.reset();
	stroke_.reset();
	joined_.reset();
	ended_ = false;
	peak_m_s_ = 0.0;
}

} // namespace steadyhand
