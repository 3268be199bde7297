#include "phase/tracker_jump.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {
namespace {

// As in phase_estimator.cpp.
constexpr double DISPLACED = 0.4;     ///< probability that it leads away
constexpr double DISPLACED_BY = 0.15; ///< standard deviation
/// A tracker that takes something else for the hand, as another hand, shows that as far off as it is: what a
/// leap from so far on adds, of each amplitude more.
constexpr double FAR = 0.6, BY_FAR = 0.6;
constexpr double FOUND = 0.45;       ///< that it leads to where a free hand is, which had not been seen
constexpr double ELSEWHERE = 1.0;    ///< standard deviation
constexpr double SLIDES_BACK = 0.04; ///< that it leads away, and the tracker slides back
constexpr double SLIDES_BY = 0.3;    ///< standard deviation
constexpr double CATCHES_UP = 0.2;   ///< that one that leads onward is the tracker's, which had fallen behind
constexpr double CATCHES_UP_S = 0.2; ///< standard deviation of by how much
constexpr double LIKELY = 0.001;     ///< weight, from which on all of these are looked at

/// In a slide that looks like a hand's motion, back to the hand or up to it: the likeliest of each regime
/// stands for all.
void slide(HypothesisBank &r_bank, bool leads_onward) {
	const std::size_t count = r_bank.size();
	for (const Regime regime : { Regime::REST, Regime::SOUND, Regime::UNSOUND }) {
		std::size_t likeliest = count;
		double sum = 0.0;
		for (std::size_t i = 0; i < count; ++i) {
			if (r_bank.regime(i) == regime && r_bank.weight(i) > LIKELY && !r_bank.is_standing(i)) {
				likeliest = likeliest == count || r_bank.weight(i) > r_bank.weight(likeliest) ? i : likeliest;
				sum += r_bank.weight(i);
			}
		}
		if (likeliest < count) {
			r_bank.add(r_bank.hypothesis(likeliest).displaced_sliding_back(SLIDES_BY),
					std::log(SLIDES_BACK * sum / r_bank.weight(likeliest)));
			if (leads_onward && regime != Regime::REST) {
				r_bank.add(r_bank.hypothesis(likeliest).caught_up(CATCHES_UP_S, SLIDES_BY),
						std::log(CATCHES_UP * sum / r_bank.weight(likeliest)));
			}
		}
	}
}

} // namespace

void branch_at_jump(HypothesisBank &r_bank, double leap) {
	const std::size_t count = r_bank.size();
	const double displaced_by = std::max(DISPLACED_BY, BY_FAR * (std::abs(leap) - FAR));
	slide(r_bank, leap > 0.0);
	for (std::size_t i = 0; i < count; ++i) {
		GestureHypothesis back = r_bank.hypothesis(i);
		const bool is_likely = r_bank.weight(i) > LIKELY, is_free = r_bank.regime(i) == Regime::FREE;
		const bool is_standing = r_bank.is_standing(i);
		// A free hand that is on no way could be anywhere, and move against any error; one that stands was
		// taken to be where it was shown; a tracker that shakes leaps without being displaced.
		const bool shakes = r_bank.error(i) == TrackerError::SHAKING;
		const bool may_be_displaced =
				is_likely && (!is_free || r_bank.on_its_way(i)) && !is_standing && !shakes;
		if (may_be_displaced) {
			r_bank.add(back.displaced(displaced_by), std::log(DISPLACED));
		}
		// It went wherever the tracker showed it, and may have been elsewhere.
		const bool may_be_elsewhere = is_likely && (is_free || is_standing);
		if (may_be_elsewhere) {
			r_bank.add((is_standing ? back.leaving_end() : back).found_elsewhere(ELSEWHERE), std::log(FOUND));
		}
		back.forget_error();
		back.log_weight +=
				std::log(1.0 - (may_be_displaced ? DISPLACED : 0.0) - (may_be_elsewhere ? FOUND : 0.0));
		r_bank.set(i, back);
	}
}

void arrive_from_jump(HypothesisBank &r_bank) {
	for (std::size_t i = 0; i < r_bank.size(); ++i) {
		if (r_bank.error(i) == TrackerError::SLIDING_BACK) {
			const GestureHypothesis back = r_bank.hypothesis(i);
			r_bank.set(i, back.in(back.regime()));
		}
	}
}

} // namespace steadyhand
