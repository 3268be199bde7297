#include "recognition/return_watch.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// The hand has turned back once it is at this share of the furthest that it went, by the tracker's steps
/// left out; or, where it was lost for so long, as it is shown: it may have turned faster than a step tells.
constexpr double RETURNED = 0.5;
constexpr double LOST_S = 0.1;

} // namespace

void ReturnWatch::see(const StrokeFinder &strokes, double gone_m, double shown_m, double amplitude_m) {
	const double unseen_s = strokes.news_s() - news_s_;
	if (unseen_s > LOST_S && speed_m_s_ * unseen_s > RETURNED * amplitude_m) {
		found_s_ = strokes.news_s();
	}
	news_s_ = strokes.news_s();
	speed_m_s_ = strokes.speed_m_s();
	gone_m_ = gone_m;
	shown_m_ = shown_m;
	furthest_m_ = std::max(furthest_m_, gone_m);
	furthest_shown_m_ = std::max(furthest_shown_m_, shown_m);
}

void ReturnWatch::end(double t_s, double gone_m) {
	ended_s_ = t_s;
	furthest_m_ = gone_m;
}

bool ReturnWatch::has_returned() const {
	const bool was_lost = found_s_ > ended_s_ - LOST_S;
	return gone_m_ < RETURNED * furthest_m_ || (was_lost && shown_m_ < RETURNED * furthest_shown_m_);
}

} // namespace steadyhand
