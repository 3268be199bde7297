#include "soundness/tremble_filter.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

/// Between places whose differences tell the noise: noise below some 20 Hz counts too.
constexpr double ANCHOR_S = 0.025;
constexpr double LONGEST_S = 0.25; ///< what is further apart says nothing of noise
constexpr double SHARE = 0.02;     ///< a turn's, in the mean
/// A single turn counts as no more than so many times the mean and this: jumps are no noise.
constexpr double LARGEST_TURNS = 3.0;
constexpr double LARGEST_TURN_M = 0.003;
/// Longer means bend the hand's own way.
constexpr double LONGEST_MEAN_S = 0.2;
constexpr double NEWEST_SHARE = 0.1;

/// How long a mean is, in windows, that leaves this share < 1 of the variance of white noise's slopes over a
/// window: with r windows 1 - r + r^2 / 5 is left (exact at both ends) up to one, 1 / (5 r^2) beyond.
double windows_that_leave(double share) {
	constexpr double AT_ONE = 0.2;
	return share > AT_ONE ? (1.0 - std::sqrt(1.0 - 4.0 * AT_ONE * (1.0 - share))) / (2.0 * AT_ONE)
						  : std::sqrt(AT_ONE / share);
}

} // namespace

void TrembleFilter::restart() {
	frames_.clear();
	anchor_count_ = 0;
	bend_m_ = FeaturePlace::Zero();
}

/// turn_m: root of how far two bends on end turn about, below 0 where they do not. White noise of deviation s
/// in each of n coordinates makes squares of 4 n s^2 in the mean, and less of their roots.
void TrembleFilter::remember_turn(double turn_m) {
	bends_ = std::min(bends_ + 1, static_cast<int>(1.0 / SHARE));
	const double largest_m = LARGEST_TURNS * noise_m_ + LARGEST_TURN_M;
	noise_m_ += (std::clamp(0.5 * turn_m, -largest_m, largest_m) - noise_m_) / bends_;
	noise_m_ = std::max(noise_m_, 0.0);
}

void TrembleFilter::measure_noise(const Place &place) {
	if (anchor_count_ > 0 && place.t_s - anchors_[1].t_s < ANCHOR_S) {
		return;
	}
	if (anchor_count_ > 0 && place.t_s - anchors_[1].t_s > LONGEST_S) {
		anchor_count_ = 0;
	}
	if (anchor_count_ >= 2) {
		const double ratio = (place.t_s - anchors_[1].t_s) / (anchors_[1].t_s - anchors_[0].t_s);
		const FeaturePlace bend_m =
				place.place_m - anchors_[1].place_m - ratio * (anchors_[1].place_m - anchors_[0].place_m);
		if (anchor_count_ > 2) {
			const double turn = -bend_m.dot(bend_m_);
			remember_turn(std::copysign(std::sqrt(std::abs(turn)), turn));
		}
		bend_m_ = bend_m;
	}
	anchors_[0] = anchors_[1];
	anchors_[1] = place;
	anchor_count_ = std::min(anchor_count_ + 1, 3);
}

TrembleFilter::Place TrembleFilter::push(const Place &place, double slope_s, double still_m_s) {
	measure_noise(place);
	if (!frames_.empty()) {
		const double dt_s = std::min(place.t_s - frames_.newest().t_s, LONGEST_S);
		period_s_ = period_s_ > 0.0 ? period_s_ + NEWEST_SHARE * (dt_s - period_s_) : dt_s;
	}
	frames_.push(place);
	// White noise of variance v, f times a second, has slopes of variance 12 v / (f W^3) over W.
	const double slope_m2_s2 = 12.0 * noise_m_ * noise_m_ * period_s_ / (slope_s * slope_s * slope_s);
	const double mean_s = still_m_s > 0.0 && slope_m2_s2 > still_m_s * still_m_s
			? std::min(slope_s * windows_that_leave(still_m_s * still_m_s / slope_m2_s2), LONGEST_MEAN_S)
			: 0.0;
	while (frames_.size() > 1 && place.t_s - frames_[0].t_s > mean_s) {
		frames_.drop_oldest();
	}
	if (frames_.size() == 1) {
		return place;
	}
	Place mean{ 0.0, FeaturePlace::Zero(), FeaturePlace::Zero() };
	for (std::size_t i = 0; i < frames_.size(); ++i) {
		mean.t_s += frames_[i].t_s - place.t_s;
		mean.place_m += frames_[i].place_m - place.place_m;
		mean.seen_m += frames_[i].seen_m - place.seen_m;
	}
	const double n = static_cast<double>(frames_.size());
	return { place.t_s + mean.t_s / n, place.place_m + mean.place_m / n, place.seen_m + mean.seen_m / n };
}

} // namespace steadyhand
