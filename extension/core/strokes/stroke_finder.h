#pragma once

#include "motion/motion.h"
#include "signal/ring.h"
#include "signal/slope_window.h"
#include "strokes/slow_moments.h"
#include "strokes/stroke.h"
#include "strokes/way_knots.h"
#include "tracking/measurement.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace steadyhand {

/// Cuts a stream of places into strokes where the hand slows down to a share of the stroke's own peak speed,
/// so that neither the gesture's size nor its pace matters. What is kept of the past is bounded; after
/// construction nothing is allocated.
class StrokeFinder {
public:
	/// scale: what a metre of each coordinate counts. smallest_m: what is shorter, so counted, is no stroke
	/// of its own: the hand only trembled.
	explicit StrokeFinder(const FeaturePlace &scale = FeaturePlace::Ones(), double smallest_m = 0.0) :
			scale_(scale), smallest_m_(smallest_m) {}
	void set_smallest(double smallest_m) { smallest_m_ = smallest_m; }
	[[nodiscard]] double smallest_m() const { return smallest_m_; }

	/// Stamps must not decrease. place_m: finite, of the feature, in the frame that was measured;
	/// displacement_m: of the tracker, in the feature's coordinates.
	void push(const Measurement &measurement, const FeaturePlace &place_m,
			const FeaturePlace &displacement_m = FeaturePlace::Zero());

	/// The one under way, or the one that has just ended, first; that one and those before it as one, where
	/// the hand only hesitated between them, newest first. None while nothing is known of the hand.
	[[nodiscard]] std::span<const Stroke> strokes() const { return { strokes_.data(), stroke_count_ }; }
	/// The last frame ended the first, and with it those that it is part of.
	[[nodiscard]] bool ended() const { return ended_; }
	/// f(t_s, place_m) for the frames since then that showed where the hand is; as many as are kept. Places
	/// are unscaled and without the tracker's displacement.
	template <class Function> void frames_since(double t_s, const Function &f) const {
		for (std::size_t i = 0; i < past_.size(); ++i) {
			if (past_[i].t_s >= t_s) {
				f(past_[i].t_s, past_[i].place_m);
			}
		}
	}
	/// How far from `from` the hand was before the onset of one of strokes(), at most, m: before slow strokes
	/// it is looked at for longer, as a hand that wanders slowly hardly moves for a while where it turns.
	[[nodiscard]] double unrest_m(const Stroke &stroke) const;
	/// The tracker's, as of the newest frame.
	[[nodiscard]] const FeaturePlace &displacement_m() const { return displacement_m_; }
	[[nodiscard]] double speed_m_s() const { return speed_m_s_; }
	/// Measurement::noise_m of the newest frame.
	[[nodiscard]] double noise_m() const { return noise_m_; }
	/// When a frame last showed where the hand is; -infinity before the first one.
	[[nodiscard]] double news_s() const { return past_.empty() ? -INFINITY : past_.newest().t_s; }

private:
	static constexpr std::size_t FRAMES = 64; ///< of the window in which the speed is taken
	static constexpr std::size_t PAST = 256;
	static constexpr std::size_t EARLIER = 5;

	struct Sample {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero(); ///< without the tracker's displacement
		FeaturePlace shown_m = FeaturePlace::Zero(); ///< with it
		FeaturePlace sum = FeaturePlace::Zero();     ///< of place over the way, m^2
		double speed_m_s = 0.0;
		double way_m = 0.0;                     ///< gone so far
		double speed_s = -INFINITY;             ///< when the hand had the speed
		double unrest_m = 0.0, watched_s = 0.0; ///< as in Stroke; of onsets
		bool is_rest = true;                    ///< of onsets: Stroke::is_from_rest
	};

	struct Earlier {
		Sample onset;
		double peak_m_s = 0.0; ///< since then, until the end of the newest of them
	};

	struct PastFrame {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
	};

	FeaturePlace scale_;
	double smallest_m_;
	Ring<PastFrame, PAST> past_;
	Ring<Sample, FRAMES> recent_; ///< of which the mean counts
	SlopeWindow<FeaturePlace, FRAMES> places_;
	Sample end_;     ///< of the one under way, should the newest frame end it
	Sample newest_;  ///< of speed 0: an end is slower than all that comes after it
	Sample piece_;   ///< where the newest straight piece of the way begins; no trembling lengthens the way
	WayKnots knots_; ///< scaled
	SlowMoments<Sample> slow_moments_;

	/// When the hand was last found again, and after how long.
	double found_s_ = -INFINITY, gap_s_ = 0.0;
	double noise_m_ = 0.0;
	FeaturePlace displacement_m_ = FeaturePlace::Zero();
	double speed_m_s_ = 0.0;
	double peak_m_s_ = 0.0;
	std::optional<Sample> onset_;
	std::array<Earlier, EARLIER> earlier_{}; ///< strokes that the hand went on from, oldest first
	std::size_t earlier_count_ = 0;
	double earlier_end_s_ = 0.0;
	bool ended_ = false;
	std::array<Stroke, 1 + EARLIER> strokes_{};
	std::size_t stroke_count_ = 0;
	std::optional<Sample> entry_; ///< where the hand came into view, until it has been slow

	void restart(const Sample &first);
	void follow(Sample now);
	void find_onset();
	void begin_anew(const Sample &end);
	void remember_stroke(const Sample &onset, const Sample &end);
	[[nodiscard]] bool turned_unseen(const FeaturePlace &place_m) const;
	[[nodiscard]] Sample smoothed(const Sample &now);
	void list_strokes(const Sample &now);
	void measure_way(Sample &r_sample);
	void measure_rest(Sample &r_onset) const;
	[[nodiscard]] static Stroke between(const Sample &onset, const Sample &now, double peak_m_s);
};

} // namespace steadyhand
