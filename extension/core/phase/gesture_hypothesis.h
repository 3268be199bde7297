#pragma once

#include "phase/regime.h"

#include <array>
#include <cstddef>

namespace steadyhand {

/// Along the way, in amplitudes: a hand that is no further may yet be where it started,
inline constexpr double NEAR_START = 0.15;
/// and one that is so near to the end is there.
inline constexpr double AT_END = 0.1;

/// One way in which the frames may have come about: the state of an extended Kalman filter (Bar-Shalom, Li,
/// Kirubarajan 2001) of
///
///     hand(t)    = (1 + g) f(p) + d(t),   p = (t - onset) / duration
///     tracker(t) = (1 + g) f(p - lag f(p) / duration) + d(t) + b(t) + noise
///     f          = (1 - shape) e + shape m;   e: the model's motion elements, m: minimum jerk
///
/// over the state (d, d', b, b', onset, log duration, g, shape, lag). At rest there is no onset, and f = 0.
/// Filtering is done several at a time (HypothesisGroup).
class GestureHypothesis {
public:
	/// The states' places.
	static constexpr std::size_t HAND = 0, HAND_RATE = 1, ERROR = 2, ERROR_RATE = 3, ONSET = 4,
								 LOG_DURATION = 5, GAIN = 6, SHAPE = 7, LAG = 8, STATES = 9;
	/// Of the covariance of two states, row >= column, in a lower triangle stored by rows.
	[[nodiscard]] static constexpr std::size_t entry(std::size_t row, std::size_t column) {
		return row * (row + 1) / 2 + column;
	}
	/// The same in either order.
	[[nodiscard]] static constexpr std::size_t symmetric_entry(std::size_t i, std::size_t j) {
		return i > j ? entry(i, j) : entry(j, i);
	}
	static constexpr std::size_t ENTRIES = STATES * (STATES + 1) / 2;

	double log_weight = 0.0;

	/// At rest, d from where it should be.
	static GestureHypothesis resting(double d);
	/// No longer in a gesture, and not yet at rest; d' is about that.
	static GestureHypothesis leaving(double d, double d_rate);
	/// By which a tracker is late at the end of a way of that duration.
	[[nodiscard]] static double expected_lag_s(Regime regime, double duration_s);
	/// The same hand and tracker, on its way since onset_s; deviations: standard. gain_spread: by which that
	/// of g is multiplied.
	[[nodiscard]] GestureHypothesis begun(Regime regime, double onset_s, double onset_deviation_s,
			double log_duration, double log_duration_deviation, double gain_spread = 1.0) const;
	/// The same hand and tracker from now on in a regime; the tracker errs as it does there, and if it slid
	/// it moves no more against the hand.
	[[nodiscard]] GestureHypothesis in(Regime regime) const;
	/// Of one at rest: the same hand and regime before a tracker that errs like that.
	[[nodiscard]] GestureHypothesis before(TrackerError error) const {
		GestureHypothesis h = *this;
		h.error_ = error;
		return h;
	}
	/// Of one whose gesture is over: the same hand from now on free, and on no way.
	[[nodiscard]] GestureHypothesis leaving_end() const;
	/// Of one that is free and on no way: the same hand, which has made the gesture and is beside its end.
	[[nodiscard]] GestureHypothesis at_end(double onset_s, double log_duration) const;
	/// A hand that stands at x, where the tracker shows it: it has made a gesture of that length, in a second
	/// from onset_s on, which is over for long. Faults do not speak against it, as with UNSOUND, but the
	/// tracker is right.
	[[nodiscard]] static GestureHypothesis standing(double x, double onset_s);
	/// Of one that is free: the same, but that the hand, which was not seen, has been so for so long, and the
	/// tracker has found it.
	[[nodiscard]] GestureHypothesis free_for(double unseen_s) const;

	/// The same, but that the tracker has jumped: it shows the hand beside where it is from now on.
	[[nodiscard]] GestureHypothesis displaced(double deviation) const;
	/// As displaced, but that the tracker slides back within 0.2 s.
	[[nodiscard]] GestureHypothesis displaced_sliding_back(double deviation) const;
	/// Of one on its way: the tracker had fallen behind, by that much unknown, and slides to where the hand
	/// is.
	[[nodiscard]] GestureHypothesis caught_up(double behind_s, double deviation) const;
	/// Of one that is free: the tracker had been astray, and shows the hand again, which is elsewhere.
	[[nodiscard]] GestureHypothesis found_elsewhere(double deviation) const;
	/// The tracker's error is as if nothing were known of it.
	void forget_error();

	[[nodiscard]] bool on_its_way() const { return on_its_way_; }
	[[nodiscard]] Regime regime() const { return regime_; }

private:
	friend class HypothesisGroup;

	std::array<double, STATES> mean_{};
	std::array<double, ENTRIES> covariance_{};
	double rate_per_s_ = 1.0; ///< exp(-log duration)
	Regime regime_ = Regime::REST;
	TrackerError error_ = TrackerError::SLIGHT;
	bool on_its_way_ = false;

	void begin_at(std::size_t i, double mean, double deviation);
	void add_to(std::size_t sum, std::size_t added);
	void forget(std::size_t forgotten);
	void begin_error();
};

} // namespace steadyhand
