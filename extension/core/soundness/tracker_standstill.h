#pragma once

#include "signal/constant_velocity_state.h"
#include "soundness/hands.h"

#include <algorithm>
#include <cmath>

namespace steadyhand {

/// Which frames show where the tracker lost the hand. One that trembles there, or whose places a headset's
/// motion shifts a little, never repeats itself, but it has stopped dead: it is where the last frame was, and
/// not where a hand that moved like that would be. Along the way, in amplitudes.
class TrackerStandstill {
public:
	void start(double t_s, double x) {
		told_ = {
			.t_s = t_s, .x = x, .hand = { .position = x, .p00 = FIRST_VARIANCE, .p11 = FIRST_VARIANCE_PER_S2 }
		};
		before_ = told_;
		rested_ = x;
		slow_since_s_ = t_s;
	}

	/// Whether x shows the place of the last frame that told where the hand is, and not where the hand would
	/// be, by their likelihoods. noise: the tracker's, standard deviation.
	[[nodiscard]] bool stands(double t_s, double x, double noise) const {
		if (repeated_ || frames_ < FIRST_FRAMES || t_s - told_.t_s > LONGEST_S || !is_moving() ||
				std::min(std::abs(x - rested_), std::abs(x)) < BACK_AT_REST || std::abs(x - 1.0) < AT_END) {
			return false;
		}
		const double noise_variance = variance(noise);
		const auto goes_on = [&](const Told &from) {
			const ConstantVelocityState hand = from.hand_at(t_s);
			return log_likelihood(x - hand.position, hand.p00 + noise_variance);
		};
		// The last frame may have been elsewhere, and the hand is where the one before it said.
		return log_likelihood(x - told_.x, 2.0 * noise_variance) >
				LOG_RATIO + std::max({ goes_on(told_), goes_on(before_), goes_on(braking()) });
	}

	/// A frame that shows that place to the last bit: a tracker that repeats itself does not tremble.
	void repeat() { repeated_ = true; }
	/// A frame that tells where the hand is. One that is off the way says nothing of the velocity, but that
	/// what was seen of it may have been the tracker's.
	void tell(double t_s, double x, double noise) {
		const double noise_variance = variance(noise);
		ConstantVelocityState hand = told_.hand_at(t_s);
		const double off = x - hand.position;
		const bool is_off_way =
				off * off > OFF_WAY_DEVIATIONS * OFF_WAY_DEVIATIONS * (hand.p00 + noise_variance);
		if (is_off_way) {
			hand.position = x;
			hand.p00 = noise_variance;
			hand.p01 = 0.0;
			hand.p11 += hand.velocity * hand.velocity;
		} else {
			hand.correct(x, noise_variance);
		}
		top_speed_ = std::max(std::abs(hand.velocity), top_speed_ * std::exp((told_.t_s - t_s) / BRAKES_S));
		if (std::abs(hand.velocity) > RESTING_PER_S) {
			slow_since_s_ = t_s;
		} else if (t_s - slow_since_s_ > RESTING_S && !is_off_way) {
			rested_ = x;
		}
		before_ = told_;
		told_ = { .t_s = t_s, .x = x, .hand = hand };
		frames_ = std::min(frames_ + 1, FIRST_FRAMES);
		repeated_ = false;
	}
	/// How long the hand has been slower than one that goes anywhere, as it was last told.
	[[nodiscard]] double slow_for_s() const { return told_.t_s - slow_since_s_; }
	/// The last frame is as if it had not been.
	void forget() { told_ = before_; }

private:
	static constexpr double LOG_RATIO = 1.5;
	static constexpr int FIRST_FRAMES = 20; ///< the noise is not known before
	/// A hand that stays for longer where it stopped has been stopped by something.
	static constexpr double LONGEST_S = 0.5;
	static constexpr double RESTING_S = 0.1; ///< a hand that has been slow for so long is at rest
	/// A tracker that stops so near to where a hand rested, or starts, shows one that has only twitched, or
	/// has come back; or it has shifted as a whole.
	static constexpr double BACK_AT_REST = 0.15;
	static constexpr double AT_END = 0.05; ///< of the way, where hands stop
	static constexpr double MOVING_DEVIATIONS = 2.0;
	static constexpr double NOT_YET_BRAKED = 0.9; ///< share of the speed, a frame before it is BRAKED
	static constexpr double OFF_WAY_DEVIATIONS = 4.0;
	/// Power spectral density of a hand's acceleration, amplitudes^2 / s^3, and what it has more for the
	/// square of its speed, 1 / s: a fast one slows down by a fifth from frame to frame.
	static constexpr double ACCELERATION_PSD = 10.0;
	static constexpr double ACCELERATION_PSD_PER_SQUARED_SPEED = 4.0;
	static constexpr double SMALLEST_NOISE = 0.002;
	static constexpr double FIRST_VARIANCE = 1e-5;
	static constexpr double FIRST_VARIANCE_PER_S2 = 1.0; ///< of the velocity

	/// After a frame that told where the hand is.
	struct Told {
		double t_s = 0.0;
		double x = 0.0;
		ConstantVelocityState hand;

		[[nodiscard]] ConstantVelocityState hand_at(double later_s) const {
			ConstantVelocityState later = hand;
			later.predict(later_s - t_s,
					ACCELERATION_PSD + ACCELERATION_PSD_PER_SQUARED_SPEED * hand.velocity * hand.velocity);
			return later;
		}
	};

	int frames_ = 0;
	double rested_ = 0.0; ///< where the hand was last at rest
	double slow_since_s_ = 0.0;
	double top_speed_ = 0.0; ///< of late
	bool repeated_ = false;  ///< since the last frame that told something
	Told told_;
	Told before_; ///< as it was a frame earlier

	[[nodiscard]] bool is_moving() const {
		const double speed = std::abs(told_.hand.velocity);
		// Where the tracker stopped within a frame's time, the last speed is less than the hand's.
		const double braked = is_sparse() ? NOT_YET_BRAKED : BRAKED;
		const bool brakes =
				speed < braked * top_speed_ && std::abs(before_.hand.velocity) < NOT_YET_BRAKED * top_speed_;
		return !brakes && speed > std::max(RESTING_PER_S, MOVING_DEVIATIONS * std::sqrt(told_.hand.p11));
	}
	/// From one frame to the next a hand may all but stop.
	[[nodiscard]] bool is_sparse() const { return told_.t_s - before_.t_s > SPARSE_S; }
	/// The hand, where it slows down once more by what it has since the frame before, or stops.
	[[nodiscard]] Told braking() const {
		Told braking = told_;
		const double velocity = told_.hand.velocity, change = velocity - before_.hand.velocity;
		if (is_sparse() && change * velocity < 0.0) {
			braking.hand.velocity += std::abs(change) < std::abs(velocity) ? change : -velocity;
		}
		return braking;
	}
	static double variance(double noise) { return noise * noise + SMALLEST_NOISE * SMALLEST_NOISE; }
	/// Of a Gaussian, but for a constant.
	static double log_likelihood(double off, double variance) {
		return -0.5 * (off * off / variance + std::log(variance));
	}
};

} // namespace steadyhand
