#pragma once

#include "signal/quintic_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace steadyhand {

/// The motion has come to where it leads: a tap to its surface, a drag to its end. Also the start of a
/// gesture.
struct Arrival {
	std::uint32_t number = 0; ///< counts them, from 1; 0: none
	double time_s = 0.0;
	double speed_m_s = 0.0;
};

/// The analytic motion around now, small enough to be handed over as a whole: its values and derivatives at
/// instants a period apart, between them the quintic that has all of these at both ends. Between knots of
/// which one has a correction its own acceleration is a straight line: what corrects is over too soon for
/// knots.
struct MotionSnapshot {
	struct Knot {
		double position = 0.0;
		double velocity = 0.0;
		double acceleration = 0.0;
		bool moving = false; ///< a gesture is under way and has not arrived, from here to the next knot
		/// Of the quintic to the next knot: its coefficients of s^3 to s^5, where fit() has made them.
		std::array<double, 3> higher{};
		double correction = 0.0; ///< as MotionPoint's
	};
	static constexpr std::size_t MOST_KNOTS = 32;

	double time_s = 0.0; ///< of the first knot
	double period_s = 0.001;
	std::size_t count = 0;
	double amplitude_m = 0.0; ///< of the task
	Arrival arrival;          ///< the last one
	Arrival expected; ///< the next one, if all goes on as it does; with a later snapshot it may be gone
	Arrival onset;    ///< the last start of a gesture, when it was recognised
	bool is_fitted = false;
	std::array<Knot, MOST_KNOTS> knots{};

	/// Makes the quintics once and for all, so that the audio thread need not; the knots are to stay as they
	/// are.
	void fit();

	[[nodiscard]] double end_s() const { return time_s + period_s * static_cast<double>(count - 1); }

	/// In units of the amplitude: 0 at the start, 1 at the end. NaN where the snapshot is. Before the first
	/// knot: as it began there. After the last one the motion coasts to a stop. At rest at 0 where there is
	/// none.
	[[nodiscard]] MotionPoint at(double t_s) const;
	[[nodiscard]] bool is_moving(double t_s) const;
	/// The first instant at or after from_s, up to the last knot, at which the position is `level` or more;
	/// NaN where there is none.
	[[nodiscard]] double reaches_s(double level, double from_s) const;
};

/// Of the piece between two knots: a straight line, where one of them has a correction.
struct OwnAcceleration {
	double at_start = 0.0, slope = 0.0;
	bool is_line = false;

	[[nodiscard]] static OwnAcceleration between(
			const MotionSnapshot::Knot &from, const MotionSnapshot::Knot &to, double period_s) {
		const double at_start = from.acceleration - from.correction;
		return { at_start, (to.acceleration - to.correction - at_start) / period_s,
			from.correction != 0.0 || to.correction != 0.0 };
	}
	/// point: of the quintic, s after its start.
	[[nodiscard]] MotionPoint of(MotionPoint point, double s) const {
		if (is_line) {
			point.correction = point.acceleration - (at_start + s * slope);
			point.correction_slope = point.jerk - slope;
		}
		return point;
	}
};

/// A snapshot that is asked for one instant after the other: the quintics of the last two pieces are kept.
class MotionCurve {
public:
	/// Of its knots those that count are copied.
	void set(const MotionSnapshot &snapshot);
	[[nodiscard]] const MotionSnapshot &snapshot() const { return snapshot_; }

	/// snapshot().at(t_s), up to rounding
	[[nodiscard]] MotionPoint at(double t_s) {
		const Piece *const piece = piece_at(t_s);
		return piece != nullptr ? piece->at(t_s) : snapshot_.at(t_s);
	}

	/// snapshot().is_moving(t_s)
	[[nodiscard]] bool is_moving(double t_s) {
		const Piece *const piece = piece_at(t_s);
		return piece != nullptr ? piece->is_moving : snapshot_.is_moving(t_s);
	}

	/// How far from t_s on it is one and the same polynomial, s; 0 where it is none.
	[[nodiscard]] double smooth_s(double t_s);
	/// At least the greatest difference of the position between two instants from the cubic that has these
	/// values and velocities there; infinite over more than two pieces, or where it does not go on moving.
	[[nodiscard]] double from_cubic(
			double from_s, const MotionPoint &from, double to_s, const MotionPoint &to);
	/// The same of the velocity, of one piece.
	[[nodiscard]] double velocity_from_cubic(double from_s, double to_s);

private:
	/// What rounding may take a time before the first knot by does not count.
	static constexpr double GRAIN_S = 1e-6;

	struct Piece {
		QuinticPiece quintic;
		OwnAcceleration own;
		double began_s = 0.0, length_s = 0.0;
		std::size_t knot = 0;
		bool is_moving = false;

		[[nodiscard]] bool has(double t_s) const {
			return t_s - began_s >= -GRAIN_S && t_s - began_s < length_s;
		}
		[[nodiscard]] MotionPoint at(double t_s) const {
			return own.of(quintic.at(t_s - began_s), t_s - began_s);
		}
		[[nodiscard]] double greatest_fourth() const {
			const double at_start = 24.0 * quintic.c[4];
			return std::max(std::abs(at_start), std::abs(at_start + 120.0 * length_s * quintic.c[5]));
		}
	};

	MotionSnapshot snapshot_;
	double knots_per_s_ = 0.0;
	std::array<Piece, 2> pieces_;
	std::size_t latest_ = 0; ///< asked for, of the two

	/// Null outside the knots. Stays until the next but one is found.
	[[nodiscard]] const Piece *piece_at(double t_s) {
		if (pieces_[latest_].has(t_s)) {
			return &pieces_[latest_];
		}
		if (!pieces_[1 - latest_].has(t_s)) {
			return find(t_s);
		}
		latest_ = 1 - latest_;
		return &pieces_[latest_];
	}
	[[nodiscard]] const Piece *find(double t_s);
};

} // namespace steadyhand
