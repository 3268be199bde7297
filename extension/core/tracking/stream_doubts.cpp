#include "tracking/stream_doubts.h"

#include <algorithm>

namespace steadyhand {
namespace {

/// Of the joint that moved most, m; nothing where none is in both.
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

std::optional<StreamDoubt> StreamDoubts::look(const HandFrame &frame) {
	const std::optional<double> gone_m = last_ ? step_m(*last_, frame) : std::nullopt;
	const double step_s = last_ ? frame.t_s - last_->t_s : 0.0;
	if (!gone_m) {
		*this = {};
		last_ = frame;
		return std::nullopt;
	}
	last_ = frame;
	if (step_s == 0.0) {
		standing_ += *gone_m > 0.0 ? 1 : 0;
		return standing_ >= FRAMES ? std::optional(StreamDoubt::TIME_STANDS) : std::nullopt;
	}
	standing_ = 0;
	rare_ = step_s > RAREST_S ? rare_ + 1 : 0;
	const bool is_fast = *gone_m > FASTEST_M_S * step_s;
	fast_ = is_fast ? fast_ + 1 : 0;
	fast_for_s_ = is_fast ? fast_for_s_ + step_s : 0.0;
	if (rare_ >= FRAMES) {
		return StreamDoubt::TOO_RARE;
	}
	const bool goes_on = fast_ >= FAST_FRAMES && fast_for_s_ >= FAST_S;
	return goes_on ? std::optional(StreamDoubt::TOO_FAST) : std::nullopt;
}

} // namespace steadyhand
