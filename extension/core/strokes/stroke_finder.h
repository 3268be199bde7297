#pragma once

#include "motion/motion.h"
#include "signal/ring.h"
#include "signal/slope_window.h"
#include "soundness/tracker_steps.h"
#include "soundness/tremble_filter.h"
#include "strokes/held_pose.h"
#include "strokes/slow_moments.h"
#include "strokes/stroke.h"
#include "strokes/way_knots.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace steadyhand {

/// Cuts a stream of places into strokes where the hand slows down to a share of the stroke's own peak speed,
/// so that neither the gesture's size nor its pace matters, nor how much a tracker trembles. What is kept of
/// the past is bounded; after construction nothing is allocated.
class StrokeFinder {
public:
	/// scale: what a metre of each coordinate counts. smallest_m: what is shorter, so counted, is no stroke
	/// of its own: the hand only trembled.
	explicit StrokeFinder(const FeaturePlace &scale = FeaturePlace::Ones(), double smallest_m = 0.0) :
			scale_(scale), smallest_m_(smallest_m) {}
	void set_smallest(double smallest_m) { smallest_m_ = smallest_m; }
	[[nodiscard]] double smallest_m() const { return smallest_m_; }

	/// t_s must not decrease; a place that is not finite, comes sooner than LEAST_FRAME_S after the last one,
	/// or repeats it to the last bit (a tracker that is frozen), is no news of the hand.
	void push(double t_s, const FeaturePlace &place_m);
	/// What was shown since `before`, a copy, was not the hand: but for frames_since all is as it was then.
	void forget_since(const StrokeFinder &before);

	/// The one under way, or the one that has just ended, first; that one and those before it as one, where
	/// the hand only hesitated between them, newest first; at last one that was lost. None while nothing is
	/// known of the hand; of one that came into view on its way what it has done since, until it is slow.
	[[nodiscard]] std::span<const Stroke> strokes() const { return { strokes_.data(), stroke_count_ }; }
	/// The last frame ended the first, and with it those that it is part of.
	[[nodiscard]] bool ended() const { return ended_; }
	/// f(t_s, place, step) for the frames since then, as they were given; as many as are kept. step: by which
	/// the tracker shows the hand beside where the first frames had it; NaN where that is not known (yet).
	template <class Function> void frames_since(double t_s, const Function &f) const {
		for (std::size_t i = 0; i < past_.size(); ++i) {
			if (past_[i].t_s >= t_s) {
				f(past_[i].t_s, past_[i].place_m, past_[i].step_m);
			}
		}
	}
	/// How far from `from` the hand was before the onset of one of strokes(), at most, m: before slow strokes
	/// it is looked at for longer, as a hand that wanders slowly hardly moves for a while where it turns.
	[[nodiscard]] double unrest_m(const Stroke &stroke) const;
	/// How far it was between the two times from where it was at then_s, at most, m.
	[[nodiscard]] double stray_m(double since_s, double then_s) const {
		return knots_.stray_m(since_s, then_s);
	}
	/// Where the hand is, as strokes count it.
	[[nodiscard]] const FeaturePlace &place_m() const { return newest_.place_m; }
	/// By how far the tracker shows it beside that.
	[[nodiscard]] const FeaturePlace &step_m() const { return steps_.step_m(); }
	[[nodiscard]] double speed_m_s() const { return speed_m_s_; }
	/// TrembleFilter::noise_m, of places as strokes count them.
	[[nodiscard]] double noise_m() const { return trembles_.noise_m(); }
	/// When a place last was news of the hand; -infinity before the first one.
	[[nodiscard]] double news_s() const { return past_.empty() ? -INFINITY : pose_.first_shown_s(); }

private:
	static constexpr std::size_t FRAMES = 64; ///< of the window in which the speed is taken
	static constexpr std::size_t PAST = 256;
	static constexpr std::size_t EARLIER = 5;

	struct Sample {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace sum = FeaturePlace::Zero(); ///< of place over the way, m^2
		double speed_m_s = 0.0;
		FeaturePlace seen_m = FeaturePlace::Zero(); ///< as given
		int leaps = 0;                              ///< so far
		double way_m = 0.0;                         ///< gone so far
		double speed_s = -INFINITY;                 ///< when the hand had the speed
		double unrest_m = 0.0, watched_s = 0.0;     ///< as in Stroke; of onsets
	};

	struct Earlier {
		Sample onset;
		double peak_m_s = 0.0; ///< since then, until the end of the newest of them
	};

	struct GivenFrame {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace step_m = FeaturePlace::Zero(); ///< as TrackerSteps has it
	};

	FeaturePlace scale_;
	double smallest_m_;
	TrackerSteps steps_;
	TrembleFilter trembles_;
	Ring<GivenFrame, PAST> past_;
	SlopeWindow<FeaturePlace, FRAMES> places_;
	Sample end_;     ///< of the one under way, should the newest frame end it
	Sample newest_;  ///< of speed 0: an end is slower than all that comes after it
	Sample piece_;   ///< where the newest straight piece of the way begins; no trembling lengthens the way
	WayKnots knots_; ///< scaled
	SlowMoments<Sample> slow_moments_;

	FeaturePlace leapt_m_ = FeaturePlace::Zero(); ///< by which the tracker shows the hand beside its place
	int leaps_ = 0;                               ///< times that it changed at once
	double seen_since_s_ = 0.0;                   ///< frozen frames count as seen
	double lost_since_s_ = -INFINITY;             ///< the last time that nobody knows where the hand was,
	double found_s_ = -INFINITY;                  ///< and its end
	HeldPose pose_;                               ///< shown first when a place was last news
	double speed_m_s_ = 0.0;
	double peak_m_s_ = 0.0;
	std::optional<Sample> onset_;
	std::array<Earlier, EARLIER> earlier_{}; ///< strokes that the hand went on from, oldest first
	std::size_t earlier_count_ = 0;
	double earlier_end_s_ = 0.0;
	bool ended_ = false;
	std::array<Stroke, 2 + EARLIER> strokes_{};
	std::size_t stroke_count_ = 0;
	std::optional<Stroke> lost_; ///< the last of them, where it is
	/// Where the hand came into view, until it has been slow; its speed: 0 until that is known.
	std::optional<Sample> entry_;

	[[nodiscard]] bool rests() const;
	void see(double t_s, const FeaturePlace &place_m);
	void restart(double t_s, const FeaturePlace &place_m, bool is_news);
	void remember(const TrackerSteps::Passed &passed);
	void take(double t_s, const FeaturePlace &place_m, double rest_shown_s, bool may_end);
	void follow(std::span<const TrackerSteps::Passed> passed, bool may_end);
	void follow(const TrembleFilter::Place &place, bool may_end);
	void find_onset();
	void begin_anew(const Sample &end);
	void remember_stroke(const Sample &onset, const Sample &end);
	[[nodiscard]] bool turned_unseen(const FeaturePlace &place_m) const;
	void list_strokes(const Sample &now);
	void list_entering(Sample &r_entry, const Sample &now);
	void list_since(const Sample &onset, const Sample &now);
	void measure_way(Sample &r_sample);
	void measure_rest(Sample &r_onset) const;
	[[nodiscard]] static Stroke between(const Sample &onset, const Sample &now, double peak_m_s);
};

} // namespace steadyhand
