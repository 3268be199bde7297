#pragma once

#include "gesture/feature.h"
#include "soundness/tracker_steps.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace steadyhand {

/// What a tracker says of a hand that rests by showing it again where it was, to the last bit: it may round,
/// or hold its last pose while the hand sets out.
class HeldPose {
public:
	static constexpr double LONGEST_S = TrackerSteps::LONGEST_HELD_S;
	static constexpr double NEVER_S = -std::numeric_limits<double>::infinity();

	[[nodiscard]] bool is_news(const FeaturePlace &place_m) const { return place_m != place_m_; }
	void show(double t_s, const FeaturePlace &place_m) {
		shown_s_ = first_shown_s_ = t_s;
		place_m_ = place_m;
	}
	void repeat(double t_s) {
		if (shown_s_ == first_shown_s_) {
			trembled_before_ = std::exchange(trembled_, 0);
		}
		shown_s_ = t_s;
	}
	/// A frame that is no tracker's step.
	void follow(double t_s, const FeaturePlace &place_m) {
		if (!has_followed_) {
			still_m_ = place_m;
			has_followed_ = true;
		} else if ((place_m - still_m_).norm() > STILL_M) {
			still_since_s_ = t_s;
			still_m_ = place_m;
			trembled_ = 0;
		} else {
			++trembled_;
		}
		followed_s_ = t_s;
	}

	/// When the place was shown first.
	[[nodiscard]] double first_shown_s() const { return first_shown_s_; }
	[[nodiscard]] const FeaturePlace &place_m() const { return place_m_; }
	/// When it was shown last, of a hand that has rested in one place, or about it, for longer than
	/// LONGEST_S; -infinity of any other, and before a tracker that trembles: one that does not any more has
	/// lost the hand.
	[[nodiscard]] double rest_shown_s() const {
		const bool has_rested =
				shown_s_ - first_shown_s_ >= LONGEST_S || followed_s_ - still_since_s_ >= LONGEST_S;
		const bool trembles = trembled_before_ >= TREMBLES;
		return has_rested && !trembles && shown_s_ > first_shown_s_ ? shown_s_ : NEVER_S;
	}
	/// Until when the hand that is seen elsewhere at t_s was there, if it was at rest.
	[[nodiscard]] double rested_until_s(double t_s) const { return std::min(shown_s_, t_s - LONGEST_S); }

private:
	static constexpr double STILL_M = 0.004;
	static constexpr int TREMBLES = 20; ///< frames in a row of a hand at rest, each of which is news

	double shown_s_ = 0.0, first_shown_s_ = 0.0;
	FeaturePlace place_m_ = FeaturePlace::Zero(); ///< as given
	double still_since_s_ = NEVER_S; ///< about still_m_; at the first place for how long, nobody knows
	FeaturePlace still_m_ = FeaturePlace::Zero();
	bool has_followed_ = false;
	double followed_s_ = 0.0;
	int trembled_ = 0;        ///< such frames, by now
	int trembled_before_ = 0; ///< and before the place was shown again
};

} // namespace steadyhand
