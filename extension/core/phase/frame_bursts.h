#pragma once

#include "gesture/feature.h"
#include "motion/motion.h"

#include <limits>

namespace steadyhand {

/// Frames of a link that holds them up and lets several through at once, stamped as they come: the newest of
/// such a burst tells where the hand is, the others where it was. Before a tracker that has come in bursts
/// the first frame after a pause waits until no other can be of the same one. In amplitudes.
class FrameBursts {
public:
	struct Frame {
		double t_s = 0.0;
		double x = 0.0;
		FeaturePlace place = FeaturePlace::Zero();
	};

	/// Whether the frame is to wait. used_s: when one was last used, before it. What is due by then has been
	/// taken.
	[[nodiscard]] bool holds(const Frame &frame, double used_s) {
		if (is_holding_) {
			burst_s_ = held_.x != frame.x ? frame.t_s : burst_s_;
			held_ = frame;
			return true;
		}
		const double since_s = frame.t_s - used_s;
		if (since_s < LEAST_FRAME_S) { // of no use
			burst_s_ = is_first_ && frame.x != used_x_ ? frame.t_s : burst_s_;
			return false;
		}
		is_first_ = since_s > PAUSE_S;
		used_x_ = frame.x;
		if (is_first_ && frame.t_s - burst_s_ < REMEMBERED_S) {
			held_ = frame;
			is_holding_ = true;
			due_s_ = frame.t_s + LEAST_FRAME_S;
		}
		return is_holding_;
	}
	[[nodiscard]] bool is_holding() const { return is_holding_; }
	/// When what is held is to be used.
	[[nodiscard]] double due_s() const { return due_s_; }
	/// Holds none afterwards.
	[[nodiscard]] Frame take() {
		is_holding_ = false;
		return held_;
	}
	void forget() { is_holding_ = false; }

private:
	static constexpr double PAUSE_S = 0.007;    ///< between frames: longer than between those of a burst
	static constexpr double REMEMBERED_S = 1.0; ///< that a tracker has come in bursts

	Frame held_;
	bool is_holding_ = false;
	double due_s_ = 0.0;
	bool is_first_ = false; ///< the last one used came after a pause
	double used_x_ = 0.0;
	double burst_s_ = -std::numeric_limits<double>::infinity(); ///< when one was last seen
};

} // namespace steadyhand
