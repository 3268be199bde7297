#pragma once

#include "gesture/feature.h"

#include <cmath>
#include <cstdint>

namespace steadyhand {

/// Which frames are news of the hand. A tracker that is read more often than it looks, or that rounds,
/// repeats itself while all is well; one that has lost the hand may repeat itself too, and is frozen.
class TrackerSilence {
public:
	/// What is back so soon where it rested, to the last bit, has not left; a hand that passes there may be.
	static constexpr double BACK_S = 0.2;
	static constexpr double SHORTEST_FRAME_S = 1e-4; ///< over which a speed is taken

	void start(double t_s) { changed_s_ = t_s_ = t_s; }
	/// The first interval between frames is the first guess of the one between news.
	void expect(double interval_s) { interval_s_ = interval_s; }
	/// A frame that repeats the one before, to the last bit.
	void repeat(double t_s) { come_to(t_s); }
	/// A frame that does not, at x; steps: since the last one of those; in amplitudes.
	void change(double t_s, double x, double step, const FeaturePlace &place_step);
	/// All of that which is learned where no hand's motion led to x: how often the tracker looks.
	void look(double t_s, double x);

	/// It has repeated itself for longer than it does.
	[[nodiscard]] bool is_silent() const;
	/// Silent although the hand was on its way, and not on its way back to the start and there, or although
	/// the tracker had been trembling as every hand and sensor does and does not round that away. Exact
	/// stillness of a track that never trembled is rest.
	[[nodiscard]] bool is_frozen() const;
	/// The newest frame shows where the hand is: it repeats nothing, or the hand is at rest.
	[[nodiscard]] bool told() const { return t_s_ == changed_s_ || (is_silent() && !is_frozen()); }

	/// A period that follows one that grows within some frames, and a burst of short ones slowly.
	static double followed(double period_s, double latest_s);

private:
	double t_s_ = 0.0;
	double frame_s_ = 0.01; ///< between the newest frames
	double changed_s_ = 0.0;
	double interval_s_ = 0.01; ///< between changes
	int changes_ = 0;          ///< so far, up to as many as tell the interval
	double x_ = 0.0;
	double speed_ = 0.0;  ///< smoothed
	double latest_ = 0.0; ///< of the last step
	double step_ = 0.0;
	double way_ = 0.0; ///< of the last two steps
	FeaturePlace place_step_ = FeaturePlace::Zero();
	std::uint64_t turns_ = 0;
	double least_step_ = INFINITY; ///< in a coordinate, but 0
	double least_share_ = 0.0;

	void come_to(double t_s);
	void look_for_resolution(double step, const FeaturePlace &place_step);
};

} // namespace steadyhand
