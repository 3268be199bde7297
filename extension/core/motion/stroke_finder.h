#pragma once

#include "gesture/feature.h"

#include <array>
#include <cstddef>
#include <optional>

namespace steadyhand {

/// What a hand did from where it was last as good as still to where it is.
struct Stroke {
	double onset_s = 0.0;
	double now_s = 0.0;
	FeaturePlace from = FeaturePlace::Zero();
	FeaturePlace to = FeaturePlace::Zero();
	FeaturePlace middle = FeaturePlace::Zero(); ///< mean over its time
	double peak_m_s = 0.0;
	/// `from` as the tracker showed it: the other places are without the steps that no hand makes.
	FeaturePlace seen_from = FeaturePlace::Zero();
	double way_m = 0.0;    ///< length of the way from `from` to `to`, >= their distance
	double unrest_m = 0.0; ///< how far from `from` the hand was before the onset, at most
	double watched_s =
			0.0; ///< for how long before the onset: no more than REST_S, less where it was not seen

	static constexpr double REST_S = 0.5;
};

/// Cuts a stream of places into strokes where the hand slows down to a share of the stroke's own peak speed,
/// so that neither the gesture's size nor its pace matters, nor how much a tracker trembles. All that is kept
/// of the past is a bounded stack; after construction nothing is allocated.
class StrokeFinder {
public:
	/// t_s must not decrease; a place that is not finite, or repeats the last one to the last bit (a tracker
	/// that is frozen), is no news of the hand.
	void push(double t_s, FeaturePlace place_m);

	/// The one under way, or the one that has just ended; nothing while the hand has not been still yet.
	[[nodiscard]] const std::optional<Stroke> &stroke() const { return stroke_; }
	/// The last two, where the hand hesitated between them: as one.
	[[nodiscard]] const std::optional<Stroke> &joined() const { return joined_; }
	/// The one that was under way before a gap that this frame has ended.
	[[nodiscard]] const std::optional<Stroke> &lost() const { return lost_; }
	/// The last frame ended stroke() and joined().
	[[nodiscard]] bool ended() const { return ended_; }
	/// f(t_s, place) for the frames since then, as they were given; as many as are kept.
	template <class Function> void frames_since(double t_s, const Function &f) const {
		for (std::size_t i = 0; i < past_count_; ++i) {
			const Frame &past = past_[(past_first_ + i) % PAST];
			if (past.t_s >= t_s) {
				f(past.t_s, past.place_m);
			}
		}
	}
	[[nodiscard]] double speed_m_s() const { return speed_m_s_; }

private:
	static constexpr std::size_t FRAMES = 64; ///< of the window in which the speed is taken
	static constexpr std::size_t PAST = 256;
	static constexpr std::size_t RESTS = 112; ///< speeds of 1 mm/s to 40 m/s, each 1.1 times the last
	static constexpr std::size_t KNOTS = 16;  ///< more than REST_S of them

	struct Sample {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace sum = FeaturePlace::Zero(); ///< of place over time, m s
		double speed_m_s = 0.0;
		FeaturePlace seen_m = FeaturePlace::Zero(); ///< as given
		double way_m = 0.0;                         ///< gone so far
		double unrest_m = 0.0, watched_s = 0.0;     ///< as in Stroke
	};

	struct Frame {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
	};

	std::array<Frame, PAST> past_{};
	std::size_t past_first_ = 0;
	std::size_t past_count_ = 0;
	std::array<Sample, FRAMES> frames_{};
	std::size_t first_ = 0;
	std::size_t count_ = 0;
	/// The way in straight pieces, so that no trembling lengthens it; the newest is at (knot_count_ - 1) %
	/// KNOTS.
	std::array<Sample, KNOTS> knots_{};
	std::size_t knot_count_ = 0;
	/// The last time that the hand was slower than ever since: speeds rise from the bottom up.
	std::array<Sample, RESTS> rests_{};
	std::size_t rest_count_ = 0;

	double seen_since_s_ = 0.0;                  ///< frozen frames count as seen
	FeaturePlace last_m_ = FeaturePlace::Zero(); ///< as given
	FeaturePlace step_m_ = FeaturePlace::Zero(); ///< sum of the steps that no hand makes
	FeaturePlace velocity_m_s_ = FeaturePlace::Zero();
	double speed_m_s_ = 0.0;
	double peak_m_s_ = 0.0;
	std::optional<Sample> onset_;
	std::optional<Sample> earlier_onset_;
	double earlier_end_s_ = 0.0;
	bool ended_ = false;
	std::optional<Stroke> stroke_, joined_, lost_;

	[[nodiscard]] Sample &frame(std::size_t i) { return frames_[(first_ + i) % FRAMES]; }
	void remember_frame(double t_s, const FeaturePlace &place_m);
	void restart(double t_s, const FeaturePlace &place_m);
	void keep(const Sample &sample);
	void begin_anew(const Sample &end);
	void measure_way(Sample &r_sample);
	void measure_velocity();
	void remember_rest(const Sample &sample);
	[[nodiscard]] const Sample *last_slower_than(double speed_m_s) const;
	[[nodiscard]] Stroke since(const Sample &onset, const Sample &now) const;
};

} // namespace steadyhand
