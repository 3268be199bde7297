#pragma once

#include "phase/element_curve.h"
#include "phase/hypothesis_bank.h"
#include "signal/quintic_piece.h"

#include <array>
#include <cmath>

namespace steadyhand {

/// What is believed of the motion at an instant; values in amplitudes, time in seconds.
struct PhaseEstimate {
	double value = 0.0;
	double velocity = 0.0;
	double acceleration = 0.0;
	double phase = 0.0;      ///< 0..1, expected of those on their way
	double moving = 0.0;     ///< probability that the gesture has begun
	double free_phase = 0.0; ///< to be added where hands that do something else count by where they are
	double correction = 0.0; ///< part of the acceleration that hides what a frame changed
};

/// The weighted mean of what hypotheses expect of the hand, in as few numbers as give it at any time until
/// they change: it is asked for each millisecond, they change with frames. For as long as the next frame is
/// usually away it is a quintic, which differs from the mean by less than 1e-4 amplitudes; and for as long
/// again each time that it is told to go on.
///
/// A gesture that was seen to begin goes on while nothing is seen. One that was not, and a hand that did
/// something else, wait, as one that halted does: nothing moves on a mere chance. One that has come no
/// further than the hand was shown to wander at rest goes on for a while.
class MotionOutlook {
public:
	/// filtered_s: the time that the hypotheses were predicted to; ahead_s: how long after that the mean is
	/// asked for first; seen_s: when a frame last told where the hand is; erred: 0..1, how far the tracker is
	/// known for that; is_halted: the hand stands, whatever a hypothesis says of it; wander: what was seen of
	/// a gesture that went no further may be the tracker's wandering. To be called after
	/// HypothesisBank::prune.
	void look(const HypothesisBank &bank, const ElementCurve &curve, double filtered_s, double ahead_s,
			double seen_s, double erred = 0.0, bool is_halted = false, double wander = 0.0);

	/// No frame came until t_s.
	void go_on(const ElementCurve &curve, double t_s);

	/// At t_s, not before filtered_s (or as it was then).
	[[nodiscard]] PhaseEstimate at(const ElementCurve &curve, double t_s) const {
		const double s = t_s - piece_from_s_;
		const bool is_on_piece = s >= 0.0 && s <= PIECE_S;
		if (!is_on_piece) {
			return beside_piece(curve, t_s);
		}
		const MotionPoint point = piece_.at(s);
		return { point.position, point.velocity, point.acceleration,
			phase_[0] + s * (phase_[1] + s * phase_[2]), moving_, free_phase_ };
	}

private:
	static constexpr double PIECE_S = 0.02;

	/// Of those on their way, side by side; shares of the total weight.
	struct Courses {
		Lanes onset_s{}, rate_per_s{};
		Lanes elements{}; ///< of the motion elements' curve in the value
		Lanes smooth{};   ///< of the minimum jerk's
		Lanes weight{};
		Lanes waits_from{}; ///< phase from which on it slows down until it is seen again
	};
	/// Of all in a regime: their deviations fade alike, so that the mean of them is one.
	struct Wandering {
		Lanes x{}, v{};
	};

	std::array<Courses, (HypothesisBank::MOST_AFTER_PRUNE + LANES - 1) / LANES> courses_{};
	std::size_t count_ = 0; ///< of those on their way
	Wandering hand_;        ///< a regime each
	double moving_ = 0.0;
	double free_phase_ = 0.0;     ///< PhaseEstimate's
	double standing_phase_ = 0.0; ///< what those that stand are beside the end's phase of 1, by their weights
	double filtered_s_ = 0.0;
	double ahead_s_ = NAN; ///< fading_from_ and fading_to_ are of it
	QuinticPiece piece_;
	double piece_from_s_ = 0.0;
	std::array<double, 3> phase_{}; ///< along the piece: coefficients

	struct Mean {
		PhaseEstimate estimate;
		double phase_rate_per_s = 0.0;
	};
	/// What a time after the hypotheses' leaves of deviations, a regime each: exp(-rate dt_s); of FREE, of
	/// its velocity.
	[[nodiscard]] static Lanes fading(double dt_s);
	void lay_piece(const ElementCurve &curve, double dt_s, const Lanes &fading_from, const Lanes &fading_to);
	[[nodiscard]] PhaseEstimate beside_piece(const ElementCurve &curve, double t_s) const;
	[[nodiscard]] Mean mean(const ElementCurve &curve, double dt_s, const Lanes &fading) const;

	Lanes fading_from_, fading_to_; ///< at the ends of the piece
};

} // namespace steadyhand
