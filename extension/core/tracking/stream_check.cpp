#include "tracking/stream_check.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// Largest displacement of a joint, m; nullopt if no joint is in both frames.
std::optional<double> step_m(const HandFrame &from, const HandFrame &to) {
	std::optional<double> most_m;
	for (std::size_t i = 0; i < JOINT_COUNT; ++i) {
		if (from.has(static_cast<Joint>(i)) && to.has(static_cast<Joint>(i))) {
			most_m = std::max(most_m.value_or(0.0), (to.positions_m[i] - from.positions_m[i]).norm());
		}
	}
	return most_m;
}

} // namespace

std::string_view explain(StreamFault fault) {
	switch (fault) {
		case StreamFault::EQUAL_TIME_STAMPS:
			return "the hand moves, but the time does not. Give each frame its own time";
		case StreamFault::TOO_RARE:
			return "frames are more than a second apart. Give times in seconds";
		case StreamFault::TOO_FAST:
			return "the hand has been faster than 10 m/s for long. Give positions in metres, in a space that "
				   "moves with the player";
	}
	return {};
}

std::optional<StreamFault> StreamCheck::push(const HandFrame &frame) {
	const std::optional<double> moved_m = last_ ? step_m(*last_, frame) : std::nullopt;
	const double step_s = last_ ? frame.t_s - last_->t_s : 0.0;
	if (!moved_m) {
		*this = {};
		last_ = frame;
		return std::nullopt;
	}
	last_ = frame;
	if (step_s == 0.0) {
		equal_stamps_ += *moved_m > 0.0 ? 1 : 0;
		return equal_stamps_ >= FRAMES ? std::optional(StreamFault::EQUAL_TIME_STAMPS) : std::nullopt;
	}
	equal_stamps_ = 0;
	rare_ = step_s > RAREST_S ? rare_ + 1 : 0;
	const bool is_fast = *moved_m > FASTEST_M_S * step_s;
	fast_ = is_fast ? fast_ + 1 : 0;
	fast_for_s_ = is_fast ? fast_for_s_ + step_s : 0.0;
	if (rare_ >= FRAMES) {
		return StreamFault::TOO_RARE;
	}
	const bool is_lasting = fast_ >= FAST_FRAMES && fast_for_s_ >= FAST_S;
	return is_lasting ? std::optional(StreamFault::TOO_FAST) : std::nullopt;
}

} // namespace steadyhand
