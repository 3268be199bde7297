#include "strokes/stroke_finder.h"

#include "base/parameters.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

using namespace parameters;
using namespace parameters::strokes;

constexpr double PIECE_S = PathKnots::APART_S; ///< least duration of a straight piece of the path

} // namespace

void StrokeFinder::restart(const Sample &first) {
	newest_ = first;
	newest_.is_rest = false;
	places_.clear();
	places_.push(first.t_s, first.place_m, WINDOW_S);
	slow_moments_.clear();
	piece_ = newest_;
	knots_.restart(first.t_s, first.place_m);
	dropout_s_ = INFINITY;
	found_s_ = first.t_s;
	speed_m_s_ = 0.0;
	onset_.reset();
	start_new_stroke(newest_);
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
		.measured_from = onset.measured_m,
		.measured_to = now.measured_m,
		.peak_m_s = peak_m_s,
		.path_m = std::max(now.path_m - onset.path_m, (now.place_m - onset.place_m).norm()),
		.motion_before_m = onset.motion_before_m,
		.tracked_before_s = onset.tracked_before_s,
		.is_from_rest = onset.is_rest };
	// path_m decreases again when the hand trembles, and its difference may be about 0.
	const double path_m = now.path_m - onset.path_m, length_m = (now.place_m - onset.place_m).norm();
	if (path_m < 0.5 * length_m) {
		stroke.middle = 0.5 * (onset.place_m + now.place_m);
	} else if (path_m > 0.0) {
		stroke.middle = (now.sum - onset.sum) / path_m;
	}
	return stroke;
}

void StrokeFinder::push(
		const Measurement &measurement, const FeaturePlace &place_m, const FeaturePlace &displacement_m) {
	const double since_s = measurement.t_s - last_measurement_s();
	if (!measurement.is_usable() || since_s < LEAST_FRAME_S) {
		return;
	}
	past_.push({ measurement.t_s, place_m - displacement_m });
	displacement_m_ = displacement_m;
	noise_m_ = measurement.noise_m;
	if (ended_) {
		start_new_stroke(end_);
	}
	const Sample now{ .t_s = measurement.t_s,
		.place_m = scale_.cwiseProduct(place_m - displacement_m),
		.measured_m = scale_.cwiseProduct(place_m) };
	if (since_s > LONG_DROPOUT_S) {
		recent_.clear();
		restart(smoothed(now));
		return;
	}
	if (since_s > LOST_S) {
		dropout_s_ = since_s;
		found_s_ = measurement.t_s;
	}
	follow(smoothed(now));
}

/// Mean of the newest samples, at their mean time. The window grows with the noise.
StrokeFinder::Sample StrokeFinder::smoothed(const Sample &now) {
	const double period_s = recent_.empty() ? 0.0 : now.t_s - recent_.newest().t_s;
	const double ratio = smallest_m_ > 0.0 ? noise_m_ / (STILL * smallest_m_) : 0.0;
	const double mean_s = std::min(ratio * ratio * period_s, LONGEST_MEAN_S);
	recent_.push(now);
	while (recent_.size() > 1 && now.t_s - recent_[0].t_s >= mean_s) {
		recent_.drop_oldest();
	}
	Sample mean{ .t_s = 0.0 };
	for (std::size_t i = 0; i < recent_.size(); ++i) {
		mean.t_s += recent_[i].t_s - now.t_s;
		mean.place_m += recent_[i].place_m - now.place_m;
		mean.measured_m += recent_[i].measured_m - now.measured_m;
	}
	const double n = static_cast<double>(recent_.size());
	return { .t_s = now.t_s + mean.t_s / n,
		.place_m = now.place_m + mean.place_m / n,
		.measured_m = now.measured_m + mean.measured_m / n };
}

void StrokeFinder::follow(Sample now) {
	const double dt_s = now.t_s - newest_.t_s;
	if (dt_s > PIECE_S && reverses(now.place_m)) {
		start_new_stroke(newest_);
	}
	// A slope is the speed at the middle of its window.
	now.speed_s = now.t_s - 0.5 * std::max(WINDOW_S, dt_s);
	update_path(now);
	now.sum = newest_.sum + 0.5 * (now.path_m - newest_.path_m) * (newest_.place_m + now.place_m);
	// If the hand turned in a dropout, the last sample before it is nearest to the turn.
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
	const bool is_slow = now.speed_m_s < SPEED_SHARE * peak_m_s_;
	list_strokes(now);
	if (stroke_count_ > 0) {
		ended_ = is_slow || velocity_m_s.dot(now.place_m - strokes_[0].from) < 0.0;
	} else if (is_slow) {
		start_new_stroke(now);
	}
}

