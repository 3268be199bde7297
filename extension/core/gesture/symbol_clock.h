#pragma once

#include <cmath>
#include <cstdint>

namespace steadyhand {

/// Clock of the HMM symbols: multiples of PERIOD_S on the frames' clock. The period does not depend on the
/// sensor, so that transition probabilities are equal for a 30 Hz camera and a 240 Hz tracker (paper,
/// "normalise in time stamp"). 100 Hz is a common rate of hand trackers. An instant without a new frame has
/// no observation.
class SymbolClock {
public:
	static constexpr double PERIOD_S = 0.01;

	/// Starts over: the next instant is the first one at or after t_s.
	void start(double t_s) {
		next_ = static_cast<std::int64_t>(std::ceil(t_s / PERIOD_S)) - 1; // the quotient may be rounded up
		while (next_s() < t_s) {
			++next_;
		}
	}

	/// True while an instant at or before t_s is due.
	[[nodiscard]] bool due(double t_s) const { return static_cast<double>(next_) * PERIOD_S <= t_s; }
	[[nodiscard]] double next_s() const { return static_cast<double>(next_) * PERIOD_S; }
	void advance() { ++next_; }

private:
	std::int64_t next_ = 0;
};

} // namespace steadyhand
