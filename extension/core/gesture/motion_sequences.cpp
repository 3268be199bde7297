#include "gesture/motion_sequences.h"

#include "gesture/directed_hmm.h"
#include "gesture/symbol_clock.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

MotionInstants::MotionInstants(const Track &track) {
	HandMotionWindow window;
	SymbolClock clock;
	clock.start(track.frames.front().t_s);
	first_s_ = clock.next_s();
	bool is_new = false;
	for (const HandFrame &frame : track.frames) {
		// Instants before this frame use only earlier frames.
		for (; clock.due(std::nextafter(frame.t_s, -INFINITY)); clock.advance()) {
			motions_.push_back(is_new ? std::optional(window.motion()) : std::nullopt);
			is_new = false;
		}
		is_new = window.push(frame) || is_new;
	}
}

int MotionInstants::index(double t_s) const {
	return static_cast<int>(std::lround((t_s - first_s_) / SymbolClock::PERIOD_S));
}

std::optional<HandMotion> MotionInstants::last_motion(int index) const {
	constexpr int LONGEST_GAP = 5;
	for (int i = std::min(index, size() - 1); i >= std::max(index - LONGEST_GAP, 0); --i) {
		if (motions_[static_cast<std::size_t>(i)]) {
			return motions_[static_cast<std::size_t>(i)];
		}
	}
	return std::nullopt;
}

std::optional<MotionSequence> MotionInstants::sequence(const MotionMarks &marks, int states) const {
	const int last = std::min(marks.last, size() - 1);
	int begin = std::max(marks.begin, 0);
	while (begin < std::min(marks.onset, size() - 1) && !motions_[static_cast<std::size_t>(begin)]) {
		++begin;
	}
	if (begin >= last) {
		return std::nullopt;
	}
	const std::optional<HandMotion> &first = motions_[static_cast<std::size_t>(begin)];
	if (!first) {
		return std::nullopt;
	}
	MotionSequence sequence;
	MotionObserver observer(*first);
	const int moves = std::max(marks.end - marks.onset, 1), stays = std::max(last - marks.end, 1);
	const int moving_states = states - 1 - END_STATES;
	for (int i = begin; i <= last; ++i) {
		const std::optional<HandMotion> &motion = motions_[static_cast<std::size_t>(i)];
		sequence.points.push_back(motion ? std::optional(observer.observe(*motion)) : std::nullopt);
		const int moving = std::min(1 + (i - marks.onset) * moving_states / moves, moving_states);
		const int after = std::min(1 + (i - marks.end) * END_STATES / stays, END_STATES);
		sequence.states.push_back(i < marks.onset ? 0 : i > marks.end ? moving_states + after : moving);
	}
	return sequence;
}

} // namespace steadyhand