/// The hand moves from the last sample to place_m against the direction of the present stroke.
bool StrokeFinder::reverses(const FeaturePlace &place_m) const {
	if (!onset_) {
		return false;
	}
	const FeaturePlace seen_m = newest_.place_m - onset_->place_m, unseen_m = place_m - newest_.place_m;
	return seen_m.norm() > smallest_m_ && unseen_m.norm() > smallest_m_ && seen_m.dot(unseen_m) < 0.0;
}

void StrokeFinder::list_strokes(const Sample &now) {
	stroke_count_ = 0;
	if (!onset_) {
		return;
	}
	strokes_[stroke_count_++] = between(*onset_, now, peak_m_s_);
	const bool goes_on = (now.place_m - onset_->place_m).norm() > smallest_m_;
	if ((goes_on ? onset_->t_s : now.t_s) - earlier_end_s_ >= PAUSE_S) {
		return;
	}
	for (std::size_t i = earlier_count_; i > 0; --i) {
		const Earlier &earlier = earlier_[i - 1];
		Stroke &stroke = strokes_[stroke_count_++];
		stroke = between(earlier.onset, now, std::max(earlier.peak_m_s, peak_m_s_));
		stroke.moved_s = goes_on ? now.t_s : earlier_end_s_;
	}
}

void StrokeFinder::update_path(Sample &r_sample) {
	const double piece_m = (r_sample.place_m - piece_.place_m).norm();
	r_sample.path_m = piece_.path_m + piece_m;
	if (r_sample.t_s - piece_.t_s >= PIECE_S && piece_m >= smallest_m_) {
		piece_ = r_sample;
	}
	knots_.push(r_sample.t_s, r_sample.place_m);
}

void StrokeFinder::measure_rest(Sample &r_onset) const {
	const double until_s = r_onset.speed_s;
	double since_s = until_s - REST_S;
	r_onset.tracked_before_s = REST_S;
	if (found_s_ > since_s && dropout_s_ > LONG_DROPOUT_S) {
		r_onset.tracked_before_s = std::max(until_s - found_s_, 0.0);
	} else if (found_s_ > since_s) {
		since_s -= dropout_s_;
	}
	r_onset.motion_before_m = knots_.max_distance_m(since_s, until_s);
}

double StrokeFinder::motion_before_m(const Stroke &stroke) const {
	const double watch_s = std::min(REST_SHARE * (stroke.now_s - stroke.onset_s), LONGEST_REST_S);
	if (watch_s <= REST_S) {
		return stroke.motion_before_m;
	}
	const double then_s = stroke.onset_s - 0.5 * WINDOW_S;
	return std::max(stroke.motion_before_m, knots_.max_distance_m(then_s - watch_s, then_s));
}

/// Finds the onset for the present peak speed. A higher peak may give a later onset, of another stroke.
void StrokeFinder::find_onset() {
	const Sample *const rest = slow_moments_.last_slower_than(SPEED_SHARE * peak_m_s_);
	if (rest == nullptr) {
		onset_ = entry_;
	} else if (!onset_ || rest->t_s > onset_->t_s) {
		Sample onset = *rest;
		measure_rest(onset);
		if (onset_ && (onset.place_m - onset_->place_m).norm() > smallest_m_) {
			store_stroke(*onset_, onset);
		}
		onset_ = onset;
		entry_.reset();
	}
}

/// The present stroke ends at `end`.
void StrokeFinder::start_new_stroke(const Sample &end) {
	if (onset_ && (end.place_m - onset_->place_m).norm() > smallest_m_) {
		store_stroke(*onset_, end);
		// The next onset is not before the end. After tremor it may be.
		slow_moments_.clear();
		slow_moments_.push(end);
	}
	onset_.reset();
	stroke_count_ = 0;
	entry_.reset();
	ended_ = false;
	peak_m_s_ = 0.0;
}

void StrokeFinder::store_stroke(const Sample &onset, const Sample &end) {
	if (onset.t_s - earlier_end_s_ >= PAUSE_S) {
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
