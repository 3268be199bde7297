#pragma once

#include "motion/motion.h"
#include "signal/ring.h"
#include "signal/slope_window.h"
#include "strokes/path_knots.h"
#include "strokes/slow_moments.h"
#include "strokes/stroke.h"
#include "tracking/measurement.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace steadyhand {

/// Cuts a stream of positions into strokes. A stroke begins and ends at a fraction of its own peak speed, so
/// that neither the gesture's size nor its pace matters. The memory is bounded; only the constructor
/// allocates.
class StrokeFinder {
public:
	/// scale: factor of each coordinate. smallest_m: scaled length; a shorter movement is tremor, not a
	/// stroke.
	explicit StrokeFinder(const FeaturePlace &scale = FeaturePlace::Ones(), double smallest_m = 0.0) :
			scale_(scale), smallest_m_(smallest_m) {}
	void set_smallest(double smallest_m) { smallest_m_ = smallest_m; }
	[[nodiscard]] double smallest_m() const { return smallest_m_; }

	/// Time stamps must not decrease. place_m: position of the feature in the measured frame, finite;
	/// displacement_m: of the tracker, in the feature's coordinates. A measurement that is not usable, or too
	/// soon after the last one, is ignored.
	void push(const Measurement &measurement, const FeaturePlace &place_m,
			const FeaturePlace &displacement_m = FeaturePlace::Zero());

	/// First the present stroke, or the one that has just ended. Then, if the hand only hesitated, the
	/// present stroke joined with the ones before it: first with one, then with two, and so on. Empty
	/// without an onset.
	[[nodiscard]] std::span<const Stroke> strokes() const { return { strokes_.data(), stroke_count_ }; }
	/// The newest frame ended all of strokes().
	[[nodiscard]] bool ended() const { return ended_; }
	/// Calls f(t_s, place_m) for each used measurement since t_s, of the newest PAST ones. Positions are
	/// unscaled and corrected for the tracker's displacement.
	template <class Function> void frames_since(double t_s, const Function &f) const {
		for (std::size_t i = 0; i < past_.size(); ++i) {
			if (past_[i].t_s >= t_s) {
				f(past_[i].t_s, past_[i].place_m);
			}
		}
	}
	/// Greatest distance, m, of the hand from `from` before the onset of one of strokes(). The time before
	/// slow strokes is longer: a hand that wanders slowly hardly moves where it turns.
	[[nodiscard]] double motion_before_m(const Stroke &stroke) const;
	/// Displacement of the tracker in the newest frame.
	[[nodiscard]] const FeaturePlace &displacement_m() const { return displacement_m_; }
	[[nodiscard]] double speed_m_s() const { return speed_m_s_; }
	/// Time of the last used measurement; -infinity before the first one.
	[[nodiscard]] double last_measurement_s() const { return past_.empty() ? -INFINITY : past_.newest().t_s; }

private:
	static constexpr std::size_t FRAMES = 64; ///< of the window of the speed
	static constexpr std::size_t PAST = 256;
	static constexpr std::size_t EARLIER = 5;

	struct Sample {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();    ///< corrected for the tracker's displacement
		FeaturePlace measured_m = FeaturePlace::Zero(); ///< not corrected
		FeaturePlace sum = FeaturePlace::Zero();        ///< integral of place_m over the path, m^2
		double speed_m_s = 0.0;
		double path_m = 0.0;                                  ///< length of the path since restart()
		double speed_s = -INFINITY;                           ///< time of the speed: the middle of its window
		double motion_before_m = 0.0, tracked_before_s = 0.0; ///< of onsets: as in Stroke
		bool is_rest = true;                                  ///< of onsets: Stroke::is_from_rest
	};

	struct Earlier {
		Sample onset;
		double peak_m_s = 0.0; ///< peak speed from this onset to earlier_end_s_
	};

	struct PastFrame {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
	};

	FeaturePlace scale_;
	double smallest_m_;
	Ring<PastFrame, PAST> past_;
	Ring<Sample, FRAMES> recent_; ///< samples of the mean
	SlopeWindow<FeaturePlace, FRAMES> places_;
	Sample end_;      ///< end of the present stroke if the newest frame ends it
	Sample newest_;   ///< speed_m_s stays 0: an end counts as slower than all later samples
	Sample piece_;    ///< start of the newest straight piece of the path; tremor does not lengthen the path
	PathKnots knots_; ///< scaled positions
	SlowMoments<Sample> slow_moments_;

	/// End and length of the last dropout.
	double found_s_ = -INFINITY, dropout_s_ = 0.0;
	double noise_m_ = 0.0; ///< of the newest measurement
	FeaturePlace displacement_m_ = FeaturePlace::Zero();
	double speed_m_s_ = 0.0;
	double peak_m_s_ = 0.0;
	std::optional<Sample> onset_;
	std::array<Earlier, EARLIER> earlier_{}; ///< strokes before the present one without a pause, oldest first
	std::size_t earlier_count_ = 0;
	double earlier_end_s_ = 0.0;
	bool ended_ = false;
	std::array<Stroke, 1 + EARLIER> strokes_{};
	std::size_t stroke_count_ = 0;
	std::optional<Sample> entry_; ///< first measurement of the hand, until the first onset or end

	void restart(const Sample &first);
	void follow(Sample now);
	void find_onset();
	void start_new_stroke(const Sample &end);
	void store_stroke(const Sample &onset, const Sample &end);
	[[nodiscard]] bool reverses(const FeaturePlace &place_m) const;
	[[nodiscard]] Sample smoothed(const Sample &now);
	void list_strokes(const Sample &now);
	void update_path(Sample &r_sample);
	void measure_rest(Sample &r_onset) const;
	[[nodiscard]] static Stroke between(const Sample &onset, const Sample &now, double peak_m_s);
};

} // namespace steadyhand
