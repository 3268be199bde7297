#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace steadyhand {

/// How far a tracker is to be believed, judged by the motion alone, because it says little about its own
/// errors: gaps between stamps, values that repeat to the last bit, steps that no hand makes. Evidence fades
/// over seconds.
class TrackingSoundness {
public:
	/// x: the motion element in amplitudes.
	void push(double t_s, double x) {
		if (frames_ > 0) {
			weigh(std::max(t_s - t_s_, SHORTEST_S), x);
		}
		t_s_ = t_s;
		x_ = x;
		frames_ = std::min(frames_ + 1, 2);
	}

	/// 0: nothing wrong has been seen .. 1.
	[[nodiscard]] double unsoundness() const { return 1.0 - std::exp(-evidence_); }
	/// The tracker repeats itself: the value stands still to the last bit although the hand was on its way,
	/// or although it had been trembling as every hand and sensor does. Exact stillness of a track that never
	/// trembled is rest.
	[[nodiscard]] bool frozen() const {
		return repeats_ >= FROZEN_REPEATS &&
				(std::abs(speed_) > RESTING_PER_S || std::popcount(turns_) >= TREMBLING_TURNS);
	}

private:
	static constexpr double MEMORY_S = 1.5;
	static constexpr double SHORTEST_S = 1e-4;
	/// Trackers double or triple an interval every second or so while all is well (1-3 % of intervals).
	static constexpr double GAP_PERIODS = 4.0;
	static constexpr double FULL_GAP_S = 0.1; ///< a gap of this length is as bad as a jump
	/// Amplitudes: a 0.15 s drag, the fastest that is studied, peaks at 1.875 / 0.15.
	static constexpr double FASTEST_PER_S = 12.5;
	static constexpr double SMALLEST_JUMP = 0.03;
	static constexpr int FROZEN_REPEATS = 2;
	static constexpr double RESTING_PER_S = 0.25;
	static constexpr int TREMBLING_TURNS = 3;  ///< of the last 16 steps, those against the one before
	static constexpr double SPEED_SHARE = 0.4; ///< a frame's share in the recent speed
	static constexpr double FROZEN_FRAME = 0.25;
	static constexpr double PERIOD_GROWTH = 1.02; ///< a frame, so that a sensor that slows down is understood

	double t_s_ = 0.0;
	double x_ = 0.0;
	double period_s_ = 0.01;
	double evidence_ = 0.0;
	double speed_ = 0.0;
	double step_ = 0.0;
	std::uint16_t turns_ = 0;
	int repeats_ = 0;
	int frames_ = 0;

	void weigh(double dt_s, double x) {
		evidence_ *= std::exp(-dt_s / MEMORY_S);
		if (frames_ == 1) {
			period_s_ = dt_s;
		}
		if (dt_s > GAP_PERIODS * period_s_) {
			evidence_ += std::min(1.0, (dt_s - 2.0 * period_s_) / FULL_GAP_S);
		}
		if (std::abs(x - x_) > FASTEST_PER_S * dt_s + SMALLEST_JUMP) {
			evidence_ += 1.0;
		}
		if (x == x_) {
			repeats_ = std::min(repeats_ + 1, FROZEN_REPEATS);
		} else {
			repeats_ = 0;
			speed_ += SPEED_SHARE * ((x - x_) / dt_s - speed_);
			turns_ = static_cast<std::uint16_t>((turns_ << 1U) | ((x - x_) * step_ < 0.0 ? 1U : 0U));
			step_ = x - x_;
		}
		if (frozen()) {
			evidence_ += FROZEN_FRAME;
		}
		period_s_ = std::min(period_s_ * PERIOD_GROWTH, dt_s);
	}
};

} // namespace steadyhand
