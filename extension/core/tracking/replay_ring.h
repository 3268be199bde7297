#pragma once

#include "signal/ring.h"

#include <cstddef>

namespace steadyhand {

/// The newest frames and a checkpoint of a state before them, so that frames that turn out to be wrong can be
/// taken back: the state becomes what it would be without them. Frame has a stamp t_s; stamps do not
/// decrease. Frame and State are copied; nothing is allocated if their copies are not.
///
/// A state is copied every CAPACITY / 2 frames, not at each: between CAPACITY / 2 and CAPACITY of the newest
/// frames can be taken back.
template <class Frame, class State, std::size_t CAPACITY = 64> class ReplayRing {
public:
	/// Forgets all frames; `state` is that before the next one.
	void start(const State &state) {
		frames_.clear();
		before_first_ = state;
	}

	/// The newest frame, and the state before it.
	void push(const Frame &frame, const State &state_before) {
		if (frames_.size() == CAPACITY) {
			for (std::size_t i = 0; i < HALF; ++i) {
				frames_.drop_oldest();
			}
			before_first_ = before_middle_;
		}
		if (frames_.size() == HALF) {
			before_middle_ = state_before;
		}
		frames_.push(frame);
	}

	/// Takes back all frames stamped since_s or later. r_state becomes that before the oldest frame kept, and
	/// `replay(r_state, frame)` is called for each that remains. False: some frames were too old to be taken
	/// back.
	template <class Replay> bool retract(double since_s, State &r_state, Replay replay) {
		const bool has_all = !frames_.empty() && frames_[0].t_s <= since_s;
		std::size_t count = frames_.size();
		while (count > 0 && frames_[count - 1].t_s >= since_s) {
			--count;
			frames_.drop_newest();
		}
		r_state = count > HALF ? before_middle_ : before_first_;
		for (std::size_t i = count > HALF ? HALF : 0; i < count; ++i) {
			replay(r_state, frames_[i]);
		}
		return has_all;
	}

	[[nodiscard]] std::size_t size() const { return frames_.size(); }

private:
	static constexpr std::size_t HALF = CAPACITY / 2;

	Ring<Frame, CAPACITY> frames_;
	State before_first_{};
	State before_middle_{}; ///< before frame HALF, where there are more
};

} // namespace steadyhand
