#pragma once

#include "gesture/feature.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace steadyhand {

/// Takes the steps that no hand makes out of a stream of places: a tracker that shows the hand beside where
/// it is, for one frame, for good, or until it has slid back. What a step is can be told from the frames on
/// either side of it: a hand that goes as far must be fast before or after. A frame off its course waits for
/// the next one, therefore; others pass at once.
class TrackerSteps {
public:
	/// A tracker holds its last pose no longer than this.
	static constexpr double LONGEST_HELD_S = 0.4;

	struct Passed {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero(); ///< without all steps so far
		FeaturePlace seen_m = FeaturePlace::Zero();  ///< as given

		/// By which the tracker shows the hand beside where it is.
		[[nodiscard]] FeaturePlace step_m() const { return seen_m - place_m; }
	};

	/// Frames that are fit to use by now, in order: none, one, or two. t_s must increase. rest_shown_s: when
	/// the place before was last shown, if the hand rested there: from then on it did not go as far.
	std::span<const Passed> push(double t_s, const FeaturePlace &place_m, double rest_shown_s = -INFINITY);
	/// The newest place was shown again: one off the hand's course that is not left soon is a step. rests: no
	/// stroke is under way.
	std::span<const Passed> stay(double t_s, bool rests);
	/// Sum of all that was taken out.
	[[nodiscard]] const FeaturePlace &step_m() const { return step_m_; }
	/// The next frame has nothing to do with the last one.
	void restart();

private:
	static constexpr double NEVER_S = -std::numeric_limits<double>::infinity();

	struct Frame {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
	};
	/// Back, after a step.
	struct Slide {
		FeaturePlace left_m = FeaturePlace::Zero(); ///< of the step; zero: the tracker does not slide
		double until_s = 0.0;
		FeaturePlace hand_m_s = FeaturePlace::Zero(); ///< the hand's own velocity, before the step
	};

	/// From where the hand was last shown to the frame that is waiting, with the hand's velocities.
	struct Leap {
		double dt_s = 0.0, next_s = 0.0; ///< of it, and from there to the next frame
		FeaturePlace way_m = FeaturePlace::Zero();
		FeaturePlace before_m_s = FeaturePlace::Zero(), after_m_s = FeaturePlace::Zero();
		bool knows_before = false;
	};

	/// Where the hand is shown, by steps that are no trembling.
	struct Stand {
		double since_s = NEVER_S;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace came_m_s = FeaturePlace::Zero(); ///< at which velocity
		double fastest_m_s = 0.0;                     ///< of late
	};

	/// A place that was shown again, to the last bit.
	struct Held {
		double shown_s = 0.0; ///< the last time
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace step_m = FeaturePlace::Zero(); ///< all that was taken out until then
	};

	Frame last_;
	Frame waiting_;
	FeaturePlace velocity_m_s_ = FeaturePlace::Zero(); ///< over the last interval
	double interval_s_ = 0.0;                          ///< the last; 0 before the second frame
	FeaturePlace step_m_ = FeaturePlace::Zero();       ///< sum of all that was taken out
	Slide slide_;
	double moved_s_ = 0.0; ///< when the hand was last faster than one that has just set out
	double bend_m_ = 0.0;  ///< mean, from frame to frame
	int bends_ = 0;
	std::optional<Held> held_;
	Stand stand_;
	double stayed_until_s_ = -INFINITY; ///< at rest, before a tracker that shows hands elsewhere
	bool shows_elsewhere_ = false;      ///< a hand at rest, for a frame or for good
	bool has_last_ = false;
	bool is_waiting_ = false;
	bool waits_after_rest_ = false; ///< which was shown until rest_shown_s_
	bool has_rested_ = false;       ///< for longer than a tracker holds its pose
	double rest_shown_s_ = 0.0;
	std::array<Passed, 2> passed_;
	std::size_t passed_count_ = 0;

	[[nodiscard]] double floor_m() const;
	void pass(const Frame &frame);
	[[nodiscard]] Leap leap_before(const Frame &next) const;
	[[nodiscard]] bool was_elsewhere(const Leap &leap, const Frame &next) const;
	[[nodiscard]] bool set_out_unseen(const Leap &leap) const;
	[[nodiscard]] bool catches_up(const Leap &leap) const;
	void stand_at(const Frame &frame);
	void resolve(const Frame &next);
	void take_out(const FeaturePlace &step_m, const Leap &leap);
	void come_back(const Frame &frame, const FeaturePlace &step_m);
	void remember_bend(double bend_m);
	void slide_to(const Frame &frame);
};

} // namespace steadyhand
