#pragma once

#include "gesture/feature.h"
#include "signal/ring.h"

#include <array>
#include <cstddef>

namespace steadyhand {

/// Takes a tracker's trembling out of a stream of places where it would pass for strokes of the hand: each
/// place becomes the mean over a window, at the window's mean time, that is as long as the noise in the
/// frames asks for; none where it is small, and the frames pass as they are. The noise is judged by turns:
/// second differences of noise turn about from one to the next, those of a hand do not.
class TrembleFilter {
public:
	struct Place {
		double t_s = 0.0;
		FeaturePlace place_m = FeaturePlace::Zero();
		FeaturePlace seen_m = FeaturePlace::Zero(); ///< averaged in the same way
	};

	/// The next place has nothing to do with the last one.
	void restart();
	/// t_s must increase. still_m_s: slopes over slope_s that the noise may make, at most; 0: no matter.
	Place push(const Place &place, double slope_s, double still_m_s);
	/// Of white noise of deviation s in each of one, two, three coordinates 0.62, 1.07, 1.42 s in the mean,
	/// m.
	[[nodiscard]] double noise_m() const { return noise_m_; }

private:
	static constexpr std::size_t FRAMES = 64;

	Ring<Place, FRAMES> frames_;
	double period_s_ = 0.0;          ///< mean, between frames
	std::array<Place, 2> anchors_{}; ///< places some time apart, the newest last
	int anchor_count_ = 0;
	FeaturePlace bend_m_ = FeaturePlace::Zero(); ///< the newest second difference of anchors
	double noise_m_ = 0.0;
	int bends_ = 0;

	void measure_noise(const Place &place);
	void remember_turn(double turn_m);
};

} // namespace steadyhand
