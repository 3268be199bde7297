#include "soundness/tracker_silence.h"

#include "soundness/hands.h"

#include <algorithm>
#include <bit>

namespace steadyhand {
namespace {

constexpr double SILENT_INTERVALS = 3.5;
/// Before so many changes a tracker may be one that looks seldom and is read often: it is not silent before
/// this time, in which any looks again (20 Hz), and the least that it takes between changes is its interval.
constexpr int UNKNOWN_CHANGES = 4;
constexpr double UNKNOWN_S = 0.07;
/// Of the last 64 steps, those against the one before in a coordinate.
constexpr int TREMBLING_TURNS = 6;
constexpr int EXACT_TURNS = 2;         ///< with fewer there is no noise
constexpr double SPEED_SHARE = 0.4;    ///< a step's share in the recent speed
constexpr double ROUNDED_SHARE = 0.25; ///< of the steps that are the least one, of a tracker that rounds
/// Of one least step a frame: a hand that is slower shows none in some frames all the same.
constexpr double ROUNDED_SPEED = 0.9;
/// In least steps: a hand at rest before a tracker that rounds makes one, now and then.
constexpr double LEAST_WAY = 1.5;
constexpr double AT_START = 0.03;    ///< amplitudes: a hand that comes back stops there
constexpr double LEAST_SHARE = 0.05; ///< a step's share in that share
constexpr double SAME = 0.01;        ///< relative difference of steps that are the same
constexpr double PERIOD_GROWTH = 1.2;
constexpr double PERIOD_SHARE = 0.1;

} // namespace

void TrackerSilence::change(double t_s, double x, double step, const FeaturePlace &place_step) {
	const double velocity = step / std::max(t_s - changed_s_, SHORTEST_FRAME_S);
	look(t_s, x);
	speed_ += SPEED_SHARE * (velocity - speed_);
	latest_ = velocity;
	const bool turned = step * step_ < 0.0 || (place_step.cwiseProduct(place_step_).array() < 0.0).any();
	look_for_resolution(step, place_step);
	turns_ = (turns_ << 1U) | (turned ? 1U : 0U);
	way_ = step_ + step;
	step_ = step;
	place_step_ = place_step;
}

bool TrackerSilence::is_silent() const {
	const double least_s = changes_ < UNKNOWN_CHANGES ? UNKNOWN_S : 0.0;
	return t_s_ - changed_s_ > std::max(SILENT_INTERVALS * interval_s_, least_s);
}

bool TrackerSilence::is_frozen() const {
	const bool rounds = least_share_ > ROUNDED_SHARE;
	const double resting_per_s =
			std::max(RESTING_PER_S, rounds ? ROUNDED_SPEED * least_step_ / frame_s_ : 0.0);
	const int turns = std::popcount(turns_);
	// Where there is no noise in it, the last step is how fast the hand was by then.
	const double speed =
			turns < EXACT_TURNS ? std::min(std::abs(speed_), std::abs(latest_)) : std::abs(speed_);
	const bool moved = speed > resting_per_s && std::abs(way_) > LEAST_WAY * least_step_;
	const bool has_come_back = std::abs(x_) < AT_START && speed_ < 0.0;
	const bool trembled = turns >= TREMBLING_TURNS && !rounds;
	return is_silent() && ((moved && !has_come_back) || trembled);
}

double TrackerSilence::followed(double period_s, double latest_s) {
	return latest_s > period_s ? std::min(period_s * PERIOD_GROWTH, latest_s)
							   : period_s + PERIOD_SHARE * (latest_s - period_s);
}

void TrackerSilence::come_to(double t_s) {
	frame_s_ = std::max(t_s - t_s_, SHORTEST_FRAME_S);
	t_s_ = t_s;
}

void TrackerSilence::look(double t_s, double x) {
	x_ = x;
	const double latest_s = t_s - changed_s_;
	if (changes_ >= UNKNOWN_CHANGES) {
		interval_s_ = followed(interval_s_, latest_s);
	} else if (latest_s <= UNKNOWN_S) {
		// The first one began anywhere between two looks, and a hand at rest before a tracker that rounds
		// makes long ones.
		const double least_s = changes_ > 1 ? std::min(interval_s_, latest_s) : latest_s;
		interval_s_ = changes_ > 0 ? least_s : std::max(interval_s_, latest_s);
		++changes_;
	}
	come_to(t_s);
	changed_s_ = t_s;
}

/// Steps of a tracker that rounds are multiples of its resolution, and at rest no more than that.
void TrackerSilence::look_for_resolution(double step, const FeaturePlace &place_step) {
	// Along an oblique way coordinates cancel to rounding errors of their own.
	const bool has_place = !place_step.isZero(0.0);
	const Eigen::Array<double, FeaturePlace::RowsAtCompileTime, 1> sizes = place_step.array().abs();
	const double least = has_place ? (sizes > 0.0).select(sizes, INFINITY).minCoeff() : std::abs(step);
	const bool is_least = std::abs(least - least_step_) <= SAME * least_step_;
	least_share_ += LEAST_SHARE * ((is_least ? 1.0 : 0.0) - least_share_);
	least_step_ = std::min(least_step_, least);
}

} // namespace steadyhand
